# SPDX-License-Identifier: MIT
"""Shared by the tests of the documents: their options, pages that a test writes, and the report."""

import argparse
import sys
from pathlib import Path


def options(description, write=None, program=False):
    """The options of a test: --root, --program if it runs the program, and --write if it can bring pages up to date."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    if program:
        parser.add_argument("--program", type=Path, required=True)
    if write:
        parser.add_argument("--write", action="store_true", help=write)
    given = parser.parse_args()
    for name, path in vars(given).items():
        if isinstance(path, Path):
            setattr(given, name, path.resolve())
    return given


def is_current(page, text, write):
    """Whether a page has a text; with `write` it then has."""
    if page.exists() and page.read_text(encoding="utf-8") == text:
        return True
    if write:
        page.write_text(text, encoding="utf-8")
    return write


def report(wrong, sound):
    """Prints what is wrong and exits 1, or says what is sound."""
    wrong = list(wrong)
    print("\n".join(wrong) or sound)
    sys.exit(1 if wrong else 0)
