# SPDX-License-Identifier: MIT
"""One run of OpenMM for the study of other programs: SETTINGS.json CONFIGURATION.gro RESULT.npz.

It is a program of its own, because OpenMM may need another Python."""

import json
import sys

import numpy as np


def configuration(path):
    """Positions [nm], velocities [nm/ps] and box edge [nm] of a GRO file of polhode."""
    lines = open(path, encoding="utf-8").read().splitlines()
    rows = [[float(line[20 + 15 * k:35 + 15 * k]) for k in range(6)] for line in lines[2:2 + int(lines[1])]]
    data = np.array(rows)
    return data[:, :3], data[:, 3:], np.array([float(x) for x in lines[2 + len(rows)].split()[:3]])


def system_of(mm, given, box):
    system, force = mm.System(), mm.NonbondedForce()
    system.setDefaultPeriodicBoxVectors(*np.diag(box))
    force.setNonbondedMethod(mm.NonbondedForce.CutoffPeriodic)
    force.setCutoffDistance(given["cutoff"])
    force.setUseSwitchingFunction(True)
    force.setSwitchingDistance(given["switch"])
    force.setReactionFieldDielectric(1e12)
    force.setUseDispersionCorrection(False)
    return system, force


def add_molecules(system, force, given, positions):
    lengths = [float(np.linalg.norm(positions[a] - positions[b])) for a, b in ((0, 1), (0, 2), (1, 2))]
    for first in range(0, len(positions), 3):
        for mass, (charge, sigma, epsilon) in zip(given["masses"], given["site"]):
            system.addParticle(mass)
            force.addParticle(charge, sigma or 1.0, epsilon)
        for (a, b), length in zip(((0, 1), (0, 2), (1, 2)), lengths):
            system.addConstraint(first + a, first + b, length)
            force.addException(first + a, first + b, 0, 1, 0)
    system.addForce(force)


def split(velocities, masses):
    """Kinetic energies of translation and of rotation [kJ/mol] of velocities [nm/ps] of all atoms of three-site molecules."""
    m = np.asarray(masses)[None, :, None]
    v = np.asarray(velocities, dtype=float).reshape(-1, 3, 3)
    centre = (m * v).sum(axis=1) / m.sum()
    translation = 0.5 * m.sum() * (centre**2).sum()
    return translation, 0.5 * (m * v**2).sum() - translation


def kicked(positions, velocities, forces, masses, time, box):
    """Velocities after the forces acted for this time and rigid bodies took the result up: momentum and angular momentum are kept."""
    m = np.asarray(masses)[None, :, None]
    v = np.asarray(velocities, dtype=float).reshape(-1, 3, 3) + time * np.asarray(forces, dtype=float).reshape(-1, 3, 3) / m
    x = np.asarray(positions, dtype=float).reshape(-1, 3, 3)
    x = x - box * np.round((x - x[:, :1]) / box)
    d = x - (m * x).sum(axis=1, keepdims=True) / m.sum()
    centre = (m * v).sum(axis=1, keepdims=True) / m.sum()
    angular = (m * np.cross(d, v)).sum(axis=1)
    inertia = (m[..., None] * ((d**2).sum(axis=2)[..., None, None] * np.eye(3) - d[..., :, None] * d[..., None, :])).sum(axis=1)
    rotation = np.linalg.solve(inertia, angular[..., None])[..., 0]
    return (centre + np.cross(rotation[:, None], d)).reshape(-1, 3)


def main():
    import openmm as mm  # only here: the study itself uses the functions above
    given = json.load(open(sys.argv[1], encoding="utf-8"))
    positions, velocities, box = configuration(sys.argv[2])
    system, force = system_of(mm, given, box)
    add_molecules(system, force, given, positions)
    if given["barostat"]:
        barostat = mm.MonteCarloBarostat(1.0, given["temperature"], 25)  # 1 bar
        barostat.setRandomNumberSeed(1)
        system.addForce(barostat)
    h = given["step"] / 1000
    verlet = given["integrator"] == "Verlet"
    integrator = mm.VerletIntegrator(h) if verlet else mm.LangevinMiddleIntegrator(given["temperature"], 1.0, h)
    integrator.setConstraintTolerance(1e-8)
    if not verlet:
        integrator.setRandomNumberSeed(1)
    context = mm.Context(system, integrator, mm.Platform.getPlatformByName("CPU"), {"Threads": "1"})
    context.setPositions(positions)
    forces = context.getState(forces=True).getForces(asNumpy=True)._value
    # Verlet of OpenMM has velocities of the half step before the positions.
    context.setVelocities(kicked(positions, velocities, forces, given["masses"], -h / 2, box))
    rows = []
    for k in range(given["steps"] // given["every"] + 1):
        if k:
            integrator.step(given["every"])
        state = context.getState(energy=True, positions=True, velocities=True, forces=True)
        box = np.diag(state.getPeriodicBoxVectors(asNumpy=True)._value)
        x, v, f = (of(asNumpy=True)._value for of in (state.getPositions, state.getVelocities, state.getForces))
        full = split(kicked(x, v, f, given["masses"], h / 2, box), given["masses"])
        rows.append((k * given["every"] * h, state.getPotentialEnergy()._value, *full, *split(v, given["masses"]), box.prod()))
    names = ("time", "potential", "translation", "rotation", "translation_half", "rotation_half", "volume")
    np.savez(sys.argv[3], version=mm.version.full_version, **dict(zip(names, np.array(rows).T)))


if __name__ == "__main__":
    main()
