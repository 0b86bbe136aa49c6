# SPDX-License-Identifier: MIT
"""Tables of the density maximum: densities without time-step bias, the maximum and its shift, compressibility and dielectric constant.

Fixed before the first run: densities are corrected to a mean pressure of 1 bar with the compressibility of all runs at a temperature. The
limit of short steps is a cubic, weighted by the errors, through densities minus predicted biases; a parabola through the biases
gives the shift. Errors of the maximum and its shift are from sets of runs drawn with replacement at each temperature. The maximum is
known if its error is at most 0.5 K. The published shift of -4 K at 2 fs is refuted if the 99 % interval of the shift excludes it."""

from collections import defaultdict

import numpy as np
from half_femtosecond_tables import bias_fit, density, density_bias, density_fit, maximum
from lib.statistics import mean
from lib.statistics import text as cell
from lib.study import table

STEP = 2  # [fs] of the runs
STEPS = (0.5, 1, 2, 4)  # [fs]
PUBLISHED = {0.5: 277.15, 2: 273.15, 4: 269.15}  # maxima [K] by step [fs] [asthagiri2025b]


def by_temperature(lines):
    found = defaultdict(list)
    for line in lines:
        found[line["temperature"]].append(line)
    return dict(sorted(found.items()))


def kappa(runs):
    return np.mean([run["compressibility_per_bar"]["value"] for run in runs])


def at_one_bar(runs):
    """The densities of runs, corrected to the set pressure by the compressibility."""
    return np.array([density(run) * (1 - kappa(runs) * (run["pressure_bar"] - 1)) for run in runs])


def limits(runs):
    """(densities at 1 bar minus predicted biases, predicted biases) of runs at a temperature."""
    biases = np.array([density_bias(run) for run in runs])
    return at_one_bar(runs) - biases, biases


class Curves:
    """Fits through the means over runs at each temperature."""

    def __init__(self, values, errors):
        """values: {T: (densities without bias, biases)}; errors: of the mean density by T."""
        T = list(values)
        self.limit = density_fit(T, [x.mean() for x, _ in values.values()], 3, errors)
        self.bias = bias_fit(T, [b.mean() for _, b in values.values()])

    def top(self, step):
        """The temperature of the maximum with velocity Verlet at this step [fs]; 0: the limit of short steps."""
        return maximum(self.limit + self.bias * (step / STEP) ** 2)


def maxima(of, draws=2000):
    """{step: (maximum, error, shift, error, 99 % interval of the shift)} for steps of velocity Verlet, and for the limit of short steps, 0."""
    values = {T: limits(runs) for T, runs in of.items()}
    errors = np.array([mean(x)[1] for x, _ in values.values()])
    random = np.random.default_rng(1)
    whole, drawn = Curves(values, errors), []
    for _ in range(draws):
        chosen = {T: random.integers(len(x), size=len(x)) for T, (x, _) in values.items()}
        drawn.append(Curves({T: (x[chosen[T]], b[chosen[T]]) for T, (x, b) in values.items()}, errors))
    rows, limit = {}, np.array([one.top(0) for one in drawn])
    for step in (0, *STEPS):
        tops = np.array([one.top(step) for one in drawn])
        rows[step] = (whole.top(step), tops.std(), whole.top(step) - whole.top(0), (tops - limit).std(), np.percentile(tops - limit, (0.5, 99.5)))
    return rows


def densities(of):
    head = ["T [K]", "runs", "density at 1 bar [kg/m³]", "bias at 2 fs, predicted [kg/m³]", "limit of short steps [kg/m³]", "error [%]"]
    rows = []
    for T, runs in of.items():
        (limit, error), (bias, bias_error), own = *map(mean, limits(runs)), mean(at_one_bar(runs))
        rows.append([T, len(runs), cell(own, 2), cell((bias, bias_error), 3), cell((limit, error), 2), f"{100 * error / limit:.3f}"])
    return table(head, rows)


def maximum_table(of):
    head = ["velocity Verlet at", "maximum [K]", "shift [K]", "99 % interval", "published maximum [K]"]
    return table(head, [[f"{step:g} fs" if step else "limit of short steps", cell((top, error), 2), cell((shift, of_shift), 2) if step else "",
                         f"{low:.2f} to {high:.2f}" if step else "", PUBLISHED.get(step, "")]
                        for step, (top, error, shift, of_shift, (low, high)) in maxima(of).items()])


def percent(runs, name, value):
    """(value, error) of the bias of a quantity in percent, at 2 fs."""
    return tuple(100 * x / value for x in mean([run["step_bias"][name]["value"] for run in runs]))


def responses(of):
    """Compressibility and dielectric constant with their biases."""
    head = ["T [K]", "κ [10⁻⁵/bar]", "bias of κ at 2 fs [%]", "ε", "bias of ε at 2 fs [%]"]
    rows = []
    for T, runs in of.items():
        k, e = mean([run["compressibility_per_bar"]["value"] for run in runs]), mean([run["dielectric"]["constant"]["value"] for run in runs])
        bias = tuple(100 * x / e[0] for x in mean([run["dielectric"]["step_bias"]["constant"]["value"] for run in runs]))
        rows.append([T, cell([1e5 * x for x in k], 2), cell(percent(runs, "compressibility_per_bar", k[0]), 2), cell(e, 1), cell(bias, 2)])
    return table(head, rows)


def report(lines):
    of = by_temperature(lines)
    parts = ["### Density\n", densities(of)]
    if min(map(len, of.values())) > 1:
        parts += ["### Temperature of maximum density\n", maximum_table(of), "### Compressibility and dielectric constant\n", responses(of)]
    return "\n".join(parts)
