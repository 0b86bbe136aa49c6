#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Time per step with a thermostat and a barostat, relative to constant energy with the same scheme and step. The user
times of alternating runs are measured, without the first quarter of the steps. The system is 512 TIP4P waters in mixed
precision."""

import argparse
import os
import statistics
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

sys.path.append(str(Path(__file__).resolve().parents[1]))
import water  # noqa: E402
from lib import study  # noqa: E402

LANGEVIN, RESCALING = ({"thermostat": {"type": name}} for name in ("langevin", "rescaling"))
CELL, MOVES = ({"barostat": {"type": name, "pressure": "1 bar"}} for name in ("cell-rescaling", "monte-carlo"))


class Ensemble(NamedTuple):
    name: str
    scheme: str
    constant_energy: str  # the scheme without a bath
    step: int  # [fs]
    tables: dict


ENSEMBLES = (
    Ensemble("Langevin, ends", "hoa2-ends", "hoa2", 4, LANGEVIN),
    Ensemble("Langevin, middle", "hoa2-middle", "hoa2", 4, LANGEVIN),
    Ensemble("Langevin, baoab", "baoab", "velocity-verlet", 2, LANGEVIN),
    Ensemble("Langevin, obabo", "obabo", "velocity-verlet", 2, LANGEVIN),
    Ensemble("rescaling", "hoa2", "hoa2", 4, RESCALING),
    Ensemble("rescaling", "velocity-verlet", "velocity-verlet", 2, RESCALING),
    Ensemble("Langevin, cell rescaling", "hoa2-ends", "hoa2", 4, LANGEVIN | CELL),
    Ensemble("Langevin, cell rescaling", "baoab", "velocity-verlet", 2, LANGEVIN | CELL),
    Ensemble("Langevin, Monte Carlo", "hoa2-ends", "hoa2", 4, LANGEVIN | MOVES),
    Ensemble("Langevin, Monte Carlo", "baoab", "velocity-verlet", 2, LANGEVIN | MOVES))


def seconds(program, electrostatics, scheme, step, tables, steps):
    """User time of a run."""
    Path("run.toml").write_text(water.run_file(
        system={"temperature": "298 K"}, forces={"cutoff": "0.9 nm", "precision": "mixed", "electrostatics": electrostatics},
        integrator={"scheme": scheme, "step": f"{step} fs"}, **tables,
        run={"length": f"{step * steps} fs", "sample": f"{100 * step} fs", "shadow_sample": "0 fs"}), encoding="utf-8")
    return water.spent([program, "run", "run.toml", "--force", "--threads", "1"])[1]


def time_per_step(few, many, *case):
    """Time of only the steps [ms], as the difference of a long and a short run."""
    return 1000 * (seconds(*case, many) - seconds(*case, few)) / (many - few)


def main():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("--program", default="polhode")
    p.add_argument("--electrostatics", nargs="+", default=["reaction-field", "pme"], choices=["reaction-field", "pme"])
    p.add_argument("--ensembles", nargs="+", default=[e.scheme for e in ENSEMBLES], help="only those with these schemes")
    p.add_argument("--steps", type=int, default=4000, help="of the long runs; a multiple of 100, so that barostats move (4000)")
    p.add_argument("--rounds", type=int, default=7, help="runs of each (7)")
    o = p.parse_args()
    short = max(o.steps // 400, 1) * 100  # this run computes and stores the mesh errors that the first boxes need
    program = study.program(o.program)
    print("| electrostatics | ensemble | scheme, step | constant energy [ms per step] | ratio: median | smallest and largest |\n"
          "| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for electrostatics in o.electrostatics:
            for e in ENSEMBLES:
                if e.scheme not in o.ensembles:
                    continue
                reference, ratios = [], []
                for _ in range(o.rounds):
                    reference.append(time_per_step(short, o.steps, program, electrostatics, e.constant_energy, e.step, {}))
                    ratios.append(time_per_step(short, o.steps, program, electrostatics, e.scheme, e.step, e.tables) / reference[-1])
                print(f"| {electrostatics} | {e.name} | {e.scheme}, {e.step} fs | {statistics.median(reference):.3f} "
                      f"| {statistics.median(ratios):.3f} | {min(ratios):.3f} to {max(ratios):.3f} |", flush=True)


if __name__ == "__main__":
    main()
