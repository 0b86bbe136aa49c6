# SPDX-License-Identifier: MIT
"""Every cited key is in docs/references.bib, every entry there is cited somewhere, and citations are in square brackets.

A key is a name and a year, with a letter if needed (vanzon2007b), so any such word in a comment, a
document, a test or a data file is a citation. A data file's `source` must be one.
"""

import re

from tree import Finding, files, line_of, lines, main

KEY = re.compile(r"(?<![\w/.-])([a-z]{3,}(?:1[6-9]|20)\d\d[a-z]?)(?![\w/-])")
IN_PARENTHESES = re.compile(r"(?<!\w)\(([a-z]{3,}(?:1[6-9]|20)\d\d[a-z]?)(?=[),;])")
ENTRY = re.compile(r"@(\w+)\s*\{\s*([^,\s]+)\s*,(.*?)\n\}", re.S)
TEXT = (".hpp", ".cpp", ".py", ".md", ".toml", ".cmake", ".cff", ".txt", "")
SOURCE = re.compile(r'\s*source\s*=\s*"([^"]*)"')
BIBLIOGRAPHY = "docs/references.bib"
PAGE = "docs/bibliography.md"  # made from it, so it cites every entry


def entries(root):
    """key → (line, body) of the bibliography, and what is wrong with its form."""
    path, found, wrong = root / BIBLIOGRAPHY, {}, []
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    for match in ENTRY.finditer(text):
        key, body, line = match[2], match[3], line_of(text, match.start())
        if key in found:
            wrong.append(Finding(path, line, f"{key} stands here twice; delete one"))
        if not KEY.fullmatch(key):
            wrong.append(Finding(path, line, f"'{key}' is no key; use name and year, as forest1990"))
        for field in ("author", "title", "year"):
            if not re.search(rf"\b{field}\s*=", body):
                wrong.append(Finding(path, line, f"{key} has no {field}; add it"))
        year = re.search(r"year\s*=\s*[{\"]?(\d{4})", body)
        if year and year[1] not in key:
            wrong.append(Finding(path, line, f"{key} is of {year[1]}; correct the key or the year"))
        found[key] = line
    if len(found) != text.count("\n@") + text.startswith("@"):
        wrong.append(Finding(path, 1, "an entry does not end with a line '}'; close it so"))
    return found, wrong


def citations(root):
    """(path, line, key) wherever a key is cited."""
    for path in files(root, TEXT):
        if path.parent in (root / "tests/lints", root / "tests/docs") or path == root / PAGE:
            continue  # examples and planted faults
        for number, text in lines(path):
            source = SOURCE.match(text) if path.parent == root / "data/molecules" else None
            keys = re.split(r"[,;]\s*", source[1]) if source else KEY.findall(text)
            yield from ((path, number, key) for key in keys)


def check(root):
    known, wrong = entries(root)
    yield from wrong
    cited = set()
    for path, number, key in citations(root):
        cited.add(key)
        if key not in known:
            yield Finding(path, number, f"'{key}' is not in {BIBLIOGRAPHY}; add the entry")
    for path in files(root, (".hpp", ".cpp", ".md")):
        for number, text in lines(path):
            for match in IN_PARENTHESES.finditer(text):
                yield Finding(path, number, f"({match[1]} ...) is a citation; write it in square brackets, [{match[1]}]")
    for key in known.keys() - cited:
        yield Finding(root / BIBLIOGRAPHY, known[key], f"{key} is cited nowhere; cite or delete it")
    for path in files(root, (".bib",)):
        if path != root / BIBLIOGRAPHY:
            yield Finding(path, 1, f"a second bibliography; merge it into {BIBLIOGRAPHY}")


if __name__ == "__main__":
    main(check, __doc__)
