# SPDX-License-Identifier: MIT
"""Does the adviser keep its accuracy guarantee, and how much of it does it leave unused? It is run once for several systems
and accuracies. Then new runs with the scheme and step of its answer, from other initial configurations and momenta, are
checked against the required R, and against the bound that the adviser reports. That bound divided by the required R is the
ratio reached: 1 is an answer without any margin, and the adviser aims at 0.8 to 1."""

import argparse
import json
import subprocess
import sys
import tempfile
from datetime import date
from math import comb
from pathlib import Path
from statistics import fmean

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import machine

# Molecules with their number, initial configuration, and forces.
BOXES = {
    "tip4p-512": (["tip4p", 512], 'initial_configuration = "w512"', 'cutoff = "1.0 nm"\nswitch = "0.85 nm"'),
    "tip4p-216-reaction-field": (["tip4p", 216], 'density = "1 g/cm3"',
                                 'truncation = "site-switch"\nelectrostatics = "reaction-field"\ncutoff = "0.9 nm"'),
    "spce-125-pme": (["spce", 125], 'density = "0.997 g/cm3"', 'electrostatics = "pme"\ncutoff = "0.75 nm"'),
    "salt-water-pme": (["spce", 120, "na-spce", 4, "cl-spce", 4], 'density = "1.05 g/cm3"',
                       'electrostatics = "pme"\ncutoff = "0.75 nm"'),
    "co2-125": (["co2", 125], 'density = "0.9 g/cm3"', 'truncation = "site-switch"\ncutoff = "1.0 nm"'),
    "argon-108": (["argon", 108], 'density = "1.4 g/cm3"\ntemperature = "100 K"', 'cutoff = "0.85 nm"'),
}


def run_file(system, seed, o):
    molecules, place, forces = BOXES[system]
    listed = ", ".join(f'{{ model = "{model}", count = {count} }}' for model, count in zip(molecules[::2], molecules[1::2]))
    equilibrate = "" if place.startswith("start") else f'equilibrate = "{o.equilibrate:g} ps"\n'
    return (f'[system]\nmolecules = [{listed}]\n{place}\nseed = {seed}\n[forces]\n{forces}\n[run]\n{equilibrate}'
            f'length = "{o.length:g} ps"\n[output]\nplot = "none"\n')


def polhode(o, folder, *arguments):
    return subprocess.run([o.program, *arguments, "--threads", str(o.threads)], cwd=folder, text=True,
                          capture_output=True)


def case(system, accuracy, seed, o):
    """One guarantee, and how many new runs met it."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "run.toml").write_text(run_file(system, seed, o))
        told = polhode(o, folder, "advise", "run.toml", "--json", "--accuracy", f"{100 * accuracy:g} %",
                       "--time", f"{o.time:g}")
        result = {"system": system, "accuracy": accuracy, "seed": seed}
        if told.returncode != 0:
            return {**result, "answer": None, "why": told.stderr.strip().splitlines()[-1]}
        advice = json.loads(told.stdout)
        best, second = advice["best"], advice["runner_up"]
        confirmed = best["confirmation"]
        # New runs: another lattice, other momenta, equilibrated as long as in the run file.
        for attempt in range(1, 11):  # molecules of a dense lattice may overlap
            (folder / "fresh.toml").write_text(run_file(system, 1_000_000 * attempt + seed, o))
            fresh = polhode(o, folder, "study", "fresh.toml", "--schemes", best["scheme"], "--steps",
                            f"{best['step_fs']:.6g} fs", "--runs", str(o.fresh), "--length",
                            f"{confirmed['length_ps']:.6g} ps", "--decorrelate", f"{o.equilibrate:g} ps")
            if "overlap" not in fresh.stderr:
                break
        if fresh.returncode != 0:
            sys.exit(fresh.stderr)
        rows = [line.split(";") for line in (folder / "study-runs.csv").read_text().splitlines()
                if not line.startswith(("#", "scheme;"))]
        ratios = [float(row[4]) if row[3] == "1" else float("inf") for row in rows]
        return {**result, "answer": {key: best[key] for key in ("scheme", "step_fs", "ns_per_day")},
                "runner_up": second and {key: second[key] for key in ("scheme", "step_fs", "ns_per_day")},
                "length_ps": confirmed["length_ps"], "R_expected": confirmed["R"],
                "R_expected_error": confirmed["R_error"], "bound": confirmed["bound"],
                "reached": confirmed["bound"] / accuracy, "refused": len(advice["refused"]),
                "surpassed": len(advice["surpassed"]), "R_fresh": ratios,
                "kept": sum(R <= accuracy for R in ratios),
                "below_bound": sum(R <= confirmed["bound"] for R in ratios), "runs": len(ratios)}


def binomial_interval(kept, runs, confidence=0.95):
    """The confidence interval of Clopper and Pearson for a probability."""
    tail = lambda p, ks: sum(comb(runs, k) * p**k * (1 - p) ** (runs - k) for k in ks)

    def bisected(too_small):
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if too_small(middle) else (low, middle)
        return low

    alpha = (1 - confidence) / 2
    low = 0.0 if kept == 0 else bisected(lambda p: tail(p, range(kept, runs + 1)) < alpha)
    high = 1.0 if kept == runs else bisected(lambda p: tail(p, range(kept + 1)) > alpha)
    return low, high


def table(cases):
    rows = ["| system | required R [%] | answer | length [ps] | sets rejected, improved | expected R [%] | 97.5 % bound [%] "
            "| bound / required | mean R of new runs / required | maximum | met | below the bound |",
            "| --- " * 12 + "|"]
    for c in cases:
        if not c["answer"]:
            rows.append(f"| {c['system']} | {100 * c['accuracy']:g} | none: {c['why']} |" + " |" * 9)
            continue
        over = [R / c["accuracy"] for R in c["R_fresh"]]
        rows.append(f"| {c['system']} | {100 * c['accuracy']:g} | {c['answer']['scheme']}, "
                    f"{c['answer']['step_fs']:.3g} fs | {c['length_ps']:.3g} | {c['refused']}, {c['surpassed']} "
                    f"| {100 * c['R_expected']:.3g} ± {100 * c['R_expected_error']:.2g} | {100 * c['bound']:.3g} "
                    f"| {c['reached']:.2f} | {fmean(over):.2f} | {max(over):.2f} "
                    f"| {c['kept']} of {c['runs']} | {c['below_bound']} of {c['runs']} |")
    answered = [c for c in cases if c["answer"]]
    if answered:
        runs = sum(c["runs"] for c in answered)
        rows.append("")
        for key, what in (("kept", "met the required R"), ("below_bound", "stayed below the bound, of which 97.5 % should")):
            count = sum(c[key] for c in answered)
            low, high = binomial_interval(count, runs)
            rows.append(f"{count} of {runs} new runs {what}: {100 * count / runs:.1f} %, 95 % interval "
                        f"{100 * low:.1f} to {100 * high:.1f} %.")
        reached = sorted(c["reached"] for c in answered)
        rows.append(f"Bounds are {reached[0]:.2f} to {reached[-1]:.2f} of the requirement, {fmean(reached):.2f} on average; "
                    f"{sum(0.8 <= r <= 1 for r in reached)} of {len(reached)} are from 0.8 to 1.")
    return "\n".join(rows) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="polhode", help="path of polhode")
    parser.add_argument("--systems", nargs="+", default=list(BOXES), choices=list(BOXES))
    parser.add_argument("--accuracies", nargs="+", type=float, default=[2, 0.5, 0.05], help="R in %%")
    parser.add_argument("--fresh", type=int, default=10, help="new runs for each answer")
    parser.add_argument("--repeats", type=int, default=1, help="questions of each kind, each with another seed")
    parser.add_argument("--time", type=float, default=60, help="computing time of the adviser [s]")
    parser.add_argument("--length", type=float, default=15, help="length of the runs for which advice is asked [ps]")
    parser.add_argument("--equilibrate", type=float, default=10, help="equilibration of lattices and of new initial configurations [ps]")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=Path, default=Path(f"{date.today()}-adviser"))
    o = parser.parse_args()
    o.program = machine.program(o.program)
    cases = []
    for repeat in range(o.repeats):
        for accuracy in o.accuracies:
            for system in o.systems:
                cases.append(case(system, accuracy / 100, o.seed + 100 * repeat, o))
                head = f"{date.today()}, {machine.processor()}"
                command = "bench/adviser/adviser.py " + " ".join(
                    f"--{name} {' '.join(map(str, value)) if isinstance(value, list) else value}"
                    for name, value in vars(o).items() if name not in ("program", "output"))
                o.output.with_suffix(".json").write_text(
                    json.dumps({"machine": machine.processor(), "date": str(date.today()), "command": command,
                                "cases": cases}, indent=1) + "\n")
                o.output.with_suffix(".md").write_text(f"# {head}\n\n`{command}`\n\n{table(cases)}")
                print(table(cases[-1:]).splitlines()[2], flush=True)
    print(table(cases))


if __name__ == "__main__":
    main()
