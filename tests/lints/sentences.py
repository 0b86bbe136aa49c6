# SPDX-License-Identifier: MIT
"""Sentences of documents, and of the doc comments of include/, are short and say what they mean.

Long sentences and four patterns are counted. Each count has a budget, which is lowered when sentences become better and never raised.
A guide has none of them: a page of docs/ with evidence of the same name, a task, the quick start.
"""

import re
from collections import defaultdict

from tree import Finding, files, line_of, main
from words import blank

LONGEST = 30  # words
NOT_CHECKED = ("docs/bibliography.md", "docs/glossary.md")  # titles of papers; words to avoid
NUMBER = r"(?:\d[\d.,]*|half|two|three|four|five|six|seven|eight|nine|ten)"
PATTERNS = {  # what is counted: pattern, what to write
    "that of": (r"\b(?:that|those) of\b", "repeat the noun"),
    "with N fs": (r"\bwith \d[\d.]*(?: (?:to|and|or) \d[\d.]*)? fs\b", "at 4 fs, or: with a 4 fs time step"),
    "N times fewer": (rf"\b{NUMBER} times (?:fewer|less|lower|smaller|shorter|cheaper)\b", "1.5x cheaper, or: a third of"),
}
BEGINNING = re.compile(r"(?:The same|Those|That|Likewise|Also|As above|Ditto)\b(?! (?:is|are|has|have|can|must)\b)")
BUDGETS = {"long": 0, "that of": 2, "with N fs": 0, "N times fewer": 0, "no sentence": 0}

CODE = re.compile(r"^```.*?^```|^> .*?$|<!--.*?-->|\]\([^)\s]*\)|^\[\w+\]: .*$", re.S | re.M)
WORD = re.compile(r"`[^`\n]+`|\$[^$\n]+\$")  # one word each
# What separates paragraphs: an empty line, and what begins an item, a heading, a row of a table or a tag of a doc comment.
PARAGRAPH = re.compile(r"\n[ \t]*(?=\n|[-*#|] ?|\d+\. |@\w)")
SENTENCE = re.compile(r"(?<=[.?!])(?<!\bEq\.)(?<!\bEqs\.)(?<!\bFig\.)(?<![ei]\.[eg]\.)[*_)\"]*\s+")
DOC_COMMENT = re.compile(r"(?:^[ \t]*///(?!<).*\n?)+|///<.*", re.M)


def pieces(text, separator):
    """(position, text) of what is between separators."""
    ends = [match.span() for match in separator.finditer(text)] + [(len(text), 0)]
    yield from ((begin, text[begin:end]) for begin, (end, _) in zip([0] + [last for _, last in ends], ends))


def findings(text):
    """(kind, position, what to do) in a text without code."""
    for start, paragraph in pieces(text, PARAGRAPH):
        if paragraph.lstrip().startswith(("|", "#")):
            continue
        for place, sentence in pieces(paragraph, SENTENCE):
            words = [word for word in re.finditer(r"\S+", sentence) if re.search(r"[^\W_]", word[0])]
            if len(words) > LONGEST:
                yield "long", start + place + words[0].start(), f"a sentence of {len(words)} words; write two, of at most {LONGEST}"
    for kind, (pattern, better) in PATTERNS.items():
        for match in re.finditer(pattern.replace(" ", r"\s+"), text):
            yield kind, match.start(), f"'{' '.join(match[0].split())}'; write: {better}"


def findings_of(suffix, text):
    one_word = lambda match: re.sub(r"\s", "x", match[0])
    if suffix == ".md":
        yield from findings(WORD.sub(one_word, CODE.sub(blank, text)))
    for comment in DOC_COMMENT.finditer(text) if suffix == ".hpp" else ():
        prose = WORD.sub(one_word, re.sub(r"///<?", blank, comment[0]))
        yield from ((kind, comment.start() + place, better) for kind, place, better in findings(prose))
        if BEGINNING.match(prose.lstrip()):
            yield "no sentence", comment.start(), "a doc comment that needs another one; begin with a noun or a verb"


def check(root):
    counted = defaultdict(list)
    for path in files(root, (".md", ".hpp"), ("docs", "include")):
        name, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
        is_guide = name.startswith(("docs/tasks/", "docs/quick-start")) or (path.parent.name == "docs" and (root / "docs/evidence" / path.name).exists())
        for kind, place, better in findings_of(path.suffix, text) if name not in NOT_CHECKED else ():
            counted["guide" if is_guide else kind].append((path, line_of(text, place), better))
    for kind, found in counted.items():
        budget = BUDGETS.get(kind, 0)
        for path, line, text in found if len(found) > budget else ():
            yield Finding(path, line, f"{text} ({kind}: {len(found)}, at most {budget})")


if __name__ == "__main__":
    main(check, __doc__)
