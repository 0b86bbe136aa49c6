# SPDX-License-Identifier: MIT
"""Shared by the benchmarks: runs of TIP4P water, larger boxes of it, and the time that a process takes."""

import itertools
import os
import resource
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "studies"))
from lib import runs  # noqa: E402


def run_file(molecules=512, start="w512", prefix="out", **tables):
    """A run file without trajectory and figure. tables: its other tables, such as forces={"precision": "mixed"}."""
    system = {"molecules": runs.molecules("tip4p", molecules), "initial_configuration": start, **tables.pop("system", {})}
    return runs.run_file(system=system, **{**tables, "output": {"prefix": prefix, **runs.QUIET, **tables.get("output", {})}})


def replicate(source, target, n):
    """Writes n × n × n copies of a configuration in GRO format; molecules stay together."""
    lines = Path(source).read_text(encoding="utf-8").splitlines()
    atoms, edges = lines[2:-1], [float(word) for word in lines[-1].split()[:3]]
    first = atoms[0].index(".")
    width = atoms[0].index(".", first + 1) - first  # of a column
    with Path(target).open("w", encoding="utf-8") as out:
        print(f"{n}³ copies", len(atoms) * n**3, sep="\n", file=out)
        for shift in itertools.product(range(n), repeat=3):
            for atom in atoms:
                place = (float(atom[20 + width * d:20 + width * (d + 1)]) + shift[d] * edges[d] for d in range(3))
                print(atom[:20] + "".join(f"{x:{width}.{width - 5}f}" for x in place) + atom[20 + 3 * width:], file=out)
        print(*(f"{n * edge:.9f}" for edge in edges), file=out)


def start(copies, folder):
    """The molecules of a box of copies of 512 waters along each edge, and its configuration, which is made in the folder."""
    if copies == 1:
        return 512, "w512"
    replicate(ROOT / "data/start/w512.gro", folder / f"w{512 * copies**3}.gro", copies)
    return 512 * copies**3, f"w{512 * copies**3}.gro"


def spent(command, folder=None, **environment):
    """(wall-clock time, user time) of a process [s]; the benchmark ends if the process fails."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime, time.perf_counter()
    done = subprocess.run(command, cwd=folder, env={**os.environ, **environment}, check=False, text=True, capture_output=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
