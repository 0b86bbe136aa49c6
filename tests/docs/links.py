# SPDX-License-Identifier: MIT
"""Every relative link in a document points to an existing file, and every #anchor to a heading."""

import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]).resolve()
LINK = re.compile(r"(?:\]\(|^\[[^\]\n]+\]: )([^)\s]+)", re.M)


def anchors(document):
    """Headings as they appear in links: lower case, spaces as hyphens, other characters dropped."""
    for heading in re.findall(r"^#+ (.+)$", document.read_text(encoding="utf-8"), re.M):
        yield re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def broken(document):
    text = re.sub(r"^```.*?^```", lambda m: re.sub(r"[^\n]", "", m[0]),
                  document.read_text(encoding="utf-8"), flags=re.S | re.M)
    for link in LINK.finditer(text):
        place, _, anchor = link[1].partition("#")
        if re.match(r"\w+:", place):
            continue
        target = (document.parent / place).resolve() if place else document
        line = text.count("\n", 0, link.start(1)) + 1
        shown = f"{document.relative_to(ROOT)}:{line}"
        if not target.exists():
            yield f"{shown}: {place} does not exist; correct the link"
        elif anchor and target.suffix == ".md" and anchor not in anchors(target):
            yield f"{shown}: no heading #{anchor} in {target.name}; correct the link"


documents = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "examples").rglob("*.md")]
found = [text for document in sorted(documents) for text in broken(document)]
print("\n".join(found) or f"{len(documents)} documents, every link leads somewhere")
sys.exit(1 if found else 0)
