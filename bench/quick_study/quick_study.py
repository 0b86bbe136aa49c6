# SPDX-License-Identifier: MIT
"""`polhode study --quick` with many seeds and instruction sets: which curves lack points that the study of
docs/efficiency.md has. Exit code 1 if one does."""

import argparse
import csv
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FIGURE = ROOT / "docs/figure1/figure1.csv"


def run_file(seed):
    """The program's default run with another seed."""
    text = (ROOT / "data/runs/default.toml").read_text(encoding="utf-8")
    return re.sub(r"^seed = .*$", f"seed = {seed}", text, flags=re.M)


def study(o, seed, instruction_set):
    """The JSON of one study. One that was interrupted resumes; one that is complete is read."""
    folder = o.folder / f"{instruction_set}-{seed}"
    folder.mkdir(parents=True, exist_ok=True)
    result = folder / "result.json"
    if not result.exists():
        (folder / "run.toml").write_text(run_file(seed), encoding="utf-8")
        done = subprocess.run([o.polhode, "study", "run.toml", "--quick", "--threads", str(o.threads), "--json", *o.options],
                              cwd=folder, env={**os.environ, "POLHODE_INSTRUCTION_SET": instruction_set},
                              text=True, capture_output=True, check=False)
        if done.returncode != 0:
            raise SystemExit(f"{folder}: {done.stderr}")
        result.write_text(done.stdout, encoding="utf-8")
    print(f"{instruction_set}, seed {seed}: done", file=sys.stderr, flush=True)
    return json.loads(result.read_text(encoding="utf-8"))


def last_steps(lines):
    """The last step [fs] of each scheme's curve, from the points of a study as CSV."""
    last = {}
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        if row["usable [1]"] == "1":
            last[row["scheme"]] = max(last.get(row["scheme"], 0), float(row["step [fs]"]))
    return last


def missing(points, last):
    """(scheme, step [fs]) of the points that are not part of their curves, up to the last step of the reference."""
    return [(p["scheme"], p["step_fs"]) for p in points if p["step_fs"] <= last.get(p["scheme"], 0) and not p["usable"]]


def lone_drifts(points):
    """(scheme, step [fs]) of significant drifts within a curve: those that do not end it."""
    return [(p["scheme"], p["step_fs"]) for p in points if p["usable"] and p["drift_p_value"] < 0.01]


def report(studies, last):
    """A line for each study, and the number of curves that lack points."""
    curves = lacking = 0
    print("instruction set | seed | points missing | significant drifts that end no curve | cheapest at R = 0.1 %")
    print("--- | --- | --- | --- | ---")
    told = lambda points: ", ".join(f"{scheme} {step:g} fs" for scheme, step in points) or "none"
    for (instruction_set, seed), result in studies.items():
        absent = missing(result["points"], last)
        curves += len({p["scheme"] for p in result["points"]})
        lacking += len({scheme for scheme, _ in absent})
        best = next(row.get("best", "none") for row in result["guidelines"] if row["R"] == 0.001)
        print(f"{instruction_set} | {seed} | {told(absent)} | {told(lone_drifts(result['points']))} | {best}")
    print(f"\n{lacking} of {curves} curves lack points")
    return lacking


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--polhode", default=str(ROOT / "polhode"), help="the program")
    parser.add_argument("--seeds", type=int, default=20, help="1 to this number")
    parser.add_argument("--instruction-sets", nargs="+", default=["avx512", "scalar"])
    parser.add_argument("--jobs", type=int, default=1, help="studies at the same time")
    parser.add_argument("--threads", type=int, default=1, help="of each")
    parser.add_argument("--folder", type=Path, default=Path("quick-study"), help="of all studies; complete ones are not repeated")
    parser.add_argument("options", nargs="*", help="further options of the study, after --")
    o = parser.parse_args()
    o.polhode = str(Path(o.polhode).resolve())
    cases = [(one, seed) for one in o.instruction_sets for seed in range(1, o.seeds + 1)]
    with ThreadPoolExecutor(o.jobs) as pool:
        studies = dict(zip(cases, pool.map(lambda case: study(o, case[1], case[0]), cases)))
    return 1 if report(studies, last_steps(FIGURE.read_text(encoding="utf-8").splitlines())) else 0


if __name__ == "__main__":
    sys.exit(main())
