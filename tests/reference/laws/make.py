#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes expected.json: energies and forces of pairs of atoms from the published formulas and parameters.

    python3 tests/reference/laws/make.py

Nothing is taken from the program: units, parameters and mixing stand here again, with 40 digits. Needs mpmath.
"""
import json
from pathlib import Path

from mpmath import diff, exp, factorial, mp, mpf, sqrt

mp.dps = 40
N_A = mpf("6.02214076e23")
K = mpf("1.380649e-26") * N_A  # kJ/mol
ERG = mpf("1e-10") * N_A  # kJ/mol


def mie(sigma, epsilon, n, m):
    sigma, epsilon, n, m = (mpf(x) for x in (sigma, epsilon, n, m))
    c = n / (n - m) * (n / m) ** (m / (n - m)) * epsilon * K
    return lambda r: c * ((sigma / r) ** n - (sigma / r) ** m)


def buckingham(r):
    angstrom = 10 * r
    return (mpf("1.69e-8") * exp(-angstrom / mpf("0.273")) - mpf("102e-12") / angstrom**6) * ERG


def jager(r):
    u = mpf("4.61330146e7") * exp(mpf("-2.98337630e1") * r - mpf("9.71208881") * r**2 + mpf("2.75206827e-2") / r
                                  - mpf("1.01489050e-2") / r**2)
    x = mpf("4.02517211e1") * r
    for n, c in [(6, "4.42812017e-1"), (8, "3.26707684e-2"), (10, "2.45656537e-3"), (12, "1.88246247e-4"),
                 (14, "1.47012192e-5"), (16, "1.17006343e-6")]:
        u -= mpf(c) / r**n * (1 - exp(-x) * sum(x**k / factorial(k) for k in range(n + 1)))
    return u * K


argon, cf4 = ("0.3405", "122.10", 13, 6), ("0.43372", "232.62", "42.553", "5.1906")
mixed = (sum(map(mpf, (argon[0], cf4[0]))) / 2, sqrt(mpf(argon[1]) * mpf(cf4[1])), (13 + mpf(cf4[2])) / 2,
         (6 + mpf(cf4[3])) / 2)  # Lorentz-Berthelot
PAIRS = [("argon-mie", "argon-mie", mie(*argon), ["0.3", "0.36", "0.51", "0.83"]),
         ("cf4-mie", "cf4-mie", mie(*cf4), ["0.41", "0.44", "0.6", "0.83"]),
         ("argon-mie", "cf4-mie", mie(*mixed), ["0.36", "0.41", "0.5", "0.83"]),
         ("argon-buckingham", "argon-buckingham", buckingham, ["0.2", "0.31", "0.41", "0.83"]),
         ("argon-ab-initio", "argon-ab-initio", jager, ["0.2211", "0.3207", "0.3762", "0.8301"])]


def main():
    rows = [{"first": a, "second": b, "r": float(r), "u": float(u(mpf(r))), "f": float(-diff(u, mpf(r)))}
            for a, b, u, distances in PAIRS for r in distances]
    Path(__file__).with_name("expected.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


main()
