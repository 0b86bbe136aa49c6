# SPDX-License-Identifier: MIT
"""The time-step bias of rigid water in GROMACS, LAMMPS and OpenMM compared with polhode: the same model, forces and initial configuration.

Criteria, stated before the data. All are in combined standard errors, and the bound is 3.
1. Energies of the initial configuration agree within 1e-4 kJ/mol per molecule, after the constant of excluded pairs in GROMACS.
2. At constant energy, programs with velocity Verlet agree with velocity-verlet of polhode at the same step: in U, in T_rot - T_trans, and in the
   biases of both that `polhode bias` computes from the energies of each program. So does gier4-fd of polhode in LAMMPS.
3. At constant temperature U and T_rot - T_trans agree with the counterpart in polhode at the same step (COUNTERPARTS).
4. At constant temperature and pressure the density agrees with this counterpart, too.
All points of an ensemble have the same length. Programs that are not installed are skipped."""

import os
import shutil
import subprocess
from math import hypot
from pathlib import Path
from typing import NamedTuple

import numpy as np
import other_programs_inputs as inputs
from lib import runs, study
from lib.statistics import block_mean, correlated_mean
from other_programs_inputs import COUNT

PUBLISHED = Path(os.environ.get("POLHODE_PUBLISHED", study.ROOT.parent / "shared/data/published")) / "mosdef_spce.csv"
MONTE_CARLO = ("mcccs", "cassandra")  # the two that agree; the third, gomc, is compared with them
SHOWN = {"lammps": "LAMMPS, 2 fs", "hoomd": "HOOMD, 1 fs", "gromacs": "GROMACS leapfrog, 1 fs", "gomc": "Monte Carlo, GOMC"}
# The bias of U with rescaling of full-step velocities at 2 fs, from the record half-femtosecond, a quarter of it at 1 fs, and none for half steps.
PREDICTED = ((0.1069, 0.0061), (0.1069 / 4, 0.0061 / 4), (0, 0))
BOUND = 3
BLOCKS = 10
ENERGIES_AGREE = 1e-4  # [kJ/mol]


class Case(NamedTuple):
    program: str
    integrator: str
    thermostat: str  # none: constant energy
    step: float  # [fs]
    repartitioned: bool = False
    barostat: str = ""  # none: constant volume


CONSTANT_ENERGY = (("polhode", "velocity-verlet"), ("GROMACS", "md-vv"), ("OpenMM", "Verlet"), ("LAMMPS", "rigid/nve/small"))
PLUGIN = (Case("LAMMPS", "polhode velocity-verlet", "", 2), Case("LAMMPS", "polhode velocity-verlet", "", 4), Case("LAMMPS", "polhode gier4-fd", "", 4))
CONSTANT_TEMPERATURE = (("polhode", "velocity-verlet", "rescaling"), ("polhode", "baoab", "langevin"), ("GROMACS", "md", "v-rescale"),
                        ("GROMACS", "md-vv", "v-rescale"), ("OpenMM", "LangevinMiddle", "langevin"), ("LAMMPS", "rigid/nvt/small", "nose-hoover"),
                        ("polhode", "velocity-verlet", "separate"), ("LAMMPS", "shake nvt", "nose-hoover"), ("GROMACS", "md-vv", "nose-hoover"))
# The run of polhode that a run at constant temperature is compared with, and why it is the counterpart.
COUNTERPARTS = {("GROMACS", "md", "v-rescale"): ("baoab", "langevin"), ("GROMACS", "md-vv", "v-rescale"): ("velocity-verlet", "rescaling"),
                ("GROMACS", "md-vv", "nose-hoover"): ("velocity-verlet", "rescaling"), ("LAMMPS", "shake nvt", "nose-hoover"): ("velocity-verlet", "rescaling"),
                ("LAMMPS", "rigid/nvt/small", "nose-hoover"): ("velocity-verlet", "separate"), ("OpenMM", "LangevinMiddle", "langevin"): ("baoab", "langevin"),
                ("LAMMPS", "shake npt", "nose-hoover"): ("velocity-verlet", "rescaling"),
                ("LAMMPS", "rigid/npt/small", "nose-hoover"): ("baoab", "langevin")}  # its thermostat controls velocities of half steps
# The same at 1 bar. The fixes of LAMMPS have thermostat and barostat in one, and Langevin dynamics of OpenMM has Monte Carlo moves of the volume.
CONSTANT_PRESSURE = (("polhode", "velocity-verlet", "rescaling", "cell-rescaling"), ("polhode", "baoab", "langevin", "cell-rescaling"), ("GROMACS", "md", "v-rescale", "c-rescale"),
                     ("GROMACS", "md-vv", "v-rescale", "c-rescale"), ("OpenMM", "LangevinMiddle", "langevin", "monte-carlo"),
                     ("LAMMPS", "rigid/npt/small", "nose-hoover", "nose-hoover"), ("LAMMPS", "shake npt", "nose-hoover", "nose-hoover"))
REPARTITIONED = (Case("polhode", "velocity-verlet", "rescaling", 4, True), Case("GROMACS", "md-vv", "v-rescale", 4, True))
# At constant temperature the errors exceed the bias of 0.5 and 1 fs. Cheap runs come first, and the longest ones last.
CASES = sorted([*(Case(*of, "", step) for step in (4, 2, 1, 0.5) for of in CONSTANT_ENERGY), *(Case(*of, step) for step in (4, 2) for of in CONSTANT_TEMPERATURE),
                Case("polhode", "gier4-fd", "", 4), Case("polhode", "gier4-fd", "rescaling", 4), *REPARTITIONED, *PLUGIN,
                *(Case(*of, step, barostat=barostat) for step in (4, 2) for *of, barostat in (*CONSTANT_PRESSURE, ("polhode", "gier4-fd", "rescaling", "cell-rescaling")))],
               key=lambda case: {"polhode": 1, "GROMACS": 1, "OpenMM": 4, "LAMMPS": 8}[case.program] * (20 if case.barostat else 2 if case.thermostat else 1) / case.step)
RUNNERS = {"polhode": inputs.polhode, "GROMACS": inputs.gromacs, "LAMMPS": inputs.lammps, "OpenMM": inputs.openmm}


# Runs

def estimate(values):
    """[mean, standard error]: the larger of the errors from blocks and from the autocorrelation."""
    blocks, correlated = block_mean(values, BLOCKS), correlated_mean(values)
    return [correlated[0], max(blocks[1], correlated[1])]


def bias(o, name, columns, case):
    """The biases that `polhode bias` computes from the columns."""
    kinds = {"total": "conserved [kJ/mol]" if case.thermostat else "total [kJ/mol]", "potential": "potential [kJ/mol]", "T_trans": "T_trans [K]",
             "T_rot": "T_rot [K]", "difference": "difference [K]", "pressure": "pressure [bar]"}
    used = [key for key in kinds if key in columns]
    path = o.folder / f"{name}-bias.csv"
    lines = [",".join(["time [ps]", *(kinds[key] for key in used)])]
    lines += [",".join(f"{x:.12g}" for x in row) for row in zip(columns["time"], *(columns[key] for key in used))]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    temperature = np.mean((columns["T_trans"] + columns["T_rot"]) / 2)
    found = runs.asked(o, "bias", path.name, "--temperature", f"{temperature} K", folder=o.folder)
    result = {c["name"].split(" [")[0]: c["bias"] for c in found["columns"]}
    return {**result, "constant temperature": found["potential_bias_at_constant_temperature"], "warnings": found["warnings"]}


def file_name(case):
    return "-".join([*case[:3], f"{case.step:g}", *(["heavy"] if case.repartitioned else []), *(["1-bar"] if case.barostat else [])]).replace("/", "-").replace(" ", "-").lower()


def point(o, case):
    """The estimates of one run."""
    name = file_name(case)

    def made():
        columns, extra = RUNNERS[case.program](o, case, name)
        kept = columns["time"] >= o.unused(case) - 1e-9
        columns = {key: np.asarray(x, dtype=float)[kept] for key, x in columns.items()}
        for ending in ("", "_half"):
            if f"T_rot{ending}" in columns:
                columns[f"difference{ending}"] = columns[f"T_rot{ending}"] - columns[f"T_trans{ending}"]
        found = {key: estimate(x / (COUNT if key in ("potential", "total") else 1)) for key, x in columns.items() if key != "time"}
        predicted = bias(o, name, columns, case) if not case.thermostat else None
        return {**case._asdict(), "samples": len(columns["time"]), **found, **extra, "bias": predicted}

    return runs.kept(o.folder, f"{name}-point", made)


def versions(o):
    said = {"polhode": subprocess.run([o.program, "-V"], text=True, capture_output=True, check=False).stdout.strip()}
    if o.gmx:
        text = subprocess.run([o.gmx, "--version"], text=True, capture_output=True, check=False).stdout
        said["GROMACS"] = next(line.split(":", 1)[1].strip() for line in text.splitlines() if line.startswith("GROMACS version"))
    if o.lmp:
        text = subprocess.run([o.lmp, "-h"], text=True, capture_output=True, check=False).stdout
        said["LAMMPS"] = next(line.split(" - ", 1)[1] for line in text.splitlines() if line.startswith("Large-scale"))
    if o.openmm:
        said["OpenMM"] = str(np.load(o.folder / "energy.npz")["version"])
    return said


def published():
    """U of each program minus the mean of MONTE_CARLO [kJ/mol per molecule]; the published table itself is not stored."""
    if not PUBLISHED.exists():
        return []
    lines = [line.split(",") for line in PUBLISHED.read_text(encoding="utf-8").splitlines()[1:]]
    energy = {(int(line[0]), line[1]): float(line[4]) for line in lines}
    step = {line[1]: float(line[5]) for line in lines}
    reference = {t: np.mean([energy[t, name] for name in MONTE_CARLO]) for t, _ in energy}
    return [{"temperature": t, "program": name, "step": step[name], "difference": round(u - float(reference[t]), 4)} for (t, name), u in energy.items()]


def measured(o):
    o.unused = lambda case: o.discard * (5 if case.barostat else 1)  # a volume equilibrates slowly
    o.total = lambda case: o.unused(case) + (o.isobaric if case.barostat else o.canonical if case.thermostat else o.length)
    o.sample = lambda case: 200 if case.barostat else 40 if case.thermostat else 8
    o.gmx, o.lmp, o.openmm = (shutil.which(name) if name else None for name in (o.gmx, o.lmp, o.openmm))
    if o.openmm and subprocess.run([o.openmm, "-c", "import openmm"], capture_output=True, check=False).returncode:
        o.openmm = None
    o.plugin = Path(o.plugin).resolve() if o.plugin else None
    available = {"polhode": True, "GROMACS": o.gmx, "LAMMPS": o.lmp, "OpenMM": o.openmm}
    with runs.scratch(o) as folder:
        o.folder = Path(folder).resolve()
        inputs.start(o, o.equilibrate)
        cases = [case for case in CASES if available[case.program] and (case.step == 4 or not o.smoke) and (o.plugin or case not in PLUGIN)]
        if o.finished:
            cases = [case for case in cases if (o.folder / f"{file_name(case)}-point.json").exists()]
        energies = runs.kept(o.folder, "energies", lambda: inputs.energies(o))
        points = runs.parallel(o, lambda case: point(o, case), cases)
        return {"versions": versions(o), "length_ps": o.length, "canonical_ps": o.canonical, "isobaric_ps": o.isobaric, "discard_ps": o.discard, "energies": energies,
                "excluded_pairs_GROMACS": inputs.excluded_pairs(),
                "velocities_in_files_GROMACS": inputs.gromacs_energies(o) if o.gmx else None, "points": points, "published": published()}


# Tables

def name_of(p):
    return f"{p['program']} {p['integrator']}" + (", hydrogen 3.024 u" if p["repartitioned"] else "")


def text(pair, digits):
    if not pair:
        return ""
    value, error = pair if isinstance(pair, list) else (pair["value"], pair["error"])
    return f"{value:.{digits}f}" + (f" ± {error:.{digits}f}" if error is not None else "")


def potential(result, p):
    """U without the constant of excluded pairs in GROMACS."""
    value, error = p["potential"]
    return [value - (result["excluded_pairs_GROMACS"] if p["program"] == "GROMACS" else 0), error]


def of_bias(p, name):
    """[bias, error], or None."""
    found = (p["bias"] or {}).get(name)
    return [found["value"], found["error"]] if found else None


def barostat_of(p):
    """Records of 2026-11-27 have none."""
    return p.get("barostat", "")


def deviation(a, b):
    return (a[0] - b[0]) / hypot(a[1], b[1])


def energy_table(result):
    of = [p for p in result["points"] if not p["thermostat"]]
    scaled = lambda pair: pair and [x / COUNT for x in pair]
    return study.table(
        ["program, integrator", "step [fs]", "U [kJ/mol]", "bias of U [kJ/mol]", "the same at constant T", "T_trans [K]", "T_rot − T_trans [K]", "its bias [K]",
         "pressure [bar]"],
        [[name_of(p), f"{p['step']:g}", text(potential(result, p), 3), text(scaled(of_bias(p, "potential")), 4), text(scaled(of_bias(p, "constant temperature")), 4),
          text(p["T_trans"], 1), text(p["difference"], 1), text(of_bias(p, "difference"), 2), text(p.get("pressure"), 0)]
         for p in sorted(of, key=lambda p: (p["step"], p["program"] != "polhode"))])


def temperature_table(result):
    of = [p for p in result["points"] if p["thermostat"] and not barostat_of(p)]
    both = lambda p, ending: f"{text(p['T_trans' + ending], 1)}, {text(p['T_rot' + ending], 1)}" if "T_rot" + ending in p else ""
    return study.table(
        ["program, integrator", "thermostat", "step [fs]", "U [kJ/mol]", "T_trans, T_rot of full steps [K]", "of half steps [K]", "pressure [bar]"],
        [[name_of(p), p["thermostat"], f"{p['step']:g}", text(potential(result, p), 3), both(p, ""), both(p, "_half"), text(p.get("pressure"), 0)]
         for p in sorted(of, key=lambda p: (p["repartitioned"], p["step"], p["program"] != "polhode"))])


def pressure_table(result):
    of = [p for p in result["points"] if barostat_of(p)]
    own = next((p["density"] for p in of if p["integrator"] == "gier4-fd" and p["step"] == 4), None)
    change = lambda p: [100 * (p["density"][0] / own[0] - 1), 100 * hypot(p["density"][1], own[1]) / own[0]]
    return study.table(
        ["program, integrator", "thermostat", "barostat", "step [fs]", "density [kg/m3]", "minus gier4-fd at 4 fs [%]", "U [kJ/mol]"],
        [[name_of(p), p["thermostat"], p["barostat"], f"{p['step']:g}", text(p["density"], 1), text(change(p), 2), text(potential(result, p), 3)]
         for p in sorted(of, key=lambda p: (p["step"], p["program"] != "polhode"))]) if own else ""


def comparisons(result):
    """(program, step, quantity, deviation in combined standard errors) of criteria 2 to 4."""
    points = {(p["program"], p["integrator"], p["thermostat"], p["step"], p["repartitioned"], bool(barostat_of(p))): p for p in result["points"]}
    found = []
    for key, p in points.items():
        program, integrator, thermostat, step, heavy, at_pressure = key
        if program == "polhode":
            continue
        own = COUNTERPARTS[program, integrator, thermostat] if thermostat else ("gier4-fd" if "gier4-fd" in integrator else "velocity-verlet", "")
        other = points.get(("polhode", *own, step, heavy, at_pressure))
        if not other:
            continue
        if at_pressure:
            found.append((p, other, "density", deviation(p["density"], other["density"])))
            continue
        found.append((p, other, "U", deviation(potential(result, p), potential(result, other))))
        ending = "" if "difference" in p and "difference" in other else None
        if ending is not None:
            found.append((p, other, "T_rot − T_trans", deviation(p["difference"], other["difference"])))
        for name, label in (("potential", "bias of U"), ("difference", "bias of T_rot − T_trans")):
            if of_bias(p, name) and of_bias(other, name):
                found.append((p, other, label, deviation(of_bias(p, name), of_bias(other, name))))
    return found


def agreement_table(result):
    rows = {}
    for p, other, quantity, d in comparisons(result):
        key = (name_of(p), p["thermostat"] + (", 1 bar" if barostat_of(p) else "") or "constant energy", f"{p['step']:g}", f"{other['integrator']} {other['thermostat']}".strip())
        rows.setdefault(key, {})[quantity] = f"**{d:+.1f}**" if abs(d) > BOUND else f"{d:+.1f}"
    names = ("U", "T_rot − T_trans", "bias of U", "bias of T_rot − T_trans", "density")
    return study.table(["program, integrator", "thermostat", "step [fs]", "polhode", *names],
                       [[*key, *(values.get(name, "") for name in names)] for key, values in sorted(rows.items(), key=lambda r: (r[0][1], float(r[0][2]), r[0][0]))])


def report(result):
    own = result["energies"]["polhode"]
    lines = [[program, f"{u:.5f}", f"{u - (result['excluded_pairs_GROMACS'] if program == 'GROMACS' else 0) - own:+.6f}"]
             for program, u in result["energies"].items()]
    tables = [study.table(["program", "U of the initial configuration [kJ/mol]", "deviation"], lines), energy_table(result), temperature_table(result),
              pressure_table(result), agreement_table(result)]
    if result["published"]:
        tables.append(study.table(["T [K]", "program", "step [fs]", "U minus Monte Carlo [kJ/mol]"],
                                  [[p["temperature"], p["program"], f"{p['step']:g}", f"{p['difference']:+.3f}"] for p in result["published"]]))
    return "\n".join(tables)


def draw(result):
    """Two panels: the bias of U at constant energy in each program against the step, and published U of six programs minus Monte Carlo."""
    from lib import figures
    figure, ((left, right),) = figures.panels(2, size=(9.6, 4.6))
    colors = [figures.styles(["velocity-verlet"])["velocity-verlet"].color, *figures.PALETTE[1:4]]
    for k, (program, marker, color) in enumerate(zip(RUNNERS, "os^D", colors)):
        rows = [(p["step"], *(x / COUNT for x in of_bias(p, "potential"))) for p in result["points"]
                if p["program"] == program and not p["thermostat"] and (program, p["integrator"]) in CONSTANT_ENERGY]
        if rows:
            x, y, error = map(np.array, zip(*sorted(rows)))
            left.errorbar(x * 1.05 ** (k - 1.5), y, [np.minimum(error, 0.9 * abs(y)), error], label=f"{program} {dict(CONSTANT_ENERGY)[program]}",
                          color=color, marker=marker, linestyle="none")
            if program == "polhode":
                left.plot(x, y[0] * (x / x[0]) ** 2, color=figures.INK, linewidth=1, linestyle=":", label="proportional to the square of the step")
    left.set(xscale="log", yscale="log", xlim=(0.4, 5), ylim=(1e-3, 4), xlabel="time step  (fs)", ylabel="U, time-step bias at constant energy  (kJ/mol)")
    figures.plain_ticks(left.xaxis, (0.5, 1, 2, 4))
    figures.plain_ticks(left.yaxis, (0.001, 0.01, 0.1, 1))
    left.legend(loc="upper left")
    shown = (colors[2], figures.PALETTE[4], colors[1], figures.INK)
    for (program, name), marker, color in zip(SHOWN.items(), "^psv", shown):
        rows = [(p["temperature"], p["difference"]) for p in result["published"] if p["program"] == program]
        if rows:
            right.plot(*zip(*rows), linestyle="none", marker=marker, color=color, label=name, markerfacecolor="none" if color == figures.INK else color)
    for (value, error), color in zip(PREDICTED, shown):
        right.axhline(value, color=color, linewidth=1, linestyle="--")
        right.axhspan(value - error, value + error, color=color, alpha=0.15, linewidth=0)
    right.plot([], [], color=figures.INK, linewidth=1, linestyle="--", label="predicted by polhode")
    right.set(xlim=(275, 325), ylim=(-0.03, 0.23), xlabel="temperature  (K)", ylabel="U minus Monte Carlo  (kJ/mol)")
    right.legend()
    return figure


if __name__ == "__main__":
    o = study.options(__doc__, {"length": 0.8, "canonical": 2.0, "isobaric": 4.0, "discard": 0.2, "equilibrate": 0.2},
                      length=(40.0, "length at constant energy [ps]"), canonical=(80.0, "length at constant temperature [ps]"), isobaric=(800.0, "length at constant pressure [ps]"),
                      discard=(4.0, "length that is not used, of each run [ps]; at constant pressure five times as long"), equilibrate=(20.0, "length of the equilibration [ps]"),
                      finished=(False, "use only the finished runs in --folder"), gmx=("gmx", "GROMACS"), lmp=("lmp", "LAMMPS"), plugin=("", "polhodeplugin.so of this LAMMPS; empty: no runs of it"),
                      openmm=("python3", "a Python that has OpenMM"))
    study.perform(o, measured, report, draw)
