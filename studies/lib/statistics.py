# SPDX-License-Identifier: MIT
"""Means with standard errors: for independent runs, for correlated samples, and for statistics of several of them."""

from math import inf, sqrt

import numpy as np
from scipy import stats


def mean(values):
    """(mean, standard error) of values of independent runs; the error of one value is infinite."""
    x = np.asarray(values, dtype=float)
    return float(x.mean()), float(stats.sem(x)) if len(x) > 1 else inf


def estimate(values):
    """The mean and its standard error as an entry of a record."""
    centre, error = mean(values)
    return {"value": centre, "error": error if error < inf else 0.0}


def rms(values):
    return sqrt(np.mean(np.square(values)))


def over_scatter(pairs):
    """(rms of stated errors, scatter of values, their ratio) of (value, error) of independent runs; None of fewer than three, or
    of values without scatter."""
    known = [(value, error) for value, error in pairs if error is not None]
    scatter = float(np.std([value for value, _ in known], ddof=1)) if len(known) > 2 else 0
    return (stated := rms([error for _, error in known]), scatter, stated / scatter) if scatter > 0 else None


def share_interval(count, runs, method="wilson"):
    """The 95 % interval of a fraction."""
    found = stats.binomtest(count, runs).proportion_ci(0.95, method=method)
    return float(found.low), float(found.high)


def inefficiency(x):
    """g = 1 + 2 times the sum of the autocorrelation, up to a window of 5 correlation times."""
    n, d = len(x), x - np.mean(x)
    rho = np.fft.irfft(np.abs(np.fft.rfft(d, 2 * n)) ** 2)[:n]
    if rho[0] <= 0:
        return 1.0
    g = 2 * np.cumsum(rho / rho[0]) - 1
    window = np.nonzero(np.arange(n) >= 2.5 * np.maximum(g, 1))[0]
    return max(1.0, float(g[window[0]] if len(window) else g[-1]))


def correlated_mean(x):
    """(mean, standard error) of correlated samples."""
    return float(np.mean(x)), float(np.std(x, ddof=1) * sqrt(inefficiency(x) / len(x)))


def block_mean(x, blocks):
    """(mean, standard error) from the scatter of blocks, which include slow parts that sums of the autocorrelation miss."""
    return mean(np.asarray(x)[:len(x) // blocks * blocks].reshape(blocks, -1).mean(axis=1))


def jackknife(items, statistic):
    """(value, error) of statistic(items), a dictionary of numbers, by the jackknife over items."""
    value, n = statistic(items), len(items)
    without = [statistic(items[:k] + items[k + 1:]) for k in range(n)]
    return value, {name: sqrt(n - 1) * float(np.std([w[name] for w in without])) for name in value}


def text(estimate, digits):
    """An estimate as text, such as 1.23 ± 0.04; empty if there is none."""
    if estimate is None:
        return ""
    value, error = estimate
    return f"{value:.{digits}f}" + (f" ± {error:.{digits}f}" if error < inf else "")
