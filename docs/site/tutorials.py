# SPDX-License-Identifier: MIT
"""Runs the tutorials and writes what their cells show, for the site.

    tutorials.py FOLDER

One file FOLDER/NAME.json for each page, with a list for each cell, of ["text", TEXT], ["html", HTML] and ["image", PNG in
base64]: what the cell prints, the value of its last expression, and its figures. Pages that have not changed since are kept,
as long as the package has not changed either.
"""

import ast
import base64
import contextlib
import hashlib
import io
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TUTORIALS = Path(__file__).resolve().parents[1] / "tutorials"
CELL = re.compile(r"^```\{code-cell\} python\n(.*?)^```$", re.M | re.S)


def run_cell(code, names):
    """What a cell shows."""
    import matplotlib.pyplot as plt

    shown, printed, tree = [], io.StringIO(), ast.parse(code)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)
        value = None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    if printed.getvalue():
        shown.append(["text", printed.getvalue()])
    if value is not None and not code.rstrip().endswith(";"):
        html = getattr(value, "_repr_html_", None)
        shown.append(["html", html()] if html else ["text", repr(value)])
    for number in plt.get_fignums():
        file = io.BytesIO()
        plt.figure(number).savefig(file, format="png", dpi=110, bbox_inches="tight")
        shown.append(["image", base64.b64encode(file.getvalue()).decode()])
    plt.close("all")
    return shown


def run_page(page):
    """What the cells of a page show, in order."""
    import matplotlib

    matplotlib.use("Agg")
    names = {}
    return [run_cell(code, names) for code in CELL.findall(page.read_text(encoding="utf-8"))]


def stamp(page):
    """Of a page and the package that runs it."""
    from polhode import _core

    package = Path(_core.__file__)
    files = [page, Path(__file__), package, *sorted(package.parent.glob("*.py"))]
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def main():
    folder = Path(sys.argv[1]).resolve()
    if len(sys.argv) == 3:  # a page, in a process of its own
        page = Path(sys.argv[2])
        (folder / f"{page.stem}.json").write_text(json.dumps([stamp(page), run_page(page)]), encoding="utf-8")
        return
    folder.mkdir(parents=True, exist_ok=True)
    for page in sorted(TUTORIALS.glob("*.md")):
        file = folder / f"{page.stem}.json"
        if page.stem == "README" or file.exists() and json.loads(file.read_text(encoding="utf-8"))[0] == stamp(page):
            continue
        with tempfile.TemporaryDirectory() as empty:
            subprocess.run([sys.executable, __file__, folder, page], cwd=empty, check=True)


main()
