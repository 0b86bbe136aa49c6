# SPDX-License-Identifier: MIT
"""Runs every command of the README, the guides, the tasks and the manual with the built program.

Per document, in order, in an empty folder where `polhode` is the built program and POLHODE the folder of the project:
a block fenced as ```sh is run by bash and stops at the first command that fails; ```sh no-run is
skipped (set-up, long studies); any other block below `<!-- file: NAME -->` is written to NAME, the first one of a name
before all commands. Each line of a block below
`<!-- output -->` must be in the output of the last commands, in this order, up to numbers and spaces; "..." is any text.
A --time-limit of a measurement is shortened, because a reader waits for a result and this test does not.
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
OUTPUT = re.compile(r"<!--\s*output\s*-->\s*\Z")
TIME_LIMIT = re.compile(r'--time-limit "\d+ s"')
NUMBER = re.compile(r"[+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
LONGEST_BLOCK = 300  # seconds
ROOT = Path(__file__).resolve().parents[2]
PAGES = ("README.md", "docs/*.md", "docs/tasks/*.md", "docs/manual/**/*.md")


class Block(NamedTuple):
    line: int      # of the first line inside the fence
    kind: str      # what follows the fence: "sh", "sh no-run", "toml"
    text: str
    file: str      # where the block goes, or ""
    is_output: bool


def blocks(document):
    text = document.read_text(encoding="utf-8")
    for fence in FENCE.finditer(text):
        name = NAMED.search(text[:fence.start()])
        yield Block(text.count("\n", 0, fence.start(2)) + 1, fence[1].strip(), fence[2],
                    name[1] if name else "", bool(OUTPUT.search(text[:fence.start()])))


def without_numbers(line):
    return " ".join(NUMBER.sub("0", line).split())


def missing_line(shown, output):
    """The first line of a shown output that is not in the output behind the lines before it, or None."""
    lines = iter(without_numbers(line) for line in output.splitlines())
    for line in shown.splitlines():
        pattern = re.escape(without_numbers(line)).replace(re.escape("..."), ".*")
        if line.strip() not in ("", "...") and not any(re.fullmatch(pattern, other) for other in lines):
            return line
    return None


def run_block(block, shown, folder):
    """Runs one block; whether every command of it ended with 0, and its output."""
    padding = "\n" * (block.line - 2)  # so that bash counts the document's lines
    script = f"""trap 'echo "{shown}:$LINENO: exit code $?: $BASH_COMMAND" >&2' ERR; set -eEuo pipefail
{padding}{TIME_LIMIT.sub('--time-limit "2 s"', block.text)}"""
    path = os.pathsep.join((str(folder / "bin"), os.environ["PATH"]))
    try:
        run = subprocess.run(["bash", "-c", script], cwd=folder / "here", text=True, timeout=LONGEST_BLOCK,
                             env={**os.environ, "PATH": path, "POLHODE": str(ROOT)}, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    except subprocess.TimeoutExpired:
        print(f"{shown}:{block.line}: longer than {LONGEST_BLOCK} s; shorten it, or tag it 'sh no-run'")
        return False, ""
    if run.returncode != 0:
        print(f"{run.stdout}\n{shown}:{block.line}: a command of this block ended with "
              f"{run.returncode}; correct the document or the program")
    return run.returncode == 0, run.stdout


def run_document(document, shown, program):
    """(number of blocks run, number of blocks that failed)."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        (folder / "bin").mkdir()
        (folder / "here").mkdir()
        (folder / "bin/polhode").symlink_to(program)
        all_blocks = list(blocks(document))
        for block in reversed(all_blocks):
            if block.file:
                (folder / "here" / block.file).write_text(block.text, encoding="utf-8")
        count = wrong = 0
        output = ""
        for block in all_blocks:
            if block.file:
                (folder / "here" / block.file).write_text(block.text, encoding="utf-8")
            elif block.is_output:
                missing = missing_line(block.text, output)
                wrong += missing is not None
                if missing is not None:
                    print(f"{output}\n{shown}:{block.line}: '{missing}' is not in this output; show what is printed")
            elif block.kind == "sh":
                count += 1
                done, output = run_block(block, shown, folder)
                wrong += not done
    return count, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--root", type=Path, default=ROOT)
    parser.add_argument("pages", nargs="*", default=PAGES, help="patterns of pages, relative to the root; default: all")
    options = parser.parse_args()
    root, program = options.root.resolve(), options.program.resolve()
    if not os.access(program, os.X_OK):
        sys.exit(f"{program.name} is not built; build it first")
    bad = 0
    for document in (page for pattern in options.pages for page in sorted(root.glob(pattern))):
        shown = document.relative_to(root)
        count, wrong = run_document(document, shown, program)
        print(f"{shown}: {count} blocks run, {wrong} wrong")
        bad += wrong
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
