# SPDX-License-Identifier: MIT
"""`polhode study --quick` with many seeds and instruction sets: which curves lack points that the study of
docs/evidence/efficiency.md has."""

import csv
import re
from pathlib import Path

from lib import runs, study

FIGURE = study.ROOT / "docs/figure1/figure1.csv"
SHORT = ("--length", "0.08 ps", "--decorrelate", "0.01 ps", "--runs", "2", "--steps", "4 fs")  # of --smoke


def measured(o):
    text = (study.ROOT / "data/runs/default.toml").read_text(encoding="utf-8")

    def one(case):
        instruction_set, seed = case
        with runs.scratch() as folder:
            Path(folder, "run.toml").write_text(re.sub(r"^seed = .*$", f"seed = {seed}", text, flags=re.M), encoding="utf-8")
            said = runs.asked(o, "study", "run.toml", "--quick", "--threads", 1, *(SHORT if o.smoke else ()), folder=folder,
                              POLHODE_INSTRUCTION_SET=instruction_set)
        best = next(row.get("best", "none") for row in said["guidelines"] if row["R"] == 0.001)
        points = [{key: p[key] for key in ("scheme", "step_fs", "usable", "drift_p_value")} for p in said["points"]]
        return {"instruction_set": instruction_set, "seed": seed, "best": best, "points": points}

    return {"studies": runs.parallel(o, one, [(each, seed) for each in o.instruction_sets for seed in range(1, o.seeds + 1)])}


def last_steps():
    """The last step [fs] of each scheme's curve in the study of docs/evidence/efficiency.md."""
    last = {}
    for row in csv.DictReader(line for line in FIGURE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")):
        if row["usable [1]"] == "1":
            last[row["scheme"]] = max(last.get(row["scheme"], 0), float(row["step [fs]"]))
    return last


def missing(points, last):
    """The points that are not part of their curves, up to the last step of the reference."""
    return [p for p in points if p["step_fs"] <= last.get(p["scheme"], 0) and not p["usable"]]


def lone_drifts(points):
    """The points within a curve that have a significant energy drift without ending the curve."""
    return [p for p in points if p["usable"] and p["drift_p_value"] is not None and p["drift_p_value"] < 0.01]


def report(result):
    """A line for each study, and the number of curves that lack points."""
    last, rows, curves, lacking = last_steps(), [], 0, 0
    told = lambda points: ", ".join(f"{p['scheme']} {p['step_fs']:g} fs" for p in points) or "none"
    for s in result["studies"]:
        absent = missing(s["points"], last)
        curves += len({p["scheme"] for p in s["points"]})
        lacking += len({p["scheme"] for p in absent})
        rows.append([s["instruction_set"], s["seed"], told(absent), told(lone_drifts(s["points"])), s["best"]])
    heads = ["instruction set", "seed", "points missing", "significant drifts that end no curve", "cheapest at R = 0.1 %"]
    return study.table(heads, rows) + f"\n{lacking} of {curves} curves lack points"


if __name__ == "__main__":
    o = study.options(__doc__, {"seeds": 1, "instruction_sets": ["scalar"]}, seeds=(20, "1 to this number"),
                      instruction_sets=(["avx512", "scalar"], "instruction sets"))
    study.perform(o, measured, report)
