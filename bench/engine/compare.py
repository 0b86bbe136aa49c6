#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the time per step of two builds of polhode in alternating runs: the current program, and the program of an
earlier commit. The earlier program is built if necessary. The ratio of the two times in a round hardly depends on other
load of the computer."""

import argparse
import datetime
import itertools
import os
import statistics
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "bench"), str(ROOT / "studies")]
import water  # noqa: E402
from lib import study  # noqa: E402

FORCES = {"reaction-field": {"electrostatics": "reaction-field", "truncation": "molecule-switch"},
          "site-switch": {"electrostatics": "reaction-field", "truncation": "site-switch"},
          "ewald": {"electrostatics": "pme"}}
MAX_TRIES = 20
STEP = 0.002  # [ps]


class Case(NamedTuple):
    forces: str  # or the path of a run file, which then sets precision and molecules
    precision: str
    molecules: int
    instruction_set: str
    threads: int


def arguments():
    words = lambda text: text.split(",")
    numbers = lambda text: [int(word) for word in text.split(",")]
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("base", help="a commit, or the path of a program")
    p.add_argument("--polhode", default="polhode", help="the current program")
    p.add_argument("--forces", type=words, default=list(FORCES), help=",".join(FORCES))
    p.add_argument("--run-files", type=lambda text: [Path(word).resolve() for word in text.split(",")], default=[], metavar="FILE,...",
                   help="runs of these files in place of water: without equilibration, trajectory and figure")
    p.add_argument("--precisions", type=words, default=["mixed", "double"], help="mixed,double")
    p.add_argument("--sizes", type=numbers, default=[512], help="waters, 512 n³ (512)")
    p.add_argument("--sets", type=words, default=[""], help="instruction sets (the best one of the processor)")
    p.add_argument("--threads", type=numbers, default=[1], help="(1)")
    p.add_argument("--rounds", type=int, default=7, help="runs of each program (7)")
    p.add_argument("--seconds", type=float, default=1, help="of a run, approximately (1)")
    p.add_argument("--cpu-time", action="store_true", help="user time instead of wall-clock time: for one thread on a busy computer")
    p.add_argument("--json", type=Path, metavar="FILE", help="write all results to this file")
    p.add_argument("--figures", type=Path, metavar="PREFIX", help="draw PREFIX-sizes.svg and PREFIX-threads.svg of the program; for one precision and set")
    o = p.parse_args()
    for size in o.sizes:
        if 512 * copies(size) ** 3 != size:
            p.error(f"--sizes: {size} is not 512 n³; use 512, 4096, 13824, 32768, ...")
    if missing := [path for path in o.run_files if not path.is_file()]:
        p.error(f"--run-files: {missing[0]} does not exist")
    if o.figures and o.run_files:
        p.error("--figures are of water: leave out --run-files")
    if o.figures and len(o.precisions) * len(o.sets) > 1:
        p.error("--figures: give one precision and one instruction set")
    o.json, o.figures = o.json and o.json.resolve(), o.figures and o.figures.resolve()
    o.polhode, o.base_program = study.program(o.polhode), base_program(o.base)
    return o


def copies(size):
    """Number of copies of the 512-water box along each edge."""
    return round((size / 512) ** (1 / 3))


def base_program(base):
    """The program at a path, or the program of a commit, built in build/base-COMMIT."""
    if Path(base).is_file():
        return study.program(base)
    git = lambda *words: subprocess.run(["git", "-C", ROOT, *words], check=True, text=True, stdout=subprocess.PIPE).stdout.strip()
    commit = git("rev-parse", "--short", "--verify", base + "^{commit}")
    folder = ROOT / "build" / f"base-{commit}"
    if not folder.exists():
        git("worktree", "add", "--detach", folder, commit)
    build = folder / "build/release"
    for command in (["cmake", "--preset", "release"], ["cmake", "--build", build, "--target", "polhode_cli"]):
        subprocess.run(command, cwd=folder, check=True, stdout=sys.stderr)
    return str(build / "polhode")


def run_file(case, steps):
    start = "w512" if case.molecules == 512 else f"w{case.molecules}.gro"
    if start.endswith(".gro") and not Path(start).exists():
        water.replicate("w512.gro", start, copies(case.molecules))
    return water.run_file(case.molecules, start, forces={"cutoff": "0.9 nm", "precision": case.precision, **FORCES[case.forces]},
                          integrator={"scheme": "velocity-verlet", "step": f"{STEP} ps"},
                          run={"length": f"{steps * STEP:.6f} ps", "shadow_sample": "0 fs"})


def run_options(case, steps):
    """The run file of a case, and its options."""
    if Path(case.forces).is_file():
        return [case.forces, "--length", f"{steps * file_step(case.forces):.17g} ps", "--output", "out"]
    Path("run.toml").write_text(run_file(case, steps), encoding="utf-8")
    return ["run.toml"]


def file_step(path):
    """[ps]"""
    number, unit = tomllib.loads(Path(path).read_text(encoding="utf-8"))["integrator"]["step"].split()
    return float(number) * {"fs": 1e-3, "ps": 1}[unit]


def seconds(program, case, steps, cpu_time):
    environment = {"POLHODE_INSTRUCTION_SET": case.instruction_set} if case.instruction_set else {}
    wall, user = water.spent([program, "run", *run_options(case, steps), "--force", "--json", "--threads", str(case.threads)], **environment)
    return user if cpu_time else wall


def time_per_step(program, case, steps, cpu_time):
    """Time of only the steps [ms], as the difference of a long and a short run. If other processes made the short run take
    longer, both are repeated."""
    few = max(1, steps // 20)
    for _ in range(MAX_TRIES):
        taken = seconds(program, case, steps, cpu_time) - seconds(program, case, few, cpu_time)
        if taken > 0:
            return 1e3 * taken / (steps - few)
    sys.exit(f"{steps} steps took less time than {few} steps in {MAX_TRIES} attempts; use a larger --seconds, or an idle machine")


def enough_steps(o, case):
    """Number of steps in a run of about the requested time. A run is doubled until it takes 10 % of this time."""
    steps = 20
    while (taken := seconds(o.base_program, case, steps, o.cpu_time) - seconds(o.base_program, case, 1, o.cpu_time)) < o.seconds / 10:
        steps *= 2
    return max(20, round(steps * o.seconds / taken))


def compared(o, case):
    steps = enough_steps(o, case)
    base, now = [], []
    for _ in range(o.rounds):
        base.append(time_per_step(o.base_program, case, steps, o.cpu_time))
        now.append(time_per_step(o.polhode, case, steps, o.cpu_time))
    gains = [b / n for b, n in zip(base, now)]
    return {**case._asdict(), "steps": steps, "base_ms": min(base), "now_ms": min(now),
            "faster": statistics.median(gains), "range": [min(gains), max(gains)]}


def cases(o):
    kinds = [(str(path), "", 0) for path in o.run_files] or itertools.product(o.forces, o.precisions, o.sizes)
    return [Case(*kind, *how) for kind, how in itertools.product(kinds, itertools.product(o.sets, o.threads))]


def main():
    o = arguments()
    result = {"date": datetime.date.today().isoformat(), "processor": study.processor(), "base": Path(o.base).name,
              "time": "user" if o.cpu_time else "wall-clock", "rounds": o.rounds, "cases": []}
    print(f"{'forces':>14} {'precision':>9} {'waters':>7} {'set':>7} {'threads':>7} | ms a step: base, now | times faster (range of {o.rounds})")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        if not o.run_files:
            Path("w512.gro").write_text(liquid(o), encoding="utf-8")
        for case in cases(o):
            r = {**compared(o, case), "forces": Path(case.forces).name}
            result["cases"].append(r)
            print(f"{r['forces']:>14} {case.precision:>9} {case.molecules or '':>7} {case.instruction_set or 'best':>7} {case.threads:>7} | "
                  f"{r['base_ms']:.4g}, {r['now_ms']:.4g} | {r['faster']:.3f} ({r['range'][0]:.3f} to {r['range'][1]:.3f})", flush=True)
        os.chdir(ROOT)
    if o.json:
        study.write(o.json, result)
    if o.figures:
        import figures  # imported only here, because measurements need no matplotlib
        figures.steps(result, o.figures)


def liquid(o):
    """512 waters in GRO format: the final configuration of a short run."""
    seconds(o.base_program, Case("reaction-field", "double", 512, "", 1), 5, False)
    return Path("out-final.gro").read_text(encoding="utf-8")


if __name__ == "__main__":
    main()
