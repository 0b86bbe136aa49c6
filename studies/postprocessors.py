# SPDX-License-Identifier: MIT
"""The stages of the postprocessors of the program, from the free Lie algebra of the flows A and B up to degree 5.

The error of a scheme K = exp(A + B + E3 + E5 + ...) has the terms E3 = a [A,[A,B]] + b [B,[A,B]] and E5. A postprocessor
P = exp(c [A,B] + P4) gives the map P K P^-1, which is the operator exp(-ln P) K exp(ln P), the prefactors a + c and b + c. The study chooses c = -(a + b)/2, and the P4 for which the sum
of the squared coefficients of E5 is smallest. Then it solves the equations for the stages of P, from random starts, and keeps the solution with
the smallest sum of absolute fractions. The postprocessor of GIER4 has two fractions more than equations; these two were chosen from the solutions of
100 starts. All commutators that contain [B,[B,[A,B]]] are zero, because T is quadratic in the momenta."""

import itertools

import numpy as np
from lib import study
from scipy.optimize import leastsq

DEGREE = 5
WORDS = [word for n in range(DEGREE + 1) for word in map("".join, itertools.product("AB", repeat=n))]
PLACE = {word: i for i, word in enumerate(WORDS)}
DEGREES = np.array([len(word) for word in WORDS])
PRODUCTS = np.array([(i, j, PLACE[u + v]) for i, u in enumerate(WORDS) for j, v in enumerate(WORDS) if len(u) + len(v) <= DEGREE])
ONE = np.eye(len(WORDS))[0]
A, B = np.eye(len(WORDS))[PLACE["A"]], np.eye(len(WORDS))[PLACE["B"]]

SCHEMES = {  # stages (flow, fraction, xi); flows of the postprocessor, and its first fractions if they are chosen
    "velocity-verlet": ([("B", 1 / 2, 0), ("A", 1, 0), ("B", 1 / 2, 0)], "BABABAB", []),
    "takahashi-imada": ([("A", 1 / 2, 0), ("B", 1, 1 / 24), ("A", 1 / 2, 0)], "BABABAB", []),
    "gier4": ([("B", 1 / 6, 0), ("A", 1 / 2, 0), ("B", 2 / 3, 1 / 48), ("A", 1 / 2, 0), ("B", 1 / 6, 0)], "ABABABABA", [0.02941249880167372, -0.147590398217303]),
}


def product(x, y):
    return np.bincount(PRODUCTS[:, 2], x[PRODUCTS[:, 0]] * y[PRODUCTS[:, 1]], len(WORDS))


def powers(x):
    power = ONE
    for _ in range(DEGREE):
        power = product(power, x)
        yield power


def exponential(x):
    factorials = np.cumprod(np.arange(1, DEGREE + 1))
    return ONE + sum(power / n for power, n in zip(powers(x), factorials))


def logarithm(x):
    return sum(power * (-1) ** n / (n + 1) for n, power in enumerate(powers(x - ONE)))


def commutator(x, y):
    return product(x, y) - product(y, x)


AB = commutator(A, B)
AAB, BAB = commutator(A, AB), commutator(B, AB)
AAAB, BAAB, zero = commutator(A, AAB), commutator(B, AAB), commutator(B, BAB)
# Commutators of each degree, and how many of them are not zero.
COMMUTATORS = {2: ([AB], 1), 3: ([AAB, BAB], 2), 4: ([AAAB, BAAB, zero], 2),
               5: ([commutator(A, AAAB), commutator(B, AAAB), commutator(B, BAAB), commutator(AB, AAB), commutator(A, zero), commutator(B, zero)], 4)}
PROJECTIONS = {d: np.linalg.pinv(np.array(basis).T)[:count] for d, (basis, count) in COMMUTATORS.items()}


def coefficients(x, degree):
    return PROJECTIONS[degree] @ (x * (DEGREES == degree))


def composed(stages):
    result = ONE
    for flow, fraction, xi in stages:
        result = product(result, exponential(fraction * (A if flow == "A" else B + xi * BAB)))
    return result


def conjugated(scheme, logarithm_of_p):
    """The logarithm of P K P^-1; the first stage acts first, so P^-1 is on the left."""
    return logarithm(product(product(exponential(-logarithm_of_p), scheme), exponential(logarithm_of_p)))


def target(scheme):
    """ln P: c, and the coefficients of degree 4."""
    c = -sum(coefficients(logarithm(scheme), 3)) / 2
    logarithm_of_p = lambda p4: c * AB + p4[0] * AAAB + p4[1] * BAAB
    p4, _ = leastsq(lambda p4: coefficients(conjugated(scheme, logarithm_of_p(p4)), 5), np.zeros(2), xtol=1e-15, ftol=1e-15)
    return c, p4, coefficients(conjugated(scheme, logarithm_of_p(p4)), 5)


def stages_of(flows, chosen, c, p4, starts):
    def missed(fractions):
        x = logarithm(composed([(flow, fraction, 0) for flow, fraction in zip(flows, [*chosen, *fractions])]))
        return [x[PLACE["A"]], x[PLACE["B"]], *(coefficients(x, 2) - c), *coefficients(x, 3), *(coefficients(x, 4) - p4)]

    random, best = np.random.default_rng(1), None
    for _ in range(starts):
        fractions, *_ = leastsq(missed, random.normal(0, 0.35, len(flows) - len(chosen)), xtol=1e-15, ftol=1e-15, maxfev=1000, full_output=True)
        fractions = np.array([*chosen, *fractions])
        if np.abs(missed(fractions[len(chosen):])).max() < 1e-13 and (best is None or abs(fractions).sum() < abs(best).sum()):
            best = fractions
    if best is None:
        return None
    for flow in "AB":  # the sums are zero to the last digit, not only to the accuracy of the fit
        own = [i for i, other in enumerate(flows) if other == flow]
        best[own[-1]] -= best[own].sum()
    return [(flow, float(fraction)) for flow, fraction in zip(flows, best)]


def measured(o):
    found = {}
    for name, (stages, flows, chosen) in SCHEMES.items():
        c, p4, left = target(composed(stages))
        found[name] = {"c": float(c), "degree 4": p4.tolist(), "left of degree 5": left.tolist(), "stages": stages_of(flows, chosen, c, p4, o.starts)}
    return {"schemes": found}


def report(result):
    numbers = lambda values: ", ".join(f"{x:.4g}" for x in values)
    stages = lambda found: " ".join(f"{flow}({fraction:.16g})" for flow, fraction in found) if found else "not found"
    return study.table(["scheme", "c", "degree 4", "left of degree 5", "stages"],
                       [[name, f"{r['c']:.6g}", numbers(r["degree 4"]), numbers(r["left of degree 5"]), stages(r["stages"])] for name, r in result["schemes"].items()])


if __name__ == "__main__":
    o = study.options(__doc__, {"starts": 1}, starts=(50, "random starts for the stages of each postprocessor"))
    study.perform(o, measured, report)
