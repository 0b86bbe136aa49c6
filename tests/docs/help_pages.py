# SPDX-License-Identifier: MIT
"""The manual shows the --help of each verb as the program prints it; with --write the manual is updated. No default in
a help text is a number of its own.

The page docs/manual/VERB.md contains it in the fenced block below `<!-- help: VERB -->`, and the index
docs/manual/README.md that of the program below `<!-- help -->`.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path


def help_text(program, *verb):
    return subprocess.run([program, *verb, "--help"], text=True, capture_output=True, check=True).stdout.strip() + "\n"


def verbs(program):
    listed = help_text(program).partition("examples\n")[0]
    return re.findall(r"^  ([\w-]+)", listed, re.M)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--write", action="store_true", help="bring the pages up to date")
    options = parser.parse_args()
    program, manual = options.program.resolve(), options.root / "docs/manual"
    wrong = []
    for verb in ("", *verbs(program)):
        page = manual / f"{verb or 'README'}.md"
        shown = page.relative_to(options.root)
        mark = f"<!-- help: {verb} -->" if verb else "<!-- help -->"
        text = page.read_text(encoding="utf-8") if page.exists() else ""
        block = re.search(re.escape(mark) + r"\n```text\n(.*?)```\n", text, re.S)
        if not block:
            wrong.append(f"{shown} has no block ```text below {mark}; add one")
            continue
        current = help_text(program, *([verb] if verb else []))
        if block[1] == current:
            continue
        if options.write:
            page.write_text(text[:block.start(1)] + current + text[block.end(1):], encoding="utf-8")
        else:
            wrong.append(f"{shown} shows another help than the program prints; run this test with --write")
    for source in sorted((options.root / "cli").glob("*.cpp")):
        if written := re.search(r'default: \\"[\d.]+', source.read_text(encoding="utf-8")):
            wrong.append(f"{source.name} writes '{written[0]}'; take the number from the settings")
    print("\n".join(wrong) or "the manual shows what the program prints")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
