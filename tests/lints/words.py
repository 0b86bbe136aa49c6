# SPDX-License-Identifier: MIT
"""Documents, comments and texts of the program contain none of the words that docs/glossary.md says to avoid.

They are the phrases in code font in the left column of its last table. Upper and lower case are equal, a phrase may
continue on the next line or in the next string literal, and N is any number. Formulas and links are not checked, code
only for names with a beginning in that column, such as `most_*`.
"""

import io
import re
import tokenize

from tree import Finding, files, line_of, main

GLOSSARY = "docs/glossary.md"
TABLE = "| do not write |"
# Raw records of measurements, as they were printed on their day.
NOT_CHECKED = ("bench/results", "studies/records", "CHANGELOG.md")
ROW = re.compile(r"^\|(?P<avoid>.+?)\|(?P<write>.+)\|$", re.M)
NOT_PROSE = re.compile(r"`[^`\n]*`|\$[^$\n]*\$|<!--.*?-->|\]\([^)\s]*\)")
BLOCK = re.compile(r"^```.*?^```|^ {4}\S[^\n]*", re.S | re.M)
IN_CPP = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])+'", re.S)
BETWEEN_LITERALS = re.compile(r"\"(\s*)\"")
COMMENT_MARK = re.compile(r"^[ \t]*(?:/[/*]+<?|\*)", re.M)


def blank(match):
    """As many characters and lines, but no words."""
    return re.sub(r"[^\n]", " ", match[0] if isinstance(match, re.Match) else match)


def rows(root):
    """The rows of the glossary's last table."""
    path = root / GLOSSARY
    return list(ROW.finditer(path.read_text(encoding="utf-8").rpartition(TABLE)[2])) if path.exists() else []


def names_to_avoid(root):
    """Pairs of a pattern of names, of which a glossary row has the beginning, and what to write instead."""
    for row in rows(root):
        for beginning in re.findall(r"`(\w+_)\*`", row["avoid"]):
            yield re.compile(rf"\b{beginning}\w+"), row["write"].strip()


def letters(text):
    """The runs of letters of a text, in lower case."""
    return set(re.findall(r"[^\W\d_]+", text.lower()))


def phrases_to_avoid(root):
    """Triples of a pattern, the words without which it is in no text, and what to write instead."""
    for row in rows(root):
        for phrase in re.findall(r"`([^`]+)`", row["avoid"]):
            if phrase.endswith("_*"):
                continue
            parts = phrase.split()
            words = [r"\d[\d.,]*" if part == "N" else re.escape(part) for part in parts]
            after = r"(?![\w-])" if phrase[-1].isalnum() else ""
            pattern = re.compile(r"(?<![\w-])" + r"\s+".join(words) + after, re.I)
            yield pattern, letters(" ".join(part for part in parts if part != "N")), row["write"].strip()


def prose_of_markdown(text):
    return NOT_PROSE.sub(blank, BLOCK.sub(blank, text))


def prose_of_cpp(text):
    """The comments and string literals at their positions; everything else is blank."""
    prose, end = [], 0
    for match in IN_CPP.finditer(text):
        kind = match[0][0]
        words = COMMENT_MARK.sub(blank, match[0]) if kind == "/" else match[0] if kind == '"' else blank(match)
        prose += [blank(text[end:match.start()]), words]
        end = match.end()
    joined = BETWEEN_LITERALS.sub(lambda m: " " + m[1] + " ", "".join(prose) + blank(text[end:]))
    return NOT_PROSE.sub(blank, joined)


def prose_of_python(text):
    """The comments, docstrings and help texts of options at their positions; everything else is blank."""
    rows = [blank(line) for line in text.splitlines(keepends=True)]
    before = ["", ""]
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        is_text = token.string.startswith('"""') or before in (["help", "="], ["description", "="])
        before = before if token.type in (tokenize.STRING, tokenize.NL) else [before[1], token.string]
        if token.type == tokenize.STRING and is_text or token.type == tokenize.COMMENT:
            row, column = token.start
            for line in token.string.replace("#", " ", 1).split("\n"):
                rows[row - 1] = rows[row - 1][:column] + line + rows[row - 1][column + len(line):]
                row, column = row + 1, 0
    return NOT_PROSE.sub(blank, "".join(rows))


def code_of_cpp(text):
    """The code at its positions; comments and literals are blank."""
    return IN_CPP.sub(blank, text)


def code_of_python(text):
    """The names at their positions; everything else is blank."""
    rows = [blank(line) for line in text.splitlines(keepends=True)]
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.NAME:
            (row, column), name = token.start, token.string
            rows[row - 1] = rows[row - 1][:column] + name + rows[row - 1][column + len(name):]
    return "".join(rows)


CODE = {".hpp": code_of_cpp, ".cpp": code_of_cpp, ".py": code_of_python}
PROSE = {".md": prose_of_markdown, ".hpp": prose_of_cpp, ".cpp": prose_of_cpp, ".py": prose_of_python}


def lies_in(name, places):
    return any(name == place or name.startswith(place + "/") for place in places)


def check(root):
    phrases, names = list(phrases_to_avoid(root)), list(names_to_avoid(root))
    if not phrases:
        yield Finding(root / GLOSSARY, 1, f"no table {TABLE} write |; add it, this lint reads it")
    for path in files(root, tuple(PROSE)):
        name, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
        if lies_in(name, NOT_CHECKED):
            continue
        prose = PROSE[path.suffix](text.rpartition(TABLE)[0] if name == GLOSSARY else text)
        there = letters(prose)
        for pattern, needed, better in phrases:
            for match in pattern.finditer(prose) if needed <= there else ():
                phrase = " ".join(match[0].split())
                yield Finding(path, line_of(prose, match.start()), f"'{phrase}' is to be avoided; write: {better}")
        code = CODE[path.suffix](text) if path.suffix in CODE else ""
        for pattern, better in names:
            for match in pattern.finditer(code):
                yield Finding(path, line_of(code, match.start()), f"the name '{match[0]}' is to be avoided; write: {better}")


if __name__ == "__main__":
    main(check, __doc__)
