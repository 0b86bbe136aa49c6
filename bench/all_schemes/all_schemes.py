# SPDX-License-Identifier: MIT
"""All built-in schemes compared at equal R: cost and wall-clock time, for water and another liquid."""

import argparse
import json
import subprocess
from datetime import date
from math import sqrt
from pathlib import Path

import figure  # to find the modules shared by the benchmarks
import curves
import machine
import records

W512 = '[system]\nmolecules = [{ model = "tip4p" }]\ninitial_configuration = "w512"\n'
CO2 = '[system]\nmolecules = [{ model = "co2", count = 216 }]\ndensity = "0.9 g/cm3"\ntemperature = "280 K"\n'
SYSTEMS = {
    "reaction-field": W512 + '[forces]\ncutoff = "0.9 nm"\nelectrostatics = "reaction-field"\n',
    "pme": W512 + '[forces]\ncutoff = "0.9 nm"\nelectrostatics = "pme"\npme_accuracy = 1e-4\n',
    "co2": CO2 + '[forces]\ntruncation = "site-switch"\ncutoff = "1.0 nm"\n',
}
COSTS = {"reaction-field": (2000, 8), "pme": (2000, 8), "co2": (1000, 9)}  # maximum of force evaluations per ps; steps
FACTOR = sqrt(2)  # between costs of neighbouring steps
RATIOS = (0.015, 0.01, 0.004, 0.001, 0.0001)
TIMED = 3  # schemes at each R whose time is measured


def table_of_schemes(o):
    """Name, order and cost of the requested schemes, from the program."""
    known = json.loads(subprocess.run([o.polhode, "schemes", "--json"], check=True, capture_output=True, text=True).stdout)
    return [s for s in known if not o.schemes or s["name"] in o.schemes]


def steps(system, cost):
    """Steps [fs] at equal costs for every scheme."""
    max_cost, points = COSTS[system]
    return [float(f"{1000 * cost / (max_cost / FACTOR**k):.3g}") for k in range(points)]


def cost_at(own, ratio, order):
    """(cost, step [fs], how): measured; or extrapolated by the order below the smallest R; or of the longest usable step."""
    found = curves.at_ratio(own, ratio)
    good = curves.usable(own)
    if found:
        return *found, "" if good[-1]["R"] > ratio else "+"
    if not good:
        return None
    shorter = (ratio / good[0]["R"]) ** (1 / order)
    return good[0]["force_evaluations_per_ps"] / shorter, good[0]["step_fs"] * shorter, "*"


def ranking(points, orders):
    """At each R the schemes by cost."""
    rows = []
    for ratio in RATIOS:
        found = [(cost_at(own, ratio, orders[scheme]), scheme) for scheme, own in curves.by_scheme(points).items()]
        rows.append({"R": ratio, "schemes": [{"scheme": scheme, "cost": c[0], "step_fs": c[1], "how": c[2]}
                                             for c, scheme in sorted((f for f in found if f[0]), key=lambda f: f[0][0])]})
    return rows


def add_times(o, run_file, rows):
    """The time of the first schemes at each R, and of the paper's."""
    for row in rows:
        timed = [r for k, r in enumerate(row["schemes"]) if k < TIMED or r["scheme"] in ("velocity-verlet", "hoa2", "gier4")]
        times = curves.seconds_per_ps(o, run_file, [(r["scheme"], r["step_fs"]) for r in timed])
        for r in timed:
            if (r["scheme"], r["step_fs"]) in times:
                r["seconds_per_ps"] = times[r["scheme"], r["step_fs"]]


def tables(result):
    """One for each system: rows are schemes, columns R, cells force evaluations per ps and seconds per ns where timed."""
    text = []
    for system, of in result["systems"].items():
        heads = [f"{100 * r['R']:g} %" for r in of["ranking"]]
        text += [f"### {system}", "", "| scheme | " + " | ".join(heads) + " |", "| --- |" + " --- |" * len(heads)]
        cells = {}
        for column, row in enumerate(of["ranking"]):
            for rank, s in enumerate(row["schemes"]):
                cell = f"{s['cost']:.0f}{s['how']}" + (f" ({1000 * s['seconds_per_ps']:.0f} s)" if "seconds_per_ps" in s else "")
                cells.setdefault(s["scheme"], {})[column] = f"**{cell}**" if rank == 0 else cell
        rank_sum = lambda name: sum(next((k for k, s in enumerate(r["schemes"]) if s["scheme"] == name), 99) for r in of["ranking"])
        for name in sorted(cells, key=rank_sum):
            text.append(f"| {name} | " + " | ".join(cells[name].get(k, "") for k in range(len(heads))) + " |")
        text.append("")
    return "\n".join(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    curves.add_arguments(parser, runs=4, length=8, decorrelate=5, folder="all-schemes")
    parser.add_argument("--systems", nargs="+", default=list(SYSTEMS), choices=list(SYSTEMS))
    parser.add_argument("--schemes", nargs="+", help="default: all of the table")
    o = parser.parse_args()
    o.polhode = machine.program(o.polhode)
    o.folder = Path(o.folder)
    o.folder.mkdir(parents=True, exist_ok=True)
    schemes = table_of_schemes(o)
    result = {"conditions": [f"{date.today()}", f"{machine.processor()}, {o.precision} precision",
                             f"bench/all_schemes/all_schemes.py --systems {' '.join(o.systems)} --runs {o.runs} "
                             f"--length {o.length:g} --decorrelate {o.decorrelate:g}"],
              "systems": {}}
    for system in o.systems:
        run_file = o.folder / f"{system}.toml"
        run_file.write_text(SYSTEMS[system].replace("[forces]\n", f'[forces]\nprecision = "{o.precision}"\n'), encoding="utf-8")
        points = [p for s in schemes
                  for p in curves.study(o, run_file, o.folder / f"{system}-{s['name']}", s["name"], steps(system, s["cost"]))]
        rows = ranking(points, {s["name"]: s["order"] for s in schemes})
        add_times(o, run_file, rows)
        result["systems"][system] = {"points": points, "ranking": rows}
        records.write(Path(o.output), result)
    print(tables(result))
    if o.figure:
        figure.draw(result, Path(o.figure))


if __name__ == "__main__":
    main()
