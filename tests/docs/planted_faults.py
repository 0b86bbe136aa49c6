# SPDX-License-Identifier: MIT
"""The tests of the documents fail on a planted fault, and pass without it."""

import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAM = '#!/usr/bin/env bash\n[[ $1 != wrong ]] && echo "$@"\n'
SOUND = """# Title
[here](README.md#title), [[one1990], Eq. 2], Eq. (1)
<!-- file: water.toml -->
```toml
step = "2 fs"
```
```sh
grep fs water.toml
polhode run water.toml > out.txt
polhode run
```
```sh
grep run out.txt
```
```sh no-run
no-such-command
```

[one1990]: docs/bibliography.md#one1990
"""
BIBLIOGRAPHY = "@book{one1990,\n  author = {A, B},\n  title = {C},\n  publisher = {D},\n  year = {1990}\n}\n"
TREE = "# Start\n\n```{toctree}\n:hidden:\n\n%s\n```\n"
MANUAL = ("dictionary", "ensembles", "gromacs", "messages", "molecule-files", "run-files")
PAGES = "\n".join(("docs/api/python", "docs/bibliography", *(f"docs/manual/{name}" for name in MANUAL), "docs/tasks/one", "docs/theory",
                   "docs/theory-rotor"))
WARNINGS = '''// "no kind
Warning walk(double R) {
  return {"walk", R};
}
std::optional<Warning> drift(double rate) {
  return Warning{"drift", rate, format("the energy drifts "
                                       "by {:.3g} K, too {}", rate, '"' ? "much" : "little")};
}
'''
EQUATION = "```math\n1 = 1 \\tag{%s}\n```\n"
FILES = {  # a sound project besides its README
    **{f"docs/manual/{name}.md": "# Keys\n\n`step`\n" for name in MANUAL},
    "docs/references.bib": BIBLIOGRAPHY,
    "docs/bibliography.md": "# Bibliography\n\nMade from [references.bib](references.bib) by `tests/docs/bibliography.py --write`.\n\n"
                            "### one1990\n\nB. A, *C*, D (1990)\n",
    "docs/theory.md": EQUATION % 1 + EQUATION % 2,
    "docs/theory-rotor.md": EQUATION % "R1",
    "docs/tasks/one.md": "# One\n\n```sh\npolhode 3 +- 1e-3 K, 7; polhode end\n```\n\n<!-- output -->\n```text\n4   +- 0.2 K...\nend\n```\n",
    "docs/manual/messages.md": "# Messages\n\n### `drift`\n\n> the energy drifts by 3 K, too much\n\n### `walk`\n",
    "src/warnings.cpp": WARNINGS,
    "src/io/gromacs/mdp.cpp": 'mdp_.number("dt", 1)',
    "docs/manual/dictionary.md": "# Dictionary\n\n| `.mdp` | polhode | |\n| --- | --- | --- |\n| `dt` | `step = \"2 fs\"` | |\n",
    "docs/site/index.md": TREE % PAGES,
    "docs/api/python.md": "# Python\n\n```{eval-rst}\n.. autofunction:: run\n```\n",
    "python/polhode/__init__.py": "__all__ = [\"run\"]\n",
}
FAULTS = [  # test, text added to the document, what the output must name
    ("run_commands", "```sh\npolhode run\npolhode wrong\ntrue\n```\n", "README.md:22: exit code 1"),
    ("run_commands", "```sh\ncat missing.toml | cat\n```\n", "README.md:21: exit code 1"),
    ("run_commands", "```sh\npolhode 3.5 K\n```\n<!-- output -->\n```text\n-4e-5 J\n```\n", "README.md:25: '-4e-5 J' is not in this output"),
    ("run_commands", "```sh\npolhode 1 K; polhode 2 J\n```\n<!-- output -->\n```text\n2 J\n1 K\n```\n", "README.md:25: '1 K' is not in this output"),
    ("links", "[there](docs/nowhere.md)\n", "README.md:20: docs/nowhere.md"),
    ("links", "[there](#nowhere)\n", "README.md:20: no heading #nowhere"),
    ("links", "[two1990]: docs/bibliography.md#two1990\n", "README.md:20: no heading #two1990"),
    ("bibliography", "As in [one1990].\n", "README.md:20: one1990 is not linked"),
    ("bibliography", "As in one1990.\n", "README.md:20: one1990 is not linked"),
    ("bibliography", "As in [[two1990]].\n", "README.md lacks links"),
    ("stated_values", "```sh no-run\npolhode study --quick  # two minutes; without --quick, three hours\npolhode study  # 2 hours\n```\n",
     "time of study has several values, correct all but one: 3 hour (README.md:21); 2 hour (README.md:22)"),
    ("stated_values", "<!-- help: bench -->\n```text\n  --quick   a few seconds\n```\nTake `polhode bench --quick`, a minute.\n",
     "a few second (README.md:22); 1 minute (README.md:24)"),
    ("stated_values", "| key | value | default |\n| --- | --- | --- |\n| `skin` | length | `\"0.1 nm\"` |\n\nThe `skin` (default: 0.2 nm).\n",
     "README.md:24: the default of skin is 0.2nm, elsewhere 0.1nm"),
    ("stated_values", "A derivative counts as two; a derivative\ncounts as three.\n", "2 (README.md:20); three (README.md:20)"),
    ("stated_values", "| GROMACS | 870 |\n", "README.md:20: name the instruction set"),
    ("stated_values", "./polhode run\n", "README.md:20: write polhode"),
    ("equations", "By Eqs. (1) and (3),\n", "README.md:20: there is no Eq. (3)"),
    ("equations", "By Eq. (R2),\n", "README.md:20: there is no Eq. (R2)"),
]
FILE_FAULTS = [  # test, file, the whole of it, what the output must name
    ("bibliography", "docs/references.bib", BIBLIOGRAPHY.replace("{C}", "{E}"), "docs/bibliography.md lacks"),
    ("equations", "docs/theory.md", EQUATION % 2 + EQUATION % 1, "docs/theory.md: equations are not numbered"),
    ("equations", "src/a.hpp", "// By Eqs. (1)\n// and\n// (3).\n", "src/a.hpp:1: there is no Eq. (3)"),
    ("site", "docs/new.md", "# New\n", "docs/new.md is not in docs/site/index.md"),
    ("site", "docs/site/index.md", TREE % (PAGES + "\ndocs/nowhere"), "there is no page docs/nowhere.md"),
    ("site", "docs/site/index.md", TREE % (PAGES + "\ndocs/theory"), "docs/theory is listed 2 times"),
    ("site", "python/polhode/__init__.py", "__all__ = [\"run\", \"stop\"]\n", "differ in stop"),
    ("messages", "src/warnings.cpp", WARNINGS.replace('"drift"', '"R"'), "has no section ### `R`"),
    ("messages", "src/warnings.cpp", WARNINGS.replace('"walk"', '"R"'), "explains `walk`, and the source has no such warning"),
    ("messages", "src/warnings.cpp", WARNINGS.replace("too {}", "far too {}"), "docs/manual/messages.md:5: the source has no text like this"),
    ("dictionary", "src/io/gromacs/mdp.cpp", 'time_of("nsteps", 1)', "dictionary.md lacks nsteps"),
    ("dictionary", "docs/manual/dictionary.md", "| `dt` | `time_step` | |\n", "run files have no key time_step"),
    ("equations", "docs/theory.md", EQUATION % 1 + "```math\n1 = 1\n```\n", "docs/theory.md: equations are not numbered"),
]


def result(test, files):
    """(exit code, output) of one test over a project of texts."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        program = root / "program"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        place = {"run_commands": ["--program", program, "--root", root], "links": [root], "site": [root]}.get(test, ["--root", root])
        run = subprocess.run([sys.executable, HERE / f"{test}.py", *place], text=True,
                             capture_output=True, check=False)
    return run.returncode, run.stdout + run.stderr


wrong = []
sound = {**FILES, "README.md": SOUND}
for test in sorted({fault[0] for fault in FAULTS + FILE_FAULTS}):
    code, output = result(test, sound)
    if code != 0:
        wrong.append(f"{test} is red on a sound document:\n{output}")
planted = [(test, "README.md", SOUND + fault, named) for test, fault, named in FAULTS] + FILE_FAULTS
for test, name, text, named in planted:
    code, output = result(test, {**sound, name: text})
    if code != 1 or named not in output:
        wrong.append(f"{test} does not say '{named}':\n{output}")
print("\n".join(wrong) or f"{len(planted)} planted faults found")
sys.exit(1 if wrong else 0)
