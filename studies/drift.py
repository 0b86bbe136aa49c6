# SPDX-License-Identifier: MIT
"""Calibration of the stated errors and of the test for an energy drift: many runs without energy drift, for schemes of
second and fourth order, at constant energy and with each thermostat, as reported by the program. Each run is suspended
and resumed, so it is judged at several lengths. --design walk: most conserved energies perform a random walk; noise:
none does, and the shadow energy is judged too."""

from pathlib import Path
from typing import NamedTuple

from lib import runs, study
from lib.statistics import over_scatter, rms, share_interval


class Cell(NamedTuple):
    """A system with a scheme."""
    model: str
    count: int
    scheme: str
    step: float  # [fs]
    lengths: tuple  # at which a run is judged [ps]
    smoothness: int = 2
    thermostat: str | None = None


BOXES = {  # density, cutoff, temperature, sample [fs]
    ("argon", 32): ("1.37 g/cm3", "0.55 nm", "100 K", 20), ("n2", 32): ("0.8 g/cm3", "0.55 nm", "80 K", 16),
    ("tip4p", 27): ("0.997 g/cm3", "0.45 nm", "297 K", 8), ("tip4p", 64): ("0.997 g/cm3", "0.6 nm", "297 K", 4),
    ("argon", 64): ("1.37 g/cm3", "0.7 nm", "100 K", 10)}
WALKS = {  # scheme, step [fs], smoothness, thermostat
    ("argon", 32): [("velocity-verlet", 10), ("gier4", 5), ("gier4", 5, 3), ("gier4-fd", 10), ("velocity-verlet", 5, 2, "langevin"),
                    ("baoab", 10, 2, "langevin"), ("hoa2", 10, 3, "rescaling")],
    ("n2", 32): [("hoa2", 8), ("gier4", 4), ("gier4", 8, 3), ("gier4-fd", 8, 2, "langevin"), ("hoa2", 8, 2, "separate-rescaling")],
    ("tip4p", 27): [("velocity-verlet", 2), ("gier4-fd", 4), ("gier4", 4, 3), ("hoa2", 4, 2, "langevin"), ("hoa2", 4, 2, "rescaling")]}
NOISE = {("tip4p", 27): (2, 4, (10, 30, 100)), ("tip4p", 64): (2, 4, (15, 30, 100)), ("argon", 64): (5, 10, (10, 30, 100))}
DESIGNS = {  # equilibration [ps], cells
    "walk": (5, [Cell(*box, *how[:2], (8, 40), *how[2:]) for box, of in WALKS.items() for how in of]),
    "noise": (20, [Cell(*box, scheme, step, lengths) for box, (short, long, lengths) in NOISE.items()
                   for scheme, step in (("velocity-verlet", short), ("hoa2", long))])}
KEPT = ("R", "R_error", "drift_kJ_per_mol_ps", "drift_error", "drift_p_value", "pressure_bar", "pressure_error_bar",
        "random_walk_kJ_per_mol_per_sqrt_ps", "shadow")


def judged(o, cell, seed):
    """The report of a run at each of its lengths."""
    density, cutoff, temperature, sample = BOXES[cell.model, cell.count]
    sample = sample if o.design == "walk" else max(4, cell.step)
    tables = {"system": {"molecules": runs.molecules(cell.model, cell.count), "density": density, "temperature": temperature, "seed": seed},
              "forces": {"cutoff": cutoff, "smoothness": cell.smoothness}, "integrator": {"scheme": cell.scheme, "step": f"{cell.step} fs"},
              "run": {"equilibrate": f"{0.1 if o.smoke else DESIGNS[o.design][0]} ps", "sample": f"{sample} fs"},
              "output": {"prefix": "run", **runs.QUIET}, "thermostat": cell.thermostat and {"type": cell.thermostat}}
    with runs.scratch() as folder:
        Path(folder, "run.toml").write_text(runs.run_file(**tables), encoding="utf-8")
        reports = [runs.asked(o, "run", "run.toml", "--threads", 1, "--resume", "--length", f"{length} ps", folder=folder) for length in cell.lengths]
    return [{key: r.get(key) for key in KEPT} for r in reports]


def fired(reports, level=0.01):
    return sum(r["drift_p_value"] is not None and r["drift_p_value"] < level for r in reports)


def row(cell, length, reports):
    """The statements of the runs of a cell at a length, compared with their scatter."""
    n = len(reports)
    known = [r for r in reports if r["drift_p_value"] is not None]
    shadow = [r["shadow"] for r in reports if r["shadow"]]
    # The size of an energy drift is known in every run, but its error is known only in runs with a p-value.
    ratio = lambda value, error, of=reports: (over_scatter([(r[value], r[error]) for r in of]) or [None])[-1]
    return {"system": f"{cell.count} {cell.model}", "scheme": f"{cell.scheme} {cell.step:g} fs", "smoothness": cell.smoothness,
            "ensemble": cell.thermostat or "NVE", "ps": length, "runs": n, "p-value": len(known) / n, "p < 5 %": 100 * fired(reports, 0.05) / n,
            "p < 1 %": 100 * fired(reports) / n, "of": [100 * x for x in share_interval(fired(reports), n)],
            "slope": ratio("drift_kJ_per_mol_ps", "drift_error", known),
            "walk": sum(bool(r["random_walk_kJ_per_mol_per_sqrt_ps"]) for r in reports) / n,
            "R %": 100 * rms([r["R"] for r in reports]), "R known": sum(r["R_error"] is not None for r in reports) / n,
            "R": ratio("R", "R_error") if sum(r["R_error"] is not None for r in reports) > 19 else None,
            "pressure": ratio("pressure_bar", "pressure_error_bar"),
            "shadow p < 5 %": 100 * fired(shadow, 0.05) / len(shadow) if shadow else None,
            "shadow p < 1 %": 100 * fired(shadow) / len(shadow) if shadow else None}


def measured(o):
    cells = DESIGNS[o.design][1]
    chosen = [cells[k] for k in o.cells if k < len(cells)]
    if o.smoke:
        chosen = [cell._replace(lengths=(0.5, 1)) for cell in chosen]
    cases = [(cell, seed) for cell in chosen for seed in range(o.first, o.first + o.runs)]
    found = dict(zip(cases, runs.parallel(o, lambda case: judged(o, *case), cases)))
    of = {cell: [reports for (c, _), reports in found.items() if c == cell] for cell in chosen}
    rows = [row(cell, length, [r[k] for r in of[cell]]) for cell in chosen for k, length in enumerate(cell.lengths)]
    totals = {}
    for cell, length in ((cell, k) for cell in chosen for k in range(len(cell.lengths))):
        kind = "with a random walk" if cell.thermostat or "gier4" in cell.scheme else "of second order at constant energy"
        count, n = totals.get(kind, (0, 0))
        totals[kind] = count + fired([r[length] for r in of[cell]]), n + len(of[cell])
    return {"rows": rows, "totals": totals}


def cell_text(value):
    if isinstance(value, list):
        return f"{value[0]:.1f} to {value[1]:.1f}"
    return "" if value is None else f"{value:.2g}" if isinstance(value, float) else str(value)


def report(result):
    """The rows, and fractions over all systems. The lengths of a run share samples."""
    lines = []
    for kind, (count, n) in result["totals"].items():
        low, high = share_interval(count, n)
        lines.append(f"{kind}: p < 1 % in {count} of {n}, {100 * count / n:.2f} % ({100 * low:.2f} to {100 * high:.2f} %)")
    return study.table(result["rows"][0], [[cell_text(x) for x in r.values()] for r in result["rows"]]) + "\n" + "\n".join(lines)


if __name__ == "__main__":
    o = study.options(__doc__, {"runs": 3, "cells": [0, 13]}, design=("walk", "walk or noise"), runs=(200, "runs of each cell"),
                      first=(1, "seed of the first run"), cells=(list(range(17)), "numbers of systems with schemes"))
    study.perform(o, measured, report)
