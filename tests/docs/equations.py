# SPDX-License-Identifier: MIT
"""The displayed equations of the theory are numbered in order, and every Eq. (n) exists; --write renumbers both.

docs/theory.md has Eq. (1), (2), ..., docs/theory-rotor.md Eq. (R1), (R2), ...: a number names one equation, in whichever
file it is cited. Equations of papers are cited without parentheses: [[vanzon2008], Eq. 3].
"""

import re

from pages import is_current, options, report

PAGES = {"docs/theory.md": "", "docs/theory-rotor.md": "R"}  # with the letter before their numbers
CITING = ("docs", "README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "include", "src", "cli", "tests", "bench", "studies", "examples")
BLOCK = re.compile(r"^```math\n(.*?)\n```", re.S | re.M)
TAG = re.compile(r"\s*\\tag\{(\w+)\}")
NUMBER = r"\((R?\d+)\)"
SPACE = r"(?:\s|///?|#)+"  # a citation may continue on the next line of a comment
CITATION = re.compile(rf"\bEqs?\.{SPACE}{NUMBER}(?:(?:,|{SPACE}and|{SPACE}to){SPACE}{NUMBER})*")


def citing_files(root):
    for name in CITING:
        place = root / name
        found = place.rglob("*") if place.is_dir() else [place]
        yield from sorted(p for p in found if p.suffix in (".md", ".hpp", ".cpp", ".py") and p.is_file()
                          and p.name not in ("equations.py", "planted_faults.py"))


def numbered(text, letter):
    """The text with its equations numbered in order, and new numbers by old ones."""
    new = {}

    def number(block):
        tag = TAG.search(block[1])
        value = f"{letter}{len(new) + 1}"
        new[tag[1] if tag else f"unnumbered {value}"] = value
        return f"```math\n{TAG.sub('', block[1])} \\tag{{{value}}}\n```"

    return BLOCK.sub(number, text), new


def cited(text):
    """(line, number) of the equations that a text cites."""
    for citation in CITATION.finditer(text):
        for number in re.findall(NUMBER, citation[0]):
            yield text.count("\n", 0, citation.start()) + 1, number


def main():
    given = options(__doc__, "number the equations, and correct the citations")
    root, new, wrong = given.root, {}, []
    for name, letter in PAGES.items():
        text = (root / name).read_text(encoding="utf-8")
        in_order, numbers = numbered(text, letter)
        new |= numbers
        if not is_current(root / name, in_order, given.write):
            wrong.append(f"{name}: equations are not numbered in order; run tests/docs/equations.py --write")
    for path in citing_files(root):
        text = path.read_text(encoding="utf-8")
        wrong += [f"{path.relative_to(root)}:{line}: there is no Eq. ({number}); correct it"
                  for line, number in cited(text) if number not in new]
        renewed = CITATION.sub(lambda c: re.sub(NUMBER, lambda n: f"({new.get(n[1], n[1])})", c[0]), text)
        if given.write:
            is_current(path, renewed, write=True)
    report(wrong, f"{len(new)} equations, numbered in order")


if __name__ == "__main__":
    main()
