# SPDX-License-Identifier: MIT
"""Every lint fails on a fault planted in a small tree, and passes without it."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SPDX = "// SPDX-License-Identifier: MIT\n"
BIB = "@article{one1990,\n  author = {A},\n  title = {B},\n  year = {1990}\n}\n"
TIDIED = SPDX + '#include "polhode/io/tidied.hpp"\n\nnamespace {\nstruct Own {};\n}  // namespace\n'
COMMANDS = [{"directory": "../..", "file": file, "command": "c++ -std=c++20 -Iinclude"}
            for file in ("src/io/one.cpp", "src/io/two.cpp")]
SOUND = {
    ".clang-format": (HERE.parents[1] / ".clang-format").read_text(),
    ".clang-tidy": (HERE.parents[1] / ".clang-tidy").read_text(),
    "build/release/compile_commands.json": json.dumps(COMMANDS),
    "include/polhode/io/tidied.hpp": SPDX + "#pragma once\n",
    "include/polhode/io/kept.hpp": SPDX + "#pragma once\nstruct Kept {};\n",
    "src/io/one.cpp": TIDIED.replace("tidied", "kept"),
    "src/io/two.cpp": TIDIED,
    "docs/references.bib": BIB,
    "docs/glossary.md": "Words.\n\n| do not write | write |\n| --- | --- |\n| `goes on`, `some N`, `most_*` | resumes |\n",
    "docs/notes.md": "As in one1990; energies in kJ/mol/nm; `goes on` is code.\n",
    "docs/evidence/guide.md": "Tables.\n",
    "docs/guide.md": "What to do.\n",
    "tests/reference/a.cpp": SPDX + 'int goes, on;\n',
    "tests/reference/a.py": SPDX.replace("//", "#") + "text = 'goes on'\n",
    "data/molecules/a.toml": 'source = "one1990"\n',
    "src/run/soar.hpp": SPDX + "int soar_over(int height);\n",
    "cli/verbs/soar.cpp": SPDX + "Action soar_verb(Command&) {\n  return [] { return soar_over(2); };\n}\n",
    "python/polhode/__init__.py": SPDX.replace("//", "#") + '__all__ = ["new", "soar"]\n',
    "src/base/pack.hpp": SPDX + "#include <hwy/highway.h>\n",
    "include/polhode/io/file.hpp": SPDX + '#include "polhode/forces/laws/settings.hpp"\n',
    "src/io/file.cpp": SPDX + "#include <fmt/core.h>\n\n"
                              'void f() { throw Error(message("x = {} is 0; write 1", x)); }\n',
}
# lint, file, text appended to it (or the whole of a new file), line that must be named
FAULTS = [
    ("floors", "include/polhode/base/low.hpp", SPDX + '#include "polhode/run/study/study.hpp"\n', 2),
    ("floors", "include/polhode/io/file.hpp", '#include "polhode/measure/energy.hpp"\n', 3),
    ("floors", "include/polhode/rotor/a.hpp", SPDX + '#include "polhode/forces/laws/laws.hpp"\n', 2),
    ("floors", "include/polhode/forces/a.hpp", SPDX + "#include <hwy/highway.h>\n", 2),
    ("floors", "include/polhode/forces/a.hpp", SPDX + "#include <fmt/core.h>\n", 2),
    ("floors", "include/polhode/forces/a.hpp", SPDX + "#include <pocketfft_hdronly.h>\n", 2),
    ("floors", "include/polhode/io/a.hpp", SPDX + "#include <hdf5.h>\n", 2),
    ("floors", "include/polhode/run/a.hpp", SPDX + '#include "run/study/claims.hpp"\n', 2),
    ("floors", "src/forces/a.cpp", SPDX + '#include "run/study/claims.hpp"\n', 2),
    ("floors", "cli/verbs.hpp", SPDX + "#include <CLI/CLI.hpp>\n", 2),
    ("floors", "src/run/report.hpp", SPDX + "#include <nlohmann/json.hpp>\n", 2),
    ("floors", "cli/verbs/run.cpp", SPDX + '#include "polhode/engine/a.hpp"\n', 2),
    ("format", "src/io/file.cpp", "void  g( ) ;\n", 5),
    ("citations", "src/io/file.cpp", "/// @source nobody1999, Eq. 3\n", 5),
    ("citations", "docs/notes.md", "See [nobody1999].\n", 2),
    ("citations", "data/molecules/b.toml", 'source = "my own"\n', 1),
    ("citations", "docs/references.bib", BIB.replace("one1990", "two1990"), 6),
    ("citations", "docs/references.bib", BIB.replace("one1990", "one1991"), 6),
    ("citations", "docs/more.bib", BIB, 1),
    ("citations", "docs/notes.md", "As is known (one1990, Eq. 3).\n", 2),
    ("errors", "src/io/file.cpp", 'void g() { throw Error("The box is 0 nm"); }\n', 5),
    ("errors", "src/io/file.cpp", 'void g() { throw Error("box is 0 nm."); }\n', 5),
    ("errors", "src/io/file.cpp", 'void g() { throw Error("box " + b + " is invalid"); }\n', 5),
    ("errors", "src/io/file.cpp", 'void g() { throw Error(message("a "\n"b failed")); }\n', 5),
    ("contents", "src/io/other.cpp", "int x;\n", 1),
    ("contents", "src/io/file.cpp", "// TO" "DO\n", 5),
    ("contents", "docs/notes.md", "Look in /ho" "me/someone.\n", 2),
    ("contents", "src/io/file.cpp", "\n" * 500, 500),
    ("function_size", "src/io/file.cpp", "int g() {\n" + "  ++x;\n" * 59 + "}\n", 5),
    ("function_size", "src/io/file.cpp", "struct S {\n  S()\n      : x{1} {\n" + "    ++x;\n" * 59 + "  }\n};\n", 6),
    ("function_size", "src/io/file.cpp",
     "int g() {\n  return [] {\n    return [&x](auto) {\n      return [] { return 1; }();\n    }(2);\n  }();\n}\n", 8),
    ("sentences", "docs/guide.md", "\nIt is " + "very " * 30 + "long.\n", 3),
    ("sentences", "docs/guide.md", "| that\nof others |\n", 2),
    ("sentences", "docs/notes.md", "It runs with 2 to 4 fs.\n", 2),
    ("sentences", "docs/notes.md", "It takes two times\nfewer steps.\n", 2),
    ("sentences", "docs/notes.md", ("very " * 31 + "long. ") * 1000, 2),
    ("sentences", "docs/notes.md", "those of " * 1000, 2),
    ("sentences", "include/polhode/rotor/a.hpp", SPDX + "/// The same for two.\nint x;\n" * 100, 2),
    ("tidy", "src/io/two.cpp", "bool is_equal(int x) { return x == x; }\n", 7),
    ("tidy", "include/polhode/io/tidied.hpp", "inline bool is_equal(int x) { return x == x; }\n", 3),
    ("tidy", "include/polhode/io/tidied.hpp", "struct Kept {};\n", 3),
    ("verbs", "cli/verbs.cpp", SPDX + '{{"fly", "move through the air",\n  fly_verb}};\n', 2),
    ("verbs", "cli/verbs.cpp", SPDX + '{{"new", "write a run file", new_verb}};\n', 2),
    ("verbs", "cli/verbs.cpp", SPDX + '{{"soar", "stay in the air", soar_verb}};\n', 2),
    ("words", "docs/notes.md", "It is long,\nand Goes\non.\n", 3),
    ("words", "docs/notes.md", "It takes some 20 ps.\n", 2),
    ("words", "docs/glossary.md", "\n| do not write | write |\n| --- | --- |\n", 1),
    ("words", "tests/reference/a.cpp", "/// The run goes\n/// on.\n", 3),
    ("words", "tests/reference/a.cpp", "int x; // goes on\n", 3),
    ("words", "src/io/file.cpp", 'auto text = "a run that goes "\n            "on";\n', 5),
    ("words", "tests/reference/a.py", "x = 1  # goes on\n", 3),
    ("words", "tests/reference/a.cpp", "int most_bins;  // and why\n", 3),
    ("words", "tests/reference/a.py", "text = most_bins\n", 3),
    ("words", "tests/reference/a.py", 'option(help="it "\n       "goes on")\n', 4),
    ("words", "tests/reference/a.py", 'def f():\n    """A run.\n\n    It goes on."""\n', 6),
]


def lint(name, tree):
    """(exit code, output) of one lint over a tree of texts."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in tree.items():
            target = Path(folder) / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text)
        run = subprocess.run([sys.executable, HERE / f"{name}.py", "--root", folder], text=True,
                             capture_output=True, check=False)
    return run.returncode, run.stdout + run.stderr


def main():
    wrong, skipped = [], set()
    for name in sorted({fault[0] for fault in FAULTS}):
        code, output = lint(name, SOUND)
        if code == 77:
            skipped.add(name)
        elif code != 0:
            wrong.append(f"{name} is red on a sound tree:\n{output}")
    for name, path, text, line in FAULTS:
        if name in skipped:
            continue
        code, output = lint(name, {**SOUND, path: SOUND.get(path, "") + text})
        if code != 1 or f"{path}:{line}: " not in output:
            wrong.append(f"{name} does not name {path}:{line} with {text!r}:\n{output}")
    print("\n".join(wrong) or f"{len(FAULTS)} planted faults found; skipped: {skipped or 'none'}")
    sys.exit(1 if wrong else 77 if skipped else 0)


if __name__ == "__main__":
    main()
