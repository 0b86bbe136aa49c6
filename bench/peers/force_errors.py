#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Errors of the electrostatic forces of GROMACS and polhode with particle mesh Ewald, in one configuration of 512 TIP4P
waters. The forces of each program are compared with forces of the same program at much more accurate settings, so that
constants of nature and digits of positions do not matter. Errors are root mean squares over the forces on molecules, and
over the torques about their centres of mass. Needs numpy and MDAnalysis."""

import argparse
import io
import json
import tempfile
from pathlib import Path

import engines
import gro
import MDAnalysis
import numpy as np

START = engines.HERE.parents[1] / "data/start/w512.gro"
CUTOFF, SWITCH = 0.9, 0.765  # [nm]
EXACT_GROMACS = {"fourierspacing": 0.04, "pme-order": 10, "ewald-rtol": 1e-8, "rcoulomb": 1.2}
EXACT_POLHODE = ("double", 1e-7)


def of_molecules(positions, forces):
    """Forces [kJ/mol/nm] and torques [kJ/mol] of molecules from those of their atoms."""
    r, f = (x.reshape(-1, gro.SITES, 3) for x in (positions, forces))
    mass = np.array([15.9994, 1.008, 1.008, 0])[:, None]
    arms = r - (mass * r).sum(axis=1, keepdims=True) / mass.sum()
    return f.sum(axis=1), np.cross(arms, f).sum(axis=1)


def gromacs(case, program, **settings):
    """Forces and torques of molecules by GROMACS, with some settings of its run file."""
    case.write("gromacs.top", "gromacs.top")
    case.write("gromacs.mdp", "gromacs.mdp", integrator="md", step_ps=0.001, steps=0, tolerance=-1, list_nm=1.2,
               list_steps=1, coulomb="PME", sample_steps=1)
    mdp = case.folder / "gromacs.mdp"
    changed = {"nstfout": 1, "nstxout": 1, **settings}
    lines = [line for line in mdp.read_text().splitlines() if line.split("=")[0].strip() not in changed]
    mdp.write_text("\n".join(lines + [f"{key} = {value}" for key, value in changed.items()]) + "\n")
    case.run(program, "-nobackup", "grompp", "-f", mdp, "-c", "start.gro", "-p", "gromacs.top", "-o", "gromacs.tpr",
             "-maxwarn", 5)
    case.run(program, "-nobackup", "mdrun", "-deffnm", "gromacs", "-ntmpi", 1, "-ntomp", 1, "-notunepme")
    frame = MDAnalysis.Universe(case.folder / "start.gro", case.folder / "gromacs.trr").trajectory[0]
    unit = 10.0  # MDAnalysis has Å
    return of_molecules(whole(frame.positions / unit, np.array(case.start.box)), frame.forces * unit)


def whole(positions, box):
    """Positions with the atoms of a molecule in the image of its first atom."""
    r = positions.reshape(-1, gro.SITES, 3)
    return r - box * np.round((r - r[:, :1]) / box)


def polhode(case, program, precision, accuracy):
    """Forces and torques of molecules by polhode."""
    file = case.folder / "polhode.toml"
    file.write_text(f"""[system]
molecules = [{{ model = "tip4p", count = {case.molecules} }}]
initial_configuration = "start.gro"
[forces]
electrostatics = "pme"
truncation = "site-switch"
cutoff = "{CUTOFF} nm"
switch = "{SWITCH} nm"
pme_accuracy = {accuracy}
precision = "{precision}"
""", encoding="utf-8")
    rows = np.genfromtxt(io.StringIO(case.run(program, "energy", "--forces", file)), delimiter=",", names=True, comments="#")
    columns = [np.stack([rows[name] for name in rows.dtype.names[k : k + 3]], axis=1) for k in (2, 5)]
    return columns


def rms(vectors):
    return float(np.sqrt((vectors**2).sum(axis=1).mean()))


def main():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("--polhode", default="./polhode")
    p.add_argument("--gmx", default="gmx")
    p.add_argument("--json", type=Path, help="file for the results")
    o = p.parse_args()
    program = Path(o.polhode).resolve()
    results = []
    with tempfile.TemporaryDirectory() as folder:
        case = engines.Case(gro.read(START.read_text()), Path(folder), CUTOFF, SWITCH)

        def add(name, settings, found, exact):
            force, torque = (rms(a - b) for a, b in zip(found, exact))
            results.append({"program": name, "settings": settings, "force_error": force,
                            "relative_force_error": force / rms(exact[0]), "torque_error": torque,
                            "relative_torque_error": torque / rms(exact[1])})
            print(json.dumps(results[-1]))

        exact = {"gromacs": gromacs(case, o.gmx, **EXACT_GROMACS), "polhode": polhode(case, program, *EXACT_POLHODE)}
        for settings in ({}, {"fourierspacing": 0.16}, {"fourierspacing": 0.1}, {"pme-order": 6}):
            add("gromacs", settings, gromacs(case, o.gmx, **settings), exact["gromacs"])
        for accuracy in (1e-4, 2e-4, 3e-4, 5e-4, 7e-4, 1e-3):
            add("polhode", {"precision": "mixed", "pme_accuracy": accuracy}, polhode(case, program, "mixed", accuracy),
                exact["polhode"])
        add("gromacs against polhode", {"gromacs": EXACT_GROMACS, "polhode": EXACT_POLHODE}, exact["gromacs"],
            exact["polhode"])
    if o.json:
        o.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
