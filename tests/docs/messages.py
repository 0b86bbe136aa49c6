# SPDX-License-Identifier: MIT
"""docs/manual/messages.md explains each kind of warning in the source, and shows messages as the source has them.

A kind is the first text of a `Warning{"kind", ...}`, also after `return` in a function that returns a Warning; its section has the
heading ### `kind`. A message in the page, a quote, must be a text of the source with values in place of its {}.
"""

import re

from pages import options, report

PAGE = "docs/manual/messages.md"
LITERAL = r'"(?:[^"\\]|\\.)*"'
LITERALS = re.compile(rf"{LITERAL}(?:\s*{LITERAL})*")
NO_LITERAL = re.compile(r"^\s*//.*$|'\\?\"'", re.M)  # comments, and the character "
KIND = re.compile(r'\bWarning\s*\{\s*"(\w+)"|^Warning \w+\([^{;]*\)\s*\{(?:[^}]|\}(?!\n))*?return \{\s*"(\w+)"', re.M)
SHORTEST_TEXT = 20  # letters that a text must have to show where a message is from


def sources(root):
    for folder in ("src", "cli", "include"):
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            yield NO_LITERAL.sub("", path.read_text(encoding="utf-8"))


def texts(source):
    """Patterns of the texts of a source, each with any value in place of {...}."""
    for found in LITERALS.finditer(source):
        text = "".join(part[1:-1] for part in re.findall(LITERAL, found[0]))
        fixed = re.split(r"\{[^{}]*\}", text.replace("\\n", "").replace('\\"', '"'))
        if sum(map(str.isalpha, "".join(fixed))) >= SHORTEST_TEXT:
            yield ".*".join(map(re.escape, fixed))


def findings(root):
    page = (root / PAGE).read_text(encoding="utf-8")
    all_sources = list(sources(root))
    kinds = {next(filter(None, found.groups())) for source in all_sources for found in KIND.finditer(source)}
    sections = set(re.findall(r"^### `(\w+)`$", page, re.M))
    if not kinds:
        yield "no kind of warning was found in the source; correct this test"
    for kind in sorted(kinds - sections):
        yield f"{PAGE} has no section ### `{kind}`; explain this warning: its text, cause and remedy"
    for kind in sorted(sections - kinds):
        yield f"{PAGE} explains `{kind}`, and the source has no such warning; delete the section"
    patterns = re.compile("|".join({pattern for source in all_sources for pattern in texts(source)}))
    for quote in re.finditer(r"^> (.+)$", page, re.M):
        if not patterns.search(quote[1]):
            yield f"{PAGE}:{page.count(chr(10), 0, quote.start()) + 1}: the source has no text like this; show a message as it is printed"


if __name__ == "__main__":
    report(findings(options(__doc__).root), "each warning is explained, and each message shown is one of the source")
