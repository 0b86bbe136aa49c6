# SPDX-License-Identifier: MIT
"""docs/bibliography.md lists docs/references.bib, and every citation in a document is a link to it; --write does both.

A citation is written `[[vanzon2008]]` or `[[vanzon2008], Eq. 3]`, so that the reader sees the brackets. The lines that
make the inner one a link, `[vanzon2008]: bibliography.md#vanzon2008`, are at the end of the page. That every key has an
entry, and every entry a citation, is checked by tests/lints/citations.py.
"""

import os
import re
import unicodedata
from pathlib import Path

from pages import is_current, options, report

KEY = r"[a-z]{3,}(?:1[6-9]|20)\d\d[a-z]?"
CITED = re.compile(rf"(?<![\w/.-])({KEY})(?![\w/-])")
DEFINITION = re.compile(rf"^\[{KEY}\]: \S*bibliography\.md#{KEY}\n", re.M)
GROUP = re.compile(rf"\[(?:[^\[\]]|\[{KEY}\])*\]")  # [[vanzon2008], Eq. 3], [[jacobi1849], [vanzon2007a]]
NOT_PROSE = re.compile(r"^```.*?^```|`[^`\n]*`|\]\([^)\s]*\)", re.S | re.M)
ENTRY = re.compile(r"@\w+\s*\{\s*([^,\s]+)\s*,(.*?)\n\}", re.S)
FIELD = re.compile(r"^\s*(\w+)\s*=\s*\{(.*)\},?$", re.M)
ACCENTS = {"`": "\u0300", "'": "\u0301", "^": "\u0302", "~": "\u0303", '"': "\u0308", "c": "\u0327"}
NOT_CHECKED = ("bench/results", "studies/records", "third_party", "build", "docs/bibliography.md", "CHANGELOG.md")
TITLE = """# Bibliography

Made from [references.bib](references.bib) by `tests/docs/bibliography.py --write`.
"""


def in_unicode(text):
    """A BibTeX value as it is read: accents and dashes as characters, no braces."""
    text = text.replace(r"{\o}", "ø").replace("$^{-1}$", "⁻¹").replace(r"\i", "i")
    text = re.sub(r"\{\\([`'^~\"c])\{?(\w)\}?\}",
                  lambda m: unicodedata.normalize("NFC", m[2] + ACCENTS[m[1]]), text)
    return re.sub(r"[{}]", "", text.replace("--", "–").replace("``", "“").replace("''", "”"))


def author(name):
    """'van Zon, Ramses' as 'R. van Zon'; a name without a comma as it is."""
    last, *rest = name.split(", ")
    initials = [f"{part[0]}." for part in re.split(r"[ -]", rest[-1])] if rest else []
    return " ".join([*initials, last, *rest[:-1]])


def authors(text):
    names = [in_unicode(name) for name in re.split(r"\s+and\s+", text)]
    return ", ".join("et al." if name == "others" else author(name) for name in names)


def reference(body):
    """One entry of the bibliography as a paragraph."""
    field = {name: value if name == "author" else in_unicode(value) for name, value in FIELD.findall(body)}
    place = field.get("journal") or field.get("booktitle") or field.get("publisher") or field["institution"]
    where = " ".join(filter(None, [place, field.get("number"), field.get("volume") and f"**{field['volume']}**"]))
    pages = f", {field['pages']}" if "pages" in field else ""
    edition = f", edition {field['edition']}" if "edition" in field else ""
    text = f"{authors(field['author'])}, *{field['title']}*{edition}, {where}{pages} ({field['year']})"
    if "doi" in field:
        return f"{text}, [doi:{field['doi']}](https://doi.org/{field['doi'].replace('(', '%28').replace(')', '%29')})"
    if "eprint" in field:
        return f"{text}, [arXiv:{field['eprint']}](https://arxiv.org/abs/{field['eprint']})"
    return f"{text}, [{field['url']}]({field['url']})" if "url" in field else text


def bibliography(root):
    entries = ENTRY.findall((root / "docs/references.bib").read_text(encoding="utf-8"))
    return TITLE + "".join(f"\n### {key}\n\n{reference(body)}\n" for key, body in sorted(entries))


def prose(text):
    """The text without definitions; code and links are blank, at their positions."""
    return NOT_PROSE.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), DEFINITION.sub("\n", text))


def linked(page, root, text):
    """The text of a page with the definitions of the keys that it cites."""
    keys = sorted(set(CITED.findall(prose(text))))
    target = Path(os.path.relpath(root / "docs/bibliography.md", page.parent)).as_posix()
    body = DEFINITION.sub("", text).rstrip("\n") + "\n"
    return body + "".join(f"{'' if n else chr(10)}[{key}]: {target}#{key}\n" for n, key in enumerate(keys))


def unlinked(text):
    """(line, key) of citations that are no link in brackets."""
    words = prose(text)
    groups = [match.span() for match in GROUP.finditer(words)]
    for match in CITED.finditer(words):
        is_link = words[match.start() - 1] + words[match.end():match.end() + 1] == "[]"
        if not is_link or not any(first < match.start() - 1 and match.end() + 1 < end for first, end in groups):
            yield words.count("\n", 0, match.start()) + 1, match[1]


def pages(root):
    for page in sorted(root.rglob("*.md")):
        name = page.relative_to(root).as_posix()
        if not any(name == place or name.startswith(place + "/") for place in NOT_CHECKED):
            yield name, page


def main():
    given = options(__doc__, "bring the bibliography and the links up to date")
    root, wrong = given.root, []
    current = {"docs/bibliography.md": bibliography(root)}
    for name, page in pages(root):
        text = page.read_text(encoding="utf-8")
        wrong += [f"{name}:{line}: {key} is not linked; write [[{key}]]" for line, key in unlinked(text)]
        current[name] = linked(page, root, text)
    wrong += [f"{name} lacks links or entries; run tests/docs/bibliography.py --write"
              for name, text in current.items() if not is_current(root / name, text, given.write)]
    report(wrong, f"{len(current)} documents, every citation is linked")


if __name__ == "__main__":
    main()
