# SPDX-License-Identifier: MIT
"""The interactions, models and configurations given to the engines."""
import tomllib
from math import inf, pi, prod
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
E, AVOGADRO, EPS0 = 1.602176634e-19, 6.02214076e23, 8.8541878128e-12  # CODATA 2018
COULOMB = E * E * AVOGADRO / (4 * pi * EPS0) * 1e6  # kJ/mol nm/e²
THERMAL = 1.380649e-26 * AVOGADRO * 298.15  # kJ/mol, for making configurations only

# The switching function decreases from 1 to 0 while x = (r - from)/(cutoff - from) runs from 0 to 1.
SWITCH = {1: "1-3*x^2+2*x^3", 2: "1-10*x^3+15*x^4-6*x^5", 3: "1-35*x^4+84*x^5-70*x^6+20*x^7"}


def molecule_switch(switch_from, cutoff, smoothness):
    return {"truncation": "molecule_switch", "switch_from": switch_from, "cutoff": cutoff,
            "smoothness": smoothness}


def reaction_field(switch_from, cutoff, smoothness, dielectric):
    return molecule_switch(switch_from, cutoff, smoothness) | {
        "truncation": "reaction_field", "dielectric": dielectric}


NO_TRUNCATION = {"truncation": "none"}


def reaction_field_constants(law):
    """k_rf and c_rf of K q q (1/r + k_rf r² - c_rf)."""
    d, rc = law["dielectric"], law["cutoff"]
    k = (0.5 if d == inf else (d - 1) / (2 * d + 1)) / rc**3
    return k, 1 / rc + k * rc**2


# ---- molecules, scenes -------------------------------------------------------------------------


class Model:
    """A molecule file: sites relative to the centre of mass."""

    def __init__(self, name):
        data = tomllib.loads((ROOT / f"data/molecules/{name}.toml").read_text(encoding="utf-8"))
        sites = data["site"]
        number = lambda s, key: float(s.get(key, "0").split()[0])
        self.name, self.names = name, [s["name"] for s in sites]
        self.m, self.q, self.sigma, self.epsilon = (
            np.array([number(s, key) for s in sites]) for key in ("mass", "charge", "sigma", "epsilon"))
        r = np.array([[float(x) for x in s["position"].split()[:3]] for s in sites])
        self.r = r - self.m @ r / self.m.sum()


def rotation(q):
    """The matrix of a quaternion (w, x, y, z), normalised here: body to lab."""
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


class Scene:
    """Rigid bodies in a box (None: open space); sites in the order of the bodies."""

    def __init__(self, counts, box, blocks=None):
        self.counts, self.box = counts, box and np.array(box)
        models = {name: Model(name) for name in counts}
        self.models = [models[name] for name, n in counts.items() for _ in range(n)]
        ends = np.cumsum([len(m.q) for m in self.models])
        self.parts = [slice(e - len(m.q), e) for e, m in zip(ends, self.models)]
        self.body = np.repeat(np.arange(len(self.models)), [len(m.q) for m in self.models])
        join = lambda key: np.concatenate([getattr(m, key) for m in self.models])
        self.m, self.q, self.sigma, self.epsilon = map(join, ("m", "q", "sigma", "epsilon"))
        if blocks is not None:
            self.sites = np.concatenate(blocks)

    def centres(self):
        return np.array([m.m @ self.sites[p] / m.m.sum() for m, p in zip(self.models, self.parts)])

    def image(self, d):
        """The nearest image of vectors d."""
        return d if self.box is None else d - self.box * np.round(d / self.box)

    def loads(self, f):
        """Force and torque about the centre of mass on every body, from the forces on its sites."""
        c = self.centres()
        return (np.array([f[p].sum(axis=0) for p in self.parts]),
                np.array([np.cross(self.sites[p] - c[i], f[p]).sum(axis=0)
                          for i, p in enumerate(self.parts)]))


def liquid(counts, box, seed, sweeps, radius=None):
    """A plausible disordered configuration: lattice, random orientations, then simple Metropolis moves.

    With a radius the bodies stay within it, in open space."""
    rng = np.random.default_rng(seed)
    scene = Scene(counts, box)
    n = len(scene.models)
    edges = np.array(box or [1.6 * radius] * 3)
    cells = np.ones(3, int)
    while prod(cells) < n:
        cells[np.argmax(edges / cells)] += 1
    points = np.array([(i, j, k) for i in range(cells[0]) for j in range(cells[1])
                       for k in range(cells[2])])
    points = points[rng.permutation(len(points))[:n]]
    q = (points + 0.5) / cells * edges - (0 if box else edges / 2)
    orientation = rng.normal(size=(n, 4))
    place = lambda i, c, a: c + scene.models[i].r @ rotation(a).T
    scene.sites = np.concatenate([place(i, q[i], orientation[i]) for i in range(n)])

    def energy(i, c, block):
        near = scene.image(q - c)
        shift = (near - (q - c))[scene.body]
        d = np.linalg.norm(scene.sites + shift - block[:, None, :], axis=2)
        other = (scene.body != i) & (np.linalg.norm(near, axis=1) < min(edges) / 2)[scene.body]
        d = np.maximum(d[:, other], 0.03)
        p = scene.parts[i]
        s6 = ((scene.sigma[p, None] + scene.sigma[other]) / 2 / d)**6
        return np.sum(4 * np.sqrt(scene.epsilon[p, None] * scene.epsilon[other]) * (s6**2 - s6)
                      + COULOMB * scene.q[p, None] * scene.q[other] / d)

    for _ in range(sweeps):
        for i in range(n):
            c = q[i] + rng.uniform(-0.03, 0.03, 3)
            a = orientation[i] / np.linalg.norm(orientation[i]) + rng.normal(size=4) * 0.1
            if radius and np.linalg.norm(c) > radius:
                continue
            block = place(i, c, a)
            change = energy(i, c, block) - energy(i, q[i], scene.sites[scene.parts[i]])
            if change < 0 or rng.random() < np.exp(-change / THERMAL):
                q[i], orientation[i] = c, a
                scene.sites[scene.parts[i]] = block
    if box:
        q -= np.floor(q / edges) * edges
        scene.sites = np.concatenate([place(i, q[i], orientation[i]) for i in range(n)])
    return scene


def w512():
    """The bodies of the start configuration, refitted to the exact geometry (least squares by mass)."""
    lines = (ROOT / "tests/reference/w512/W512.gro").read_text(encoding="utf-8").splitlines()
    r = np.array([[float(x) for x in line.split()[3:6]] for line in lines[2:-1]]).reshape(-1, 4, 3)
    box = [float(x) for x in lines[-1].split()]
    model, blocks = Model("tip4p"), []
    for sites in r:
        c = model.m @ sites / model.m.sum()
        u, _, vt = np.linalg.svd((model.m[:, None] * model.r).T @ (sites - c))
        fit = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt  # body to lab, on rows
        blocks.append(c + model.r @ fit)
        assert np.abs(blocks[-1] - sites).max() < 1e-6
    return Scene({"tip4p": len(blocks)}, box, blocks)


# ---- OpenMM ------------------------------------------------------------------------------------
