# SPDX-License-Identifier: MIT
"""Readers of the output of each program: energies during a run, and the time of its steps."""

import csv
import json
import re
from typing import NamedTuple

KJ_PER_KCAL = 4.184
US_PER_DAY = 86400e6


class Sample(NamedTuple):
    total: float  # [kJ/mol]
    potential: float  # [kJ/mol]
    temperature: float  # [K]


def gromacs_energies(text, terms=("Potential", "Total Energy", "Temperature")):
    """The table of `gmx energy`: time, then the terms in the order of its legends."""
    legends = re.findall(r'^@ s\d+ legend "([^"]*)"', text, re.M)
    columns = [legends.index(term) + 1 for term in terms]
    rows = [[float(x) for x in line.split()] for line in text.splitlines() if line[:1] not in "#@"]
    return [Sample(r[columns[1]], r[columns[0]], r[columns[2]]) for r in rows if r]


def gromacs_step_us(text, step_fs):
    """Microseconds per step, for the steps after the counters were reset."""
    found = re.search(r"^Performance:\s+(\S+)", text, re.M)
    return None if found is None else US_PER_DAY * step_fs * 1e-6 / float(found[1])


def gromacs_lists(text):
    """The pair lists of mdrun, outer first: (steps between updates, range [nm])."""
    found = re.findall(r"updated every (\d+) steps?, buffer \S+ nm, rlist (\S+) nm", text)
    return [(int(steps), float(reach)) for steps, reach in found]


def lammps_energies(text):
    """The thermo table of the last run: step, etotal, pe, temp; kcal/mol become kJ/mol."""
    table = text.rpartition("Temp")[2].partition("\n")[2]
    samples = []
    for line in table.splitlines():
        words = line.split()
        try:
            _, total, potential, temperature = (float(w) for w in words)
        except ValueError:
            break
        samples.append(Sample(total * KJ_PER_KCAL, potential * KJ_PER_KCAL, temperature))
    return samples


def lammps_step_us(text):
    """Microseconds per step of the last run."""
    found = re.findall(r"^Loop time of (\S+) on \d+ procs for (\d+) steps", text, re.M)
    return 1e6 * float(found[-1][0]) / int(found[-1][1]) if found else None


def polhode_energies(text):
    """The table of energies of `polhode run`."""
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
    return [Sample(float(r["total [kJ/mol]"]), float(r["potential [kJ/mol]"]),
                   float(r["temperature [K]"])) for r in rows]


def polhode_summary(text):
    """(microseconds per step, force evaluations per step) from the JSON summary."""
    s = json.loads(text)
    # The evaluation for the initial configuration is not part of a step.
    return 1e6 * s["seconds"]["all"] / s["steps"], (s["force_evaluations"] - 1) / s["steps"]


def openmm_report(text):
    """The last line of openmm_run.py: energies, and microseconds per step."""
    report = json.loads(text.splitlines()[-1])
    return [Sample(*s) for s in report["samples"]], report["step_us"]
