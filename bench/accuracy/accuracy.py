# SPDX-License-Identifier: MIT
"""How dynamics depends on the accuracy of the integration: diffusion, relaxation times and temperatures of liquid TIP4P
with schemes and time steps of very different R, from the same initial configurations, by `polhode run` and `polhode analyze`."""

import argparse
import json
import subprocess
import sys
from datetime import date
from math import sqrt
from pathlib import Path
from statistics import fmean, stdev

import figure  # to find the modules shared by the benchmarks
import machine
import records

POINTS = [("velocity-verlet", h) for h in (1, 2, 3, 4, 5)] + [("hoa2", 4), ("hoa2", 6), ("gier4", 3)]
RUN_FILE = """[system]
molecules = [{{ model = "tip4p", count = {count} }}]
{start}
temperature = "298.15 K"
seed = {seed}
[forces]
cutoff = "0.9 nm"
precision = "mixed"
[integrator]
scheme = "{scheme}"
step = "{step:g} fs"
[run]
equilibrate = "{equilibrate:g} ps"
length = "{length:g} ps"
sample = "{sample:g} fs"
[output]
prefix = "{name}"
trajectory_every = "{every:g} fs"
formats = ["{form}"]
plot = "none"
"""


def number(found):
    """The value, or the estimate of a run that is too short for one: the mean over many runs may determine it."""
    return found["value"] if found["value"] is not None else found["unconverged_estimate"]


# name in the table, unit, position in the output of analyze or run
QUANTITIES = {
    "D": ("1e-9 m²/s", lambda run, said: number(said["parts"][0]["D_1e-9_m2_per_s"])),
    "tau": ("ps", lambda run, said: number(said["parts"][0]["relaxation"]["dipole"]["P2"]["exponential_ps"])),
    "T": ("K", lambda run, said: run["temperature_K"]),
    "T_translation": ("K", lambda run, said: run["temperature_translation_K"]),
    "T_rotation": ("K", lambda run, said: fmean(run["temperature_rotation_K"])),
    "potential": ("kJ/mol", lambda run, said: run["potential_kJ_per_mol"]),
    "R": ("", lambda run, said: run["R"]),
}


def asked(program, folder, *words):
    done = subprocess.run([program, *words, "--force", "--json"], cwd=folder, check=True, stdout=subprocess.PIPE,
                          text=True)
    return done.stdout


def start(o, seed):
    """A liquid at 298 K: a lattice melted with velocity rescaling, then a picosecond at constant energy."""
    name = f"start-{seed}"
    if not (o.folder / f"{name}-final.gro").exists():
        text = RUN_FILE.format(count=o.count, start='density = "0.997 g/cm3"', seed=seed, scheme="hoa2", step=2,
                               equilibrate=o.equilibrate, length=1, sample=20, name=name, every=0, form="gro")
        (o.folder / f"{name}.toml").write_text(text, encoding="utf-8")
        asked(o.polhode, o.folder, "run", f"{name}.toml", "--threads", "1")
    return f"{name}-final.gro"


def measured(o, scheme, step, seed):
    """{quantity: value} of one run; its frames are deleted."""
    name = f"{scheme}-{step:g}-{seed}"
    kept = o.folder / f"{name}.json"
    if not kept.exists():
        whole = lambda fs: step * max(1, round(fs / step))  # so that all steps have the same sampling interval
        text = RUN_FILE.format(count=o.count, start=f'initial_configuration = "{start(o, seed)}"', seed=seed, scheme=scheme, step=step,
                               equilibrate=0, length=o.length, sample=whole(12), name=name, every=whole(120),
                               form=o.format)
        (o.folder / f"{name}.toml").write_text(text, encoding="utf-8")
        run = json.loads(asked(o.polhode, o.folder, "run", f"{name}.toml", "--threads", "1"))
        frames = o.folder / f"{name}-trajectory.{o.format}"
        said = json.loads(asked(o.polhode, o.folder, "analyze", frames.name, "--run", f"{name}.toml", "--what",
                                "msd,rotation", "--window", f"{o.window:g} ps", "--plot", "none", "--threads", "1",
                                "--output", name))
        frames.unlink()
        kept.write_text(json.dumps({q: value(run, said) for q, (_, value) in QUANTITIES.items()}), encoding="utf-8")
    run = json.loads(kept.read_text(encoding="utf-8"))
    return {**run, "excess": run["T_rotation"] - run["T_translation"]}


def mean(values):
    return {"value": fmean(values), "error": stdev(values) / sqrt(len(values)) if len(values) > 1 else 0.0}


def differences(runs, exact):
    """Differences of each quantity from the most accurate runs with the same initial configuration, whose scatter cancels."""
    return {q: mean([run[q] - best[q] for run, best in zip(runs, exact)]) for q in runs[0]}


def report(result):
    """Two tables in Markdown: means, and their differences from the most accurate scheme and step."""
    columns = [("D", "D [1e-9 m²/s]", 2), ("tau", "τ₂ of the dipole [ps]", 2), ("T_translation", "T of translation [K]", 1),
               ("T_rotation", "T of rotation [K]", 1), ("potential", "potential energy [kJ/mol]", 3)]
    rows = []
    for more, of in (("", lambda p: p), (", less that of the most accurate", lambda p: p["differences"])):
        rows += [f"| scheme | step [fs] | R [%] | " + " | ".join(name + more for _, name, _ in columns) + " |",
                 "| --- " * (3 + len(columns)) + "|"]
        for p in result["points"]:
            values = (f"{of(p)[q]['value']:.{d}f} ± {of(p)[q]['error']:.{d}f}" for q, _, d in columns)
            rows.append(f"| {p['scheme']} | {p['step_fs']:g} | {100 * p['R']['value']:.3g} | " + " | ".join(values) + " |")
        rows.append("")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--polhode", default="polhode", help="path of polhode")
    parser.add_argument("--runs", type=int, default=6, help="runs of each scheme and step, each from another initial configuration")
    parser.add_argument("--count", type=int, default=512, help="waters in a run")
    parser.add_argument("--length", type=float, default=100, help="length of a run at constant energy [ps]")
    parser.add_argument("--equilibrate", type=float, default=20, help="equilibration of an initial configuration [ps]")
    parser.add_argument("--window", type=float, default=10, help="maximum lag of correlations [ps]")
    parser.add_argument("--format", default="trr", help="format of the frames, which are not kept")
    parser.add_argument("--points", help="instead of the default ones: \"velocity-verlet 2, hoa2 4\"")
    parser.add_argument("--folder", type=Path, default=Path("accuracy"),
                        help="where results of runs are stored; stored runs are not repeated")
    parser.add_argument("--json", type=Path, help="write all results to this file")
    parser.add_argument("--figure", type=Path, help="draw the figure to this file, .svg or .png")
    o = parser.parse_args()
    o.polhode = machine.program(o.polhode)
    o.folder.mkdir(parents=True, exist_ok=True)
    points = POINTS
    if o.points:
        points = [(scheme, float(step)) for scheme, step in (p.split() for p in o.points.split(","))]
    runs = {p: [] for p in points}
    for seed in range(1, o.runs + 1):
        for p in points:
            runs[p].append(measured(o, *p, seed))
        print(f"start {seed} of {o.runs} done", file=sys.stderr, flush=True)
    exact = min(points, key=lambda p: fmean(r["R"] for r in runs[p]))
    result = {"date": date.today().isoformat(), "processor": machine.processor(),
              "command": " ".join(["accuracy.py", *sys.argv[1:]]), "waters": o.count, "length_ps": o.length,
              "points": [{"scheme": scheme, "step_fs": step, "runs": o.runs,
                          **{q: mean([r[q] for r in runs[scheme, step]]) for q in runs[scheme, step][0]},
                          "differences": differences(runs[scheme, step], runs[exact])}
                         for scheme, step in points]}
    print(report(result))
    if o.json:
        records.write(o.json, result)
    if o.figure:
        figure.draw(result, o.figure)


if __name__ == "__main__":
    main()
