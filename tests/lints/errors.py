# SPDX-License-Identifier: MIT
"""Error texts: lower case, no full stop, none of four empty words (CONTRIBUTING.md)."""

import re

from tree import Finding, files, line_of, main, matching_bracket, without_comments

THROWN = re.compile(r"\b(?:Error|RunError|refuse)\s*([({])")
LITERALS = re.compile(r'"(?:\\.|[^"\\\n])*"(?:\s*"(?:\\.|[^"\\\n])*")*')
EMPTY = re.compile(r"\b(invalid|illegal|failed|please)\b", re.I)
NAMES = ("Lennard", "Coulomb", "Verlet", "Python", "Cartesian", "Euler", "Debian")


def complaint(text, is_first):
    """What is wrong with one literal of a message, or None."""
    word = re.match(r"[A-Z][a-z]+", text)
    if is_first and word and word[0] not in NAMES:
        return f"the message begins with '{word[0]}'; begin in lower case with what is"
    if text.endswith(".") and not text.endswith("..") and " " in text:
        return "the message ends with a full stop; leave it out"
    empty = EMPTY.search(text)
    if empty:
        return f"'{empty[1]}' says nothing; give the value, the bound, the reason and the remedy"
    return None


def check(root):
    for path in files(root, (".hpp", ".cpp"), ("include", "src", "cli", "python", "lammps")):
        text = without_comments(path.read_text(encoding="utf-8"))
        for thrown in THROWN.finditer(text):
            end = matching_bracket(text, thrown.start(1))
            begin = thrown.end()
            for literal in LITERALS.finditer(text, begin, end):
                message = "".join(re.findall(r'"((?:\\.|[^"\\\n])*)"', literal[0]))
                is_first = not re.search(r"[+,]", text[begin:literal.start()])
                wrong = complaint(message, is_first)
                if wrong:
                    yield Finding(path, line_of(text, literal.start()), wrong)


if __name__ == "__main__":
    main(check, __doc__)
