# SPDX-License-Identifier: MIT
"""The slope of the log ratio of two densities [merz2018], by maximum likelihood, and its theoretical value.

Of two samples of a quantity x with densities p1 and p2, each value belongs to the second with the probability 1/(1 + exp(-(a + s x)))
if ln p2/p1 = const + s x. For the potential energy at two temperatures s = 1/kT1 - 1/kT2, for the volume at two pressures
s = (P1 - P2)/kT, whatever the density of states."""

import numpy as np

from .statistics import inefficiency

BOLTZMANN = 0.00831446261815324  # [kJ/mol/K]
BAR = 0.0602214076  # [kJ/mol/nm^3]


def independent(x):
    """Values at intervals of g, which are nearly uncorrelated."""
    return x[::int(np.ceil(inefficiency(x)))]


def slope(first, second):
    """The slope s and its standard error, of uncorrelated values: logistic regression by Newton's method."""
    x = np.concatenate([first, second])
    y = np.concatenate([np.zeros(len(first)), np.ones(len(second))])
    centre, width = x.mean(), x.std()
    A = np.column_stack([np.ones(len(x)), (x - centre) / width])
    b = np.zeros(2)
    for _ in range(100):
        p = 1 / (1 + np.exp(-A @ b))
        information = A.T @ (A * (p * (1 - p))[:, None])
        step = np.linalg.solve(information, A.T @ (y - p))
        b += step / max(1.0, np.abs(step).max())  # at most 1, because Newton's steps may be too long far from the maximum
        if np.abs(step).max() < 1e-10:
            break
    return float(b[1] / width), float(np.sqrt(np.linalg.inv(information)[1, 1]) / width)


def expected(quantity, first, second):
    """The slope that theory gives.
    quantity: "potential" [kJ/mol] or "volume" [nm^3]; first, second: {"temperature": [K], "pressure": [bar]}"""
    beta = [1 / (BOLTZMANN * at["temperature"]) for at in (first, second)]
    if quantity == "potential":
        return beta[0] - beta[1]
    return beta[0] * first["pressure"] * BAR - beta[1] * second["pressure"] * BAR


def check(quantity, first, second, at_first, at_second):
    """Measured and expected slope of two correlated series, and the deviation in standard errors."""
    a, b = independent(first), independent(second)
    s, error = slope(a, b)
    theory = expected(quantity, at_first, at_second)
    return {"slope": s, "error": error, "expected": theory, "deviation": (s - theory) / error, "samples": [len(a), len(b)]}
