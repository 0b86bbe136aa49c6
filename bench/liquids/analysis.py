# SPDX-License-Identifier: MIT
"""Properties of a liquid at one temperature from the energies of runs at constant energy, with block errors."""

from math import sqrt
from statistics import fmean, linear_regression, stdev
from typing import NamedTuple


class Block(NamedTuple):
    """Means over a block of a run."""
    run: int
    total: float  # of the whole system [kJ/mol]
    potential: float  # [kJ/mol]
    temperature: float  # [K]
    pressure: float  # [bar]


def blocks(runs, count):
    """The samples of each run divided into `count` equal blocks, without the first sample."""
    found = []
    for k, samples in enumerate(runs):
        size = (len(samples) - 1) // count
        for b in range(count):
            piece = samples[1 + b * size : 1 + (b + 1) * size]
            mean = lambda column: fmean(s[column] for s in piece)
            found.append(Block(k, mean("total"), mean("potential"), mean("temperature"), mean("pressure")))
    return found


def on_line(points, x):
    """The value at x of the least-squares line through (x, y); the mean of y where all x are equal."""
    xs, ys = zip(*points)
    if len(set(xs)) < 2:
        return fmean(ys)
    slope, intercept = linear_regression(xs, ys)
    return intercept + slope * x


def at_temperature(found, temperature):
    """Potential energy and pressure at the required mean temperature, and dE/dT. A run is characterized
    by its total energy, which is conserved: T(E), V(E) and P(E) are fitted by lines, and E is chosen to give T."""
    slope, intercept = linear_regression([b.total for b in found], [b.temperature for b in found])
    energy = (temperature - intercept) / slope
    value = {name: on_line([(b.total, getattr(b, name)) for b in found], energy) for name in ("potential", "pressure")}
    return {"heat_capacity": 1 / slope, **value}


def jackknife(items, statistic):
    """(value, error) of a dictionary of statistics, by the jackknife over items."""
    value, n = statistic(items), len(items)
    without = [statistic(items[:k] + items[k + 1 :]) for k in range(n)]
    error = {name: sqrt((n - 1) / n * sum((w[name] - fmean(v[name] for v in without)) ** 2 for w in without))
             for name in value}
    return value, error


def block_errors(runs, column, counts):
    """(blocks a run, error of the mean over all runs) from the scatter of blocks about the mean of their own run."""
    rows = []
    for count in counts:
        own = [[getattr(b, column) for b in blocks([samples], count)] for samples in runs]
        square = sum(stdev(means) ** 2 / count for means in own)
        rows.append((count, sqrt(square) / len(runs)))
    return rows


def first_peak(runs, temperature):
    """Position and height of the first peak of g(r) at a temperature, from (temperature, place, height) of each run."""
    at = lambda own: {name: on_line([(r[0], r[k]) for r in own], temperature) for k, name in ((1, "place"), (2, "height"))}
    return jackknife(runs, at)
