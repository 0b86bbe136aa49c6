# SPDX-License-Identifier: MIT
"""Calibration of the errors and of the test for an energy drift: many runs without energy drift, as reported by the program.

Every run is suspended and resumed: the program reports on its first part, then on the first two together, then on the whole."""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import machine  # noqa: E402

SYSTEMS = {  # molecules, count, density, cutoff, temperature, steps [fs] of both schemes, lengths [ps]
    "27 TIP4P": ("tip4p", 27, "0.997 g/cm3", "0.45 nm", "297 K", (2, 4), (10, 30, 100)),
    "64 TIP4P": ("tip4p", 64, "0.997 g/cm3", "0.6 nm", "297 K", (2, 4), (15, 30, 100)),
    "64 argon": ("argon", 64, "1.37 g/cm3", "0.7 nm", "100 K", (5, 10), (10, 30, 100)),
}
SCHEMES = ("velocity-verlet", "hoa2")
RUN = """[system]
molecules = [{{ model = "{model}", count = {count} }}]
density = "{density}"
temperature = "{temperature}"
seed = {seed}
[forces]
cutoff = "{cutoff}"
[integrator]
scheme = "{scheme}"
step = "{step} fs"
[run]
equilibrate = "20 ps"
sample = "{sample} fs"
[output]
prefix = "run"
plot = "none"
trajectory_every = "0 ps"
"""
KEYS = ("samples", "R", "R_error", "drift_kJ_per_mol_ps", "drift_error", "drift_p_value", "drift_verdict", "pressure_bar",
        "pressure_error_bar", "total_kJ_per_mol")


def judged(program, system, scheme, seed, lengths):
    """What one run reports at each of its lengths."""
    model, count, density, cutoff, temperature, steps, _ = SYSTEMS[system]
    step = steps[SCHEMES.index(scheme)]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "run.toml").write_text(RUN.format(model=model, count=count, density=density, cutoff=cutoff,
                                                       temperature=temperature, seed=seed, scheme=scheme, step=step,
                                                       sample=max(4, step)))
        reports = []
        for length in lengths:
            process = subprocess.run([program, "run", "run.toml", "--threads", "1", "--json", "--continue", "--length", f"{length} ps"],
                                     cwd=folder, capture_output=True, text=True, check=True)
            report = json.loads(process.stdout)
            reports.append({key: report[key] for key in KEYS} | {"shadow": report.get("shadow")})
    return reports


def rms(values):
    return math.sqrt(sum(v * v for v in values) / len(values))


def scatter(values):
    mean = sum(values) / len(values)
    return math.sqrt(sum((v - mean) ** 2 for v in values) / (len(values) - 1))


def over_scatter(reports, value, error):
    """The rms of the reported errors divided by the scatter of the values between runs; None with too few runs."""
    known = [r for r in reports if r[error] is not None]
    return rms([r[error] for r in known]) / scatter([r[value] for r in known]) if len(known) > 2 else None


def fired(reports, level):
    return sum(r["drift_p_value"] is not None and r["drift_p_value"] < level for r in reports) / len(reports) / level


def row(system, scheme, length, reports):
    """Fractions of runs with a significant energy drift are divided by the nominal ones."""
    shadow = [r["shadow"] for r in reports if r["shadow"]]
    return {"system": system, "scheme": scheme, "length_ps": length, "runs": len(reports),
            "told": sum(r["drift_p_value"] is not None for r in reports) / len(reports),
            "fired_5": fired(reports, 0.05), "fired_1": fired(reports, 0.01),
            "shadow_told": sum(r["drift_p_value"] is not None for r in shadow) / len(shadow) if shadow else None,
            "shadow_fired_5": fired(shadow, 0.05) if shadow else None, "shadow_fired_1": fired(shadow, 0.01) if shadow else None,
            "error_of_R": over_scatter(reports, "R", "R_error"),
            "error_of_drift": over_scatter(reports, "drift_kJ_per_mol_ps", "drift_error"),
            "error_of_pressure": over_scatter(reports, "pressure_bar", "pressure_error_bar")}


def table(rows):
    columns = [key for key in rows[0]]
    lines = ["| " + " | ".join(columns) + " |", "|" + " --- |" * len(columns)]
    for r in rows:
        cells = [f"{r[c]:.2f}" if isinstance(r[c], float) else "" if r[c] is None else str(r[c]) for c in columns]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="polhode")
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--first", type=int, default=1, help="seed of the first run")
    parser.add_argument("--systems", nargs="+", default=list(SYSTEMS), choices=list(SYSTEMS))
    parser.add_argument("--lengths", nargs="+", type=float, help="lengths of the runs [ps]; default: those of the system")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--output", type=Path, required=True)
    options = parser.parse_args()
    program = machine.program(options.program)
    rows = []
    for system in options.systems:
        lengths = options.lengths or SYSTEMS[system][-1]
        for scheme in SCHEMES:
            with ThreadPoolExecutor(options.jobs) as pool:
                runs = list(pool.map(lambda seed: judged(program, system, scheme, seed, lengths),
                                     range(options.first, options.first + options.runs)))
            rows += [row(system, scheme, length, [run[k] for run in runs]) for k, length in enumerate(lengths)]
            print(table(rows[-3:]), flush=True)
    options.output.write_text(json.dumps({"date": time.strftime("%Y-%m-%d"), "processor": machine.processor(),
                                          "command": " ".join(sys.argv[1:]), "rows": rows}, indent=1) + "\n")
    options.output.with_suffix(".md").write_text(table(rows) + "\n")


if __name__ == "__main__":
    main()
