# SPDX-License-Identifier: MIT
"""Runs of the program, from run files that are dictionaries."""

import contextlib
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

QUIET = {"trajectory_every": "0 ps", "plot": "none"}  # of [output]: neither trajectory nor figure


def value(x):
    """A value as TOML."""
    if isinstance(x, bool):
        return str(x).lower()
    if isinstance(x, dict):
        return "{ " + ", ".join(f"{key} = {value(v)}" for key, v in x.items()) + " }"
    if isinstance(x, (list, tuple)):
        return "[" + ", ".join(map(value, x)) + "]"
    return f'"{x}"' if isinstance(x, (str, Path)) else f"{x:.12g}"


def run_file(**tables):
    """The text of a run file from its tables; keys whose value is None are omitted."""
    return "\n".join(f"[{name}]\n" + "".join(f"{key} = {value(x)}\n" for key, x in table.items() if x is not None)
                     for name, table in tables.items() if table is not None)


def molecules(*of):
    """molecules("spce", 64, "na-spce", 3) for the key of [system]."""
    return [{"model": model, "count": count} for model, count in zip(of[::2], of[1::2])]


def called(o, *words, folder, **environment):
    """The output of the program; the study ends if the program fails."""
    done = subprocess.run([o.program, *map(str, words)], cwd=folder, text=True, capture_output=True, check=False, env={**os.environ, **environment})
    if done.returncode:
        raise SystemExit(f"polhode {' '.join(map(str, words))}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def asked(o, *words, folder, **environment):
    """The JSON output of the program."""
    return json.loads(called(o, *words, "--json", folder=folder, **environment))


def run(o, tables, folder, *words, name="run"):
    """The report of a run with files in the folder."""
    Path(folder, f"{name}.toml").write_text(run_file(**tables), encoding="utf-8")
    return asked(o, "run", f"{name}.toml", "--threads", 1, "--force", *words, folder=folder)


def scratch(o=None):
    """A folder: the folder of the option, or a temporary one."""
    return contextlib.nullcontext(o.folder) if o and o.folder else tempfile.TemporaryDirectory()


def kept(folder, name, make):
    """The JSON of a file; if the file does not exist, make() gives the contents."""
    path = Path(folder, f"{name}.json")
    if not path.exists():
        path.write_text(json.dumps(make()), encoding="utf-8")
    return json.loads(path.read_text(encoding="utf-8"))


def parallel(o, work, cases):
    """[work(case)] in the order of cases, several at a time."""
    done = []
    with ThreadPoolExecutor(o.jobs) as pool:
        for case, result in zip(cases, pool.map(work, cases)):
            done.append(result)
            print(f"{len(done)} of {len(cases)}: {case}", file=sys.stderr, flush=True)
    return done


def columns(path):
    """A CSV file of the program as a table. Column names have no units."""
    import pandas  # only here: benchmarks need none
    return pandas.read_csv(path, comment="#").rename(columns=lambda name: name.split(" [")[0])


UNKNOWN = {"value": None, "unconverged_estimate": float("nan")}


def number(estimate):
    """The value of an estimate. If the run is too short, it is the preliminary value, because the mean over many runs may determine it."""
    return estimate["value"] if estimate["value"] is not None else estimate.get("unconverged_estimate")
