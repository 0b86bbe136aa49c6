# SPDX-License-Identifier: MIT
"""docs/manual/dictionary.md has each run parameter of GROMACS that the program reads, and its keys are those of run files."""

import re

from pages import options, report

PAGE, SOURCE = "docs/manual/dictionary.md", "src/io/gromacs/mdp.cpp"
KEYS = ("docs/manual/run-files.md", "docs/manual/ensembles.md", "docs/manual/gromacs.md", "docs/manual/molecule-files.md")
READ = re.compile(r'(?:mdp_\.(?:is|number|numbers|text)|time_of)\("([\w-]+)"')


def findings(root):
    page = (root / PAGE).read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`.*?) \| (.*?) \|", page, re.M)
    theirs = set(re.findall(r"[\w-]+", " ".join(left for left, _ in rows).lower()))
    read = set(READ.findall((root / SOURCE).read_text(encoding="utf-8")))
    if not read:
        yield f"{SOURCE} reads no parameters; correct this test"
    for name in sorted(read):
        if name.lower() not in theirs:
            yield f"{PAGE} lacks {name}, which {SOURCE} reads; add a row"
    documented = " ".join((root / name).read_text(encoding="utf-8") for name in KEYS)
    known = set(re.findall(r"`(\w+)`", documented))
    for _, ours in rows:
        for code in re.findall(r"`([^`]+)`", ours):
            key = re.match(r"(\w+)(?: = |$)", code)
            if key and key[1] not in known:
                yield f"{PAGE}: run files have no key {key[1]}; correct the row"


if __name__ == "__main__":
    report(findings(options(__doc__).root), "each parameter and each key of the dictionary exists")
