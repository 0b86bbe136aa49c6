# SPDX-License-Identifier: MIT
"""Runs every command of the README, the guides and the manual with the built program.

Per document, in order, in an empty folder where `polhode` is the built program:
a block fenced as ```sh is run by bash and stops at the first command that fails; ```sh no-run is
skipped (set-up, long studies); a ```toml or ```text block below `<!-- file: NAME -->` is written to NAME.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

FENCE = re.compile(r"^```(.*?)\n(.*?)^```\s*$", re.S | re.M)
NAMED = re.compile(r"<!--\s*file:\s*(\S+)\s*-->\s*\Z")
LONGEST_BLOCK = 300  # seconds


class Block(NamedTuple):
    line: int      # of the first line inside the fence
    kind: str      # what follows the fence: "sh", "sh no-run", "toml"
    text: str
    file: str      # where a toml block goes, or ""


def blocks(document):
    text = document.read_text(encoding="utf-8")
    for fence in FENCE.finditer(text):
        name = NAMED.search(text[:fence.start()])
        yield Block(text.count("\n", 0, fence.start(2)) + 1, fence[1].strip(), fence[2],
                    name[1] if name else "")


def run_block(block, shown, folder):
    """Runs one block; True if every command of it ended with 0."""
    padding = "\n" * (block.line - 2)  # so that bash counts the document's lines
    script = f"""trap 'echo "{shown}:$LINENO: exit code $?: $BASH_COMMAND" >&2' ERR; set -eEuo pipefail
{padding}{block.text}"""
    path = os.pathsep.join((str(folder / "bin"), os.environ["PATH"]))
    try:
        run = subprocess.run(["bash", "-c", script], cwd=folder / "here", text=True, timeout=LONGEST_BLOCK,
                             env={**os.environ, "PATH": path}, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    except subprocess.TimeoutExpired:
        print(f"{shown}:{block.line}: longer than {LONGEST_BLOCK} s; shorten it, or tag it 'sh no-run'")
        return False
    if run.returncode != 0:
        print(f"{run.stdout}\n{shown}:{block.line}: a command of this block ended with "
              f"{run.returncode}; correct the document or the program")
    return run.returncode == 0


def run_document(document, shown, program):
    """(number of blocks run, number of blocks that failed)."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        (folder / "bin").mkdir()
        (folder / "here").mkdir()
        (folder / "bin/polhode").symlink_to(program)
        count = wrong = 0
        for block in blocks(document):
            if block.kind in ("toml", "text") and block.file:
                (folder / "here" / block.file).write_text(block.text, encoding="utf-8")
            elif block.kind == "sh":
                count += 1
                wrong += not run_block(block, shown, folder)
    return count, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options = parser.parse_args()
    root, program = options.root.resolve(), options.program.resolve()
    if not os.access(program, os.X_OK):
        sys.exit(f"{program.name} is not built; build it first")
    documents = [root / "README.md", *sorted((root / "docs").glob("*.md")), *sorted((root / "docs/manual").rglob("*.md"))]
    bad = 0
    for document in documents:
        shown = document.relative_to(root)
        count, wrong = run_document(document, shown, program)
        print(f"{shown}: {count} blocks run, {wrong} wrong")
        bad += wrong
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
