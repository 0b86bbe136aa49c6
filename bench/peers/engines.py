# SPDX-License-Identifier: MIT
"""Interfaces to each program: how it reads the water, reports energies during a run, and is timed.

An engine produces samples with `samples(case, step, length, interval)` and a time with
`step_us(case, step, steps, threads)`. Timed runs write no intermediate energies."""

import json
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from string import Template

import gro
import logs

HERE = Path(__file__).resolve().parent
CHARGES, MASSES = (0, 0.52, -1.04), (15.9994, 1.008, 1e-20)  # O, H, M; LAMMPS has no massless atoms

# Each LAMMPS rank has one thread; Open MPI refuses to run as root unless both variables are set.
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "GMX_MAXBACKUP": "-1"}


def said(*command):
    """All output of a command."""
    done = subprocess.run(command, text=True, capture_output=True, check=False)
    return done.stdout + done.stderr


def complaint(error):
    """The most informative line of a RuntimeError: the first after the command with 'error', else the last."""
    lines = [line.strip() for line in str(error).splitlines()]
    return next((line for line in lines[1:] if "error" in line.lower()), lines[-1])


@dataclass
class Case:
    """An initial configuration in a separate folder, and the cutoff treatment."""

    start: gro.Start
    folder: Path
    cutoff: float  # [nm]
    switch: float  # [nm]

    def __post_init__(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / "start.gro").write_text(gro.written(self.start, "TIP4P water, replicated"))

    @property
    def molecules(self):
        return self.start.molecules

    def write(self, name, template, **values):
        text = Template((HERE / "inputs" / template).read_text(encoding="utf-8")).substitute(
            values, molecules=self.molecules, cutoff_nm=self.cutoff, switch_nm=self.switch)
        (self.folder / name).write_text(text, encoding="utf-8")

    def run(self, *command, given=None):
        """Standard output and error of a command in the folder of the case; raises RuntimeError if it failed."""
        done = subprocess.run([str(c) for c in command], cwd=self.folder, text=True, input=given,
                              capture_output=True, check=False,
                              env={**os.environ, **ENVIRONMENT})
        if done.returncode != 0:
            end = "\n".join((done.stdout + done.stderr).splitlines()[-15:])
            raise RuntimeError(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{end}")
        return done.stdout


def steps_between(interval, step):
    """Number of whole steps between samples at most `interval` apart, at least one."""
    return max(1, int(interval / step + 1e-9))


class Engine:
    """A program with an integrator that has `evaluations` force evaluations per step."""

    evaluations = 1
    start_step = 2.0  # [fs], for the first table of times
    ladder = (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0)  # [fs]

    def missing(self):
        """The reason why the engine cannot run here, or None."""
        return None if shutil.which(self.program) else f"no program '{self.program}' on PATH"

    def threads(self, requested):
        return requested


class Polhode(Engine):
    schemes = {"velocity-verlet": (1, 2.0, Engine.ladder), "hoa2": (2, 4.0, (1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0)),
               "gier4-fd": (3, 5.0, (3.0, 4.0, 5.0, 6.0, 7.0, 8.0))}

    def __init__(self, options, scheme):
        self.name, self.scheme = f"polhode {scheme}", scheme
        self.program, self.truncation = options.polhode, options.truncation
        self.precision, self.threaded = options.precision, options.polhode_threads
        self.evaluations, self.start_step, self.ladder = self.schemes[scheme]

    def threads(self, requested):
        return requested if self.threaded else 1

    def version(self):
        return said(self.program, "--version").strip()

    def _run(self, case, step, length, interval, threads):
        case.write("polhode.toml", "polhode.toml", start="start.gro", truncation=self.truncation,
                   precision=f'precision = "{self.precision}"\n' if self.precision else "",
                   scheme=self.scheme, step_fs=step, length_fs=length, sample_fs=interval,
                   prefix="polhode")
        more = ["--threads", threads] if self.threaded else []
        return case.run(self.program, "run", "polhode.toml", "--json", "--force", *more)

    def samples(self, case, step, length, interval):
        self._run(case, step, length, interval, 1)
        return logs.polhode_energies((case.folder / "polhode-energies.csv").read_text())

    def step_us(self, case, step, steps, threads):
        length = steps * step
        return logs.polhode_summary(self._run(case, step, length, length, threads))[0]


class Gromacs(Engine):
    def __init__(self, options, name="gromacs", integrator="md-vv", coulomb="reaction-field",
                 program=None):
        self.name, self.program = name, program or options.gmx
        self.integrator, self.coulomb = integrator, coulomb
        self.tolerance, self.skin, self.lifetime = options.gromacs_tolerance, 0.1, 20.0
        self.lists = {}  # by step

    def version(self):
        text = said(self.program, "--version")
        found = [re.search(rf"^{key}:\s*(.*)$", text, re.M) for key in
                 ("GROMACS version", "Precision", "SIMD instructions")]
        return ", ".join(f[1] for f in found if f)

    def _run(self, case, step, steps, every, threads, *more):
        case.write("gromacs.top", "gromacs.top")
        case.write("gromacs.mdp", "gromacs.mdp", integrator=self.integrator, step_ps=step / 1000,
                   steps=steps, tolerance=self.tolerance, list_nm=case.cutoff + self.skin,
                   list_steps=max(1, round(self.lifetime / step)), coulomb=self.coulomb,
                   sample_steps=every)
        for old in case.folder.glob("gromacs.*[rg]"):  # no backups of tpr, edr, log
            old.unlink()
        case.run(self.program, "-nobackup", "grompp", "-f", "gromacs.mdp", "-c", "start.gro", "-p",
                 "gromacs.top", "-o", "gromacs.tpr", "-po", "mdout.mdp", "-maxwarn", 3)
        case.run(self.program, "-nobackup", "mdrun", "-deffnm", "gromacs", "-ntmpi", 1, "-ntomp",
                 threads, "-noconfout", *more)
        log = (case.folder / "gromacs.log").read_text(errors="replace")
        self.lists[step] = logs.gromacs_lists(log)
        return log

    def samples(self, case, step, length, interval):
        self._run(case, step, round(length / step), steps_between(interval, step), 1)
        case.run(self.program, "-nobackup", "energy", "-f", "gromacs.edr", "-o", "energy.xvg",
                 given="Potential\nTotal-Energy\nTemperature\n\n")
        return logs.gromacs_energies((case.folder / "energy.xvg").read_text())

    def step_us(self, case, step, steps, threads):
        # GROMACS resets its counters halfway, after tuning its pair list, so the run has twice as many steps.
        log = self._run(case, step, 2 * steps, 100, threads, "-resethway")
        return logs.gromacs_step_us(log, step)


class Lammps(Engine):
    rows = 8000  # of a table, evenly spaced in r²
    nearest = 0.05  # [nm], where the tables begin
    laws = {
        "reaction-field": ("pair_style hybrid lj/cut {rc} table linear {rows}",
                           "table lammps.table {name} {rc}", ""),
        "PME": ("pair_style hybrid lj/cut {rc} coul/long {rc}", "coul/long", "kspace_style pppm 1e-4"),
    }

    def __init__(self, options, name="lammps", law="reaction-field"):
        self.name, self.program, self.law = name, options.lmp, law

    def threads(self, requested):
        return requested if shutil.which("mpirun") else 1

    def version(self):
        found = re.search(r"Simulator - (.*)", said(self.program, "-h"))
        return found[1] if found else "unknown"

    def _run(self, case, step, steps, every, threads, warmup):
        if not (case.folder / "lammps.data").exists():
            (case.folder / "lammps.data").write_text(gro.lammps_data(case.start, CHARGES, MASSES))
            (case.folder / "lammps.table").write_text(
                gro.lammps_tables(self.rows, self.nearest, case.cutoff, CHARGES))
        style, coefficients, kspace = self.laws[self.law]
        rc = 10 * case.cutoff
        lines = [style.format(rc=rc, rows=self.rows), "pair_coeff 1 1 lj/cut 0.155 3.15365",
                 "pair_coeff 1 2*3 none"]
        lines += [f"pair_coeff {pair} {coefficients.format(rc=rc, name=name)}"
                  for pair, name in (("2 2", "HH"), ("2 3", "HM"), ("3 3", "MM"))]
        case.write("lammps.in", "lammps.in", pairs="\n".join(lines), kspace=kspace, step_fs=step,
                   steps=steps, sample_steps=every, warmup=warmup)
        ranks = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", threads] if threads > 1 else []
        return case.run(*ranks, self.program, "-in", "lammps.in", "-log", "none", "-sf", "opt")

    def samples(self, case, step, length, interval):
        every, steps = steps_between(interval, step), round(length / step)
        return logs.lammps_energies(self._run(case, step, steps, every, 1, 0))

    def step_us(self, case, step, steps, threads):
        return logs.lammps_step_us(self._run(case, step, steps, steps, threads, max(10, steps // 10)))


class OpenMM(Engine):
    def __init__(self, options, name="openmm", law="reaction-field"):
        self.name, self.program, self.law = name, options.openmm_python or sys.executable, law

    def missing(self):
        if super().missing():
            return super().missing()
        asked = subprocess.run([self.program, "-c", "import openmm"], capture_output=True, check=False)
        return None if asked.returncode == 0 else f"{self.program} has no module openmm"

    def version(self):
        return said(self.program, "-c", "import openmm; print(openmm.__version__)").strip()

    def _run(self, case, step, steps, every, threads):
        order = {"start": "start.gro", "cutoff": case.cutoff, "switch": case.switch, "law": self.law,
                 "step_fs": step, "steps": steps, "every": every, "threads": threads}
        return logs.openmm_report(case.run(self.program, HERE / "openmm_run.py", json.dumps(order)))

    def samples(self, case, step, length, interval):
        return self._run(case, step, round(length / step), steps_between(interval, step), 1)[0]

    def step_us(self, case, step, steps, threads):
        return self._run(case, step, steps, 0, threads)[1]


def engines(options):
    """The requested programs, with polhode first; the other names are the values of --peers."""
    peers = {
        "gromacs": lambda: Gromacs(options),
        "gromacs-md": lambda: Gromacs(options, "gromacs-md", integrator="md"),
        "gromacs-double": lambda: Gromacs(options, "gromacs-double", program=options.gmx_double),
        "gromacs-pme": lambda: Gromacs(options, "gromacs-pme", coulomb="PME"),
        "lammps": lambda: Lammps(options),
        "lammps-pppm": lambda: Lammps(options, "lammps-pppm", "PME"),
        "openmm": lambda: OpenMM(options),
        "openmm-pme": lambda: OpenMM(options, "openmm-pme", "PME"),
    }
    ours = [Polhode(options, scheme) for scheme in Polhode.schemes]
    for name in options.peers:
        if name not in peers:
            sys.exit(f"there is no peer '{name}'; those known are {', '.join(peers)}")
    return ours, [peers[name]() for name in options.peers]
