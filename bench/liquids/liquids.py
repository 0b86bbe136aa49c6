# SPDX-License-Identifier: MIT
"""Energy, pressure and the first peak of the O-O radial distribution of liquid TIP4P, SPC/E and TIP4P/2005 at
298.15 K, from runs at constant energy with PME, with block errors."""

import argparse
import sys
import tempfile
from datetime import date
from math import sqrt
from pathlib import Path
from statistics import fmean, stdev

import analysis
import figure  # to find the modules shared by the benchmarks
import machine
import records
import waters


def properties(water, runs, o):
    """The results for one water model, from its runs."""
    samples = [r.energies for r in runs]
    found = analysis.blocks(samples, o.blocks)
    at = lambda own: analysis.at_temperature(own, waters.TEMPERATURE)
    value, error = analysis.jackknife(found, at)
    by_run = analysis.jackknife(analysis.blocks(samples, 1), at)[1] if len(runs) > 2 else {}
    of = lambda name, scale: {"value": value[name] * scale, "error": error[name] * scale,
                              "error_by_run": by_run.get(name, error[name]) * scale}
    mean = lambda k, name: fmean(getattr(b, name) for b in found if b.run == k)
    means = [{"temperature_K": mean(k, "temperature"), "potential_kJ_per_mol": mean(k, "potential") / o.count,
              "total_kJ_per_mol": mean(k, "total") / o.count, "pressure_bar": mean(k, "pressure"),
              "temperature_translation_K": r.summary["temperature_translation_K"],
              "temperature_rotation_K": r.summary["temperature_rotation_K"],
              "R": r.summary["R"], "drift_kJ_per_mol_ps": r.summary["drift_kJ_per_mol_ps"]}
             for k, r in enumerate(runs)]
    temperatures = [m["temperature_K"] for m in means]
    peak, peak_error = analysis.first_peak([(t, r.peak["peak_nm"]["value"], r.peak["peak_height"]["value"])
                                            for t, r in zip(temperatures, runs)], waters.TEMPERATURE)
    g = [[round(bins[0][0], 6), round(fmean(value for _, value in bins), 6)] for bins in zip(*(r.g for r in runs))]
    return {"model": water.model, "name": water.name, "density_g_per_cm3": water.density,
            "potential_kJ_per_mol": of("potential", 1 / o.count), "pressure_bar": of("pressure", 1),
            "heat_capacity_J_per_mol_K": of("heat_capacity", 1000 / o.count),
            "peak_nm": {"value": peak["place"], "error": peak_error["place"]},
            "peak_height": {"value": peak["height"], "error": peak_error["height"]},
            "temperature_K": {"value": fmean(temperatures), "error": stdev(temperatures) / sqrt(len(temperatures))},
            "pressure_block_errors_bar": analysis.block_errors(samples, "pressure", o.halvings),
            "temperature_block_errors_K": analysis.block_errors(samples, "temperature", o.halvings),
            "runs": means, "g": g}


def shown(number, digits):
    return f"{number['value']:.{digits}f} ± {number['error']:.{digits}f}"


def table(result):
    """The results in Markdown."""
    rows = ["| | density [g/cm³] | mean T of the runs [K] | potential energy [kJ/mol] | pressure [bar] "
            "| heat capacity [J/mol/K] | first peak [nm] | its height |",
            "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    rows += [f"| {w['name']} | {w['density_g_per_cm3']:g} | {shown(w['temperature_K'], 2)} "
             f"| {shown(w['potential_kJ_per_mol'], 3)} | {shown(w['pressure_bar'], 0)} "
             f"| {shown(w['heat_capacity_J_per_mol_K'], 1)} | {shown(w['peak_nm'], 5)} | {shown(w['peak_height'], 3)} |"
             for w in result["waters"]]
    return "\n".join(rows)


def report(result):
    """The report stored with the JSON file: conditions, the table, each run, and how errors grow with the block length."""
    text = [f"# {', '.join(result['conditions'][:2])}", "", f"`{result['conditions'][2]}`", "",
            "At 298.15 K, with errors by the jackknife over blocks:", "", table(result), "",
            "Each run: mean temperature, of translation and of rotation about the principal axes; R and energy drift of the "
            "total energy:", "",
            "| | run | T [K] | of translation | of rotation | potential [kJ/mol] | pressure [bar] | R [%] "
            "| energy drift [kJ/mol/ps] |", "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for w in result["waters"]:
        for k, r in enumerate(w["runs"], 1):
            axes = " ".join(f"{t:.2f}" for t in r["temperature_rotation_K"])
            text.append(f"| {w['name']} | {k} | {r['temperature_K']:.2f} | {r['temperature_translation_K']:.2f} "
                        f"| {axes} | {r['potential_kJ_per_mol']:.4f} | {r['pressure_bar']:.0f} | {100 * r['R']:.4f} "
                        f"| {r['drift_kJ_per_mol_ps']:.1e} |")
    counts = [c for c, _ in result["waters"][0]["pressure_block_errors_bar"]]
    text += ["", "Errors by the jackknife over whole runs in place of blocks:", "",
             "| | potential energy [kJ/mol] | pressure [bar] | heat capacity [J/mol/K] |", "| --- | --- | --- | --- |"]
    text += [f"| {w['name']} | {w['potential_kJ_per_mol']['error_by_run']:.3f} "
             f"| {w['pressure_bar']['error_by_run']:.0f} | {w['heat_capacity_J_per_mol_K']['error_by_run']:.1f} |"
             for w in result["waters"]]
    text += ["", "Error of the mean over all runs, by the number of blocks a run is cut into:", "",
             "| | " + " | ".join(map(str, counts)) + " |", "| --- |" + " --- |" * len(counts)]
    for w in result["waters"]:
        for name, key in (("pressure [bar]", "pressure_block_errors_bar"), ("T [K]", "temperature_block_errors_K")):
            text.append(f"| {w['name']}, {name} | " + " | ".join(f"{e:.3g}" for _, e in w[key]) + " |")
    return "\n".join(text) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--polhode", default="polhode", help="path of polhode")
    parser.add_argument("--quick", action="store_true", help="2 runs of 3 ps of 216 waters: a few seconds, a test without useful results")
    parser.add_argument("--runs", type=int, default=8, help="runs of each water model, each from another initial configuration; at least 2")
    parser.add_argument("--spread", type=float, default=8, help="two of the runs are colder and warmer by this much [K]")
    parser.add_argument("--count", type=int, default=360, help="waters in a run")
    parser.add_argument("--length", type=float, default=100, help="length of a run at constant energy [ps]")
    parser.add_argument("--equilibrate", type=float, default=20, help="length of the equilibration with velocity rescaling [ps]")
    parser.add_argument("--every", type=float, default=1, help="time between frames for the radial distribution function [ps]")
    parser.add_argument("--blocks", type=int, default=5, help="number of blocks of a run, for errors")
    parser.add_argument("--folder", type=Path, help="where runs are stored; stored runs are read, not repeated")
    parser.add_argument("--output", default="liquids", help="prefix of the JSON and Markdown files")
    parser.add_argument("--figure", help="SVG or PNG")
    o = parser.parse_args()
    if o.quick:
        o.runs, o.count, o.length, o.equilibrate, o.every, o.blocks = 2, 216, 3, 1, 0.2, 3
    if o.runs < 2:
        parser.error("a line through the temperatures needs --runs 2 at least")
    o.halvings = [2, 4] if o.quick else [2, 4, 5, 8, 10, 20, 40, 100]
    o.polhode = machine.program(o.polhode)
    # Two runs colder and warmer than the others: without them the slope with T would be dominated by noise.
    temperatures = [waters.TEMPERATURE] * (o.runs - 2) + [waters.TEMPERATURE + d for d in (-o.spread, o.spread)]
    result = {"conditions": [f"{date.today()}", f"{machine.processor()}, one thread",
                             "bench/liquids/liquids.py " + ("--quick" if o.quick else
                             f"--runs {o.runs} --spread {o.spread:g} --count {o.count} --length {o.length:g} "
                             f"--equilibrate {o.equilibrate:g} --every {o.every:g} --blocks {o.blocks}")],
              "temperature_K": waters.TEMPERATURE, "waters": []}
    with tempfile.TemporaryDirectory() as scratch:
        folder = o.folder or Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for water in waters.WATERS:
            runs = [waters.run(o.polhode, folder, water, o.count, seed, temperature, o.equilibrate, o.length, o.every)
                    for seed, temperature in enumerate(temperatures, 1)]
            result["waters"].append(properties(water, runs, o))
            print(f"{water.name} done", file=sys.stderr, flush=True)
    records.write(Path(f"{o.output}.json"), result)
    Path(f"{o.output}.md").write_text(report(result), encoding="utf-8")
    print(table(result))
    if o.figure:
        figure.draw(result, Path(o.figure))


if __name__ == "__main__":
    main()
