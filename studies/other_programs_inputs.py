# SPDX-License-Identifier: MIT
"""Inputs of GROMACS, LAMMPS and OpenMM for the study of other programs, and the columns that their runs give."""

import json
import struct
import subprocess
from math import dist
from pathlib import Path

import npt
import npt_liquids as liquids
import numpy as np
from lib import runs
from lib.study import ROOT
from npt_liquids import BOLTZMANN, LIQUIDS
from other_programs_openmm import configuration, kicked, split

COUNT, TEMPERATURE, CUTOFF, SWITCH = 216, 298.15, 0.85, 0.7225  # molecules, [K], [nm], [nm]
FORCES = {"truncation": "site-shift", "electrostatics": "reaction-field", "dielectric": "infinite", "cutoff": f"{CUTOFF} nm", "precision": "mixed"}
TIME_CONSTANT = 0.1  # of all thermostats but Langevin [ps]
VOLUME_TIME, COMPRESSIBILITY = 1.0, 4.6e-5  # time constant of barostats [ps], [1/bar]
WATER = 18.0154 * 1.66053907  # mass of a molecule over its volume in nm³ [kg/m³]
MASSES = (15.9994, 1.008, 1.008)  # of the molecule file [u]
REPARTITIONED = (11.9674, 3.024, 3.024)  # three times the mass of hydrogen
TRANSLATION, ROTATION = 3 * COUNT - 3, 3 * COUNT  # degrees of freedom
CALORIE, ATMOSPHERE, COULOMB = 4.184, 1.01325, 138.935458  # [kJ], [bar], [kJ/mol nm/e²]


def density(volume):
    """[kg/m³], of the volume [nm³]."""
    return COUNT * WATER / np.asarray(volume, dtype=float)


def temperatures(translation, rotation, degrees=TRANSLATION):
    """T of translation and of rotation [K] from kinetic energies [kJ/mol]."""
    return {"T_trans": 2 * translation / (degrees * BOLTZMANN), "T_rot": 2 * rotation / (ROTATION * BOLTZMANN)}


# polhode

def switched(r, sigma, epsilon):
    """u and -u' of Lennard-Jones times the switching function of GROMACS and OpenMM."""
    x = np.maximum((r - SWITCH) / (CUTOFF - SWITCH), 0)  # above 1 beyond the cutoff, where the table of polhode must continue smoothly
    w, slope = 1 - 10 * x**3 + 15 * x**4 - 6 * x**5, -30 * x**2 * (1 - x) ** 2 / (CUTOFF - SWITCH)
    s = (sigma / r) ** 6
    u, force = 4 * epsilon * (s**2 - s), 24 * epsilon * (2 * s**2 - s) / r
    return w * u, w * force - slope * u


def reaction_field(r, charges):
    """u and -u' of the reaction field with infinite permittivity."""
    return (COULOMB * charges * (1 / r + r**2 / (2 * CUTOFF**3) - 3 / (2 * CUTOFF)), COULOMB * charges * (1 / r**2 - r / CUTOFF**3))


def molecule(o, masses=MASSES):
    """The name of a molecule file of SPC/E with a tabulated potential. The other programs switch the Lennard-Jones potential but not the reaction
    field. The shift of polhode leaves both unchanged, because energy and force already vanish at the cutoff."""
    name = "water" if masses == MASSES else "repartitioned"
    oxygen = liquids.atoms(LIQUIDS["spce"])[0]
    r = np.linspace(0.2, CUTOFF + 0.005, 1311)
    lines = "".join(f"{a:.12f} {u:.15g} {f:.15g}\n" for a, u, f in zip(r, *switched(r, oxygen.sigma, oxygen.epsilon)))
    (o.folder / "switched.txt").write_text(lines, encoding="utf-8")
    kept = [line for line in (ROOT / "data/molecules/spce.toml").read_text(encoding="utf-8").splitlines() if not line.startswith("epsilon")]
    text = "\n".join('law = "tabulated"\ntable = "switched.txt"' if line.startswith("sigma") else line for line in kept)
    for old, new in zip(MASSES[:2], masses):
        text = text.replace(f'"{old:g} u"', f'"{new:g} u"')
    (o.folder / f"{name}.toml").write_text(text.replace('name = "spce"', f'name = "{name}"'), encoding="utf-8")
    return f"./{name}.toml"


def start(o, equilibrate):
    """Equilibrates the common initial configuration, and keeps it."""
    if not (o.folder / "start-final.gro").exists():
        tables = {"system": {"molecules": runs.molecules(molecule(o), COUNT), "density": "0.998 g/cm3", "temperature": f"{TEMPERATURE} K"},
                  "forces": FORCES, "integrator": {"scheme": "gier4-fd", "step": "4 fs"},
                  "run": {"equilibrate": f"{equilibrate} ps", "length": "0.02 ps"}, "output": {"prefix": "start", **runs.QUIET}}
        runs.run(o, tables, o.folder, name="start")


def polhode(o, case, name):
    model = molecule(o, REPARTITIONED if case.repartitioned else MASSES)
    kind = {"rescaling": {"type": "rescaling", "time_constant": f"{TIME_CONSTANT} ps"},
            "separate": {"type": "separate-rescaling", "time_constant": f"{TIME_CONSTANT} ps"}, "langevin": {"type": "langevin", "friction": "1 1/ps"}}
    tables = {"system": {"molecules": runs.molecules(model, COUNT), "initial_configuration": "start-final.gro", "temperature": f"{TEMPERATURE} K",
                         "velocities": "new" if case.repartitioned else None},
              "forces": FORCES, "integrator": {"scheme": case.integrator, "step": f"{case.step} fs"},
              "run": {"length": f"{o.total(case)} ps", "sample": f"{o.sample(case)} fs"}, "output": {"prefix": name, **runs.QUIET},
              "thermostat": kind.get(case.thermostat)}
    if case.barostat:
        tables["barostat"] = {"type": "cell-rescaling", "pressure": "1 bar", "time_constant": f"{VOLUME_TIME} ps", "compressibility": f"{COMPRESSIBILITY} 1/bar"}
    report = runs.run(o, tables, o.folder, name=name)
    of = runs.columns(o.folder / f"{name}-energies.csv")
    own = {"density": density(of.volume)} if case.barostat else {}
    columns = {**own, "time": of.time, "potential": of.potential, "total": of.conserved if case.thermostat else of.total, "pressure": of.pressure,
               **temperatures(of.kinetic_translation, of.kinetic_rotation, report["degrees_of_freedom_translation"])}
    half = report.get("half_steps")
    extra = {"T_trans_half": [half["temperature_translation_K"], half["temperature_translation_error_K"]],
             "T_rot_half": [float(np.mean(half["temperature_rotation_K"])), None]} if half else {}
    return {key: np.asarray(x, dtype=float) for key, x in columns.items()}, extra


# GROMACS

MDP = """integrator = {integrator}
dt = {dt:g}
nsteps = {steps}
continuation = {continuation}
gen-vel = {new}
gen-temp = {temperature}
gen-seed = 1
cutoff-scheme = Verlet
verlet-buffer-tolerance = -1
rlist = {list_range}
nstlist = {list}
vdwtype = cut-off
vdw-modifier = potential-switch
rvdw-switch = {switch}
rvdw = {cutoff}
coulombtype = reaction-field
coulomb-modifier = potential-shift
epsilon-rf = 0
rcoulomb = {cutoff}
comm-mode = linear
nstcomm = {every}
tcoupl = {thermostat}
tc-grps = System
tau-t = {tau}
nh-chain-length = 1
nsttcouple = {couple}
ref-t = {temperature}
pcoupl = {barostat}
tau-p = {volume_time}
ref-p = 1
compressibility = {compressibility}
nstpcouple = 10
ld-seed = 1
nstcalcenergy = {every}
nstenergy = {every}
nstvout = {every}
nstfout = {forces}
nstlog = 1000000
"""


def frames(path, forces=False):
    """Velocities, or forces, of each frame of a TRR file in single precision."""
    data, at = Path(path).read_bytes(), 0
    while at < len(data):
        sizes = struct.unpack(">13i", data[at + 24:at + 76])
        at += 84  # with time and lambda
        box, x, v, f = sizes[2], sizes[7], sizes[8], sizes[9]
        if size := f if forces else v:
            yield np.frombuffer(data, ">f4", size // 4, at + box + x + (v if forces else 0)).reshape(-1, 3)
        at += box + x + v + f


def topology(masses):
    text = liquids.topology(LIQUIDS["spce"]._replace(count=COUNT))
    for old, new in zip(MASSES[:2], masses):
        text = text.replace(f" {old:.6f}", f" {new:.6f}")
    return text


def gromacs_run(o, name, **mdp):
    masses, start_file = mdp.pop("masses", MASSES), mdp.pop("start", "start-final.gro")
    text = MDP.format(**{"temperature": TEMPERATURE, "cutoff": CUTOFF, "switch": SWITCH, "tau": TIME_CONSTANT, "thermostat": "no", "new": "no", "continuation": "yes",
                         "integrator": "md-vv", "dt": 0.001, "steps": 0, "couple": 1, "every": 1, "list": 10, "list_range": 0.93, "forces": 0,
                         "barostat": "no", "volume_time": VOLUME_TIME, "compressibility": COMPRESSIBILITY, **mdp})
    (o.folder / f"{name}.mdp").write_text(text, encoding="utf-8")
    (o.folder / f"{name}.top").write_text(topology(masses), encoding="utf-8")
    npt.called(o.folder, o.gmx, "-nobackup", "grompp", "-f", f"{name}.mdp", "-c", start_file, "-p", f"{name}.top", "-o", f"{name}.tpr",
               "-po", f"{name}-out.mdp", "-maxwarn", 5)
    npt.called(o.folder, o.gmx, "-nobackup", "mdrun", "-deffnm", name, "-ntmpi", 1, "-ntomp", 1, "-pin", "off", "-noconfout", "-cpt", 1000)


def excluded_pairs():
    """The reaction field of a molecule with itself [kJ/mol], a constant that GROMACS includes."""
    sites = LIQUIDS["spce"].sites
    charge, place = [liquids.number(s, "charge") for s in sites], [liquids.position(s) for s in sites]
    k, c = 1 / (2 * CUTOFF**3), 3 / (2 * CUTOFF)
    pairs = sum(charge[a] * charge[b] * (k * dist(place[a], place[b]) ** 2 - c) for a, b in ((0, 1), (0, 2), (1, 2)))
    return COULOMB * (pairs - c / 2 * sum(q**2 for q in charge))


def gromacs_start(o, step):
    """The initial configuration with velocities of half a step before. GROMACS takes velocities of a file as these, also with md-vv."""
    if not (o.folder / "forces.trr").exists():
        gromacs_run(o, "forces", forces=1)
    x, v, box = configuration(o.folder / "start-final.gro")
    v = kicked(x, v, next(frames(o.folder / "forces.trr", forces=True)), MASSES, -step / 2000, box)
    lines = (o.folder / "start-final.gro").read_text(encoding="utf-8").splitlines()
    lines[2:-1] = [line[:65] + "".join(f"{c:15.11f}" for c in of) for line, of in zip(lines[2:-1], v)]
    (o.folder / f"start-{step:g}.gro").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return f"start-{step:g}.gro"


def gromacs(o, case, name):
    masses = REPARTITIONED if case.repartitioned else MASSES
    gromacs_run(o, name, integrator=case.integrator, dt=case.step / 1000, steps=round(1000 * o.total(case) / case.step), masses=masses, start=gromacs_start(o, case.step),
                list=round(20 / case.step),
                new="yes" if case.repartitioned else "no", continuation="no" if case.repartitioned else "yes", thermostat=case.thermostat or "no",
                tau=TIME_CONSTANT * (5 if case.thermostat == "nose-hoover" else 1), every=round(o.sample(case) / case.step), barostat=case.barostat or "no",
                list_range=0.89 if case.barostat else 0.93)  # the box of a barostat may become smaller
    energy = "Conserved-En." if case.thermostat else "Total-Energy"
    time, potential, total, pressure, temperature = npt.gromacs_table(o, name, ("Time", "Potential", energy, "Pressure", "Temperature"))
    volume = {"density": density(npt.gromacs_table(o, name, ("Volume",))[0])} if case.barostat else {}
    kinetic = np.array([split(v, masses) for v in frames(o.folder / f"{name}.trr")])
    own = temperatures(*kinetic.T)
    ending = "_half" if case.integrator == "md" else ""
    columns = {"time": time, "potential": potential, "total": total, "pressure": pressure, "temperature": temperature, **volume,
               **{key + ending: x for key, x in own.items()}}
    (o.folder / f"{name}.trr").unlink()
    return columns, {}


def gromacs_energies(o, step=2):
    """Total energy [kJ/mol] that md-vv prints at the beginning, from a file with velocities of full steps and of half steps."""
    found = {}
    for kind, file in (("full steps", "start-final.gro"), ("half steps", gromacs_start(o, step))):
        gromacs_run(o, "velocities", dt=step / 1000, start=file)
        found[kind] = float(npt.gromacs_table(o, "velocities", ("Total-Energy",))[0][0])
    return found


# LAMMPS

LAMMPS = """units real
atom_style full
pair_style table spline 3000
bond_style zero
angle_style zero
special_bonds lj/coul 0 0 0
read_data lammps-angles.data nocoeff
pair_coeff 1 1 water.table PAIR_1_1
pair_coeff 1 2 water.table PAIR_1_2
pair_coeff 2 2 water.table PAIR_2_2
bond_coeff * {bond}
angle_coeff * {angle}
neighbor 1.5 bin
neigh_modify delay 0 every 1 check yes
{fix}
timestep {step}
compute molecule all chunk/atom molecule
compute centres all temp/chunk molecule kecom
variable translation equal sum(c_centres[1])
thermo_style custom step time pe {energy} press ke v_translation vol
thermo_modify norm no format float %.15g
thermo {every}
run {steps}
"""
FIXES = {"rigid/nve/small": "fix 1 all rigid/nve/small molecule", "rigid/nvt/small": "fix 1 all rigid/nvt/small molecule temp {t} {t} {tau}",
         **{f"polhode {scheme}": f"plugin load {{plugin}}\nfix 1 all polhode scheme {scheme}" for scheme in ("velocity-verlet", "gier4-fd")},
         "rigid/npt/small": "fix 1 all rigid/npt/small molecule temp {t} {t} {tau} iso {p} {p} {tau_p}",
         "shake npt": "fix 2 all shake 1e-8 200 0 b 1 a 1\nfix 1 all npt temp {t} {t} {tau} iso {p} {p} {tau_p}",
         "shake nvt": "fix 2 all shake 1e-8 200 0 b 1 a 1\nfix 1 all nvt temp {t} {t} {tau}"}


def lammps_potentials(points=3000):
    """The tables of the three pairs of sites, in Angstrom and kcal/mol."""
    oxygen, hydrogen, _ = liquids.atoms(LIQUIDS["spce"])
    r = np.sqrt(np.linspace(0.1**2, CUTOFF**2, points))
    text = ""
    for name, a, b in (("1_1", oxygen, oxygen), ("1_2", oxygen, hydrogen), ("2_2", hydrogen, hydrogen)):
        u, force = reaction_field(r, a.charge * b.charge)
        if a.epsilon * b.epsilon:
            more = switched(r, a.sigma, a.epsilon)
            u, force = u + more[0], force + more[1]
        text += f"PAIR_{name}\nN {points} RSQ 1 {10 * CUTOFF:.15g}\n\n" + "".join(
            f"{k} {10 * x:.15g} {y / CALORIE:.15g} {z / (10 * CALORIE):.15g}\n" for k, (x, y, z) in enumerate(zip(r, u, force), 1)) + "\n"
    return text


def lammps_data(o):
    """The data file that polhode exports, with angles, because SHAKE needs them."""
    tables = {"system": {"molecules": runs.molecules(molecule(o), COUNT), "initial_configuration": "start-final.gro"},
              "forces": FORCES, "integrator": {"scheme": "velocity-verlet", "step": "2 fs"}, "run": {"length": "1 ps"}, "output": runs.QUIET}
    (o.folder / "lammps.toml").write_text(runs.run_file(**tables), encoding="utf-8")
    runs.called(o, "export", "lammps", "lammps.toml", "--output", "lammps", "--force", folder=o.folder)
    text = (o.folder / "lammps.data").read_text(encoding="utf-8")
    text = text.replace("1 bond types", f"1 bond types\n{COUNT} angles\n1 angle types")
    (o.folder / "water.table").write_text(lammps_potentials(), encoding="utf-8")
    angles = "".join(f"{k + 1} 1 {3 * k + 2} {3 * k + 1} {3 * k + 3}\n" for k in range(COUNT))
    (o.folder / "lammps-angles.data").write_text(text.rstrip() + "\n\nAngles\n\n" + angles, encoding="utf-8")


def lammps_table(text):
    """The columns of the last thermo table of a log."""
    lines = text.splitlines()
    head = max(k for k, line in enumerate(lines) if line.split()[:2] == ["Step", "Time"])
    end = next(k for k, line in enumerate(lines) if k > head and line.startswith("Loop time"))
    return dict(zip(lines[head].split(), np.array([[float(x) for x in line.split()] for line in lines[head + 1:end]]).T))


def lammps_run(o, name, fix, step, steps, every, thermostat):
    if not (o.folder / "lammps-angles.data").exists():
        lammps_data(o)
    evaluations = 3 if "gier4-fd" in fix else 1  # force evaluations per step, each a step of LAMMPS
    text = LAMMPS.format(fix=fix, step=step / evaluations, steps=evaluations * steps, every=evaluations * every, bond=1.0, angle=109.47, energy="econserve" if thermostat else "etotal")
    (o.folder / f"{name}.in").write_text(text, encoding="utf-8")
    done = subprocess.run([o.lmp, "-in", f"{name}.in", "-log", f"{name}.log", "-screen", "none"], cwd=o.folder, text=True, capture_output=True, check=False)
    if done.returncode:
        raise SystemExit(f"LAMMPS, {name}: {done.stdout}{done.stderr}{(o.folder / f'{name}.log').read_text(encoding='utf-8')[-1000:]}")
    return lammps_table((o.folder / f"{name}.log").read_text(encoding="utf-8"))


def lammps(o, case, name):
    fix = FIXES[case.integrator].format(t=TEMPERATURE, tau=1000 * TIME_CONSTANT, plugin=o.plugin, p=1 / ATMOSPHERE, tau_p=1000 * VOLUME_TIME)
    of = lammps_run(o, name, fix, case.step, round(1000 * o.total(case) / case.step), round(o.sample(case) / case.step), case.thermostat)
    translation = CALORIE * of["v_translation"]
    volume = {"density": density(of["Volume"] / 1000)} if case.barostat else {}
    return {**volume, "time": of["Time"] / 1000, "potential": CALORIE * of["PotEng"], "total": CALORIE * of["Econserve" if case.thermostat else "TotEng"],
            "pressure": ATMOSPHERE * of["Press"], **temperatures(translation, CALORIE * of["KinEng"] - translation)}, {}


# OpenMM

def openmm_run(o, name, integrator, step, steps, every, barostat=""):
    given = {"integrator": integrator, "step": step, "steps": steps, "every": every, "temperature": TEMPERATURE, "cutoff": CUTOFF, "switch": SWITCH, "masses": MASSES, "barostat": barostat,
             "site": [(a.charge, a.sigma, a.epsilon) for a in liquids.atoms(LIQUIDS["spce"])]}
    (o.folder / f"{name}-openmm.json").write_text(json.dumps(given), encoding="utf-8")
    npt.called(o.folder, o.openmm, "-B", ROOT / "studies/other_programs_openmm.py", f"{name}-openmm.json", "start-final.gro", f"{name}.npz")
    return dict(np.load(o.folder / f"{name}.npz"))


def openmm(o, case, name):
    of = openmm_run(o, name, case.integrator, case.step, round(1000 * o.total(case) / case.step), round(o.sample(case) / case.step), case.barostat)
    degrees = TRANSLATION + 3 if case.thermostat else TRANSLATION
    half = temperatures(of["translation_half"], of["rotation_half"], degrees)
    return {"time": of["time"], "potential": of["potential"], "total": of["potential"] + of["translation"] + of["rotation"],
            **temperatures(of["translation"], of["rotation"], degrees), **{key + "_half": x for key, x in half.items()},
            **({"density": density(of["volume"])} if case.barostat else {})}, {}


# The same forces

def energies(o):
    """Potential energy of the initial configuration per molecule [kJ/mol] by each program, and the largest deviation that constants explain."""
    tables = {"system": {"molecules": runs.molecules(molecule(o), COUNT), "initial_configuration": "start-final.gro"}, "forces": {**FORCES, "precision": "double"}}
    (o.folder / "energy.toml").write_text(runs.run_file(**tables), encoding="utf-8")
    found = {"polhode": runs.asked(o, "energy", "energy.toml", folder=o.folder)["potential_kJ_per_mol"]}
    if o.gmx:
        gromacs_run(o, "energy")
        found["GROMACS"] = float(npt.gromacs_table(o, "energy", ("Potential",))[0][0])
    if o.lmp:
        found["LAMMPS"] = CALORIE * float(lammps_run(o, "energy", FIXES["rigid/nve/small"], 1, 0, 1, "")["PotEng"][0])
    if o.openmm:
        found["OpenMM"] = float(openmm_run(o, "energy", "Verlet", 1, 0, 1)["potential"][0])
    return {program: u / COUNT for program, u in found.items()}
