# SPDX-License-Identifier: MIT
"""Calibration of the test for an energy drift: many runs without one, for schemes of second and fourth order, at constant energy and
with each thermostat, as reported by the program. Each run is suspended and resumed, so it is judged at two lengths."""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import machine  # noqa: E402

SYSTEMS = {  # molecule, count, density, cutoff, temperature, sample [fs]
    "argon": ("argon", 32, "1.37 g/cm3", "0.55 nm", "100 K", 20),
    "N2": ("n2", 32, "0.8 g/cm3", "0.55 nm", "80 K", 16),
    "TIP4P": ("tip4p", 27, "0.997 g/cm3", "0.45 nm", "297 K", 8),
}
CELLS = [  # system, scheme, step [fs], smoothness, thermostat
    ("argon", "velocity-verlet", 10, 2, None),
    ("argon", "gier4", 5, 2, None),
    ("argon", "gier4", 5, 3, None),
    ("argon", "gier4-fd", 10, 2, None),
    ("argon", "velocity-verlet", 5, 2, "langevin"),
    ("argon", "baoab", 10, 2, "langevin"),
    ("argon", "hoa2", 10, 3, "rescaling"),
    ("N2", "hoa2", 8, 2, None),
    ("N2", "gier4", 4, 2, None),
    ("N2", "gier4", 8, 3, None),
    ("N2", "gier4-fd", 8, 2, "langevin"),
    ("N2", "hoa2", 8, 2, "separate-rescaling"),
    ("TIP4P", "velocity-verlet", 2, 2, None),
    ("TIP4P", "gier4-fd", 4, 2, None),
    ("TIP4P", "gier4", 4, 3, None),
    ("TIP4P", "hoa2", 4, 2, "langevin"),
    ("TIP4P", "hoa2", 4, 2, "rescaling"),
]
LENGTHS = (8, 40)  # [ps]
HEAD = """# Calibration of the test for an energy drift

By [drift.py](../calibration/README.md#energy-drift). `p-value`: share of runs that have one; `p < 1 %`, `of`: share of runs below, with its 95 % interval [%]; `slope`: rms of the
stated errors of the slope divided by the scatter of the slopes; `walk`: share of runs with a random walk; `R %`: rms of R; `R known`: share of runs in which R has an error;
`R`: rms of these errors divided by the scatter of R, where at least 20 runs have one.

"""
RUN = """[system]
molecules = [{{ model = "{model}", count = {count} }}]
density = "{density}"
temperature = "{temperature}"
seed = {seed}
[forces]
cutoff = "{cutoff}"
smoothness = {smoothness}
[integrator]
scheme = "{scheme}"
step = "{step} fs"
[run]
equilibrate = "5 ps"
sample = "{sample} fs"
[output]
prefix = "run"
plot = "none"
trajectory_every = "0 ps"
"""


def run_file(cell, seed):
    system, scheme, step, smoothness, thermostat = cell
    model, count, density, cutoff, temperature, sample = SYSTEMS[system]
    text = RUN.format(model=model, count=count, density=density, cutoff=cutoff, temperature=temperature, seed=seed,
                      smoothness=smoothness, scheme=scheme, step=step, sample=sample)
    return text + (f'[thermostat]\ntype = "{thermostat}"\n' if thermostat else "")


def report(program, folder, length):
    """What the run in this folder reports at this length."""
    process = subprocess.run([program, "run", "run.toml", "--threads", "1", "--json", "--continue", "--length", f"{length} ps"],
                             cwd=folder, capture_output=True, text=True, check=True)
    return json.loads(process.stdout)


def reports(program, cell, seed):
    """What one run reports at each length."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "run.toml").write_text(run_file(cell, seed))
        return [report(program, folder, length) for length in LENGTHS]


def rms(values):
    return math.sqrt(sum(v * v for v in values) / len(values))


def scatter(values):
    mean = sum(values) / len(values)
    return math.sqrt(sum((v - mean) ** 2 for v in values) / (len(values) - 1))


def interval(count, runs):
    """The 95 % interval of a share, by Wilson's formula [%]."""
    z, p = 1.96, count / runs
    middle, width = p + z * z / (2 * runs), z * math.sqrt(p * (1 - p) / runs + z * z / (4 * runs * runs))
    return [100 * (middle + sign * width) / (1 + z * z / runs) for sign in (-1, 1)]


def row(cell, length, runs):
    system, scheme, step, smoothness, thermostat = cell
    known = [r for r in runs if r["drift_p_value"] is not None]
    fired = [sum(r["drift_p_value"] < level for r in known) for level in (0.05, 0.01)]
    rates = [r["drift_kJ_per_mol_ps"] for r in runs]
    bounded = [r for r in runs if r["R_error"] is not None]
    return {"system": system, "scheme": f"{scheme} {step} fs", "smoothness": smoothness, "ensemble": thermostat or "NVE", "ps": length,
            "runs": len(runs), "p-value": len(known) / len(runs), "p < 5 %": 100 * fired[0] / len(runs),
            "p < 1 %": 100 * fired[1] / len(runs), "of": interval(fired[1], len(runs)),
            "slope": rms([r["drift_error"] for r in known]) / scatter(rates),
            "walk": sum(bool(r.get("random_walk_kJ_per_mol_per_sqrt_ps")) for r in runs) / len(runs),
            "R %": 100 * rms([r["R"] for r in runs]), "R known": len(bounded) / len(runs),
            "R": rms([r["R_error"] for r in bounded]) / scatter([r["R"] for r in bounded]) if len(bounded) > 19 else None}


def text(value):
    if isinstance(value, list):
        return f"{value[0]:.1f} to {value[1]:.1f}"
    if value is None:
        return ""
    return f"{value:.2g}" if isinstance(value, float) else str(value)


def table(rows):
    return "\n".join(["| " + " | ".join(rows[0]) + " |", "|" + " --- |" * len(rows[0])] +
                     ["| " + " | ".join(text(v) for v in r.values()) + " |" for r in rows])


def totals(runs):
    """Shares over all systems. The two lengths of a run share a fifth of their samples."""
    lines = []
    for name, chosen in (("with a random walk", lambda c: c[4] or "gier4" in c[1]), ("of second order at constant energy",
                                                                                     lambda c: not (c[4] or "gier4" in c[1]))):
        mine = [r for (cell, _), reports_of in runs.items() if chosen(cell) for r in reports_of]
        fired = sum(r["drift_p_value"] is not None and r["drift_p_value"] < 0.01 for r in mine)
        low, high = interval(fired, len(mine))
        lines.append(f"{name}: p < 1 % in {fired} of {len(mine)}, {100 * fired / len(mine):.2f} % ({low:.2f} to {high:.2f} %)")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="polhode")
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--first", type=int, default=1, help="seed of the first run")
    parser.add_argument("--cells", type=int, nargs="+", default=range(len(CELLS)), help="numbers of systems with schemes, from 0")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--output", type=Path, required=True, help="a table in Markdown")
    o = parser.parse_args()
    program = machine.program(o.program)
    runs = {}
    for k in o.cells:
        with ThreadPoolExecutor(o.jobs) as pool:
            found = list(pool.map(lambda seed: reports(program, CELLS[k], seed), range(o.first, o.first + o.runs)))
        for length, of_length in zip(LENGTHS, zip(*found)):
            runs[CELLS[k], length] = of_length
        print(table([row(CELLS[k], length, runs[CELLS[k], length]) for length in LENGTHS]), flush=True)
    write(o.output, runs)


def write(file, runs):
    rows = [row(cell, length, of_length) for (cell, length), of_length in runs.items()]
    file.write_text(HEAD + table(rows) + "\n\n" + totals(runs) + "\n")


if __name__ == "__main__":
    main()
