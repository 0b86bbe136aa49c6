# SPDX-License-Identifier: MIT
"""The tutorials and all other pages with Python: the code of each page runs in order, in a folder of its own."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import package

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGES = [p for p in sorted((DOCS / "tutorials").glob("*.md")) if p.stem != "README"]
CELL = re.compile(r"^```(?:\{code-cell\} python|python)\n(.*?)^```$", re.M | re.S)
FRONT = re.compile(r"---\n(jupytext:\n.*?\nkernelspec:\n.*?)\n---\n\n# ", re.S)


def cells(page):
    """The code of a page, with its line numbers, as one program."""
    text = page.read_text(encoding="utf-8")
    program, line = "import matplotlib\nmatplotlib.use('Agg')\n", 0
    for cell in CELL.finditer(text):
        line = text.count("\n", 0, cell.start(1))
        program += f"exec(compile({cell[1]!r}.rjust({line} + {len(cell[1])}, chr(10)), " \
                   f"{page.name!r}, 'exec'))\n"
    return program, line > 0


def make_test(page):
    def test(self):
        program, any_cell = cells(page)
        self.assertTrue(any_cell, "the page has no cells")
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run([sys.executable, "-c", program], cwd=folder, text=True,
                                    capture_output=True, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
    return test


class Tutorials(unittest.TestCase):
    def test_there_are_some(self):
        self.assertGreater(len(PAGES), 3)

    def test_jupyter_knows_their_format_and_kernel(self):
        """What jupytext needs to open a page as a notebook: without it the cells are text."""
        for page in PAGES:
            front = FRONT.match(page.read_text(encoding="utf-8"))
            self.assertIsNotNone(front, f"{page.name} does not begin with a front matter; copy that of another page")
            for line in ("    format_name: myst", "  language: python", "  name: python3"):
                self.assertIn(line, front[1].splitlines(), page.name)

    def test_jupytext_finds_every_cell(self):
        jupytext = package.optional("jupytext")
        for page in PAGES:
            found = [cell.source for cell in jupytext.read(page).cells if cell.cell_type == "code"]
            self.assertEqual(found, [cell[1].rstrip() for cell in CELL.finditer(page.read_text(encoding="utf-8"))],
                             page.name)


OTHERS = [p for p in (DOCS.parent / "README.md", *sorted(DOCS.rglob("*.md")))
          if p not in PAGES and CELL.search(p.read_text(encoding="utf-8"))]

for path in (*PAGES, *OTHERS):
    setattr(Tutorials, f"test_{path.relative_to(DOCS.parent).with_suffix('').as_posix().replace('-', '_')}", make_test(path))

if __name__ == "__main__":
    package.main()
