# SPDX-License-Identifier: MIT
"""Shared by the benchmarks: runs of TIP4P water, larger boxes of it, and the time that a process takes."""

import os
import resource
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path += [str(ROOT / "studies"), str(ROOT / "bench/peers")]
import gro  # noqa: E402
from lib import runs  # noqa: E402


def run_file(molecules=512, start="w512", prefix="out", **tables):
    """A run file without trajectory and figure. tables: its other tables, such as forces={"precision": "mixed"}."""
    system = {"molecules": runs.molecules("tip4p", molecules), "initial_configuration": start, **tables.pop("system", {})}
    return runs.run_file(system=system, **{**tables, "output": {"prefix": prefix, **runs.QUIET, **tables.get("output", {})}})


def replicate(source, target, n):
    """Writes n × n × n copies of a configuration of waters in GRO format."""
    copies = gro.replicated(gro.read(Path(source).read_text(encoding="utf-8")), n)
    Path(target).write_text(gro.written(copies, f"{n}³ copies"), encoding="utf-8")


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
