# SPDX-License-Identifier: MIT
"""The framework of all studies: options, record, tables and figure."""

import argparse
import json
import os
import platform
import shlex
import sys
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WIDTH = 300  # characters of a line of a record


def options(doc, smoke, **own):
    """The options of a study. own: name=(default, help), of the type of the default; smoke: values of the shortest study that still
    runs everything, which replace defaults where --smoke is given."""
    name = Path(sys.argv[0]).stem.replace("_", "-")
    p = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--program", default="polhode", help="the program")
    p.add_argument("--jobs", type=int, default=1, help="simultaneous runs (1)")
    p.add_argument("--record", type=Path, default=Path(f"{name}.json"), help=f"what all runs report ({name}.json)")
    p.add_argument("--report", action="store_true", help="print and draw what the record has; no runs")
    p.add_argument("--figure", type=Path, help="an image, SVG or PNG")
    p.add_argument("--folder", type=Path, help="where runs are kept: finished ones are not repeated")
    p.add_argument("--smoke", action="store_true", help="seconds: everything runs, results mean nothing")
    for option, (default, text) in own.items():
        many = isinstance(default, (list, tuple))
        kind = {} if isinstance(default, bool) else {"type": type(default[0] if many else default), "nargs": "+" if many else None}
        shown = " ".join(f"{x}" for x in default) if many else f"{default}"
        p.add_argument("--" + option.replace("_", "-"), default=default, help=f"{text} ({shown})".replace("%", "%%"),
                       **({"action": "store_true"} if isinstance(default, bool) else kind))
    if "--smoke" in sys.argv:
        p.set_defaults(**smoke)
    o = p.parse_args()
    o.command = shlex.join([f"studies/{Path(sys.argv[0]).name}", *sys.argv[1:]])
    o.program = program(o.program)
    if o.folder:
        o.folder = o.folder.resolve()
        o.folder.mkdir(parents=True, exist_ok=True)
    return o


def program(name):
    """A program as typed: a path, made absolute, or a name that the shell finds."""
    return str(Path(name).resolve()) if Path(name).exists() else name


def processor():
    """The name of the processor."""
    try:
        return next(line.split(":", 1)[1].strip() for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
                    if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def head(o):
    """The first part of every record."""
    return {"date": str(date.today()), "processor": processor(), "command": o.command}


def as_json(value, indent=0):
    """JSON with as few lines as are readable."""
    line = json.dumps(value, ensure_ascii=False)
    if indent + len(line) <= WIDTH or not isinstance(value, (dict, list)):
        return line
    if isinstance(value, dict):
        entries = [json.dumps(key, ensure_ascii=False) + ": " + as_json(v, indent + 1) for key, v in value.items()]
    else:
        entries = [as_json(v, indent + 1) for v in value]
    blanks = "\n" + " " * (indent + 1)
    return ("{" if isinstance(value, dict) else "[") + blanks + ("," + blanks).join(entries) + blanks[:-1] + ("}" if isinstance(value, dict) else "]")


def write(path, value):
    """Writes a record; a study that is interrupted there keeps the old one."""
    new = path.with_name(path.name + ".new")
    new.write_text(as_json(value) + "\n", encoding="utf-8")
    os.replace(new, path)


def read(path):
    return json.loads(path.read_text(encoding="utf-8"))


def perform(o, measure, report, draw=None):
    """Performs a whole study. measure(o) gives the contents of the record below its head, report(result) the tables in Markdown, and
    draw(result) a matplotlib figure."""
    if not o.report:
        write(o.record, head(o) | measure(o))
    result = read(o.record)
    print(report(result))
    if o.figure and draw:
        from . import figures  # only here: tables need no matplotlib
        figures.save(draw(result), o.figure)


def table(heads, rows):
    """A table in Markdown."""
    return "\n".join(["| " + " | ".join(map(str, heads)) + " |", "|" + " --- |" * len(heads), *("| " + " | ".join(map(str, row)) + " |" for row in rows)]) + "\n"
