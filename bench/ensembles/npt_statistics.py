# SPDX-License-Identifier: MIT
"""Means and fluctuations of correlated series, with their errors from the integrated autocorrelation time."""

from math import sqrt
from typing import NamedTuple

import numpy

WINDOW = 6  # autocorrelation times after which the sum is cut, as Sokal recommends


class Estimate(NamedTuple):
    value: float
    error: float
    samples: float  # independent ones


def autocorrelation_time(series):
    """Integrated, in samples: 1/2 for independent ones. The sum ends at the first lag of WINDOW times itself."""
    x = series - series.mean()
    if not x.any():
        return 0.5
    n = len(x)
    spectrum = numpy.abs(numpy.fft.rfft(x, 2 * n)) ** 2
    correlation = numpy.fft.irfft(spectrum)[:n] / numpy.arange(n, 0, -1)
    sums = numpy.cumsum(correlation / correlation[0]) - 0.5
    ends = numpy.nonzero(numpy.arange(n) >= WINDOW * sums)[0]
    return max(0.5, float(sums[ends[0] if len(ends) else -1]))


def mean(series):
    n = len(series) / (2 * autocorrelation_time(series))
    return Estimate(float(series.mean()), float(series.std()) / sqrt(n), n)


def variance(series):
    """Of the distribution, not of the mean; what the mean of the sample itself takes away is restored."""
    squares = (series - series.mean()) ** 2
    found = mean(squares)
    factor = 1 / (1 - 1 / mean(series).samples)
    return Estimate(found.value * factor, found.error * factor, found.samples)


def scaled(estimate, factor):
    return Estimate(estimate.value * factor, estimate.error * abs(factor), estimate.samples)


def deviation(a, b):
    """Of two estimates, in combined standard errors."""
    return (a.value - b.value) / sqrt(a.error**2 + b.error**2)
