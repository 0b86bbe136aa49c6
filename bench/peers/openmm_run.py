# SPDX-License-Identifier: MIT
"""Rigid TIP4P water in OpenMM, on its CPU platform: run by peers.py in the Python that has OpenMM.

Its only argument is a job as JSON; the last line printed is the report."""

import json
import sys
import time
from pathlib import Path

import openmm as mm

import gro

MASSES, CHARGES = (15.9994, 1.008, 1.008, 0.0), (0.0, 0.52, 0.52, -1.04)
SIGMA, EPSILON = 0.315365, 0.64852  # of the oxygen [nm, kJ/mol]
OH, HH, M = 0.09572, 0.15139006545, 0.12801206487  # distances [nm]; weight of a hydrogen in M
WARMUP = 50  # steps before the clock starts


def water(start, order):
    """The OpenMM system: rigid bodies as three constraints, M as a virtual site."""
    system, force = mm.System(), mm.NonbondedForce()
    a, b, c = start.box
    system.setDefaultPeriodicBoxVectors(mm.Vec3(a, 0, 0), mm.Vec3(0, b, 0), mm.Vec3(0, 0, c))
    for first in range(0, len(start.labels), gro.SITES):
        for mass, charge, epsilon in zip(MASSES, CHARGES, (EPSILON, 0, 0, 0)):
            system.addParticle(mass)
            force.addParticle(charge, SIGMA, epsilon)
        o, h1, h2, m = range(first, first + gro.SITES)
        for i, j, length in ((o, h1, OH), (o, h2, OH), (h1, h2, HH)):
            system.addConstraint(i, j, length)
        system.setVirtualSite(m, mm.ThreeParticleAverageSite(o, h1, h2, 1 - 2 * M, M, M))
        for i in range(first, first + gro.SITES):
            for j in range(first, i):
                force.addException(i, j, 0, 1, 0)
    force.setNonbondedMethod(force.PME if order["law"] == "PME" else force.CutoffPeriodic)
    force.setCutoffDistance(order["cutoff"])
    force.setReactionFieldDielectric(1e12)
    force.setUseSwitchingFunction(True)
    force.setSwitchingDistance(order["switch"])
    force.setUseDispersionCorrection(False)
    system.addForce(force)
    return system


def main():
    order = json.loads(sys.argv[1])
    start = gro.read(Path(order["start"]).read_text())
    integrator = mm.VerletIntegrator(order["step_fs"] / 1000)
    integrator.setConstraintTolerance(1e-6)
    context = mm.Context(water(start, order), integrator, mm.Platform.getPlatformByName("CPU"),
                         {"Threads": str(order["threads"])})
    context.setPositions([mm.Vec3(*r) for r in start.positions])
    # The velocities of this OpenMM integrator lag the positions by half a time step.
    pull = context.getState(getForces=True).getForces()._value
    back = [order["step_fs"] / 2000 / MASSES[i % gro.SITES] if MASSES[i % gro.SITES] else 0.0
            for i in range(len(start.labels))]
    context.setVelocities([mm.Vec3(*v) - f * b for v, f, b in zip(start.velocities, pull, back)])
    context.applyVelocityConstraints(1e-6)
    degrees_of_freedom = 6 * start.molecules - 3
    samples, step_us = [], None

    def sample():
        state = context.getState(getEnergy=True)
        kinetic, potential = (e._value for e in (state.getKineticEnergy(), state.getPotentialEnergy()))
        samples.append((kinetic + potential, potential, 2 * kinetic / degrees_of_freedom / 0.00831446261815324))

    if order["every"] == 0:
        integrator.step(WARMUP)
        context.getState(getEnergy=True)
        begin = time.perf_counter()
        integrator.step(order["steps"])
        context.getState(getPositions=True)
        step_us = 1e6 * (time.perf_counter() - begin) / order["steps"]
    else:
        sample()
        for _ in range(order["steps"] // order["every"]):
            integrator.step(order["every"])
            sample()
    print(json.dumps({"samples": samples, "step_us": step_us}))


if __name__ == "__main__":
    main()
