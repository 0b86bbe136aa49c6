#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Free rotor rows in addition to the truth table: random tops of every class, 60 digits or more.

    python3 make_rows.py > random_rows.csv        (mpmath; minutes; the seed is fixed)

The motion is the textbook closed form: Jacobi's functions with u0 by an incomplete integral of the
first kind and the angle by Legendre's Pi, all by mpmath. It shares no formula with the program
except the Euler equations (there: addition theorems, Carlson's R_J, a power series). Rows with |omega t| <= 12
are checked against a Taylor series of the Euler equations and q' = q (0, omega)/2.

Tolerances as in README.md: 16 * 2^-53 * (1 + k), with k the change of the result in units of 2^-53 when
each of the seven inputs changes by a relative 2^-53, summed, by finite difference of the truth.
"""
import random
import sys
from mpmath import mp, mpf, sqrt, atan2, asin, cos, sin, floor, nint, matrix, ellipfun, ellipf, ellippi, ellipk, pi

mp.dps = 70
random.seed(20080213)
EPS = mpf(2) ** -53


def frame(L, z):
    """c1, c2, c3 with c3 = L/|L| and c1 = c3 x e_z, normalised."""
    n = sqrt(sum(c * c for c in L))
    c3 = [c / n for c in L]
    x, y = (z + 1) % 3, (z + 2) % 3
    c1 = [mpf(0)] * 3
    r = sqrt(c3[x] ** 2 + c3[y] ** 2)
    c1[x], c1[y] = c3[y] / r, -c3[x] / r
    c2 = [c3[1] * c1[2] - c3[2] * c1[1], c3[2] * c1[0] - c3[0] * c1[2], c3[0] * c1[1] - c3[1] * c1[0]]
    return c1, c2, c3


def about_L(J, L, w, t):
    """Rotation by |w| t about w, passive (Rodrigues), for a body with constant L."""
    n = sqrt(sum(c * c for c in w))
    if n == 0:
        return [[mpf(i == j) for j in range(3)] for i in range(3)], list(L)
    a, e = n * t, [c / n for c in w]
    c, s = cos(a), sin(a)
    cross = [[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]]
    P = [[c * (i == j) + (1 - c) * e[i] * e[j] - s * cross[i][j] for j in range(3)] for i in range(3)]
    return P, [sum(P[i][j] * L[j] for j in range(3)) for i in range(3)]


def motion(J, L, t):
    """P(t) and L(t)."""
    if any(j == 0 for j in J):
        return about_L(J, L, [l / j if j else mpf(0) for j, l in zip(J, L)], t)
    w = [l / j for j, l in zip(J, L)]
    if all(L[i] * L[j] * (J[i] - J[j]) == 0 for i in range(3) for j in range(i)):
        return about_L(J, L, w, t)
    lo, y, hi = sorted(range(3), key=lambda k: J[k])
    L2 = sum(l * l for l in L)
    E2 = sum(l * l / j for j, l in zip(J, L))
    D = L[hi] ** 2 * (J[hi] - J[y]) / J[hi] - L[lo] ** 2 * (J[y] - J[lo]) / J[lo]
    x, z = (lo, hi) if D >= 0 else (hi, lo)
    odd = (x + 1) % 3 != y
    Jx, Jy, Jz = J[x], J[y], J[z]
    Lx, Ly, Lz = L[x], L[y], L[z]
    if odd:
        Lx = -Lx
    Wz = Lx ** 2 * (Jz - Jx) / Jx + Ly ** 2 * (Jz - Jy) / Jy
    Wx = Ly ** 2 * (Jx - Jy) / Jy + Lz ** 2 * (Jx - Jz) / Jz
    Ax, Ay, Az = sqrt(Jx * Wz / (Jz - Jx)), sqrt(Jy * Wz / (Jz - Jy)), sqrt(-Jz * Wx / (Jz - Jx))
    p = sqrt(-(Jz - Jy) * Wx / (Jx * Jy * Jz))
    m = -(Jy - Jx) * Wz / ((Jz - Jy) * Wx)
    g = 1 if Lz > 0 else -1
    s = g * (1 if Jz > Jx else -1)
    N = (Jy - Jx) * Jz / ((Jz - Jy) * Jx)
    n = sqrt(L2)
    c = n * (Jz - Jx) / (Jx * Jz * p)
    am0 = atan2(Ly / Ay, Lx / (s * Ax))
    K = ellipk(m)
    u = ellipf(am0, m) + p * t
    turns = nint(u / (2 * K))
    rest = u - 2 * K * turns
    sn, cn, dn = (ellipfun(f, rest, m=m) for f in ("sn", "cn", "dn"))
    am = asin(sn) + pi * turns
    sign = 1 if turns % 2 == 0 else -1
    phi = n / Jz * t + c * (ellippi(-N, am, m) - ellippi(-N, am0, m))
    after = [mpf(0)] * 3
    after[x], after[y], after[z] = s * Ax * cn * sign, Ay * sn * sign, g * Az * dn
    if odd:
        after[x] = -after[x]
    a, b = frame(L, z), frame(after, z)
    co, si = cos(phi), sin(phi)
    u1 = [co * a[0][i] + si * a[1][i] for i in range(3)]
    u2 = [-si * a[0][i] + co * a[1][i] for i in range(3)]
    P = [[b[0][i] * u1[j] + b[1][i] * u2[j] + b[2][i] * a[2][j] for j in range(3)] for i in range(3)]
    return P, after


def taylor(J, L, t, order=50):
    """The same by Taylor steps of the equations of motion."""
    w0 = sqrt(sum((l / j) ** 2 for j, l in zip(J, L)))
    steps = int(floor(abs(w0 * t) * 12)) + 1
    h = t / steps
    q, l = [mpf(1), mpf(0), mpf(0), mpf(0)], list(L)
    for _ in range(steps):
        qs, ls = [q], [l]
        for n in range(order):
            dl, dq = [mpf(0)] * 3, [mpf(0)] * 4
            for k in range(n + 1):
                w = [a / j for a, j in zip(ls[n - k], J)]
                b, r = ls[k], qs[k]
                dl[0] += b[1] * w[2] - b[2] * w[1]
                dl[1] += b[2] * w[0] - b[0] * w[2]
                dl[2] += b[0] * w[1] - b[1] * w[0]
                dq[0] += -r[1] * w[0] - r[2] * w[1] - r[3] * w[2]
                dq[1] += r[0] * w[0] + r[2] * w[2] - r[3] * w[1]
                dq[2] += r[0] * w[1] - r[1] * w[2] + r[3] * w[0]
                dq[3] += r[0] * w[2] + r[1] * w[1] - r[2] * w[0]
            ls.append([c * h / (n + 1) for c in dl])
            qs.append([c * h / (2 * (n + 1)) for c in dq])
        l = [sum(c[i] for c in ls) for i in range(3)]
        q = [sum(c[i] for c in qs) for i in range(4)]
    a, x, y, z = q
    S = [[a*a + x*x - y*y - z*z, 2*(x*y + a*z), 2*(x*z - a*y)],
         [2*(x*y - a*z), a*a - x*x + y*y - z*z, 2*(y*z + a*x)],
         [2*(x*z + a*y), 2*(y*z - a*x), a*a - x*x - y*y + z*z]]
    return S, l


def quaternion(P):
    """w >= 0, active matrix P^T."""
    tr = P[0][0] + P[1][1] + P[2][2]
    q2 = [(1 + tr) / 4] + [(1 + 2 * P[i][i] - tr) / 4 for i in range(3)]
    k = max(range(4), key=lambda i: q2[i])
    r = sqrt(q2[k])
    v = [P[1][2] - P[2][1], P[2][0] - P[0][2], P[0][1] - P[1][0]]
    if k == 0:
        q = [r] + [c / (4 * r) for c in v]
    else:
        i = k - 1
        q = [v[i] / (4 * r)] + [(P[i][j] + P[j][i]) / (4 * r) if j != i else r for j in range(3)]
    return [-c for c in q] if q[0] < 0 else q


def distance(a, b, scale):
    P = max(abs(a[0][i][j] - b[0][i][j]) for i in range(3) for j in range(3))
    l = max(abs(a[1][i] - b[1][i]) for i in range(3)) / scale if scale else mpf(0)
    return P, l


def u(a, b):
    return random.uniform(a, b)


def direction():
    v = [random.gauss(0, 1) for _ in range(3)]
    n = sum(c * c for c in v) ** 0.5
    return [c / n for c in v]


def body():
    """Moments of a random mass distribution, any order."""
    a = [10 ** u(-1, 0) for _ in range(3)]
    return [a[1] + a[2], a[2] + a[0], a[0] + a[1]]


def rows():
    def row(name, J, L, angle):
        w = max(abs(l / j) for j, l in zip(J, L) if j) if any(L) else 1.0
        return name, J, L, angle / w

    for scale in (1e-10, 1e-3, 0.1, 0.3, 0.31, 1, 10, 100, 1e3, 1e4):
        for _ in range(3):
            J = body()
            yield row("asym", J, direction(), scale * u(0.7, 1) * random.choice((-1, 1)))
    for delta in (1e-2, 1e-5, 1e-8, 1e-11, 1e-14):
        for angle in (0.2, 3, 30, 500):
            J = [1.0, 1 + delta, u(0.3, 1.9)]
            random.shuffle(J)
            yield row("nearsym", J, direction(), angle)
        J = [1.0, 1 + delta, 1.6]
        yield row("nearsym_equator", J, [0.6, 0.8, delta ** 0.5 * u(0.5, 2)], u(1, 200))
        J = [1 + delta, 0.4, 1.0]
        yield row("nearsym_equator", J, [0.6, delta ** 0.5 * u(0.5, 2), 0.8], u(1, 200))
        J = [1.0, 1 + delta, 1 + 2.5 * delta]
        yield row("nearspherical", J, direction(), u(1, 1000))
    for delta in (1e-2, 1e-4, 1e-6, 1e-9, 1e-13):
        for sign in (1, -1):
            J = sorted(body())
            # L_z^2 (Jz-Jy)/Jz = L_x^2 (Jy-Jx)/Jx (1 + delta)
            Ly = u(-1, 1)
            Lx = 1.0
            Lz = (J[2] / (J[2] - J[1]) * (J[1] - J[0]) / J[0] * (1 + sign * delta)) ** 0.5
            order = random.sample(range(3), 3)
            L = [Lx, Ly, Lz]
            yield row("separatrix", [J[k] for k in order], [L[k] for k in order], u(1, 40))
    for delta in (1e-3, 1e-7, 1e-12, 1e-40, 1e-170):
        for k in range(3):
            J = body()
            L = [delta * u(-1, 1) for _ in range(3)]
            L[k] = random.choice((-1, 1)) * 1.0
            yield row("nearaxis", J, L, u(1, 60))
    for _ in range(6):
        j, k = u(0.3, 1.9), random.randrange(3)
        J = [1.0] * 3
        J[k] = j
        yield row("symmetric", J, direction(), 10 ** u(-2, 3))
    for k in range(3):
        J, L = [0.7] * 3, direction()
        J[k] = L[k] = 0.0
        yield row("linear", J, L, 10 ** u(-1, 3))
        yield row("spherical", [0.7] * 3, direction(), 10 ** u(-1, 3))
    for power in (-100, -30, 30, 100):
        J, L = body(), direction()
        name, J, L, t = row("scaled", J, L, u(0.1, 20))
        yield name, [c * 10.0 ** power for c in J], [c * 10.0 ** -power for c in L], t * 10.0 ** (2 * power)
    for small in (1e-3, 1e-6):
        J = [small, 1.0, 1.0 + 0.5 * small]
        w = direction()
        random.shuffle(J)
        yield row("needle", J, [j * c for j, c in zip(J, w)], u(0.1, 30))
        J = [small, 1.0, 1.0 + small]
        yield row("flat", J, [j * c for j, c in zip(J, direction())], u(0.1, 30))


def main():
    names = "class,I1,I2,I3,L1,L2,L3,t," + ",".join(f"P{i}{j}" for i in "123" for j in "123")
    print(names + ",qw,qx,qy,qz,Lf1,Lf2,Lf3,max_abs_omega_t,kP_rel,kL_rel,tolP,tolL")
    worst = mpf(0)
    for name, J, L, t in rows():
        mp.dps = 420 if "nearaxis" in name else 70
        Jm, Lm, tm = [mpf(c) for c in J], [mpf(c) for c in L], mpf(t)
        norm = sqrt(sum(c * c for c in Lm))
        truth = motion(Jm, Lm, tm)
        angle = max(abs(l / j * tm) for j, l in zip(Jm, Lm) if j)
        if angle <= 12 and 0 not in J and mp.dps == 70:
            other = taylor(Jm, Lm, tm)
            worst = max(worst, *distance(truth, other, norm))
        kP = kL = mpf(0)
        step = mpf(10) ** (-mp.dps // 3) if "separatrix" not in name else EPS
        step = min(step, EPS)
        for i in range(7):
            changed = Jm + Lm + [tm]
            changed[i] *= 1 + step
            if name == "linear" and i < 3:  # stays linear: both moments change
                changed[:3] = [c * (1 + step) for c in Jm]
            if name in ("symmetric", "spherical") and i < 3 and step < EPS:
                changed[i] = Jm[i] * (1 + EPS)
                dP, dL = distance(motion(changed[:3], changed[3:6], changed[6]), truth, norm)
                kP, kL = kP + dP / EPS, kL + dL / EPS
                continue
            dP, dL = distance(motion(changed[:3], changed[3:6], changed[6]), truth, norm)
            kP, kL = kP + dP / step, kL + dL / step
        numbers = [f"{c:.17g}" for c in J + L + [t]]
        P, l = truth
        numbers += [mp.nstr(c, 21) for r in P for c in r] + [mp.nstr(c, 21) for c in quaternion(P) + l]
        numbers += [mp.nstr(c, 3) for c in (angle, kP, kL)]
        numbers += [mp.nstr(16 * EPS * (1 + k), 3) for k in (kP, kL)]
        print(name + "," + ",".join(numbers))
        sys.stdout.flush()
    print(f"largest difference to the Taylor series: {mp.nstr(worst, 3)}", file=sys.stderr)


if __name__ == "__main__":
    main()
