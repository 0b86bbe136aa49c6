# SPDX-License-Identifier: MIT
"""Multiple time steps compared with single schemes for 512 TIP4P waters: cost at equal R, wall-clock time, resonance."""

import argparse
from datetime import date
from pathlib import Path

import figure  # to find the modules shared by the benchmarks
import curves
import machine
import records

SYSTEM = """[system]
molecules = [{ model = "tip4p" }]
initial_configuration = "w512"
[forces]
precision = "%s"
%s
"""
LAWS = {"cutoff": 'cutoff = "1.0 nm"',
        "reaction-field": 'cutoff = "1.0 nm"\nelectrostatics = "reaction-field"',
        "pme": 'cutoff = "0.9 nm"\nelectrostatics = "pme"\npme_accuracy = 1e-4'}
SINGLE = {"velocity-verlet": (1, 1.5, 2, 2.5, 3), "hoa2": (2, 3, 4, 5, 6), "bcss3": (8, 9, 10, 12), "gier4-fd": (4, 5, 6)}
# Outer scheme, inner scheme, outer steps [fs] for each number of inner steps in a drift.
NESTED = [("velocity-verlet", "hoa2", {2: (3, 4), 4: (8, 10, 12, 14, 16)}),
          ("hoa2", "hoa2", {1: (6, 8, 10), 2: (8, 10)}),
          ("hoa2", "bcss3", {1: (8, 10)}),
          ("hoa2", "gier4-fd", {1: (8, 9, 10, 12)}),
          ("bcss3", "hoa2", {1: (12, 14)}),
          ("gier4-fd", "gier4-fd", {1: (6, 8, 10)})]
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
    """Studies of all curves."""
    run_file = o.folder / f"{law}.toml"
    run_file.write_text(SYSTEM % (o.precision, LAWS[law]), encoding="utf-8")
    return [point for number, (scheme, steps) in enumerate(ladder(o))
            for point in curves.study(o, run_file, o.folder / f"{law}-{number}", scheme, steps)]


def guideline(o, law, found):
    """Single and nested schemes at each R: cost, and the time of the best of each."""
    rows = []
    for ratio in RATIOS:
        row = {"R": ratio}
        for kind in ("single", "nested"):
            costs = [(curves.at_ratio(own, ratio), scheme) for scheme, own in curves.by_scheme(found).items()
                     if ("/" in scheme) == (kind == "nested")]
            costs = sorted((c[0], c[1], scheme) for c, scheme in costs if c)
            if costs:
                row[kind] = {"scheme": costs[0][2], "step_fs": costs[0][1], "cost": costs[0][0]}
        if len(row) == 3:
            pair = [(row[k]["scheme"], row[k]["step_fs"]) for k in ("single", "nested")]
            times = curves.seconds_per_ps(o, o.folder / f"{law}.toml", pair)
            if not all(key in times for key in pair):
                continue
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
    curves.add_arguments(parser, runs=6, length=10, decorrelate=5, folder="nested")
    parser.add_argument("--laws", nargs="+", default=["cutoff", "pme"], choices=list(LAWS))
    parser.add_argument("--reaches", nargs="+", type=float, default=list(REACHES), help="cutoff of the near forces [nm]")
    o = parser.parse_args()
    o.polhode = machine.program(o.polhode)
    o.folder = Path(o.folder)
    o.folder.mkdir(parents=True, exist_ok=True)
    result = {"conditions": [f"{date.today()}", f"{machine.processor()}, one thread, {o.precision} precision",
                             f"bench/multiple_time_steps/multiple_time_steps.py --laws {' '.join(o.laws)} --runs {o.runs} --length {o.length:g} "
                             f"--decorrelate {o.decorrelate:g} --reaches {' '.join(f'{r:g}' for r in o.reaches)}"],
              "laws": {}}
    for law in o.laws:
        found = points(o, law)
        result["laws"][law] = {"points": found, "guideline": guideline(o, law, found)}
    records.write(Path(o.output), result)
    print(table(result))
    if o.figure:
        figure.draw(result, Path(o.figure))


if __name__ == "__main__":
    main()
