# SPDX-License-Identifier: MIT
"""The time-step bias at the same kinetic energy, and comparisons of measured with predicted averages.

Two groups of short runs test what this module computes. Their criteria were written before the runs were made:

- "half-steps": for velocity Verlet the temperatures of full and half steps deviate from the temperature of the shadow ensemble by -2 to 1.
  The mean (T_full + 2 T_half)/3 of rotation is therefore equal to the mean of translation: within two standard errors at 2 fs, and within a
  tenth of the difference of the full-step temperatures at 4 fs.
- "conserved": the bias of the potential energy with a rescaling thermostat, from the conserved energy (`polhode bias`), agrees within
  two standard errors with the bias at constant energy times the ratio of heat capacities, for fourth-order schemes.
"""

from collections import defaultdict
from math import hypot, inf, sqrt

import half_femtosecond_tables as tables
import numpy as np
from lib.statistics import mean
from lib.statistics import text as cell
from lib.study import table
from scipy import stats

GAS = 8.31446261815324e-3  # kJ/mol/K
# At constant temperature and pressure a density bias of 0.02 % takes the place of the pressure bias.
BAR = 10 * 8.31446261815324 / 18.0154  # bar cm³/g/K of water: the pressure of an ideal gas
LOGGED = ("potential", "pressure", "kinetic_translation", "kinetic_rotation")  # columns whose biases the record has
REQUIRED = {**tables.REQUIRED, "density": (0.02, "%")}


def potential(run):
    return run["potential_kJ_per_mol"]


def pressure(run):
    return run["pressure_bar"]


def kinetic(run):
    """The kinetic energy of full steps per molecule [kJ/mol]."""
    molecules = run["degrees_of_freedom_rotation"][0]
    return (6 * molecules - 3) / (2 * molecules) * GAS * run["temperature_K"]


def pooled(points, value):
    """(standard deviation of one run, degrees of freedom) from the scatter about the mean of each point, over all points; infinite if every
    point has one run."""
    values = [np.array([value(run) for run in runs]) for runs in points.values()]
    freedom = sum(len(x) - 1 for x in values)
    if not freedom:
        return inf, 0
    return sqrt(sum(((x - x.mean()) ** 2).sum() for x in values) / freedom), freedom


def from_common_starts(points, value, bias):
    """By point, (measured bias, standard error). The n-th runs of all points begin with the same configuration and have the same energy.
    The reference is the mean over all points of the n-th runs minus their predicted biases. The error is the pooled scatter of what
    remains after the means of points and of starts are removed."""
    starts = min(map(len, points.values()))
    x = np.array([[value(run) for run in runs[:starts]] for runs in points.values()])
    predicted = np.array([tables.of_runs(runs, tables.predicted(bias))[0] for runs in points.values()])
    residual = x - x.mean(axis=1, keepdims=True) - x.mean(axis=0) + x.mean()
    freedom = (len(points) - 1) * (starts - 1)
    error = sqrt((residual**2).sum() / freedom / starts) if freedom else inf
    reference = (x - predicted[:, None]).mean(axis=0)
    return {p: (float(row.mean()), error) for p, row in zip(points, x - reference)}


def chi_squared(measured, predicted):
    return sum((m - p) ** 2 / (e**2 + s**2) for (m, e), (p, s) in zip(measured, predicted))


def constant_energy(points):
    """A table of measured and predicted biases at constant energy."""
    biases = {name: from_common_starts(points, value, name) for name, value in (("potential", potential), ("pressure", pressure))}
    error, freedom = pooled(points, tables.difference)
    starts = min(map(len, points.values()))
    head = ["scheme", "step [fs]", "force evaluations per ps", "T_rot − T_trans, measured [K]", "predicted [K]", "configurational [K]",
            "potential energy bias, measured [kJ/mol]", "predicted [kJ/mol]", "pressure bias, measured [bar]", "predicted [bar]"]
    own = lambda runs, name, digits: cell(tables.of_runs(runs, tables.predicted(name)), digits)
    rows = [[p.scheme, f"{p.step:g}", f"{tables.cost(p):.0f}",
             cell((tables.of_runs(runs, tables.difference)[0], error / sqrt(len(runs))), 2), own(runs, "difference", 3),
             cell(tables.of_runs(runs, tables.configurational), 2), cell(biases["potential"][p], 3), own(runs, "potential", 4),
             cell(biases["pressure"][p], 0), own(runs, "pressure", 2)] for p, runs in points.items()]
    agreement = []
    for name, unit in (("potential", "kJ/mol"), ("pressure", "bar")):
        predicted = [tables.of_runs(runs, tables.predicted(name)) for runs in points.values()]
        agreement.append(f"{name}: chi squared of measured minus predicted {chi_squared(biases[name].values(), predicted):.1f} with "
                         f"{len(points) - 1} degrees of freedom, pooled standard error {next(iter(biases[name].values()))[1]:.3g} {unit}")
    excess = [[tables.difference(run) - tables.predicted("difference")(run) for run in runs[:starts]] for runs in points.values()]
    agreement.append(f"difference of temperatures, measured minus predicted: {cell(mean(np.ravel(excess)), 2)} K over all runs, "
                     f"{cell(mean(np.mean(excess, axis=0)), 2)} K from the scatter of the means over initial configurations")
    agreement.append(f"difference of temperatures: standard deviation of a run {error:.2f} K, {freedom} degrees of freedom")
    return table(head, rows) + "\n" + "\n".join(agreement) + "\n"


def controlled(points):
    """A table of averages with a thermostat minus the averages of hybrid Monte Carlo, and of predicted biases."""
    exact = next((runs for p, runs in points.items() if p.ensemble == "hybrid Monte Carlo"), None)
    if exact is None:
        return "There are no runs with hybrid Monte Carlo to compare with.\n"
    error = {value: pooled(points, value)[0] for value in (potential, pressure)}

    def against(runs, value, digits):
        difference = mean([value(run) for run in runs])[0] - mean([value(run) for run in exact])[0]
        return cell((difference, error[value] * sqrt(1 / len(runs) + 1 / len(exact))), digits)

    head = ["thermostat", "scheme", "step [fs]", "force evaluations per ps", "potential energy, measured minus hybrid Monte Carlo [kJ/mol]",
            "predicted [kJ/mol]", "pressure, measured minus hybrid Monte Carlo [bar]", "predicted [bar]"]
    rows = [[p.ensemble, p.scheme, f"{p.step:g}", f"{tables.cost(p):.0f}", against(runs, potential, 3),
             cell(tables.of_runs(runs, tables.predicted("potential")), 3), against(runs, pressure, 0),
             cell(tables.of_runs(runs, tables.predicted("pressure")), 0)] for p, runs in points.items() if runs is not exact]
    return table(head, rows)


def responses(points):
    """(dU/dK, error) and (dP/dK, error) [bar mol/kJ] at constant volume, from runs at constant energy: the initial configurations have
    different energies, and the predicted biases are subtracted from all means."""
    means = []
    for start in range(min(len(runs) for runs in points.values())):
        rows = [(kinetic(run) + tables.predicted("potential")(run), potential(run) - tables.predicted("potential")(run),
                 pressure(run) - tables.predicted("pressure")(run)) for run in (runs[start] for runs in points.values())]
        means.append(np.mean(rows, axis=0))
    K, U, P = np.transpose(means)
    found = []
    for y in (U, P):
        (slope, _), covariance = np.polyfit(K, y, 1, cov=True)
        found.append((float(slope), float(sqrt(covariance[0, 0]))))
    return found


def at_same_kinetic_energy(points):
    """bias(runs, name) at the same mean kinetic energy, from the bias at constant energy (theory.md, Eq. (51)); the density at the same
    pressure as well."""
    (heat, heat_error), (stress, stress_error) = responses(points)

    def bias(runs, name):
        if name == "difference":
            return tables.of_runs(runs, tables.predicted(name))
        U, error = tables.of_runs(runs, tables.predicted("potential"))
        if name == "potential":
            return (1 + heat) * U, hypot((1 + heat) * error, heat_error * U)
        P, error = mean([tables.predicted("pressure")(run) + stress * tables.predicted("potential")(run) for run in runs])
        scale = 1 if name == "pressure" else -100 * tables.KAPPA
        return scale * P, abs(scale) * hypot(error, stress_error * U)

    return bias


def same_kinetic_energy(points):
    """Costs at the same kinetic energy, and the responses that convert the biases."""
    (heat, heat_error), (stress, stress_error) = responses(points)
    return (tables.costs(points, REQUIRED, at_same_kinetic_energy(points))
            + f"\ndU/dK = {heat:.2f} ± {heat_error:.2f}, dP/dK = {stress:.0f} ± {stress_error:.0f} bar mol/kJ\n")


def biases_at_same_kinetic_energy(points):
    """A table of all biases at the same kinetic energy, from the biases at constant energy."""
    bias = at_same_kinetic_energy(points)
    head = ["scheme", "step [fs]", "force evaluations per ps", "potential energy [kJ/mol]", "pressure [bar]", "density at constant pressure [%]"]
    return table(head, [[p.scheme, f"{p.step:g}", f"{tables.cost(p):.0f}", cell(bias(runs, "potential"), 4), cell(bias(runs, "pressure"), 1),
                         cell(bias(runs, "density"), 3)] for p, runs in points.items()])


def converted(energy, canonical):
    """A table of biases with a rescaling thermostat: from samples of the shadow energy, and from runs at constant energy."""
    bias = at_same_kinetic_energy(energy)
    other = {(p.scheme, p.step): runs for p, runs in energy.items()}
    head = ["scheme", "step [fs]", "potential energy, Eq. (48) [kJ/mol]", "Eq. (51) [kJ/mol]", "pressure, Eq. (48) [bar]", "Eq. (51) [bar]"]
    rows = []
    for p, runs in canonical.items():
        if p.ensemble == "rescaling" and (p.scheme, p.step) in other:
            row = [p.scheme, f"{p.step:g}"]
            for name, digits in (("potential", 4), ("pressure", 1)):
                row += [cell(tables.of_runs(runs, tables.predicted(name)), digits), cell(bias(other[p.scheme, p.step], name), digits)]
            rows.append(row)
    return table(head, rows)


def conserved(points):
    """Biases with a rescaling thermostat, from the conserved energy (theory.md, Eq. (53))."""
    per_molecule = lambda run, name: run["log_bias"][name] / run["degrees_of_freedom_rotation"][0]
    temperature = lambda run: (per_molecule(run, "kinetic_rotation") - per_molecule(run, "kinetic_translation")) / (1.5 * GAS)
    head = ["scheme", "step [fs]", "force evaluations per ps", "T_rot − T_trans [K]", "potential energy [kJ/mol]", "pressure [bar]"]
    return table(head, [[p.scheme, f"{p.step:g}", f"{tables.cost(p):.0f}", cell(tables.of_runs(runs, temperature), 2),
                         cell(tables.of_runs(runs, lambda run: per_molecule(run, "potential")), 4),
                         cell(tables.of_runs(runs, lambda run: run["log_bias"]["pressure"]), 1)] for p, runs in points.items()])


def estimators(points):
    """Estimators of the temperature with velocity Verlet, scaled to a full-step temperature of 298.15 K. Third order: a third of the
    full-step temperature plus two thirds of the half-step temperature. The noise of full and half steps is the same, so their differences
    are precise. The pressure of half steps differs by the kinetic energy of translation."""
    half = lambda run: (run["half_steps"]["temperature_translation_K"], float(np.mean(run["half_steps"]["temperature_rotation_K"])))
    full = lambda run: (run["temperature_translation_K"], tables.rotation(run))
    place = lambda run: (run["temperature_configurational_K"][0]["value"],
                         float(np.mean([T["value"] for T in run["temperature_configurational_K"][1:]])))
    kinds = {"full steps": full, "half steps": half, "third order": lambda run: tuple((f + 2 * h) / 3 for f, h in zip(full(run), half(run))),
             "configurational": place, "third order minus full steps": lambda run: tuple(2 / 3 * (h - f) for f, h in zip(full(run), half(run)))}
    motions = {"translation": lambda pair: pair[0], "rotation": lambda pair: pair[1], "rotation minus translation": lambda pair: pair[1] - pair[0]}
    head = ["step [fs]", "motion", *(f"{name} [K]" for name in kinds), "pressure, half steps minus full steps [bar]"]
    rows = []
    for p, runs in points.items():
        at = [p.temperature / run["temperature_K"] for run in runs]
        stress = mean([scale * BAR * p.density * (half(run)[0] - full(run)[0]) for scale, run in zip(at, runs)])
        for motion, of in motions.items():
            values = [cell(mean([scale * of(kind(run)) for scale, run in zip(at, runs)]), 3 if "minus" in name else 2) for name, kind in kinds.items()]
            rows.append([f"{p.step:g}", motion, *values, cell(stress, 2) if motion == "translation" else ""])
    return table(head, rows)


def at_constant_pressure(points):
    """Biases at constant temperature and pressure, averaged over the temperatures. The measured value is the
    difference from the mean over all schemes of averages minus predicted biases, with the scatter pooled over all points."""
    known = {p: runs for p, runs in points.items() if tables.of_runs(runs, tables.predicted("potential")) is not None}
    bias = lambda run: tables.predicted("potential")(run)
    reference = defaultdict(list)
    for p, runs in known.items():
        reference[p.temperature] += [potential(run) - bias(run) for run in runs]
    error, _ = pooled(points, potential)
    by_scheme = defaultdict(list)
    for p, runs in points.items():
        by_scheme[p.scheme, p.step].append((p, runs))
    head = ["scheme", "step [fs]", "T_rot − T_trans, measured [K]", "predicted [K]", "potential energy bias, measured [kJ/mol]",
            "predicted [kJ/mol]", "density bias, predicted, rms over temperatures [%]"]
    rows = []
    for (scheme, step), of in by_scheme.items():
        every = [run for _, runs in of for run in runs]
        shift = mean([potential(run) - np.mean(reference[p.temperature]) for p, runs in of for run in runs])[0]
        free = of[0][0] not in known
        size = error * sqrt(1 / len(every) + 1 / sum(map(len, reference.values()))) if free else error / sqrt(len(every))
        density = lambda run: 100 * tables.density_bias(run) / tables.density(run)
        rows.append([scheme, f"{step:g}", cell(tables.of_runs(every, tables.difference), 2),
                     "" if free else cell(tables.of_runs(every, tables.predicted("difference")), 2), cell((float(shift), size), 3),
                     "" if free else cell(tables.of_runs(every, bias), 4),
                     "" if free else f"{sqrt(np.mean([mean([density(run) for run in runs])[0] ** 2 for _, runs in of])):.3f}"])
    return table(head, rows)


def decided(points):
    """Densities minus the density of the reference: hybrid Monte Carlo with exact volume moves, which has no time-step bias, or gier4-fd at
    2 fs. The question, put before the runs: is the density of gier4-fd at 4 fs unbiased, or 0.08 % too low? It is decided if the 99 % interval
    of the difference at 1 bar contains only one of both. Of the short step, 32 runs of each point are planned.
    At 1 bar: each density is corrected to the set pressure with the compressibility of all runs."""
    kappa = np.mean([run["compressibility_per_bar"]["value"] for runs in points.values() for run in runs])
    kinds = (tables.density, lambda run: tables.density(run) * (1 - kappa * (pressure(run) - 1)))
    reference = next((runs for p, runs in points.items() if p.scheme == "hoa2"), points[min(points, key=lambda p: p.step)])
    rows = []
    for p, runs in points.items():
        row = [f"{p.scheme}, {p.step:g} fs", p.ensemble, len(runs), cell(mean([tables.density(run) for run in runs]), 2), cell(mean([pressure(run) for run in runs]), 1)]
        for kind in kinds:
            own, exact = (mean([kind(run) for run in of]) for of in (runs, reference))
            difference, error = 100 * (own[0] / exact[0] - 1), 100 * hypot(own[1], exact[1]) / exact[0]
            half = stats.t.ppf(0.995, len(runs) + len(reference) - 2) * error
            row += ["", ""] if runs is reference else [cell((difference, error), 3), f"{difference - half:.3f} to {difference + half:.3f}"]
        biases = [100 * tables.density_bias(run) / tables.density(run) for run in runs if run["step_bias"]]
        rows.append([*row, cell(mean(biases), 3) if biases else ""])
    return table(["scheme", "ensemble", "runs", "density [kg/m³]", "mean pressure [bar]", "difference [%]", "99 % interval", "at 1 bar [%]", "99 % interval",
                  "predicted bias [%]"], rows)
