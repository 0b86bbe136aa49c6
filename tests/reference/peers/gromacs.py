#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PME for rigid molecules as GROMACS computes it in double precision.

    apt-get install gromacs python3-numpy        # for gmx_d
    python3 tests/reference/peers/gromacs.py [case ...]

Run by hand, never by the tests. Bodies and interactions are those of the files of ewald.py. It writes one JSON
file for each case to its own folder and prints how GROMACS differs from itself with another mesh, and from
OpenMM; README.md describes the files. Units: nm, u, e, kJ/mol.
"""
import re
import subprocess
import sys
import tempfile
from math import sqrt
from pathlib import Path

import numpy as np

from files import of_file, off, provenance, read, rounded, write
from scenes import COULOMB, Scene

CASES = ["tip4p", "mixture", "nacl-spce", "co2", "benzene"]

# Where charges are cut off, of the cutoff; erfc there; spacing of the mesh [nm], order of its splines.
MESH = {"reach": 1.0, "ewald-rtol": 1e-16, "fourierspacing": 0.02, "pme-order": 12}
OTHER_MESH = {"reach": 1.02, "ewald-rtol": 1e-15, "fourierspacing": 0.018, "pme-order": 12}


def parameters(law, mesh):
    """Lennard-Jones with Potential-switch, which is the switching function of smoothness 2."""
    reach = mesh["reach"] * law["cutoff"]
    options = {"integrator": "md", "nsteps": 0, "continuation": "yes", "nstxout": 1, "nstfout": 1,
               "verlet-buffer-tolerance": -1, "rlist": reach, "rvdw": law["cutoff"],
               "rvdw-switch": law["switch_from"], "vdw-modifier": "Potential-switch",
               "DispCorr": "no", "coulombtype": "PME", "coulomb-modifier": "None",
               "rcoulomb": reach} | mesh
    del options["reach"]
    return "".join(f"{key} = {value}\n" for key, value in options.items())


def topology(scene, engine_coulomb):
    """Each site is an independent atom of mass 1; pairs within a body are excluded."""
    strengths = dict.fromkeys(zip(scene.sigma.tolist(), scene.epsilon.tolist()))
    kinds = {k: f"T{i}" for i, k in enumerate(strengths)}
    lines = ["[ defaults ]", "1 2", "[ atomtypes ]"]
    lines += [f"{kind} 1 0 A {sigma!r} {epsilon!r}" for (sigma, epsilon), kind in kinds.items()]
    scale = sqrt(COULOMB / engine_coulomb)
    for m in {m.name: m for m in scene.models}.values():
        sites = range(1, len(m.q) + 1)
        lines += ["[ moleculetype ]", f"{m.name} 0", "[ atoms ]"]
        lines += [f"{k} {kinds[strength]} 1 BODY S {k} {scale * q:.17g} 1"
                  for k, strength, q in zip(sites, zip(m.sigma.tolist(), m.epsilon.tolist()), m.q)]
        if len(sites) > 1:
            lines += ["[ bonds ]", "[ exclusions ]"]  # the second needs the first, though empty
            lines += [" ".join(map(str, (k, *sites))) for k in sites]
    lines += ["[ system ]", "rigid bodies", "[ molecules ]"]
    return "\n".join([*lines, *(f"{name} {n}" for name, n in scene.counts.items()), ""])


def coordinates(scene):
    """A GRO file is read with as many decimals as it has."""
    lines = ["rigid bodies", f"{len(scene.sites)}"]
    lines += [f"    1BODY     S{(i + 1) % 100000:5}" + "".join(f"{x:22.17f}" for x in r)
              for i, r in enumerate(scene.sites)]
    return "\n".join([*lines, " ".join(f"{edge:.17g}" for edge in scene.box), ""])


def gmx(folder, *arguments, answer=""):
    done = subprocess.run(["gmx_d", *arguments], cwd=folder, input=answer, text=True,
                          capture_output=True)
    if done.returncode:
        sys.exit(done.stderr)
    return done.stdout


def gromacs_run(scene, options, engine_coulomb):
    """Energies of both terms, forces on sites, and the virial Σ r ⊗ f of sites."""
    with tempfile.TemporaryDirectory() as folder:
        at = Path(folder)
        (at / "in.mdp").write_text(options)
        (at / "in.top").write_text(topology(scene, engine_coulomb))
        (at / "in.gro").write_text(coordinates(scene))
        gmx(folder, "grompp", "-f", "in.mdp", "-c", "in.gro", "-p", "in.top", "-o", "run.tpr")
        gmx(folder, "mdrun", "-s", "run.tpr", "-deffnm", "run", "-ntmpi", "1", "-ntomp", "1")
        terms = ["LJ-(SR)", "Coulomb-(SR)", "Coul.-recip."]
        terms += [f"Vir-{a}{b}" for a in "XYZ" for b in "XYZ"]
        gmx(folder, "energy", "-f", "run.edr", "-o", "run.xvg", "-dp", answer="\n".join(terms) + "\n")
        table = (at / "run.xvg").read_text()
        frame = (at / "run.trr").read_bytes()
    values = [float(v) for v in table.splitlines()[-1].split()[1:]]
    e = dict(zip(re.findall(r'legend "(.*)"', table), values, strict=True))
    r, f = np.frombuffer(frame[-48 * len(scene.sites):], ">f8").reshape(2, -1, 3)  # its last two
    assert off(scene.image(r - scene.sites), 0) < 1e-15
    # What GROMACS calls virial is -½ Σ r ⊗ f.
    virial = -2 * np.array([[e[f"Vir-{a}{b}"] for b in "XYZ"] for a in "XYZ"])
    return (e["LJ (SR)"], e["Coulomb (SR)"] + e.get("Coul. recip.", 0)), f, virial


def gromacs_coulomb():
    """The engine's own Coulomb constant, from the force between two unit charges 1 nm apart; energies
    are shifted at the cutoff."""
    probe = Scene({"argon": 2}, [6.0] * 3, [np.full((1, 3), 2.0), np.array([[3.0, 2, 2]])])
    probe.models[0].q[:], probe.models[0].epsilon[:] = 1, 0  # one model, of both
    probe.epsilon[:] = 0
    options = parameters({"switch_from": 1.5, "cutoff": 2.0}, {"reach": 1, "coulombtype": "Cut-off"})
    return float(gromacs_run(probe, options, COULOMB)[1][1, 0])


def of_bodies(scene, f, virial):
    """Forces and torques on bodies. The virial of sites minus the part that rotates and stretches molecules is the
    molecular virial."""
    arms = scene.sites - scene.centres()[scene.body]
    return *scene.loads(f), virial - arms.T @ f


def run(case, engine, engine_coulomb):
    peer = read(f"ewald-{case}")["results"][0]
    scene, law = of_file(f"ewald-{case}"), peer["law"] | {"smoothness": 2}
    compute = lambda mesh: gromacs_run(scene, parameters(law, mesh), engine_coulomb)
    energies, *on_sites = compute(MESH)
    again, *on_sites_again = compute(OTHER_MESH)
    loads, loads_again = of_bodies(scene, *on_sites), of_bodies(scene, *on_sites_again)
    force, torque, virial = loads
    names = ("force", "torque", "virial")
    other = {"energy": off(energies, again)} | {
        name: off(*both) for name, both in zip(names, zip(loads, loads_again))}
    result = {
        "law": law, "engine": engine, "mesh": MESH,
        "energy": {"lennard_jones": energies[0], "coulomb": energies[1]},
        "rms_electric_force": peer["rms_electric_force"],
        "largest": {"force": off(force, 0), "torque": off(torque, 0)},
        "virial": rounded(virial, 8), "other_mesh": other,
        "force": rounded(force, 8), "torque": rounded(torque, 9)}
    scene_name = read(f"ewald-{case}").get("scene", f"ewald-{case}")
    write(f"gromacs-{case}", provenance("gromacs", case, {"GROMACS": engine_coulomb})
          | {"scene": scene_name, "results": [result]})
    from_openmm = {"energy": energies[1] - peer["energy"]["coulomb"]}
    if peer["law"] == law:
        both = np.add(peer["virial"]["lennard_jones"], peer["virial"]["coulomb"])
        from_openmm |= {"force": off(force, peer["force"]), "torque": off(torque, peer["torque"]),
                        "virial": off(virial.diagonal(), both)}
    show = lambda d: " / ".join(f"{abs(v):.1e}" for v in d.values())
    print(f"| {case} | {energies[0]:.10g} | {energies[1]:.10g} | {show(other)} | {show(from_openmm)} |",
          flush=True)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as anywhere:
        version = re.search(r"GROMACS version:\s*(\S+)", gmx(anywhere, "--version"))[1]
    constant = gromacs_coulomb()
    for case in sys.argv[1:] or CASES:
        run(case, f"GROMACS {version}, double precision, PME", constant)
