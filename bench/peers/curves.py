# SPDX-License-Identifier: MIT
"""Statistics of energies, and the step at which a program has a required R."""

from math import exp, isfinite, log, sqrt
from statistics import fmean, median, pstdev
from typing import NamedTuple

BLOCKS = 20
T_18 = 2.878  # value of Student's t with 18 degrees of freedom that chance exceeds in 1 % of cases
LONG = 400.0  # length of a block [fs]; within shorter times energies are correlated, and a t-test would always find drifts
LOST = 0.05  # fraction of the kinetic energy per nanosecond above which a drift matters


class Point(NamedTuple):
    step: float  # [fs]
    ratio: float  # R
    error: float  # of R
    drift: float  # [1/ns], of the total energy, over the kinetic energy
    drift_significant: bool
    temperature: float  # [K]
    potential: float  # mean [kJ/mol]

    @property
    def usable(self):
        """Whether energies stay finite and the total energy does not diverge."""
        return isfinite(self.ratio) and not (self.drift_significant and abs(self.drift) > LOST)


def ratio(samples):
    """R: rms deviation of the total energy from its mean, divided by the rms deviation of the potential energy."""
    return pstdev([s.total for s in samples]) / pstdev([s.potential for s in samples])


def blocks(samples):
    """Divides a series into BLOCKS equal consecutive parts; the remainder is omitted."""
    size = len(samples) // BLOCKS
    return [samples[k * size : (k + 1) * size] for k in range(BLOCKS)]


def ratio_error(samples):
    """Standard error of R, by the jackknife over blocks."""
    parts = blocks(samples)
    without = [ratio([s for j, p in enumerate(parts) if j != k for s in p]) for k in range(BLOCKS)]
    mean = fmean(without)
    return sqrt((BLOCKS - 1) / BLOCKS * sum((r - mean) ** 2 for r in without))


def slope(times, values):
    """Least-squares slope and its standard error from the scatter about the line."""
    t, v = fmean(times), fmean(values)
    spread = sum((x - t) ** 2 for x in times)
    result = sum((x - t) * (y - v) for x, y in zip(times, values)) / spread
    scatter = sum((y - v - result * (x - t)) ** 2 for x, y in zip(times, values))
    return result, sqrt(scatter / (len(times) - 2) / spread)


def point(step, samples, interval_fs):
    """The results of a run at a given step, from samples at every `interval_fs`."""
    if not all(isfinite(s.total) and isfinite(s.potential) for s in samples) or len(samples) < 2 * BLOCKS:
        return Point(step, float("nan"), float("nan"), float("nan"), True, float("nan"), float("nan"))
    parts = blocks(samples)
    length = len(parts[0]) * interval_fs
    times = [(k + 0.5) * length * 1e-6 for k in range(BLOCKS)]  # [ns]
    rate, error = slope(times, [fmean(s.total for s in p) for p in parts])
    kinetic = fmean(s.total - s.potential for s in samples)
    return Point(step, ratio(samples), ratio_error(samples), rate / kinetic,
                 length >= LONG and abs(rate) > T_18 * error,
                 fmean(s.temperature for s in samples), fmean(s.potential for s in samples))


def step_at(target, points):
    """(longest step with R at or below the target, mark), log-log between neighbouring usable points.

    The mark is "" between points, "+" if even the longest usable step has a smaller R, and "not
    reached", without a step, if R is always above the target."""
    usable = []
    for p in sorted(points):
        if not p.usable:
            break
        usable.append(p)
    if not usable:
        return None, "not reached"
    if usable[-1].ratio <= target:
        return usable[-1].step, "+"
    for low, high in reversed(list(zip(usable, usable[1:]))):
        if low.ratio <= target < high.ratio:
            part = log(target / low.ratio) / log(high.ratio / low.ratio)
            return exp(log(low.step) + part * log(high.step / low.step)), ""
    return None, "not reached"


def seconds_per_ns(step_us, step_fs):
    return step_us / step_fs  # 10⁶ fs in a ns, 10⁶ µs in a second


def ns_per_day(step_us, step_fs):
    return 86400 / seconds_per_ns(step_us, step_fs)


def middle(values):
    """The median, and half of the range divided by the median."""
    m = median(values)
    return m, (max(values) - min(values)) / 2 / m
