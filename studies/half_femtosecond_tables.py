# SPDX-License-Identifier: MIT
"""Tables of the time-step bias. They show means over the runs of a point with standard errors from the scatter of runs.
They also show the cost at which the bias of a scheme is as small as required."""

from collections import defaultdict
from math import exp, hypot, inf, log

import numpy as np
from lib.runs import number
from lib.statistics import mean
from lib.statistics import text as cell
from lib.study import table
from numpy.polynomial import Polynomial

KEPT = ("potential_kJ_per_mol", "temperature_K", "temperature_translation_K", "temperature_rotation_K", "pressure_bar", "R",
        "temperature_configurational_K", "step_bias", "half_steps", "force_evaluations", "degrees_of_freedom_rotation")  # of a report
# The number of force evaluations per step, which is the cost by which points are compared.
EVALUATIONS = {"velocity-verlet": 1, "hoa2": 2, "bcss3": 3, "gier4-fd": 3, "4mn5fv": 5, "baoab": 1, "obabo": 1}
KAPPA = 4.6e-5  # 1/bar, of SPC/E water at 298 K
# The required biases of quantities with their units, and the names of the quantities in the record.
REQUIRED = {"difference": (0.1, "K"), "potential": (0.01, "kJ/mol"), "pressure": (4, "bar")}
BIASES = {"difference": "rotation_minus_translation_K", "potential": "potential_kJ_per_mol", "pressure": "pressure_bar"}


def cost(point):
    """Force evaluations per ps."""
    return 1000 * EVALUATIONS[point.scheme] / point.step


def by_point(lines, groups):
    """The runs of each point of these groups, in the order of points."""
    found = defaultdict(list)
    for (point, _), line in lines.items():
        if point.group in groups:
            found[point].append(line)
    return dict(sorted(found.items(), key=lambda item: (item[0].group, item[0].temperature, item[0].ensemble, item[0].scheme, item[0].step)))


def of_runs(runs, value):
    """Mean and standard error of a quantity; None if a run lacks it."""
    values = [value(run) for run in runs]
    return None if any(v is None for v in values) else mean(values)


def rotation(run):
    return float(np.mean(run["temperature_rotation_K"]))  # of the three axes, with as many degrees of freedom each


def difference(run):
    """The difference of the kinetic temperatures of rotation and translation [K]."""
    return rotation(run) - run["temperature_translation_K"]


def configurational(run):
    """The difference of the configurational temperatures of rotation and translation [K]."""
    translation, *axes = [T["value"] for T in run["temperature_configurational_K"]]
    return float(np.mean(axes)) - translation


def predicted(name):
    """The bias that a run predicts for itself; None if it is not known."""
    return lambda run: run["step_bias"] and run["step_bias"][BIASES[name]]["value"]


def controlled(points):
    """A table of averages of runs with a thermostat."""
    head = ["thermostat", "scheme", "step [fs]", "force evaluations per ps", "potential energy [kJ/mol]", "pressure [bar]",
            "T_trans, T_rot, kinetic [K]", "configurational [K]"]
    kelvin = lambda runs, *values: ", ".join(cell(of_runs(runs, value), 2) for value in values)
    place = lambda k: lambda run: float(np.mean([T["value"] for T in run["temperature_configurational_K"]][slice(1, 4) if k else slice(0, 1)]))
    return table(head, [[p.ensemble, p.scheme, f"{p.step:g}", f"{cost(p):.0f}",
                         cell(of_runs(runs, lambda run: run["potential_kJ_per_mol"]), 4), cell(of_runs(runs, lambda run: run["pressure_bar"]), 1),
                         kelvin(runs, lambda run: run["temperature_translation_K"], rotation), kelvin(runs, place(0), place(1))]
                        for p, runs in points.items()])


def density(run):
    return run["density_kg_per_m3"]["value"]


def density_bias(run):
    """The predicted bias of the density [kg/m³], from the bias of the volume; None for a scheme of fourth order, which has no prediction at constant pressure."""
    if not run["step_bias"]:
        return None
    return -density(run) * run["step_bias"]["volume_nm3"]["value"] / run["volume_nm3"]["value"]


def name_of(p):
    return f"{p.scheme}, {p.step:g} fs"


def density_biases(points):
    """[(T, predicted bias, error)] by scheme and step; for a single run, the error is the error that it states."""
    curves = defaultdict(list)
    for p, runs in points.items():
        if (bias := of_runs(runs, density_bias)) is None:
            continue
        value, error = bias
        if error == inf:
            error = density(runs[0]) * runs[0]["step_bias"]["volume_nm3"]["error"] / runs[0]["volume_nm3"]["value"]
        curves[name_of(p)].append((p.temperature, value, error))
    return dict(curves)


def density_fit(T, densities, degree=3, errors=None):
    """A least-squares polynomial, weighted if there are errors and none is zero."""
    weights = None if errors is None or min(errors) <= 0 else 1 / np.asarray(errors)
    return Polynomial.fit(T, densities, degree, w=weights)


def bias_fit(T, biases):
    return Polynomial.fit(T, biases, 2)


def maximum(curve):
    """The temperature of the maximum of a fit, within the temperature range of the points."""
    low, high = curve.domain
    flat = [root.real for root in curve.deriv().roots() if abs(root.imag) < 1e-9 and low < root.real < high]
    return float(max([low, high, *flat], key=curve))


def spread(drawn):
    """Half of the interval that contains 68 % of the draws, because a few draws have curves without a maximum."""
    return float(np.diff(np.percentile(drawn, (16, 84)))[0] / 2)


def cost_at(curve, bound):
    """Force evaluations per ps at which the bias is as large as the bound, from (cost, bias). It follows from the power law between the two
    points on either side of the bound, or, at steps shorter than measured, of the two shortest steps. If the longest step satisfies the
    bound, it is the cost of this step, because no power law is continued beyond the longest step measured. None if there are fewer than
    two points."""
    curve = sorted((c, abs(b)) for c, b in curve)
    if len(curve) < 2 or curve[0][1] <= bound:
        return curve[0][0] if len(curve) > 1 else None
    (c1, b1), (c2, b2) = next((pair for pair in zip(curve, curve[1:]) if pair[0][1] >= bound >= pair[1][1]), curve[-2:])
    return exp(log(c1) + log(bound / b1) * log(c2 / c1) / log(b2 / b1)) if b1 != b2 else None


def cost_text(curve, bound, draws=500):
    """The cost at a bound from (cost, bias, error), with its error from biases drawn within their errors; or that the cost is below the
    cost of the longest step measured."""
    bare = [(c, b) for c, b, _ in curve]
    found, least = cost_at(bare, bound), min(c for c, _ in bare)
    if found is None or found == least:
        return "" if found is None else f"below {least:.0f} (longest step measured)"
    random = np.random.default_rng(1)
    drawn = [cost_at([(c, b + (e if e < inf else 0) * random.standard_normal()) for c, b, e in curve], bound) for _ in range(draws)]
    return f"{found:.0f} ± {spread([one for one in drawn if one is not None]):.0f}"


def costs(points, required=None, bias=None):
    """By scheme, the cost at which the bias of each quantity is as large as required. `bias(runs, name)` is (bias, error); the default is the
    predicted bias at constant energy."""
    required, bias = required or REQUIRED, bias or (lambda runs, name: of_runs(runs, predicted(name)))
    curves = defaultdict(lambda: defaultdict(list))
    for p, runs in points.items():
        for name in required:
            curves[p.scheme][name].append((cost(p), *bias(runs, name)))
    head = ["scheme", *(f"{name}: {bound:g} {unit}" for name, (bound, unit) in required.items())]
    return table(head, [[scheme, *(cost_text(curve[name], required[name][0]) for name in required)] for scheme, curve in curves.items()])


def biases(runs, value):
    """The mean over runs of a predicted bias, with the error that the runs state. There are too few runs for an error
    from the scatter."""
    known = [value(run) for run in runs]
    if any(k is None or k["error"] is None for k in known):
        return None
    return sum(k["value"] for k in known) / len(known), hypot(*(k["error"] for k in known)) / len(known)


def peak(pair, name):
    return lambda run: run["analysis"]["rdf"][pair].get("step_bias", {}).get(name)


def dielectric(run):
    return run["analysis"]["dielectric"].get("step_bias", {}).get("constant")


def structure(points):
    """A table of the predicted time-step bias of averages over frames."""
    head = ["ensemble", "scheme", "step [fs]", "force evaluations per ps", "ε", "first peak of g(r), O–O", "first peak of g(r), O–H"]
    return table(head, [[p.ensemble, p.scheme, f"{p.step:g}", f"{cost(p):.0f}", cell(biases(runs, dielectric), 2),
                         cell(biases(runs, peak(0, "peak_height")), 4), cell(biases(runs, peak(1, "peak_height")), 4)] for p, runs in points.items()])


def structure_seen(points):
    """A table of averages over frames."""
    height = lambda pair: lambda run: run["analysis"]["rdf"][pair]["peak_height"]["value"]
    dielectric = lambda run: number(run["analysis"]["dielectric"]["constant"])
    head = ["ensemble", "scheme", "step [fs]", "force evaluations per ps", "ε", "first peak of g(r), O–O", "first peak of g(r), O–H"]
    return table(head, [[p.ensemble, p.scheme, f"{p.step:g}", f"{cost(p):.0f}", cell(of_runs(runs, dielectric), 0),
                         cell(of_runs(runs, height(0)), 3), cell(of_runs(runs, height(1)), 3)] for p, runs in points.items()])


def slope(curve):
    """(slope, error) of the weighted line through (x, y, error)."""
    x, y, error = map(np.array, zip(*curve))
    (value, _), covariance = np.polyfit(x, y, 1, w=1 / error, cov="unscaled")
    return float(value), float(covariance[0, 0] ** 0.5)


def compressibilities(points):
    """The bias of the compressibility, from the bias of the pressure at three densities."""
    curves = defaultdict(list)
    for p, runs in points.items():
        curves[p.scheme, p.step].append((p.density / 0.998, *biases(runs, lambda run: run["step_bias"]["pressure_bar"])))
    rows = []
    for (scheme, step), curve in curves.items():
        change, error = slope(curve) if len(curve) > 1 else (0, inf)
        rows.append([scheme, f"{step:g}", *(cell((b, e), 1) for _, b, e in sorted(curve)), cell((-100 * KAPPA * change, 100 * KAPPA * error), 2)])
    return table(["scheme", "step [fs]", *(f"pressure bias at {x:g} g/cm³ [bar]" for x in (0.978, 0.998, 1.018)), "resulting bias of κ [%]"], rows)


def starts(points):
    """Temperature differences without a time-step bias."""
    head = ["initial configuration", "runs", "length [ps]", "T_rot − T_trans, measured [K]", "predicted [K]", "configurational [K]"]
    return table(head, [[p.ensemble, str(len(runs)), f"{p.length:g}", cell(of_runs(runs, difference), 3), cell(of_runs(runs, predicted("difference")), 3),
                         cell(of_runs(runs, configurational), 3)] for p, runs in points.items()])


KNOWN_STARTS = 4  # the first initial configurations, of the group "energy"


def new_starts(points):
    """The temperature difference of runs of 100 ps from initial configurations that no other run has, equilibrated for 10 ps as in the group
    "energy". The question, put before the runs: is the difference of -0.54 K in that group caused by the short equilibration? Then new runs have
    it, too. It was chance if their mean is within 2.6 standard errors of zero, and more than 2.6 from -0.54 K."""
    head = ["runs", "equilibration [ps]", "length [ps]", "T_rot − T_trans minus predicted [K]", "standard errors from 0", "standard errors from −0.54"]
    rows = []
    for p, runs in points.items():
        value, error = mean([difference(run) - predicted("difference")(run) for run in runs[KNOWN_STARTS:]])
        rows.append([str(len(runs) - KNOWN_STARTS), "10", f"{p.length:g}", cell((value, error), 3), f"{value / error:.1f}", f"{(value + 0.54) / error:.1f}"])
    return table(head, rows)


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
