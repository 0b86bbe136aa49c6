# SPDX-License-Identifier: MIT
"""A study with --smoke: it runs the program, keeps its record, prints its tables from it again, and draws its figure."""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def done(folder, *command):
    process = subprocess.run([sys.executable, "-B", *map(str, command)], cwd=folder, text=True, capture_output=True, check=False)
    if process.returncode:
        sys.exit(process.stdout + process.stderr)
    return process.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study")
    parser.add_argument("--program", type=Path, required=True)
    o = parser.parse_args()
    script = ROOT / f"studies/{o.study}.py"
    text = script.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        figure = [] if "draw" not in text else ["--figure", "figures" if o.study == "half_femtosecond" else "figure.svg"]
        first = done(folder, script, "--smoke", "--program", o.program.resolve(), *figure)
        if "| --- |" not in first:
            sys.exit(f"no table:\n{first}")
        record = next(iter(folder.glob("*.json*")), None)
        if record:
            if first != done(folder, script, "--smoke", "--report"):
                sys.exit("the record gives another report")
            text = record.read_text(encoding="utf-8")
            begin = json.loads(text.splitlines()[0] if record.suffix == ".jsonl" else text)
            if not {"date", "processor", "command"} <= set(begin):
                sys.exit(f"the record does not say how it was made: {list(begin)}")
        if figure and not [path for path in folder.rglob("*.svg") if "<svg" in path.read_text(encoding="utf-8")]:
            sys.exit("no figure")


if __name__ == "__main__":
    main()
