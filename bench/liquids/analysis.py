# SPDX-License-Identifier: MIT
"""Properties of a liquid at one temperature from runs at constant energy, with block errors; plain Python."""

from math import ceil, floor, pi, sqrt
from statistics import fmean, stdev
from typing import NamedTuple

BIN, REACH = 0.002, 1.0  # of the radial distribution [nm]
TOP = 0.9  # the top of the peak is where g exceeds this fraction of its maximum


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


def line(points):
    """(mean x, mean y, slope) of the least-squares line through (x, y)."""
    x, y = (fmean(p[k] for p in points) for k in (0, 1))
    spread = sum((p[0] - x) ** 2 for p in points)
    return x, y, sum((p[0] - x) * (p[1] - y) for p in points) / spread if spread > 0 else 0.0


def at_temperature(found, temperature):
    """Potential energy and pressure at the required mean temperature, and dE/dT. A run is characterized
    by its total energy, which is conserved: T(E), V(E) and P(E) are fitted by lines, and E is chosen to give T."""
    energy, mean, slope = line([(b.total, b.temperature) for b in found])
    beyond = (temperature - mean) / slope if slope > 0 else 0.0  # [kJ/mol] from the mean total energy
    value = {"heat_capacity": 1 / slope if slope > 0 else 0.0}
    for name in ("potential", "pressure"):
        _, y, rise = line([(b.total, getattr(b, name)) for b in found])
        value[name] = y + rise * beyond
    return value


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


def distances(edge, places):
    """Number of pairs in each distance bin, for nearest images in a cube."""
    size = ceil(min(REACH, edge / 2) / BIN - 1e-9)
    counts, half = [0] * size, edge / 2
    reach = min(size * BIN, half) ** 2
    for i, (x, y, z) in enumerate(places):
        for u, v, w in places[i + 1 :]:
            u = abs(u - x) % edge
            if u > half:
                u = edge - u
            v = abs(v - y) % edge
            if v > half:
                v = edge - v
            w = abs(w - z) % edge
            if w > half:
                w = edge - w
            square = u * u + v * v + w * w
            if square < reach:
                counts[int(sqrt(square) / BIN)] += 1
    return counts


def radial(histograms, edge, molecules):
    """g(r) [(middle of a bin, value)] from the histograms of frames: pairs divided by those of an ideal gas of the same density."""
    frames = len(histograms)
    pairs = molecules * (molecules - 1) / 2 / edge**3
    shell = lambda k: 4 / 3 * pi * ((k + 1) ** 3 - k**3) * BIN**3
    return [((k + 0.5) * BIN, sum(column) / frames / (pairs * shell(k)))
            for k, column in enumerate(zip(*histograms))]


def solved(matrix, right):
    """The solution of linear equations, by elimination with pivots."""
    rows, n = [list(r) + [b] for r, b in zip(matrix, right)], len(right)
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[best] = rows[best], rows[k]
        for i in range(n):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [rows[k][n] / rows[k][k] for k in range(n)]


def first_peak(g):
    """Position [nm] and height of the first peak: the maximum of a cubic through its top."""
    top = max(range(len(g)), key=lambda k: g[k][1])
    low = high = top
    while low > 0 and g[low - 1][1] > TOP * g[top][1]:
        low -= 1
    while high + 1 < len(g) and g[high + 1][1] > TOP * g[top][1]:
        high += 1
    low, high = min(low, max(0, top - 2)), max(high, min(len(g) - 1, top + 2))
    points = [((r - g[top][0]) / BIN, y) for r, y in g[low : high + 1]]
    powers = range(4 if len(points) > 5 else 3)
    c = solved([[sum(x ** (i + j) for x, _ in points) for j in powers] for i in powers],
               [sum(y * x**i for x, y in points) for i in powers])
    value = lambda x: sum(a * x**i for i, a in enumerate(c))
    start, end = floor(points[0][0]), ceil(points[-1][0])
    x = max((start + (end - start) * k / 2000 for k in range(2001)), key=value)
    return {"place": g[top][0] + x * BIN, "height": value(x)}


def peak(histograms, edge, molecules, pieces):
    """The first peak and its jackknife error, from blocks of consecutive frames."""
    size = len(histograms) // pieces
    cut = [[sum(column) for column in zip(*histograms[k * size : (k + 1) * size])] for k in range(pieces)]
    return jackknife([[x / size for x in piece] for piece in cut],
                     lambda own: first_peak(radial(own, edge, molecules)))
