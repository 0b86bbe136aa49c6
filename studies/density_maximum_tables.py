# SPDX-License-Identifier: MIT
"""Tables of the density maximum: densities without time-step bias, the maximum and its shift, compressibility and dielectric constant.

Fixed before the first run: densities are corrected to a mean pressure of 1 bar with the compressibility of all runs at a temperature. The
limit of short steps is a cubic, weighted by the errors, through densities minus predicted biases; a parabola through the biases
gives the shift. Errors of the maximum and its shift are from sets of runs drawn with replacement at each temperature. The maximum is
known if its error is at most 0.5 K. The published shift of -4 K at 2 fs is refuted if the 99 % interval of the shift excludes it."""

from collections import defaultdict
from math import hypot, sqrt
from typing import NamedTuple

import half_femtosecond
import numpy as np
from half_femtosecond_tables import bias_fit, by_point, density, density_bias, density_biases, density_fit, maximum, name_of
from lib.runs import number
from lib.statistics import mean
from lib.statistics import text as cell
from lib.study import ROOT, table

STEP = 2  # [fs] of the runs
STEPS = (0.5, 1, 2, 4)  # [fs]
EARLIER = [ROOT / f"studies/records/{name}.jsonl" for name in
           ("2026-11-23-half-femtosecond", "2026-11-23-density-298", "2026-11-27-density-318", "2026-11-27-density-318-short-step")]
PUBLISHED = {0.5: 277.15, 2: 273.15, 4: 269.15}  # maxima [K] by step [fs] [asthagiri2025b]


def by_temperature(lines):
    found = defaultdict(list)
    for line in lines:
        found[line["temperature"]].append(line)
    return dict(sorted(found.items()))


def kappa(runs):
    return np.mean([run["compressibility_per_bar"]["value"] for run in runs])


def at_one_bar(runs, compressibility):
    """The densities of runs, corrected to the set pressure by the compressibility [1/bar]."""
    return np.array([density(run) * (1 - compressibility * (run["pressure_bar"] - 1)) for run in runs])


def limits(runs):
    """(densities at 1 bar minus predicted biases, predicted biases) of runs at a temperature."""
    biases = np.array([density_bias(run) for run in runs])
    return at_one_bar(runs, kappa(runs)) - biases, biases


def unbiased(runs, compressibility):
    """The densities of earlier runs at 1 bar minus their predicted biases."""
    return at_one_bar(runs, compressibility) - np.array([density_bias(run) or 0 for run in runs])


def earlier_runs():
    """Runs of the study of the half femtosecond that predict their bias, and runs of gier4-fd at 2 fs, which have none within 0.01 %."""
    lines = [line for record in EARLIER for line in half_femtosecond.known(record).values()]
    return [line for line in lines if line["point"][4] == "constant pressure" and (line["step_bias"] or line["point"][5:7] == ["gier4-fd", 2])]


class Curves:
    """Fits through the means over runs at each temperature."""

    def __init__(self, values, errors):
        """values: {T: (densities without bias, biases, further densities without bias)}; errors: of the mean density by T."""
        T = list(values)
        self.limit = density_fit(T, [np.concatenate([x, more]).mean() for x, _, more in values.values()], 3, errors)
        self.bias = bias_fit(T, [b.mean() for _, b, _ in values.values()])

    def of(self, step):
        """The densities of velocity Verlet at this step [fs]; 0: the limit of short steps."""
        return self.limit + self.bias * (step / STEP) ** 2


class Resampled(NamedTuple):
    """The curves of all runs, and curves of runs drawn with replacement at each temperature."""
    whole: Curves
    drawn: list

    def maximum(self, step):
        """(maximum, error, shift, error, 99 % interval of the shift) of velocity Verlet at this step."""
        top = lambda curves, h: maximum(curves.of(h))
        tops, shifts = np.array([(top(one, step), top(one, step) - top(one, 0)) for one in self.drawn]).T
        return (top(self.whole, step), tops.std(), top(self.whole, step) - top(self.whole, 0), shifts.std(), np.percentile(shifts, (0.5, 99.5)))


def resampled(of, draws=1000, earlier=()):
    """earlier: further runs with predicted biases, or without any bias, for the limit of short steps."""
    values = {T: (*limits(runs), unbiased([run for run in earlier if run["point"][2] == T], kappa(runs))) for T, runs in of.items()}
    errors = np.array([mean(np.concatenate([x, more]))[1] for x, _, more in values.values()])
    random = np.random.default_rng(1)
    again = lambda n: random.integers(n, size=n) if n else []
    drawn = []
    for _ in range(draws):
        chosen = {T: (again(len(x)), again(len(more))) for T, (x, _, more) in values.items()}
        drawn.append(Curves({T: (x[chosen[T][0]], b[chosen[T][0]], more[chosen[T][1]]) for T, (x, b, more) in values.items()}, errors))
    return Resampled(Curves(values, errors), drawn)


def densities(of):
    """Densities of the runs, and what they say of other steps."""
    head = ["T [K]", "runs", "density at 1 bar [kg/m³]", "bias, predicted [kg/m³]", "limit of short steps [kg/m³]", "error [%]",
            *(f"at {step:g} fs [kg/m³]" for step in STEPS if step != STEP)]
    rows = []
    for T, runs in of.items():
        x, b = limits(runs)
        at = [mean(x + b * (step / STEP) ** 2) for step in STEPS if step != STEP]
        rows.append([T, len(runs), cell(mean(x + b), 2), cell(mean(b), 3), cell(mean(x), 2), f"{100 * mean(x)[1] / x.mean():.3f}",
                     *(cell(one, 2) for one in at)])
    return table(head, rows)


def hoa2_maximum(curves, points):
    """(maximum, error, shift, error, 99 % interval of the shift) of hoa2 at 4 fs, from the biases that its earlier runs predict."""
    T, biases, errors = map(np.array, zip(*density_biases(points)["hoa2, 4 fs"]))
    random = np.random.default_rng(2)
    top = lambda limit, b: np.array([maximum(limit + bias_fit(T, b)), maximum(limit)])
    tops = np.array([top(one.limit, biases + errors * random.standard_normal(len(T))) for one in curves.drawn])
    whole, shifts = top(curves.whole.limit, biases), tops[:, 0] - tops[:, 1]
    return whole[0], tops[:, 0].std(), whole[0] - whole[1], shifts.std(), np.percentile(shifts, (0.5, 99.5))


def maxima(of, points):
    curves = resampled(of)
    head = ["scheme", "maximum [K]", "shift [K]", "99 % interval", "published maximum [K]"]
    found = {f"velocity Verlet, {step:g} fs" if step else "limit of short steps": (step, curves.maximum(step)) for step in (0, *STEPS)}
    rows = []
    for name, (step, (top, error, shift, of_shift, (low, high))) in (found | {"hoa2, 4 fs": (None, hoa2_maximum(curves, points))}).items():
        moved = ["", ""] if step == 0 else [cell((shift, of_shift), 2), f"{low:.2f} to {high:.2f}"]
        rows.append([name, cell((top, error), 2), *moved, PUBLISHED.get(step, "")])
    rows.insert(1, ["the same, with earlier runs", cell(resampled(of, earlier=earlier_runs()).maximum(0)[:2], 2), "", "", ""])
    return table(head, rows)


def fits(of):
    """The maximum of the limit of short steps by other fits: how much the choice of the fit matters."""
    head = ["polynomial of degree", "temperatures [K]", "maximum [K]", "χ²", "degrees of freedom"]
    random = np.random.default_rng(3)
    T, values, errors = map(np.array, zip(*((T, *mean(limits(runs)[0])) for T, runs in of.items())))
    rows = []
    for degree, first in ((3, 0), (2, 0), (4, 0), (3, 1), (2, 1)):
        t, x, e = T[first:], values[first:], errors[first:]
        fit = density_fit(t, x, degree, e)
        tops = [maximum(density_fit(t, x + e * random.standard_normal(len(t)), degree, e)) for _ in range(1000)]
        rows.append([degree, f"{t[0]} to {t[-1]}", cell((maximum(fit), np.std(tops)), 2), f"{(((x - fit(t)) / e) ** 2).sum():.1f}", len(t) - degree - 1])
    return table(head, rows)


def earlier(of, points):
    """Runs of the study of the half femtosecond, which are independent of these: their densities at 1 bar minus the limit of short steps and
    minus their predicted biases, averaged over the temperatures. Errors are from the scatter of the runs of this study at each temperature."""
    rows = []
    for name in dict.fromkeys(map(name_of, points)):
        found = []
        for runs, T in ((runs, p.temperature) for p, runs in points.items() if name_of(p) == name and p.temperature in of):
            x, _ = limits(of[T])
            biases = [density_bias(run) for run in runs if run["step_bias"]]
            bias, of_bias = mean(biases) if biases else (0, 0)
            difference = np.mean(at_one_bar(runs, kappa(of[T]))) - bias - x.mean()
            found.append((difference / x.mean(), hypot(x.std(ddof=1) / sqrt(len(runs)), mean(x)[1], of_bias) / x.mean()))
        difference, size = 100 * np.array(found).T
        rows.append([name, cell((difference.mean(), sqrt((size**2).sum()) / len(size)), 3), f"{((difference / size) ** 2).sum():.1f}"])
    return table(["scheme", "density minus bias and limit, mean over temperatures [%]", f"χ², {len(of)} temperatures"], rows)


def permittivity(run):
    """The dielectric constant of a run and its bias. The program subtracts the square of the mean dipole, which is the share 2τ/t of the variance
    in a run of length t with the relaxation time τ. Here it is added again, because the true mean is zero."""
    of, rest = run["dielectric"], 1 - run["dielectric"]["mean_over_rms_dipole"] ** 2
    return 1 + (number(of["constant"]) - 1) / rest, of["step_bias"]["constant"]["value"] / rest


def responses(of):
    """Compressibility and dielectric constant with their biases."""
    head = ["T [K]", "κ [10⁻⁵/bar]", "bias of κ [%]", "ε", "bias of ε [%]"]
    rows = []
    for T, runs in of.items():
        quantities = []
        for values, biases, digits in (
                ([1e5 * run["compressibility_per_bar"]["value"] for run in runs],
                 [1e5 * run["step_bias"]["compressibility_per_bar"]["value"] for run in runs], 2),
                (*zip(*map(permittivity, runs)), 1)):
            value = mean(values)
            quantities += [cell(value, digits), cell([100 * x / value[0] for x in mean(biases)], 2)]
        rows.append([T, *quantities])
    return table(head, rows)


def report(lines):
    of = by_temperature(lines)
    if min(map(len, of.values())) < 2:
        return "at least two runs at each temperature are needed"
    points = by_point(half_femtosecond.known(EARLIER[0]), ["density"])
    return "\n".join(["### Density\n", densities(of), "### Temperature of maximum density\n", maxima(of, points), "### Other fits\n", fits(of), "### Earlier runs\n", earlier(of, points),
                      "### Compressibility and dielectric constant\n", responses(of)])
