#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Stated errors of the averages of a run against their scatter over many runs of one system.

Each run begins with the final state of the one before, so runs at constant energy have one energy, and all are of one
equilibrium. What a run states is compared with the scatter of all.
"""

import argparse
import json
import math
import subprocess
import tempfile
from pathlib import Path

SYSTEMS = {
    "argon": ('{ model = "argon", count = 108 }', "1.3 g/cm3", "100 K", "0.7 nm", "coulomb", "15 fs"),
    "nitrogen": ('{ model = "n2", count = 32 }', "0.6 g/cm3", "110 K", "0.6 nm", "coulomb", "10 fs"),
    "water": ('{ model = "tip4p", count = 64 }', "0.997 g/cm3", "330 K", "0.6 nm", "reaction-field", "4 fs"),
}
ENSEMBLES = {
    "constant energy": "",
    "Langevin": '[thermostat]\ntype = "langevin"\nfriction = "2 1/ps"\n',
    "rescaling": '[thermostat]\ntype = "rescaling"\ntime_constant = "0.5 ps"\n',
    "constant pressure": '[thermostat]\ntype = "langevin"\nfriction = "2 1/ps"\n'
                         '[barostat]\npressure = "{pressure} bar"\ncompressibility = "{compressibility} 1/bar"\ntime_constant = "0.5 ps"\n',
    "hybrid Monte Carlo": '[hybrid_monte_carlo]\nsteps = 10\n',
}
# Near the pressure of the density above, and the compressibility there, which sets the size of moves only. The box of the waters is too
# small for its volume to fluctuate.
PRESSURES = {"argon": (200, 2e-4), "nitrogen": (100, 4e-4)}
RUN = """[system]
molecules = [{molecules}]
{initial}
temperature = "{temperature}"
seed = {seed}
[forces]
cutoff = "{cutoff}"
electrostatics = "{electrostatics}"
[integrator]
scheme = "hoa2"
step = "{step}"
[run]
equilibrate = "{equilibrate} ps"
length = "{length} ps"
sample = "{sample} fs"
[output]
prefix = "{prefix}"
trajectory_every = "0 ps"
plot = "none"
{ensemble}"""


def averages(report):
    """(name, value, error) of every average of a report; error None where it is not known. The total energy at constant energy is left
    out: each run begins with rounded coordinates, which change it by more than it fluctuates."""
    for name, unit in (("potential", "kJ_per_mol"), ("total", "kJ_per_mol"), ("temperature", "K"),
                       ("temperature_translation", "K"), ("pressure", "bar"), ("rms_potential", "kJ_per_mol")):
        if report["ensemble"] or name != "total":
            yield name, report[f"{name}_{unit}"], report[f"{name}_error_{unit}"]
    yield "R", report["R"], report["R_error"]
    for k, (value, error) in enumerate(zip(report["temperature_rotation_K"], report["temperature_rotation_error_K"])):
        if report["degrees_of_freedom_rotation"][k] > 0:
            yield f"temperature_rotation_{k + 1}", value, error
    for part in ("barostat", "hybrid_monte_carlo"):
        for name, estimate in ((report["ensemble"] or {}).get(part) or {}).items():
            if isinstance(estimate, dict) and "error" in estimate:
                yield name, estimate["value"], estimate["error"]


def runs(program, folder, system, ensemble, count, length):
    """The averages of every run; the first, which equilibrates, is left out."""
    molecules, density, temperature, cutoff, electrostatics, step = SYSTEMS[system]
    pressure, compressibility = PRESSURES.get(system, (None, None))
    initial = f'density = "{density}"'
    for k in range(count + 1):
        text = RUN.format(molecules=molecules, initial=initial, temperature=temperature, seed=k + 1, cutoff=cutoff, electrostatics=electrostatics,
                          step=step, equilibrate=0 if k else 10, length=length, sample=4 * int(step.split()[0]) if "hybrid" not in ensemble else 10 * int(step.split()[0]),
                          prefix=folder / f"run{k % 2}", ensemble=ENSEMBLES[ensemble].format(pressure=pressure, compressibility=compressibility))
        (folder / "run.toml").write_text(text)
        done = subprocess.run([program, "run", folder / "run.toml", "--threads", "1", "--force", "--json"], capture_output=True, text=True)
        if done.returncode:
            raise SystemExit(done.stderr)
        if k:
            yield list(averages(json.loads(done.stdout)))
        initial = f'initial_configuration = "{folder / f"run{k % 2}-final.gro"}"'


def table(all_runs):
    """For each average: the number of runs with an error, their rms, the scatter, and the ratio with its error by chance."""
    by_name = {}
    for run in all_runs:
        for name, value, error in run:
            by_name.setdefault(name, []).append((value, error))
    for name, pairs in by_name.items():
        known = [(value, error) for value, error in pairs if error is not None]
        if len(known) < 3:
            continue
        mean = sum(value for value, _ in known) / len(known)
        scatter = math.sqrt(sum((value - mean)**2 for value, _ in known) / (len(known) - 1))
        stated = math.sqrt(sum(error**2 for _, error in known) / len(known))
        if scatter > 0:
            yield name, len(known), len(pairs), stated, scatter, stated / scatter, stated / scatter / math.sqrt(2 * (len(known) - 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="polhode")
    parser.add_argument("--systems", nargs="+", default=list(SYSTEMS), choices=SYSTEMS)
    parser.add_argument("--ensembles", nargs="+", default=list(ENSEMBLES), choices=ENSEMBLES)
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--length", type=float, default=30, help="of a run [ps]")
    options = parser.parse_args()
    print("| system | ensemble | average | runs with an error | stated error, rms | scatter | stated / scatter |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for system in options.systems:
        for ensemble in options.ensembles:
            if ensemble == "constant pressure" and system not in PRESSURES:
                continue
            with tempfile.TemporaryDirectory() as folder:
                found = list(runs(options.program, Path(folder), system, ensemble, options.runs, options.length))
            for name, known, count, stated, scatter, ratio, chance in table(found):
                print(f"| {system} | {ensemble} | {name} | {known} of {count} | {stated:.3g} | {scatter:.3g} | {ratio:.2f} ± {chance:.2f} |", flush=True)


if __name__ == "__main__":
    main()
