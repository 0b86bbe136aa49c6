# SPDX-License-Identifier: MIT
"""Energy, pressure and the first peak of the O-O radial distribution of liquid TIP4P, SPC/E and TIP4P/2005 at 298.15 K,
from runs at constant energy with PME, with block errors."""

from pathlib import Path
from statistics import fmean

import numpy as np
from lib import runs, study, waters
from lib.statistics import block_mean, estimate, jackknife, text

HALVINGS = (2, 4, 5, 8, 10, 20, 40, 100)  # numbers of blocks of a run


def blocks(series, count):
    """Means over `count` equal blocks of each run, without the first sample."""
    found = []
    for k, samples in enumerate(series):
        size = (len(samples) - 1) // count
        found += [{"run": k, **samples.iloc[1 + b * size:1 + (b + 1) * size].mean()} for b in range(count)]
    return found


def on_line(x, y, at):
    """The value of the least-squares line; the mean of y where all x are equal."""
    return float(np.polyval(np.polyfit(x, y, 1), at) if len(set(x)) > 1 else np.mean(y))


def at_temperature(found, temperature):
    """Potential energy and pressure at the required mean temperature, and dE/dT. A run is characterized
    by its total energy, which is conserved: T(E), V(E) and P(E) are fitted by lines, and E is chosen to give T."""
    column = lambda name: np.array([b[name] for b in found])
    slope, intercept = np.polyfit(column("total"), column("temperature"), 1)
    energy = (temperature - intercept) / slope
    return {"heat_capacity": 1 / float(slope), **{name: on_line(column("total"), column(name), energy) for name in ("potential", "pressure")}}


def first_peak(peaks, temperature):
    """Position and height of the first peak of g(r) at a temperature, from (temperature, place, height) of each run."""
    at = lambda own: {name: on_line(*list(zip(*own))[:1], [r[k] for r in own], temperature) for k, name in ((1, "place"), (2, "height"))}
    return jackknife(peaks, at)


def block_errors(series, column, counts):
    """(blocks a run, error of the mean over all runs) from the scatter of blocks about the mean of their own run."""
    error = lambda samples, count: block_mean(samples[column].to_numpy()[1:], count)[1]
    return [(count, float(np.sqrt(sum(error(s, count) ** 2 for s in series)) / len(series))) for count in counts]


def properties(water, found, o):
    """The results for a water model, from (report, energies, peak, g) of its runs."""
    reports, series, peaks, g = zip(*found)
    parts = blocks(series, o.blocks)
    at = lambda own: at_temperature(own, waters.TEMPERATURE)
    value, error = jackknife(parts, at)
    by_run = jackknife(blocks(series, 1), at)[1] if len(found) > 2 else error
    of = lambda name, scale: {"value": value[name] * scale, "error": error[name] * scale, "error_by_run": by_run[name] * scale}
    mean = lambda k, name: fmean(b[name] for b in parts if b["run"] == k)
    means = [{"temperature_K": mean(k, "temperature"), "potential_kJ_per_mol": mean(k, "potential") / o.count,
              "total_kJ_per_mol": mean(k, "total") / o.count, "pressure_bar": mean(k, "pressure"),
              **{key: r[key] for key in ("temperature_translation_K", "temperature_rotation_K", "R", "drift_kJ_per_mol_ps")}}
             for k, r in enumerate(reports)]
    temperatures = [m["temperature_K"] for m in means]
    peak, peak_error = first_peak([(t, p["peak_nm"]["value"], p["peak_height"]["value"]) for t, p in zip(temperatures, peaks)], waters.TEMPERATURE)
    halvings = [n for n in HALVINGS if n <= len(series[0]) // 4]
    return {"model": water.model, "name": water.name, "density_g_per_cm3": water.density,
            "potential_kJ_per_mol": of("potential", 1 / o.count), "pressure_bar": of("pressure", 1),
            "heat_capacity_J_per_mol_K": of("heat_capacity", 1000 / o.count),
            "peak_nm": {"value": peak["place"], "error": peak_error["place"]},
            "peak_height": {"value": peak["height"], "error": peak_error["height"]}, "temperature_K": estimate(temperatures),
            "pressure_block_errors_bar": block_errors(series, "pressure", halvings),
            "temperature_block_errors_K": block_errors(series, "temperature", halvings),
            "runs": means, "g": np.round(np.mean(g, axis=0), 6).tolist()}


def measured(o):
    # One run is colder and one run is warmer than the other runs; otherwise noise would dominate the slope with temperature.
    temperatures = [waters.TEMPERATURE] * (o.runs - 2) + [waters.TEMPERATURE + d for d in (-o.spread, o.spread)]
    cases = [(water, seed, T) for water in waters.WATERS for seed, T in enumerate(temperatures, 1)]

    def one(case):
        prefix, report = waters.made(o, folder, *case)
        peak, = waters.analyzed(o, folder, prefix, "--what", "rdf")["rdf"]
        column = lambda name: runs.columns(Path(folder, f"{prefix}-{name}.csv"))
        return report, column("energies"), peak, column("rdf")[["r", "g OW-OW"]].to_numpy()

    with runs.scratch(o) as folder:
        found = runs.parallel(o, one, cases)
    return {"temperature_K": waters.TEMPERATURE,
            "waters": [properties(water, [f for c, f in zip(cases, found) if c[0] == water], o) for water in waters.WATERS]}


def report(result):
    """The results, each run, and the growth of errors with the block length."""
    cell = lambda number, digits: text((number["value"], number["error"]), digits)
    all_waters = result["waters"]
    parts = ["At 298.15 K, with errors by the jackknife over blocks:\n", study.table(
        ["", "density [g/cm³]", "mean T of the runs [K]", "potential energy [kJ/mol]", "pressure [bar]", "heat capacity [J/mol/K]", "first peak [nm]",
         "its height"],
        [[w["name"], f"{w['density_g_per_cm3']:g}", cell(w["temperature_K"], 2), cell(w["potential_kJ_per_mol"], 3), cell(w["pressure_bar"], 0),
          cell(w["heat_capacity_J_per_mol_K"], 1), cell(w["peak_nm"], 5), cell(w["peak_height"], 3)] for w in all_waters]),
        "Each run: mean temperature, of translation and of rotation about the principal axes; R and energy drift of the total energy:\n", study.table(
        ["", "run", "T [K]", "of translation", "of rotation", "potential [kJ/mol]", "pressure [bar]", "R [%]", "energy drift [kJ/mol/ps]"],
        [[w["name"], k, f"{r['temperature_K']:.2f}", f"{r['temperature_translation_K']:.2f}", " ".join(f"{t:.2f}" for t in r["temperature_rotation_K"]),
          f"{r['potential_kJ_per_mol']:.4f}", f"{r['pressure_bar']:.0f}", f"{100 * r['R']:.4f}", f"{r['drift_kJ_per_mol_ps']:.1e}"]
         for w in all_waters for k, r in enumerate(w["runs"], 1)]),
        "Errors by the jackknife over whole runs in place of blocks:\n", study.table(
        ["", "potential energy [kJ/mol]", "pressure [bar]", "heat capacity [J/mol/K]"],
        [[w["name"], *(f"{w[key]['error_by_run']:.{d}f}" for key, d in (("potential_kJ_per_mol", 3), ("pressure_bar", 0), ("heat_capacity_J_per_mol_K", 1)))]
         for w in all_waters]),
        "Error of the mean over all runs, by the number of blocks a run is cut into:\n", study.table(
        ["", *(count for count, _ in all_waters[0]["pressure_block_errors_bar"])],
        [[f"{w['name']}, {name}", *(f"{e:.3g}" for _, e in w[key])] for w in all_waters
         for name, key in (("pressure [bar]", "pressure_block_errors_bar"), ("T [K]", "temperature_block_errors_K"))])]
    return "\n".join(parts)


def draw(result):
    """g(r) of the oxygens of each water, and their first peaks larger."""
    from lib import figures
    figure, ((whole, peak),) = figures.panels(2, size=(10, 4.4), width_ratios=(3, 2))
    for ax in (whole, peak):
        for w, colour in zip(result["waters"], figures.PALETTE):
            ax.plot(*zip(*w["g"]), color=colour, label=w["name"])
        ax.set_xlabel("r  (nm)")
    whole.axhline(1, color=figures.INK, linewidth=0.8, linestyle=":", label="no structure")
    whole.set(title="oxygen-oxygen radial distribution, 298 K", ylabel="g$_{\\rm OO}$", xlim=(0.2, 0.9), ylim=(0, 3.5))
    whole.legend()
    peak.set(title="first peak", xlim=(0.26, 0.30), ylim=(2, 3.5))
    return figure


if __name__ == "__main__":
    o = study.options(__doc__, {"runs": 2, "count": 216, "length": 2.0, "equilibrate": 0.5, "every": 0.2, "blocks": 3},
                      runs=(8, "runs of each water model, each from another initial configuration; at least 2"),
                      spread=(8.0, "two of the runs are colder and warmer by this much [K]"), count=(360, "waters in a run"),
                      cutoff=(0.9, "cutoff [nm]"), length=(100.0, "length of a run at constant energy [ps]"),
                      equilibrate=(20.0, "length of the equilibration with velocity rescaling [ps]"),
                      every=(1.0, "time between frames for the radial distribution function [ps]"), blocks=(5, "blocks of a run, for errors"))
    study.perform(o, measured, report, draw)
