#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Time per step of water in LAMMPS on one process, compared with polhode. The inputs are pair_style polhode with fix
polhode, with atoms or with one particle per molecule, and fix polhode and fix rigid/nve/small with pair styles of LAMMPS.
The fastest of these is lj/cut for the pairs of oxygen alone, with a style for all charges, from the package OPENMP. All
runs have a cutoff of 1 nm and a step of 2 fs, with a reaction field or a plain cutoff of charges, or with PPPM.

    bench/lammps/cost.py --polhode ./polhode --environment FOLDER --plugin polhodeplugin.so

It prints a table. Times are user times: the difference of two runs of different lengths, and the minimum over rounds. They
hardly depend on other load of the computer. FOLDER is the folder that lammps/environment.py makes.
"""

import argparse
import datetime
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "studies"), str(ROOT / "bench")]
import water  # noqa: E402
from lib import study  # noqa: E402

SCRIPT = """plugin load {plugin}
units real
atom_style full
neighbor 1.0 bin
pair_style {style}
bond_style zero
special_bonds lj/coul 0 0 0
read_data water.data nocoeff
bond_coeff *
{coefficients}
{mesh}
replicate {copies} {copies} {copies}
fix rigid all {fix}
timestep 2
thermo 100
run {steps}
"""

PARTICLES = """plugin load {plugin}
units real
atom_style atomic
atom_modify map yes
neighbor 1.0 bin
pair_style {style}
fix orientations all property/atom d2_orientation 4 d2_angular_momentum 3
read_data particles.data fix orientations NULL Orientations nocoeff
pair_coeff 1 1 0.155 3.1536
pair_coeff 2*4 2*4 0 0
fix rigid all {fix}
timestep 2
thermo 100
run {steps}
"""

ALL_PAIRS = "pair_coeff 1 1 0.155 3.1536\npair_coeff 2*3 2*3 0 0"
OXYGEN_ALONE = "pair_coeff * * coul/{0}\npair_coeff 1 1 lj/cut 0.155 3.1536"
OMP = ("-sf", "omp", "-pk", "omp", "1")  # styles of the package OPENMP, with one thread
FIX, OTHER = "polhode massless 3", "rigid/nve/small molecule"
PARTICLE = f"{FIX} particle 4 particles-1.molecule"


@dataclass
class Input:
    """Pair style and fix of an input of LAMMPS."""
    style: str
    fix: str = FIX
    coefficients: str = ALL_PAIRS
    options: tuple = ()  # of the command line
    mesh: bool = False

    def script(self, plugin, copies, steps):
        text = PARTICLES if self.fix == PARTICLE else SCRIPT
        mesh = "kspace_style pppm 1e-5\npair_modify table 0" if self.mesh else ""
        return text.format(plugin=plugin, copies=copies, steps=steps, **vars(self) | {"mesh": mesh})


STYLES = {
    "pair_style polhode, double": Input("polhode 10 electrostatics reaction-field"),
    "pair_style polhode, mixed": Input("polhode 10 electrostatics reaction-field precision mixed"),
    "one particle a molecule, double": Input("polhode 10 electrostatics reaction-field", PARTICLE),
    "one particle a molecule, mixed": Input("polhode 10 electrostatics reaction-field precision mixed", PARTICLE),
    "fix polhode, lj/cut/coul/cut": Input("lj/cut/coul/cut 10"),
    "rigid/nve/small, lj/cut/coul/cut": Input("lj/cut/coul/cut 10", OTHER),
    "rigid/nve/small, lj/cut/coul/cut/omp": Input("lj/cut/coul/cut 10", OTHER, options=OMP),
    "rigid/nve/small, lj/cut/omp and coul/cut/omp": Input("hybrid/overlay lj/cut 10 coul/cut 10", OTHER, OXYGEN_ALONE.format("cut"), OMP),
    "pair_style polhode, double, PPPM": Input("polhode 10 electrostatics pme", mesh=True),
    "pair_style polhode, mixed, PPPM": Input("polhode 10 electrostatics pme precision mixed", mesh=True),
    "pair_style polhode, mixed, PPPM/omp": Input("polhode 10 electrostatics pme precision mixed", options=OMP, mesh=True),
    "rigid/nve/small, lj/cut/coul/long, PPPM": Input("lj/cut/coul/long 10", OTHER, mesh=True),
    "rigid/nve/small, lj/cut/coul/long/omp, PPPM/omp": Input("lj/cut/coul/long 10", OTHER, options=OMP, mesh=True),
    "rigid/nve/small, lj/cut/omp and coul/long/omp, PPPM/omp": Input("hybrid/overlay lj/cut 10 coul/long 10", OTHER, OXYGEN_ALONE.format("long"), OMP, True),
}


def add_programs(parser, required=True):
    """The options for the programs, which all benchmarks of LAMMPS have."""
    parser.add_argument("--polhode", default="polhode", help="the program")
    parser.add_argument("--environment", type=Path, required=required, help="with LAMMPS")
    parser.add_argument("--plugin", type=Path, required=required)


def arguments():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_programs(p)
    p.add_argument("--copies", type=lambda text: [int(word) for word in text.split(",")], default=[1, 2],
                   help="of 512 waters along each edge (1,2)")
    p.add_argument("--rounds", type=int, default=3)
    p.add_argument("--steps", type=int, default=1000, help="of 512 waters; fewer of more (1000)")
    return p.parse_args()


class Bench:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.program = study.program(options.polhode)
        self.lmp = next(options.environment.resolve().glob("lib/python3*/site-packages/lammps/lmp"))
        self.mpiexec = options.environment.resolve() / "bin/mpiexec"
        self.environment = {"OMP_NUM_THREADS": "1", "LD_LIBRARY_PATH": str(options.environment.resolve() / "lib")}

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def run(self, command):
        return water.spent(command, self.folder, **self.environment)[1]

    def output(self, script, *options, launcher=()):
        """What LAMMPS prints, started by another program if there is one; the benchmark ends if it fails."""
        self.write("run.in", script)
        done = subprocess.run([*launcher, self.lmp, "-in", "run.in", "-log", "none", *options], cwd=self.folder,
                              env={**os.environ, **self.environment}, text=True, capture_output=True, check=False)
        if done.returncode:
            sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
        return done.stdout + done.stderr

    def export(self, text, style="table"):
        """Writes the LAMMPS input for a run file."""
        self.write("start.toml", text)
        self.run([self.program, "export", "lammps", "start.toml", "--pair-style", style, "--force"])

    def run_file(self, copies, steps, truncation="molecule-switch", precision="double", prefix="run"):
        return water.run_file(*water.start(copies, self.folder), prefix, system={"temperature": "297 K"},
                              forces={"truncation": truncation, "electrostatics": "reaction-field", "cutoff": "1 nm", "precision": precision},
                              integrator={"scheme": "velocity-verlet", "step": "2 fs"},
                              run={"length": f"{2 * steps} fs", "sample": "200 fs", "shadow_sample": "0 fs"})

    def polhode(self, copies, precision, steps):
        self.write("run.toml", self.run_file(copies, steps, precision=precision))
        return self.run([self.program, "run", "run.toml", "--force", "--threads", "1"])

    def lammps(self, copies, what, steps):
        self.write("run.in", what.script(self.options.plugin.resolve(), copies, steps))
        return self.run([self.lmp, "-in", "run.in", "-log", "none", *what.options])

    def step(self, work, copies):
        """Milliseconds."""
        steps = max(40, self.options.steps // copies**3)
        return min(1e3 * (work(steps + 20) - work(20)) / steps for _ in range(self.options.rounds))


def main():
    options = arguments()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options, Path(folder))
        bench.export(bench.run_file(1, 1000, truncation="site-switch", prefix="water"))
        print(f"{datetime.date.today()}, {study.processor()}\n")
        print("| waters | program | ms per step | against polhode in the same precision |\n| --- | --- | --- | --- |")
        for copies in options.copies:
            bench.export(bench.run_file(copies, 1000, prefix="particles"), "polhode-particles")
            own = {}
            show = lambda name, time, precision: print(f"| {512 * copies**3} | {name} | {time:.3f} | {time / own[precision]:.2f} |", flush=True)
            for precision in ("double", "mixed"):
                own[precision] = bench.step(lambda steps: bench.polhode(copies, precision, steps), copies)
                show(f"polhode, {precision}", own[precision], precision)
            for name, style in STYLES.items():
                show(name, bench.step(lambda steps: bench.lammps(copies, style, steps), copies), "mixed" if "mixed" in name else "double")


if __name__ == "__main__":
    main()
