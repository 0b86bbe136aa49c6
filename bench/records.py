# SPDX-License-Identifier: MIT
"""JSON files of results with as few lines as are readable."""

import json

WIDTH = 300  # characters of a line


def lines(entries, indent):
    """The entries, several on a line where they fit."""
    filled = []
    for entry in entries:
        if filled and "\n" not in filled[-1] + entry and indent + len(filled[-1]) + len(entry) < WIDTH:
            filled[-1] += ", " + entry
        else:
            filled.append(entry)
    return filled


def text(value, indent=0):
    """The value as JSON."""
    line = json.dumps(value, ensure_ascii=False)
    if indent + len(line) <= WIDTH or not isinstance(value, (dict, list)):
        return line
    if isinstance(value, dict):
        entries, brackets = [json.dumps(k, ensure_ascii=False) + ": " + text(v, indent + 1) for k, v in value.items()], "{}"
    else:
        entries, brackets = [text(v, indent + 1) for v in value], "[]"
    blanks = "\n" + " " * (indent + 1)
    return brackets[0] + blanks + ("," + blanks).join(lines(entries, indent + 1)) + blanks[:-1] + brackets[1]


def write(path, value):
    path.write_text(text(value) + "\n", encoding="utf-8")
