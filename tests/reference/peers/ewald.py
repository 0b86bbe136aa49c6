#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ewald sums of rigid molecules by other engines: energies, forces and torques, and molecular virials.

    python3 -m pip install numpy openmm        # OpenMM 8; and LAMMPS with KSPACE, as the program lmp
    python3 tests/reference/peers/ewald.py [case ...]

Run by hand, never by the tests. It writes one JSON file for each case to its own folder and prints how well
the engines agree; README.md describes the files. Units: nm, u, e, kJ/mol.
"""
import subprocess
import sys
import tempfile
from itertools import combinations
from math import sqrt
from pathlib import Path

import numpy as np
import openmm as mm

from engines import (LENNARD_JONES, SITE_MIXING, exclude_within_bodies, openmm_coulomb, openmm_run,
                     switch_text)
from files import bodies, of_file, off, provenance, rounded, write
from scenes import COULOMB, Scene, liquid

TOLERANCE = 1e-12  # of OpenMM's Ewald sum


def site_switch(switch_from, cutoff, smoothness):
    return {"truncation": "site_switch", "electrostatics": "ewald", "switch_from": switch_from,
            "cutoff": cutoff, "smoothness": smoothness}


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
    "ewald-na-spce": (lambda: liquid({"spce": 60, "na-spce": 4}, [1.25, 1.3, 1.28], 14, 150),
                      site_switch(0.45, 0.6, 2)),  # charged, within a uniform background
}

# ---- OpenMM ------------------------------------------------------------------------------------


def openmm_ewald(scene, law, cutoff=None):
    """Energies of both terms, forces on sites. The cutoff is that of the charges and arbitrary: no result
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


def openmm_charges_alone(scene, law):
    """Electrostatic forces on sites."""
    bare = Scene(scene.counts, list(scene.box), [scene.sites])
    bare.epsilon = np.zeros_like(scene.epsilon)
    return openmm_ewald(bare, law)[1]


def strained(scene, factor):
    """Box and centres scaled along the axes, molecules unchanged."""
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
    """Lennard-Jones outside the truncation at a uniform density of sites: the engine's own correction,
    computed for each pair of kinds of sites with two sites outside the cutoff, which then represent four pairs
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


# ---- LAMMPS ------------------------------------------------------------------------------------


def lammps_ewald(scene, law):
    """Coulomb energy, forces and torques on bodies, and the molecular virial as a full tensor: the
    engine's own virial of sites minus the part that rotates and stretches molecules. Its erfc is a polynomial
    of seven digits."""
    scale = sqrt(COULOMB)  # the engine's own constant is 1 in the unit system "lj"
    charges = {q: i + 1 for i, q in enumerate(dict.fromkeys(scene.q.tolist()))}
    rows = [f"{i + 1} {scene.body[i] + 1} {charges[scene.q[i]]} {scale * scene.q[i]:.17g} "
            + " ".join(f"{x:.17g}" for x in r) for i, r in enumerate(scene.sites)]
    # Bonds without a force, from the first site to all others: so a body has no pairs of its own.
    bonds = [f"1 {p.start + 1} {k + 1}" for p in scene.parts for k in range(p.start + 1, p.stop)]
    bounds = [f"0 {edge:.17g} {x}lo {x}hi" for edge, x in zip(scene.box, "xyz")]
    data = ["rigid bodies", "", f"{len(rows)} atoms", f"{len(charges)} atom types",
            f"{len(bonds)} bonds", "1 bond types", *bounds, "", "Masses", "",
            *(f"{k} 1" for k in charges.values()), "", "Atoms # full", "", *rows, "", "Bonds", "",
            *(f"{i + 1} {bond}" for i, bond in enumerate(bonds)), ""]
    script = [
        "units lj", "atom_style full", "boundary p p p", "neighbor 0.02 bin", "bond_style zero",
        "special_bonds lj/coul 0 0 0", "read_data data extra/special/per/atom 20", "bond_coeff *",
        f"pair_style coul/long {law['cutoff']!r}", "pair_coeff * *", "pair_modify table 0",
        "kspace_style ewald 1e-12", "compute w all pressure NULL virial",
        "thermo_style custom step ecoul elong c_w[1] c_w[2] c_w[3] c_w[4] c_w[5] c_w[6]",
        "thermo_modify norm no format float %.15g",
        "dump d all custom 1 out id x y z fx fy fz", "dump_modify d sort id format float %.15g", "run 0"]
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "data").write_text("\n".join(data))
        (Path(folder) / "in").write_text("\n".join(script) + "\n")
        log = subprocess.run(["lmp", "-in", "in", "-log", "none"], cwd=folder, check=True,
                             capture_output=True, text=True).stdout.splitlines()
        dump = (Path(folder) / "out").read_text().splitlines()[9:]
    version = log[0].strip().removeprefix("LAMMPS (").removesuffix(")")
    values = [float(v) for v in next(b for a, b in zip(log, log[1:]) if a.startswith("Step")).split()]
    xx, yy, zz, xy, xz, yz = values[3:]
    f = np.array([line.split()[4:] for line in dump], float)
    # Centres may have been wrapped; arms are those of the scene.
    arms = scene.sites - scene.centres()[scene.body]
    virial = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) * scene.box.prod() - arms.T @ f
    return version, values[1] + values[2], scene.loads(f), virial


# ---- Files -------------------------------------------------------------------------------------


def run(name):
    source, law = CASES[name]
    scene = of_file(source) if isinstance(source, str) else source()
    energies, f = openmm_ewald(scene, law)
    force, torque = scene.loads(f)
    electric_forces = openmm_charges_alone(scene, law)
    on_charges = electric_forces[scene.q != 0]
    electric = float(np.sqrt((on_charges**2).sum(axis=1).mean()))
    again, g = openmm_ewald(scene, law, 0.9 * law["cutoff"])  # another width of the Gaussians
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
    version, energy, loads, tensor = lammps_ewald(scene, law)
    lj_force, lj_torque = scene.loads(f - electric_forces)
    beside = tensor.diagonal() - virial[1]
    if abs(scene.q.sum()) > 1e-6:  # the engine's virial omits the background, which is the same on all axes
        beside -= beside.mean()
    result["lammps"] = {
        "engine": f"LAMMPS {version}, coul/long and Ewald", "coulomb": energy,
        "virial": rounded(tensor, 8),  # of charges
        "from_openmm": {"energy": energy - energies[1], "force": off(force, lj_force + loads[0]),
                        "torque": off(torque, lj_torque + loads[1]),
                        "virial": float(np.abs(beside).max())}}
    if law["smoothness"] == 2:
        result["dispersion"] = openmm_tail(scene, law)
    print(f"| {name} | {energies[0]:.10g} | {energies[1]:.10g} | {electric:.4g} | "
          + " / ".join(f"{v:.1e}" for v in (*result["other_width"].values(),
                                            *result["other_step"].values(),
                                            *result["lammps"]["from_openmm"].values())) + " |", flush=True)
    write(name, provenance("ewald", name, {"OpenMM": openmm_coulomb()})
          | ({"scene": source} if isinstance(source, str) else bodies(scene)) | {"results": [result]})


if __name__ == "__main__":
    for case in sys.argv[1:] or CASES:
        run(case)
