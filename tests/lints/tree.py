# SPDX-License-Identifier: MIT
"""Shared by all lints: the files of the project, and the report."""

import argparse
import re
import sys
from pathlib import Path
from typing import NamedTuple

TOP_LEVEL = (".ci", "bench", "cli", "cmake", "data", "docs", "examples", "include", "lammps",
             "python", "scripts", "src", "studies", "tests")
CODE = (".hpp", ".cpp", ".py", ".cmake", ".sh")


class Finding(NamedTuple):
    path: Path
    line: int
    text: str  # what is, and what to do


def files(root, suffixes=None, folders=TOP_LEVEL):
    """The project's files, sorted: those in its folders and, for TOP_LEVEL, those at its root."""
    found = [p for folder in folders for p in (root / folder).rglob("*")]
    if folders is TOP_LEVEL:  # but neither git's own nor what the program wrote there
        found += [p for p in root.iterdir() if not p.name.startswith((".git", "polhode"))]
    found = [p for p in found if p.is_file() and "__pycache__" not in p.parts]
    return sorted(p for p in found if suffixes is None or p.suffix in suffixes)


def lines(path):
    """(number, text) of each line; nothing for files that are not text."""
    try:
        return list(enumerate(path.read_text(encoding="utf-8").splitlines(), 1))
    except UnicodeDecodeError:
        return []


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def string_end(text, start):
    """The position after the C++ string or character literal that begins at `start`."""
    quote, i = text[start], start + 1
    while i < len(text) and text[i] != quote:
        i += 2 if text[i] == "\\" else 1
    return i + 1


def matching_bracket(text, start):
    """The position of the bracket that closes the one at `start`, strings ignored."""
    depth, i = 0, start
    while i < len(text):
        if text[i] == '"' or (text[i] == "'" and not text[i - 1].isalnum()):
            i = string_end(text, i)
            continue
        depth += (text[i] in "({[") - (text[i] in ")}]")
        if depth == 0:
            return i
        i += 1
    return len(text)


def without_comments(text):
    """C++ text with each comment blanked, so that positions and lines stay."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"'
    blank = lambda m: m[0] if m[0][0] == '"' else re.sub(r"[^\n]", " ", m[0])
    return re.sub(pattern, blank, text, flags=re.S)


def main(check, description):
    """Runs one lint over --root and exits 1 if it finds something."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    root = parser.parse_args().root.resolve()
    findings = list(check(root))
    for path, line, text in findings:
        print(f"{path.relative_to(root)}:{line}: {text}")
    sys.exit(1 if findings else 0)
