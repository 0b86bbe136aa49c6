# SPDX-License-Identifier: MIT
"""What the step changes in properties, and friction and start in averages."""

from collections import defaultdict
from math import hypot, inf

import numpy as np
from tables import cell, configurational, difference, mean, of_runs, predicted, rotation, table

KAPPA = 4.6e-5  # 1/bar, of SPC/E water at 298 K


def biases(runs, value):
    """The mean over runs of a predicted bias, with the error that the runs state: too few runs for that of their scatter."""
    known = [value(run) for run in runs]
    if any(k is None or k["error"] is None for k in known):
        return None
    return sum(k["value"] for k in known) / len(known), hypot(*(k["error"] for k in known)) / len(known)


def peak(pair, name):
    return lambda run: run["analysis"]["rdf"][pair].get("step_bias", {}).get(name)


def dielectric(run):
    return run["analysis"]["dielectric"].get("step_bias", {}).get("constant")


def structure(points):
    """What the step changes in averages over frames, as runs predict it."""
    head = ["ensemble", "scheme", "step [fs]", "force evaluations per ps", "ε", "first peak of g(r), O–O", "first peak of g(r), O–H"]
    return table(head, [[p.ensemble, p.scheme, f"{p.step:g}", f"{p.evaluations_per_ps:.0f}", cell(biases(runs, dielectric), 2),
                         cell(biases(runs, peak(0, "peak_height")), 4), cell(biases(runs, peak(1, "peak_height")), 4)] for p, runs in points.items()])


def estimate(of):
    """The value, or the estimate of a run that is too short for one: the mean over several runs may determine it."""
    return of["value"] if of["value"] is not None else of["unconverged_estimate"]


def structure_seen(points):
    """Averages over frames themselves."""
    height = lambda pair: lambda run: run["analysis"]["rdf"][pair]["peak_height"]["value"]
    dielectric = lambda run: estimate(run["analysis"]["dielectric"]["constant"])
    head = ["ensemble", "scheme", "step [fs]", "force evaluations per ps", "ε", "first peak of g(r), O–O", "first peak of g(r), O–H"]
    return table(head, [[p.ensemble, p.scheme, f"{p.step:g}", f"{p.evaluations_per_ps:.0f}", cell(of_runs(runs, dielectric), 0),
                         cell(of_runs(runs, height(0)), 3), cell(of_runs(runs, height(1)), 3)] for p, runs in points.items()])


def slope(curve):
    """(slope, error) of the weighted line through (x, y, error)."""
    weights = [1 / error**2 for _, _, error in curve]
    total = sum(weights)
    centre = sum(w * x for w, (x, _, _) in zip(weights, curve)) / total
    spread = sum(w * (x - centre) ** 2 for w, (x, _, _) in zip(weights, curve))
    return sum(w * (x - centre) * y for w, (x, y, _) in zip(weights, curve)) / spread, spread**-0.5


def compressibilities(points):
    """From the bias of the pressure at three densities."""
    curves = defaultdict(list)
    for p, runs in points.items():
        curves[p.scheme, p.step].append((p.density / 0.998, *biases(runs, lambda run: run["step_bias"]["pressure_bar"])))
    rows = []
    for (scheme, step), curve in curves.items():
        change, error = slope(curve) if len(curve) > 1 else (0, inf)
        rows.append([scheme, f"{step:g}", *(cell((b, e), 1) for _, b, e in sorted(curve)), cell((-100 * KAPPA * change, 100 * KAPPA * error), 2)])
    return table(["scheme", "step [fs]", *(f"bias of the pressure at {x:g} g/cm³ [bar]" for x in (0.978, 0.998, 1.018)), "hence of κ [%]"], rows)


def from_volumes(points):
    """Compressibilities that runs at constant pressure have, relative to the mean of all schemes at the same temperature, averaged over
    the temperatures, from whose scatter the errors are."""
    kappa = {p: mean([run["compressibility_per_bar"]["value"] for run in runs])[0] for p, runs in points.items()}
    at = {T: np.mean([value for p, value in kappa.items() if p.temperature == T]) for T in {p.temperature for p in kappa}}
    ratios = defaultdict(list)
    for p, value in kappa.items():
        ratios[p.scheme, p.step].append(100 * (value / at[p.temperature] - 1))
    return table(["scheme", "step [fs]", "κ against the mean of all [%]"],
                 [[scheme, f"{step:g}", cell(mean(values), 1)] for (scheme, step), values in ratios.items()])


def starts(points):
    """Differences of temperatures without a bias of the step."""
    head = ["start", "runs", "length [ps]", "T_rot − T_trans, seen [K]", "predicted [K]", "configurational [K]"]
    return table(head, [[p.ensemble, str(len(runs)), f"{p.length:g}", cell(of_runs(runs, difference), 3), cell(of_runs(runs, predicted("difference")), 3),
                         cell(of_runs(runs, configurational), 3)] for p, runs in points.items()])


def friction(points):
    """Langevin thermostats: averages against friction."""
    half = lambda run: (run["half_steps"]["temperature_translation_K"], sum(run["half_steps"]["temperature_rotation_K"]) / 3) if run["half_steps"] else None
    places = [lambda run, k=k: [T["value"] for T in run["temperature_configurational_K"]][k] if k == 0
              else sum(T["value"] for T in run["temperature_configurational_K"][1:]) / 3 for k in (0, 1)]
    pair = lambda runs, values: ", ".join(cell(of_runs(runs, value), 2) for value in values)
    halves = lambda runs: pair(runs, [lambda run, k=k: half(run)[k] for k in (0, 1)]) if half(runs[0]) else ""
    head = ["scheme", "step [fs]", "friction", "potential energy [kJ/mol]", "pressure [bar]", "T_trans, T_rot of full steps [K]", "of half steps [K]",
            "configurational [K]"]
    order = sorted(points, key=lambda p: (p.scheme, p.step, float(p.ensemble[10:].removesuffix("/ps") or 1)))
    return table(head, [[p.scheme, f"{p.step:g}", (p.ensemble[10:] or "1/ps"), cell(of_runs(points[p], lambda run: run["potential_kJ_per_mol"]), 4),
                         cell(of_runs(points[p], lambda run: run["pressure_bar"]), 1),
                         pair(points[p], [lambda run: run["temperature_translation_K"], rotation]), halves(points[p]), pair(points[p], places)]
                        for p in order])
