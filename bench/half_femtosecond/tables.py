# SPDX-License-Identifier: MIT
"""What the runs show: means over the runs of a point with standard errors from their scatter, and the cost at which the bias of a
scheme is as small as required."""

from collections import defaultdict
from math import exp, inf, log
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial
from points import Point

# What is required: bias [unit], name in the record.
REQUIRED = {"difference": (0.1, "K"), "potential": (0.01, "kJ/mol"), "pressure": (4, "bar")}
BIASES = {"difference": "rotation_minus_translation_K", "potential": "potential_kJ_per_mol", "pressure": "pressure_bar"}


def mean(values):
    """(mean, standard error) of values of independent runs."""
    x = np.array(values, dtype=float)
    return float(x.mean()), float(x.std(ddof=1) / np.sqrt(len(x))) if len(x) > 1 else inf


def by_point(lines):
    """The runs of each point, in the order of points."""
    runs = defaultdict(list)
    for line in lines:
        runs[Point(*line["point"])].append(line)
    return dict(sorted(runs.items(), key=lambda item: (item[0].group, item[0].temperature, item[0].ensemble, item[0].scheme, item[0].step)))


def of_runs(runs, value):
    """Mean and standard error of a quantity; None if a run lacks it."""
    values = [value(run) for run in runs]
    return None if any(v is None for v in values) else mean(values)


def rotation(run):
    return float(np.mean(run["temperature_rotation_K"]))  # of the three axes, with as many degrees of freedom each


def difference(run):
    """Of the kinetic temperatures of rotation and translation [K]."""
    return rotation(run) - run["temperature_translation_K"]


def configurational(run):
    """The same of the configurational temperatures [K]."""
    translation, *axes = [T["value"] for T in run["temperature_configurational_K"]]
    return float(np.mean(axes)) - translation


def predicted(name):
    """The bias that a run predicts for itself; None where it is not known."""
    return lambda run: run["step_bias"] and run["step_bias"][BIASES[name]]["value"]


def cell(estimate, digits):
    if estimate is None:
        return ""
    value, error = estimate
    return f"{value:.{digits}f}" + (f" ± {error:.{digits}f}" if error < inf else "")


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + " --- |" * len(head), *("| " + " | ".join(row) + " |" for row in rows)]) + "\n"


def constant_energy(points):
    """Biases against the step."""
    head = ["scheme", "step [fs]", "force evaluations per ps", "T_rot − T_trans, seen [K]", "predicted [K]", "configurational [K]",
            "potential energy, predicted bias [kJ/mol]", "pressure, predicted bias [bar]"]
    return table(head, [[p.scheme, f"{p.step:g}", f"{p.evaluations_per_ps:.0f}", cell(of_runs(runs, difference), 3),
                         cell(of_runs(runs, predicted("difference")), 3), cell(of_runs(runs, configurational), 2),
                         cell(of_runs(runs, predicted("potential")), 4), cell(of_runs(runs, predicted("pressure")), 2)]
                        for p, runs in points.items()])


def controlled(points):
    """Averages of runs with a thermostat."""
    head = ["thermostat", "scheme", "step [fs]", "force evaluations per ps", "potential energy [kJ/mol]", "predicted bias", "pressure [bar]",
            "predicted bias", "T_trans, T_rot, kinetic [K]", "configurational [K]"]
    kelvin = lambda runs, *values: ", ".join(cell(of_runs(runs, value), 2) for value in values)
    place = lambda k: lambda run: float(np.mean([T["value"] for T in run["temperature_configurational_K"]][slice(1, 4) if k else slice(0, 1)]))
    return table(head, [[p.ensemble, p.scheme, f"{p.step:g}", f"{p.evaluations_per_ps:.0f}",
                         cell(of_runs(runs, lambda run: run["potential_kJ_per_mol"]), 4), cell(of_runs(runs, predicted("potential")), 4),
                         cell(of_runs(runs, lambda run: run["pressure_bar"]), 1), cell(of_runs(runs, predicted("pressure")), 1),
                         kelvin(runs, lambda run: run["temperature_translation_K"], rotation), kelvin(runs, place(0), place(1))]
                        for p, runs in points.items()])


def density(run):
    return run["density_kg_per_m3"]["value"]


def density_bias(run):
    """[kg/m³]: of the volume, with the other sign; None for a scheme of fourth order, which has no prediction at constant pressure."""
    if not run["step_bias"]:
        return None
    return -density(run) * run["step_bias"]["volume_nm3"]["value"] / run["volume_nm3"]["value"]


def unbiased_density(run):
    """What is left of the density without the predicted bias; None where that is not known."""
    bias = density_bias(run)
    return None if bias is None else density(run) - bias


def densities(points):
    head = ["T [K]", "scheme", "step [fs]", "density [kg/m³]", "predicted bias [kg/m³]", "without it [kg/m³]"]
    return table(head, [[f"{p.temperature:g}", p.scheme, f"{p.step:g}", cell(of_runs(runs, density), 2), cell(of_runs(runs, density_bias), 2),
                         cell(of_runs(runs, unbiased_density), 2)] for p, runs in points.items()])


LIMIT = "limit of short steps"


def name_of(p):
    return f"{p.scheme}, {p.step:g} fs"


def limit_densities(points):
    """[(T, density, error)] without the bias of the step, from all runs that predict theirs."""
    corrected = defaultdict(list)
    for p, runs in points.items():
        corrected[p.temperature] += [unbiased_density(run) for run in runs if run["step_bias"]]
    return [(T, *mean(values)) for T, values in sorted(corrected.items()) if values]


def density_biases(points):
    """By scheme and step: [(T, predicted bias, error)]; of one run the error that it states."""
    curves = defaultdict(list)
    for p, runs in points.items():
        if (bias := of_runs(runs, density_bias)) is None:
            continue
        value, error = bias
        if error == inf:
            error = density(runs[0]) * runs[0]["step_bias"]["volume_nm3"]["error"] / runs[0]["volume_nm3"]["value"]
        curves[name_of(p)].append((p.temperature, value, error))
    return dict(curves)


def own_densities(points):
    """By scheme and step: [(T, density, error)] of schemes without a prediction."""
    curves = defaultdict(list)
    for p, runs in points.items():
        if of_runs(runs, density_bias) is None:
            curves[name_of(p)].append((p.temperature, *of_runs(runs, density)))
    return dict(curves)


def density_fit(T, densities):
    """A least-squares cubic: water is lost faster on the cold side of the maximum than on the warm one, and a parabola misses the
    densities of this study by more than their errors (chi squared 21 with 4 degrees of freedom; cubic: 4 with 3)."""
    return Polynomial.fit(T, densities, 3)


def bias_fit(T, biases):
    return Polynomial.fit(T, biases, 2)


def maximum(curve):
    """The temperature at which a fit is highest, within the temperatures of its points."""
    low, high = curve.domain
    flat = [root.real for root in curve.deriv().roots() if abs(root.imag) < 1e-9 and low < root.real < high]
    return float(max([low, high, *flat], key=curve))


def spread(drawn):
    """Half of the interval that holds 68 % of the draws: a few of them have curves without a maximum."""
    return float(np.diff(np.percentile(drawn, (16, 84)))[0] / 2)


class Maximum(NamedTuple):
    """Of a curve: (value, error) of its place, how far the step moves it [K], and what the step changes in the density, the mean over
    temperatures [%]; `fit` is the curve."""
    place: tuple
    moved: tuple | None
    change: tuple | None
    fit: Polynomial


def maxima_of(points, draws=2000):
    """By curve, the limit first: its maximum, with errors from curves drawn within the errors of their points. The curve of a scheme
    with a prediction is the fit of the limit plus the fit of its bias, and is drawn with the drawn limit; curves of their own do not
    depend on it."""
    random = np.random.default_rng(1)
    drawn = lambda value, error: value + error * random.standard_normal((draws, len(value)))
    T, limit, error = map(np.array, zip(*limit_densities(points)))
    limits, fit = drawn(limit, error), density_fit(T, limit)
    fits = [density_fit(T, one) for one in limits]
    tops = np.array([maximum(one) for one in fits])
    result = {LIMIT: Maximum((maximum(fit), spread(tops)), None, None, fit)}

    def add(name, curve, many, change, changes):
        place = np.array([maximum(one) for one in many])
        result[name] = Maximum((maximum(curve), spread(place)), (maximum(curve) - maximum(fit), spread(place - tops)),
                               (100 * float(change.mean()), spread(100 * changes.mean(axis=1))), curve)

    for name, curve in own_densities(points).items():
        if len(curve) == len(T):
            _, value, error = map(np.array, zip(*curve))
            own = drawn(value, error)
            add(name, density_fit(T, value), [density_fit(T, one) for one in own], value / limit - 1, own / limits - 1)
    for name, curve in density_biases(points).items():
        if len(curve) == len(T):
            _, value, error = map(np.array, zip(*curve))
            biases = drawn(value, error)
            add(name, fit + bias_fit(T, value), [f + bias_fit(T, one) for f, one in zip(fits, biases)], value / limit, biases / limits)
    return result


def maxima(points, draws=2000):
    """Temperatures of the maxima, how far the step moves them, and what it changes in the density."""
    row = lambda name, m: [name, cell(m.place, 1), cell(m.moved, 1), cell(m.change, 3)]
    return table(["", "maximum of the density [K]", "moved by the step [K]", "density, mean over temperatures [%]"],
                 [row(name, m) for name, m in maxima_of(points, draws).items()])


def cost_at(curve, bound):
    """Force evaluations per ps at which the bias is as large as the bound, from (cost, bias) by the power law between two points, or
    of the two nearest points beyond them; None if it has no two points."""
    curve = sorted((c, abs(b)) for c, b in curve)
    if len(curve) < 2:
        return None
    pairs = list(zip(curve, curve[1:]))
    (c1, b1), (c2, b2) = next((pair for pair in pairs if pair[0][1] >= bound >= pair[1][1]), pairs[0] if curve[0][1] < bound else pairs[-1])
    return exp(log(c1) + log(bound / b1) * log(c2 / c1) / log(b2 / b1)) if b1 != b2 else None


def costs(points):
    """By scheme: the cost at which the predicted bias of each quantity is as large as required."""
    curves = defaultdict(lambda: defaultdict(list))
    for p, runs in points.items():
        for name in REQUIRED:
            curves[p.scheme][name].append((p.evaluations_per_ps, of_runs(runs, predicted(name))[0]))
    head = ["scheme", *(f"{name}: {bound:g} {unit}" for name, (bound, unit) in REQUIRED.items())]
    number = lambda cost: "" if cost is None else f"{cost:.0f}"
    return table(head, [[scheme, *(number(cost_at(curve[name], REQUIRED[name][0])) for name in REQUIRED)] for scheme, curve in curves.items()])
