#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Free rotor rows of tops that lie exactly on the separatrix, 2 E J_y = L^2, as doubles.

    python3 make_separatrix_rows.py > separatrix_rows.csv        (mpmath; minutes; the seed is fixed)

Moments and components of L are whole numbers with L_z^2 (Jz - Jy)/Jz = L_x^2 (Jy - Jx)/Jx, and such that doubles
see that too: alpha = beta in include/polhode/rotor/orbit.hpp, which is computed here in the same way. L runs to the
middle axis and stays: with T = tanh u, u = u0 + p t,

    L_x = A_x sech u,  L_y = |L| T,  L_z = A_z sech u,
    phi = |L| t/Jy + |L| (1/Jx - 1/Jy) A_x/(A_z p) [atan(A_z T/A_x) - atan(A_z T0/A_x)]    about L, following z,

from phi' = |L| (L_x^2/Jx + L_y^2/Jy)/(L_x^2 + L_y^2). The program has the integral in another form. Rows with
|omega t| <= 12 are checked against a Taylor series of Euler's equations, and one with |omega t| = 60 at 90 digits.

Tolerances: 16 * 2^-53 * (1 + k) as in README.md, with k of those changes of inputs that stay on the separatrix: of
t, of the size of L and of the size of J, each like a change of t: k <= 3 |t| max |omega| for P, and 3 |t L'|/|L| for L.
All other changes grow like exp(p t); a program that sees alpha = beta makes none.
"""
import math
import random
import sys
from mpmath import mp, mpf, sqrt, atan, atanh, tanh, cosh, cos, sin
from make_rows import EPS, distance, frame, quaternion, taylor

mp.dps = 70
random.seed(12152025)


def motion(J, L, t):
    """P(t) and L(t)."""
    x, y, z = sorted(range(3), key=lambda k: J[k])
    n = sqrt(sum(l * l for l in L))
    T0 = L[y] / n
    sech0 = sqrt((L[x] ** 2 + L[z] ** 2)) / n
    Ax, Az = L[x] / sech0, L[z] / sech0
    turn = 1 if (x + 1) % 3 == y else -1
    p = turn * Ax * Az * (1 / J[x] - 1 / J[z]) / n  # L_y' = L_z L_x (1/Jx - 1/Jz), cyclic
    u = atanh(T0) + p * t
    T, sech = tanh(u), 1 / cosh(u)
    after = [mpf(0)] * 3
    after[x], after[y], after[z] = Ax * sech, n * T, Az * sech
    c = n * (1 / J[x] - 1 / J[y]) * Ax / (Az * p)
    phi = n * t / J[y] + c * (atan(Az * T / Ax) - atan(Az * T0 / Ax))
    a, b = frame(L, z), frame(after, z)
    co, si = cos(phi), sin(phi)
    u1 = [co * a[0][i] + si * a[1][i] for i in range(3)]
    u2 = [-si * a[0][i] + co * a[1][i] for i in range(3)]
    P = [[b[0][i] * u1[j] + b[1][i] * u2[j] + b[2][i] * a[2][j] for j in range(3)] for i in range(3)]
    return P, after, abs(p * t) * sech


def exact_for_doubles(J, L):
    """Whether alpha = beta in doubles."""
    alpha = abs(L[2]) * math.sqrt((J[2] - J[1]) / J[2])
    beta = abs(L[0]) * math.sqrt((J[1] - J[0]) / J[0])
    return alpha == beta


def tops(max_moment):
    """(J, L) with ascending moments of a mass distribution."""
    for low in range(1, max_moment + 1):
        for middle in range(low + 1, max_moment + 1):
            for high in range(middle + 1, min(max_moment, low + middle) + 1):
                above, below = high * (middle - low), low * (high - middle)
                common = math.gcd(above, below)
                Lz, Lx = math.isqrt(above // common), math.isqrt(below // common)
                if Lz * Lz * common == above and Lx * Lx * common == below:
                    yield [low, middle, high], [Lx, 1, Lz]


def rows(count):
    yield [12.0, 15.0, 20.0], [1.0, 1.0, 1.0], 25000.0
    found = [top for top in tops(120) if exact_for_doubles(*top)]
    while count > 1:
        J, L = random.choice(found)
        scale = random.choice((1, 0.5, 3, 7))
        L = [float(random.choice((-1, 1)) * L[0] * scale), random.choice((0.0, 0.25, -1.0, 2.0, -6.0, 40.0)) * scale,
             float(random.choice((-1, 1)) * L[2] * scale)]
        if not exact_for_doubles(J, L):
            continue
        order = random.sample(range(3), 3)
        J, L = [float(J[k]) for k in order], [L[k] for k in order]
        speed = max(abs(l / j) for j, l in zip(J, L))
        yield J, L, random.choice((-1, 1)) * float(f"{10 ** random.uniform(-2, 5) / speed:.6g}")
        count -= 1


def check(J, L, t):
    """Difference to the Taylor series; L runs from the separatrix by exp(p t) times its rounding."""
    found, other = motion(J, L, t), taylor(J, L, t)
    return max(distance(found, other, sqrt(sum(l * l for l in L))))


def main():
    names = "class,I1,I2,I3,L1,L2,L3,t," + ",".join(f"P{i}{j}" for i in "123" for j in "123")
    print(names + ",qw,qx,qy,qz,Lf1,Lf2,Lf3,max_abs_omega_t,tolP,tolL")
    worst = mpf(0)
    for J, L, t in rows(320):
        Jm, Lm, tm = [mpf(c) for c in J], [mpf(c) for c in L], mpf(t)
        P, l, change = motion(Jm, Lm, tm)
        angle = max(sqrt(sum((c / j) ** 2 for j, c in zip(Jm, v))) for v in (Lm, l)) * abs(tm)
        if angle <= 12:
            worst = max(worst, check(Jm, Lm, tm))
        numbers = [f"{c:.17g}" for c in J + L + [t]]
        numbers += [mp.nstr(c, 18) for r in P for c in r] + [mp.nstr(c, 18) for c in quaternion(P) + l]
        numbers += [mp.nstr(c, 3) for c in (angle, 16 * EPS * (1 + 3 * angle), 16 * EPS * (1 + 3 * change))]
        print("exact_separatrix," + ",".join(numbers))
    mp.dps = 90
    far = check([mpf(c) for c in (20, 12, 15)], [mpf(c) for c in (-1, 1, 1)], mpf(500))
    print(f"largest difference to the Taylor series: {mp.nstr(worst, 3)}, far out: {mp.nstr(far, 3)}", file=sys.stderr)


if __name__ == "__main__":
    main()
