# SPDX-License-Identifier: MIT
"""Does the adviser meet the accuracy guarantee, and how much shorter than necessary is the step? It is run once for
several systems and accuracies. Then new runs with the scheme and step of its answer, from other initial configurations
and momenta, are checked against the required R, and against the bound that the adviser reports. The ratio of this bound
to the required R is reported. A ratio of 1 is an answer without any margin, and the adviser aims at 0.8 to 1."""

import csv
import subprocess
from pathlib import Path
from statistics import fmean

from lib import runs, study
from lib.statistics import share_interval

BOXES = {  # molecules, keys of [system], [forces]
    "tip4p-512": (("tip4p", 512), {"initial_configuration": "w512"}, {"cutoff": "1.0 nm", "switch": "0.85 nm"}),
    "tip4p-216-reaction-field": (("tip4p", 216), {"density": "1 g/cm3"},
                                 {"truncation": "site-switch", "electrostatics": "reaction-field", "cutoff": "0.9 nm"}),
    "spce-125-pme": (("spce", 125), {"density": "0.997 g/cm3"}, {"electrostatics": "pme", "cutoff": "0.75 nm"}),
    "salt-water-pme": (("spce", 120, "na-spce", 4, "cl-spce", 4), {"density": "1.05 g/cm3"}, {"electrostatics": "pme", "cutoff": "0.75 nm"}),
    "co2-125": (("co2", 125), {"density": "0.9 g/cm3"}, {"truncation": "site-switch", "cutoff": "1.0 nm"}),
    "argon-108": (("argon", 108), {"density": "1.4 g/cm3", "temperature": "100 K"}, {"cutoff": "0.85 nm"}),
}


def write(o, folder, name, system, seed):
    molecules, place, forces = BOXES[system]
    Path(folder, name).write_text(runs.run_file(
        system={"molecules": runs.molecules(*molecules), **place, "seed": seed}, forces=forces,
        run={"equilibrate": f"{o.equilibrate:g} ps", "length": f"{o.length:g} ps"}, output={"plot": "none"}), encoding="utf-8")


def new_runs(o, folder, system, seed, best):
    """R of new runs with another lattice and other momenta, equilibrated as in the run file; infinite after a blow-up."""
    for attempt in range(1, 11):  # molecules of a dense lattice may overlap
        write(o, folder, "fresh.toml", system, 1_000_000 * attempt + seed)
        try:
            runs.called(o, "study", "fresh.toml", "--schemes", best["scheme"], "--steps", f"{best['step_fs']:.6g} fs", "--runs", o.fresh, "--length",
                        f"{best['confirmation']['length_ps']:.6g} ps", "--decorrelate", f"{o.equilibrate:g} ps", "--threads", o.jobs, folder=folder)
            break
        except SystemExit as error:
            if "overlap" not in str(error) or attempt == 10:
                raise
    rows = csv.reader((line for line in Path(folder, "study-runs.csv").read_text(encoding="utf-8").splitlines()
                       if not line.startswith(("#", "scheme;"))), delimiter=";")
    return [float(row[4]) if row[3] == "1" else float("inf") for row in rows]


def case(o, system, accuracy, seed):
    """A guarantee, and the number of new runs that met it."""
    with runs.scratch() as folder:
        write(o, folder, "run.toml", system, seed)
        result = {"system": system, "accuracy": accuracy, "seed": seed}
        told = subprocess.run([o.program, "advise", "run.toml", "--json", "--accuracy", f"{100 * accuracy:g} %", "--time", f"{o.time:g}",
                               "--threads", str(o.jobs)], cwd=folder, text=True, capture_output=True, check=False)
        if told.returncode:
            return {**result, "answer": None, "why": told.stderr.strip().splitlines()[-1]}
        advice = study.json.loads(told.stdout)
        best, second = advice["best"], advice["runner_up"]
        confirmed, ratios = best["confirmation"], new_runs(o, folder, system, seed, best)
    answer = lambda one: one and {key: one[key] for key in ("scheme", "step_fs", "ns_per_day")}
    return {**result, "answer": answer(best), "runner_up": answer(second), "length_ps": confirmed["length_ps"], "R_expected": confirmed["R"],
            "R_expected_error": confirmed["R_error"], "bound": confirmed["bound"], "reached": confirmed["bound"] / accuracy,
            "refused": len(advice["refused"]), "surpassed": len(advice["surpassed"]), "R_fresh": ratios,
            "kept": sum(R <= accuracy for R in ratios), "below_bound": sum(R <= confirmed["bound"] for R in ratios), "runs": len(ratios)}


def measured(o):
    return {"cases": [case(o, system, accuracy / 100, o.seed + 100 * repeat) for repeat in range(o.repeats)
                      for accuracy in o.accuracies for system in o.systems]}


def row(c):
    if not c["answer"]:
        return [c["system"], f"{100 * c['accuracy']:g}", f"none: {c['why']}", *[""] * 9]
    over = [R / c["accuracy"] for R in c["R_fresh"]]
    return [c["system"], f"{100 * c['accuracy']:g}", f"{c['answer']['scheme']}, {c['answer']['step_fs']:.3g} fs", f"{c['length_ps']:.3g}",
            f"{c['refused']}, {c['surpassed']}", f"{100 * c['R_expected']:.3g} ± {100 * c['R_expected_error']:.2g}", f"{100 * c['bound']:.3g}",
            f"{c['reached']:.2f}", f"{fmean(over):.2f}", f"{max(over):.2f}", f"{c['kept']} of {c['runs']}", f"{c['below_bound']} of {c['runs']}"]


def report(result):
    heads = ["system", "required R [%]", "answer", "length [ps]", "sets rejected, improved", "expected R [%]", "97.5 % bound [%]", "bound / required",
             "mean R of new runs / required", "maximum", "met", "below the bound"]
    text = [study.table(heads, map(row, result["cases"]))]
    if answered := [c for c in result["cases"] if c["answer"]]:
        total = sum(c["runs"] for c in answered)
        for key, what in (("kept", "met the required R"), ("below_bound", "stayed below the bound, of which 97.5 % should")):
            count = sum(c[key] for c in answered)
            low, high = share_interval(count, total, "exact")
            text.append(f"{count} of {total} new runs {what}: {100 * count / total:.1f} %, 95 % interval {100 * low:.1f} to {100 * high:.1f} %.")
        reached = sorted(c["reached"] for c in answered)
        text.append(f"Bounds are {reached[0]:.2f} to {reached[-1]:.2f} of the requirement, {fmean(reached):.2f} on average; "
                    f"{sum(0.8 <= r <= 1 for r in reached)} of {len(reached)} are from 0.8 to 1.")
    return "\n".join(text)


if __name__ == "__main__":
    o = study.options(__doc__, {"systems": ["argon-108"], "accuracies": [5.0], "fresh": 2, "time": 2.0, "length": 4.0, "equilibrate": 0.5},
                      systems=(list(BOXES), "systems"), accuracies=([2.0, 0.5, 0.05], "required R [%]"), fresh=(10, "new runs for each answer"),
                      repeats=(1, "questions of each kind, each with another seed"), time=(60.0, "computing time of the adviser [s]"),
                      length=(15.0, "length of the runs for which advice is asked [ps]"),
                      equilibrate=(10.0, "equilibration of lattices and of new initial configurations [ps]"), seed=(1, "of the first question"))
    study.perform(o, measured, report)
