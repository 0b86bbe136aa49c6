#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Free energies from samples of several stages: acceptance ratios between neighbours against MBAR, which uses the energies of all samples at
all stages. Stages are harmonic wells with equal distances, so that exact results are known."""

import numpy as np
from lib import study
from lib.statistics import mean
from lib.statistics import text as cell
from scipy.optimize import brentq

SHARES = (0.7, 0.5, 0.25)  # effective share of the samples of a stage at the next one; `polhode measure` requires at least 0.25


def acceptance_ratio(forward, backward):
    """The free energy difference [kT] from energy differences of two stages, sampled at the first and at the second."""
    return brentq(lambda f: (1 / (1 + np.exp(forward - f))).sum() - (1 / (1 + np.exp(backward + f))).sum(), -30, 30)


def mbar(energies, samples):
    """Free energies [kT] of the stages relative to the first, from the energies of all samples at all stages."""
    f = np.zeros(len(energies))
    for _ in range(1000):
        mixed = np.logaddexp.reduce(np.log(samples) + f[:, None] - energies, axis=0)
        new = -np.logaddexp.reduce(-energies - mixed, axis=1)
        new -= new[0]
        if np.abs(new - f).max() < 1e-7:
            break
        f = new
    return f


def both(share, stages, samples, random):
    """(sum of acceptance ratios, MBAR) of independent samples. Neighbours with the distance d have the effective share exp(-d²)."""
    centres = np.arange(stages) * (-np.log(share)) ** 0.5
    x = centres[:, None] + random.standard_normal((stages, samples))
    u = lambda k, at: 0.5 * (at - centres[k]) ** 2
    steps = [acceptance_ratio(u(k + 1, x[k]) - u(k, x[k]), u(k, x[k + 1]) - u(k + 1, x[k + 1])) for k in range(stages - 1)]
    return sum(steps), mbar(u(np.arange(stages)[:, None], x.ravel()[None, :]), samples)[-1]


def measured(o):
    random = np.random.default_rng(1)
    cases = []
    for share in SHARES:
        pairs = np.array([both(share, o.stages, o.samples, random) for _ in range(o.repeats)])
        squares = pairs**2
        blocks = [s[:, 1].mean() / s[:, 0].mean() for s in np.array_split(squares, 10)]
        cases.append({"share": share, "mean_acceptance_ratios": mean(pairs[:, 0]), "mean_mbar": mean(pairs[:, 1]),
                      "variance_ratio": [squares[:, 1].mean() / squares[:, 0].mean(), mean(blocks)[1]]})
    return {"stages": o.stages, "samples": o.samples, "repeats": o.repeats, "cases": cases}


def report(result):
    return study.table(["effective share", "acceptance ratios, error [kT]", "MBAR, error [kT]", "variance, MBAR to acceptance ratios"],
                       [[f"{c['share']:g}", cell(c["mean_acceptance_ratios"], 4), cell(c["mean_mbar"], 4), cell(c["variance_ratio"], 3)]
                        for c in result["cases"]])


def main():
    o = study.options(__doc__, {"repeats": 20, "stages": 4, "samples": 50}, stages=(12, "stages"), samples=(200, "samples of each stage"),
                      repeats=(400, "sets of samples"))
    study.perform(o, measured, report)


if __name__ == "__main__":
    main()
