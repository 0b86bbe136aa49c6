# SPDX-License-Identifier: MIT
"""Multiple time steps against single schemes on 512 TIP4P waters: cost at equal R, wall-clock time, resonance."""

import argparse
import json
import subprocess
import sys
from datetime import date
from math import exp, log
from pathlib import Path

import figure  # which finds what benchmarks share
import machine

SYSTEM = """[system]
molecules = [{ model = "tip4p" }]
start = "w512"
[forces]
precision = "%s"
%s
"""
LAWS = {"cutoff": 'cutoff = "1.0 nm"',
        "reaction-field": 'cutoff = "1.0 nm"\nelectrostatics = "reaction-field"',
        "pme": 'cutoff = "0.9 nm"\nelectrostatics = "pme"\naccuracy = 1e-3'}
SINGLE = {"velocity-verlet": (1, 1.5, 2, 2.5, 3), "hoa2": (2, 3, 4, 5, 6, 7), "gier4": (4, 5, 6, 7)}
# Outer scheme, inner scheme, outer steps [fs] for each number of inner steps in a drift.
NESTED = [("velocity-verlet", "hoa2", {1: (3, 4, 5, 6), 2: (3, 4, 5, 6, 8)}),
          ("velocity-verlet", "gier4", {1: (3, 4, 5, 6)}),
          ("hoa2", "hoa2", {1: (6, 8, 10), 2: (6, 8, 10, 12)}),
          ("hoa2", "gier4", {1: (6, 8, 10), 2: (8, 10, 12)}),
          ("gier4", "gier4", {1: (6, 8, 10), 2: (8, 10)})]
REACHES = (0.4, 0.5, 0.6, 0.7)  # [nm]
RATIOS = (0.01, 0.005, 0.001)


def ladder(o):
    """(scheme text, steps [fs]) of all curves."""
    yield from SINGLE.items()
    for outer, inner, counts in NESTED:
        for n, steps in counts.items():
            for reach in o.reaches:
                yield f"{outer} / {inner} x {n} within {0.7 * reach:g} to {reach:g} nm", steps


def points(o, law):
    """Studies of all curves; one that was cut short goes on where it was."""
    run_file = o.folder / f"{law}.toml"
    run_file.write_text(SYSTEM % (o.precision, LAWS[law]), encoding="utf-8")
    found = []
    for number, (scheme, steps) in enumerate(ladder(o)):
        prefix = o.folder / f"{law}-{number}"
        command = [o.polhode, "study", str(run_file), "--schemes", scheme, "--steps", *(f"{h:g} fs" for h in steps),
                   "--runs", str(o.runs), "--length", f"{o.length:g} ps", "--decorrelate", f"{o.decorrelate:g} ps",
                   "--threads", "1", "--output", str(prefix), "--json"]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        found += json.loads(done.stdout)["points"]
        print(f"{law}: {scheme} done", file=sys.stderr, flush=True)
    return found


def curves(found):
    """Points by scheme, by growing step."""
    result = {}
    for p in found:
        result.setdefault(p["scheme"], []).append(p)
    for own in result.values():
        own.sort(key=lambda p: p["step_fs"])
    return result


def at_ratio(own, ratio):
    """(cost, step [fs]) of a curve at R, by interpolation in logarithms between neighbouring points that are usable;
    nothing beyond the measured ones, but the longest usable step where even its R is below."""
    usable = []
    for p in own:
        if not p["usable"]:
            break
        usable.append(p)
    if not usable or usable[0]["R"] > ratio:
        return None
    for a, b in zip(usable, usable[1:]):
        if a["R"] <= ratio < b["R"]:
            part = log(ratio / a["R"]) / log(b["R"] / a["R"])
            mix = lambda key: exp(log(a[key]) + part * log(b[key] / a[key]))
            return mix("force_evaluations_per_ps"), mix("step_fs")
    return usable[-1]["force_evaluations_per_ps"], usable[-1]["step_fs"]


def seconds_per_ps(o, law, chosen):
    """Wall-clock time of (scheme, step) pairs, energies not sampled: the best of repeats in turn."""
    best = {}
    for _ in range(o.repeats):
        for scheme, step in chosen:
            command = [o.polhode, "run", str(o.folder / f"{law}-clock.toml"), "--scheme", scheme, "--step",
                       f"{step:.3f} fs", "--length", f"{o.clock:g} ps", "--threads", "1", "--force", "--json",
                       "--output", str(o.folder / "clock")]
            done = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
            time = (done["seconds"]["all"] - done["seconds"]["energies_and_output"]) / done["length_ps"]
            best[scheme, step] = min(time, best.get((scheme, step), time))
    return best


def guideline(o, law, found):
    """Single against nested at each R: cost, and the time of the best of both."""
    (o.folder / f"{law}-clock.toml").write_text(
        SYSTEM % (o.precision, LAWS[law]) + f'[run]\nsample = "{o.clock:g} ps"\n'
        '[output]\ntrajectory_every = "0 ps"\nplot = "none"\n', encoding="utf-8")
    rows = []
    for ratio in RATIOS:
        row = {"R": ratio}
        for kind in ("single", "nested"):
            costs = [(at_ratio(own, ratio), scheme) for scheme, own in curves(found).items()
                     if ("/" in scheme) == (kind == "nested")]
            costs = sorted((c[0], c[1], scheme) for c, scheme in costs if c)
            if costs:
                row[kind] = {"scheme": costs[0][2], "step_fs": costs[0][1], "cost": costs[0][0]}
        if len(row) == 3:
            pair = [(row[k]["scheme"], row[k]["step_fs"]) for k in ("single", "nested")]
            times = seconds_per_ps(o, law, pair)
            for kind, key in zip(("single", "nested"), pair):
                row[kind]["seconds_per_ps"] = times[key]
        rows.append(row)
    return rows


def table(result):
    rows = ["| forces | R [%] | best single scheme | cost [1/ps] | time [s/ns] | best nested scheme | cost [1/ps] "
            "| time [s/ns] | gain in cost | in time |",
            "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for law, of in result["laws"].items():
        for row in of["guideline"]:
            if len(row) < 3:
                continue
            s, n = row["single"], row["nested"]
            rows.append(f"| {law} | {100 * row['R']:g} | {s['scheme']}, {s['step_fs']:.1f} fs | {s['cost']:.0f} "
                        f"| {1000 * s['seconds_per_ps']:.0f} | {n['scheme']}, {n['step_fs']:.1f} fs | {n['cost']:.0f} "
                        f"| {1000 * n['seconds_per_ps']:.0f} | {s['cost'] / n['cost']:.2f} "
                        f"| {s['seconds_per_ps'] / n['seconds_per_ps']:.2f} |")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--polhode", default="polhode", help="the program")
    parser.add_argument("--precision", default="mixed", choices=("mixed", "double"))
    parser.add_argument("--laws", nargs="+", default=["cutoff", "pme"], choices=list(LAWS))
    parser.add_argument("--reaches", nargs="+", type=float, default=list(REACHES), help="of near forces [nm]")
    parser.add_argument("--runs", type=int, default=6, help="at each point")
    parser.add_argument("--length", type=float, default=10, help="of each [ps]")
    parser.add_argument("--decorrelate", type=float, default=5, help="preparation of each start [ps]")
    parser.add_argument("--clock", type=float, default=2, help="length of a run whose time counts [ps]")
    parser.add_argument("--repeats", type=int, default=5, help="of those, in turn")
    parser.add_argument("--folder", type=Path, default=Path("nested"), help="keeps the studies, and goes on from them")
    parser.add_argument("--output", default="nested.json")
    parser.add_argument("--figure", help="SVG or PNG")
    o = parser.parse_args()
    o.polhode = machine.program(o.polhode)
    o.folder.mkdir(parents=True, exist_ok=True)
    result = {"conditions": [f"{date.today()}", f"{machine.processor()}, one thread, {o.precision} precision",
                             f"bench/nested/nested.py --laws {' '.join(o.laws)} --runs {o.runs} --length {o.length:g} "
                             f"--decorrelate {o.decorrelate:g} --reaches {' '.join(f'{r:g}' for r in o.reaches)}"],
              "laws": {}}
    for law in o.laws:
        found = points(o, law)
        result["laws"][law] = {"points": found, "guideline": guideline(o, law, found)}
    Path(o.output).write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    print(table(result))
    if o.figure:
        figure.draw(result, Path(o.figure))


if __name__ == "__main__":
    main()
