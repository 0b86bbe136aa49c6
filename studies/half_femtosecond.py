#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The time-step bias in rigid water: temperatures, energy, pressure, density, structure and compressibility against the time step, for
many schemes.

Every run adds a line to the record; a study that was interrupted, or is given more runs, continues where the record ends. --figure
FOLDER draws bias.svg there."""

import json
import zlib
from pathlib import Path
from typing import NamedTuple

import half_femtosecond_compared as compared
import half_femtosecond_tables as tables
from lib import runs, study

SMALL, LATE = "constant energy, 64 molecules", "constant energy, after 100 ps"
HALF = "constant energy, half steps"  # baoab without friction is velocity Verlet, and reports half-step temperatures
EXACT = "hybrid Monte Carlo at constant pressure"
FOURTH_ORDER = ("gier4-fd", "4mn5fv")  # without a shadow energy to be sampled
RESCALING = {"thermostat": {"type": "rescaling", "time_constant": "1 ps"}}
BAROSTAT = {"type": "cell-rescaling", "pressure": "1 bar", "compressibility": "4.5e-5 1/bar", "time_constant": "1 ps"}
FRICTIONS = (0.1, 1, 5, 20)  # [1/ps]
# time between frames [fs]; frames of "properties" are samples of the shadow energy with a thermostat, and ends of trajectories
# in hybrid Monte Carlo
FRAMES = {"properties": 40, "structure": 100}


def langevin(friction):
    """The name of an ensemble."""
    return "Langevin" if friction == 1 else f"Langevin, {friction:g}/ps"


ENSEMBLES = {
    "constant energy": {}, SMALL: {}, LATE: {}, "rescaling": RESCALING,
    HALF: {"thermostat": {"type": "langevin", "friction": "1e-9 1/ps"}},
    "separate rescaling": {"thermostat": {"type": "separate-rescaling", "time_constant": "1 ps"}},
    **{langevin(friction): {"thermostat": {"type": "langevin", "friction": f"{friction} 1/ps"}} for friction in FRICTIONS},
    "hybrid Monte Carlo": {"hybrid_monte_carlo": {"steps": 25}},
    "constant pressure": {**RESCALING, "barostat": BAROSTAT},
    EXACT: {"hybrid_monte_carlo": {"steps": 25}, "barostat": BAROSTAT},
}


class Point(NamedTuple):
    group: str
    model: str
    temperature: float  # [K]
    density: float  # [g/cm³]
    ensemble: str
    scheme: str
    step: float  # [fs]
    length: float  # of a run [ps]


WATER = ("spce", 298.15, 0.998)
GROUPS = {  # (ensemble, length [ps], time steps [fs] of each scheme)
    "energy": [("constant energy", 100, {"velocity-verlet": (0.5, 1, 2, 3, 4), "hoa2": (2, 3, 4, 5, 6, 7), "bcss3": (3, 4.5, 6, 7.5, 9),
                                         "gier4-fd": (3, 4, 5, 6), "4mn5fv": (5, 7, 9)})],
    "starts": [(ensemble, 400, {"gier4-fd": (5,)}) for ensemble in ("constant energy", LATE, SMALL)],
    "new-starts": [("constant energy", 100, {"gier4-fd": (5,)})],
    "canonical": [("rescaling", 500, {"velocity-verlet": (2, 4), "hoa2": (4, 6)}), ("hybrid Monte Carlo", 500, {"hoa2": (4,)}),
                  ("separate rescaling", 500, {"velocity-verlet": (2, 4)}),
                  ("Langevin", 500, {"obabo": (2, 4, 6), "baoab": (2, 4, 6, 8, 9)})],
    "friction": [(langevin(friction), 250, {"obabo": (4, 8), "baoab": (4, 8)}) for friction in FRICTIONS],
    "properties": [("constant energy", 100, {"velocity-verlet": (0.5, 1, 2, 4), "hoa2": (4,), "gier4-fd": (5,)}),
                   ("rescaling", 100, {"velocity-verlet": (2, 4), "hoa2": (4, 6)})],
    "structure": [("hybrid Monte Carlo", 250, {"hoa2": (4,)}), ("Langevin", 250, {"baoab": (2, 4, 6, 8), "obabo": (4,)})],
    "half-steps": [(HALF, 100, {"baoab": (1, 2, 4)})],
    "conserved": [("rescaling", 100, {"velocity-verlet": (4,), "gier4-fd": (4, 5, 6), "4mn5fv": (7,)})],
    "quick": [("constant energy", 30, {"velocity-verlet": (0.5, 1, 2, 4), "hoa2": (2, 4, 6), "gier4-fd": (3, 4, 5)})],
}
PAIRS = (("velocity-verlet", 2), ("velocity-verlet", 4), ("hoa2", 4), ("hoa2", 6))
# Initial densities: the densities of TIP4P/2005 at 1 bar [abascal2005].
TIP4P_2005 = {257: 0.995, 267: 0.999, 277: 1.000, 287: 0.9995, 298: 0.997, 308: 0.994, 318: 0.990}
POINTS = [Point(group, *WATER, ensemble, scheme, step, length) for group, of in GROUPS.items() for ensemble, length, schemes in of
          for scheme, steps in schemes.items() for step in steps]
# The bias of the compressibility follows from the dependence of the pressure bias on the density.
POINTS += [Point("compression", "spce", 298.15, density, "rescaling", scheme, step, 100) for density in (0.978, 0.998, 1.018) for scheme, step in PAIRS]
POINTS += [Point("density", "tip4p-2005", T, density, "constant pressure", scheme, step, 500) for T, density in TIP4P_2005.items()
           for scheme, step in (*PAIRS[:3], ("gier4-fd", 4))]
# The density of gier4-fd against a density without any time-step bias, at the temperature where the volume relaxes fastest.
POINTS += [Point("decision", "tip4p-2005", 318, TIP4P_2005[318], ensemble, scheme, 4, 500) for ensemble, scheme in (
    ("constant pressure", "gier4-fd"), (EXACT, "hoa2"), ("constant pressure", "velocity-verlet"))]
# The same question with a reference of less noise: gier4-fd at 2 fs, whose bias is a sixteenth or less.
POINTS += [Point("short-step", "tip4p-2005", 318, TIP4P_2005[318], "constant pressure", "gier4-fd", step, 500) for step in (4, 2)]
# One short run for each kind of run.
SMOKE = [Point(group, *WATER, ensemble, scheme, 4, 1) for group, ensemble, scheme in (
    ("energy", SMALL, "velocity-verlet"), ("energy", SMALL, "hoa2"), ("canonical", "rescaling", "velocity-verlet"),
    ("friction", langevin(20), "baoab"), ("properties", "constant energy", "velocity-verlet"), ("structure", "hybrid Monte Carlo", "hoa2"),
    ("half-steps", HALF, "baoab"), ("conserved", "rescaling", "velocity-verlet"), ("density", "constant pressure", "velocity-verlet"), ("decision", EXACT, "hoa2"), ("short-step", "constant pressure", "gier4-fd"))]


def run_tables(point, seed, equilibrate):
    """The tables of a run. At constant energy the n-th runs of all points have the same initial configuration, and are compared with each other.
    With a thermostat every run has a different seed, because a common seed would share the noise among points."""
    small, pressure = point.ensemble == SMALL, "barostat" in ENSEMBLES[point.ensemble]
    if not point.ensemble.startswith("constant energy"):
        seed = zlib.crc32(repr((*point, seed)).encode())
    brackets = point.ensemble in ("rescaling", "constant pressure") and point.scheme not in FOURTH_ORDER
    return {"system": {"molecules": runs.molecules(point.model, 64 if small else 216), "density": f"{point.density} g/cm3",
                       "temperature": f"{point.temperature} K", "seed": seed},
            # The long-range dispersion correction shifts energy and pressure by constants, so it matters only at constant pressure.
            "forces": {"precision": "mixed", "cutoff": f"{0.6 if small else 0.85} nm", "electrostatics": "pme",
                       "dispersion_correction": pressure or None},
            "integrator": {"scheme": point.scheme, "step": f"{point.step} fs"},
            "run": {"equilibrate": f"{equilibrate} ps", "length": f"{point.length} ps", "sample": "20 fs",
                    "configurational_sample": "200 fs", "shadow_sample": "40 fs" if brackets else None},
            "output": {"prefix": "run", "trajectory_every": f"{FRAMES.get(point.group, 0)} fs", "formats": ["trr"], "plot": "none"},
            **ENSEMBLES[point.ensemble]}


def equilibration(point):
    """[ps]"""
    return 100 if point.ensemble == LATE else 50 if point.group in ("decision", "short-step") else 30 if point.group in ("canonical", "density", "structure") else 10


def line(o, point, seed):
    """The data that a run adds to the record."""
    with runs.scratch() as folder:
        report = runs.run(o, run_tables(point, seed, 0.5 if o.smoke else equilibration(point)), folder)
        found = {"point": list(point), "seed": seed, **{name: report.get(name) for name in tables.KEPT}, "seconds": report["seconds"]["all"]}
        if point.group in FRAMES:  # g(r) and dielectric constant; with the energies also their bias
            energies = ["--energies", "run-energies.csv"] if point.group == "properties" else []
            said = runs.asked(o, "analyze", "run-trajectory.trr", "--run", "run.toml", "--names", "run-final.gro", *energies, "--what", "rdf,dielectric",
                              "--pairs", "OW-OW, OW-HW", "--cutoff", "0.6 nm", "--plot", "none", "--threads", 1, folder=folder)
            found["analysis"] = {name: said[name] for name in ("rdf", "dielectric", "frames", "notes")}
        if point.group == "conserved":
            columns = runs.asked(o, "bias", "run-energies.csv", "--temperature", f"{point.temperature} K", folder=folder)["columns"]
            found["log_bias"] = {one["name"]: one["bias"]["value"] for one in columns if one["name"] in compared.LOGGED}
    barostat = (report["ensemble"] or {}).get("barostat")
    return found | ({name: barostat[name] for name in ("density_kg_per_m3", "volume_nm3", "compressibility_per_bar")} if barostat else {})


def known(record):
    """The lines of a record by point and seed."""
    lines = map(json.loads, record.read_text(encoding="utf-8").splitlines()) if record.exists() else ()
    return {(Point(*one["point"]), one["seed"]): one for one in lines}


def complete(o, lines):
    """Performs the runs that are missing in the record, the first runs of all points before the second runs."""
    points = [p for p in (SMOKE if o.smoke else POINTS) if p.group in o.groups]
    missing = [(p, seed) for seed in range(1, o.runs + 1) for p in points if (p, seed) not in lines]
    with o.record.open("a", encoding="utf-8") as record:
        def one(case):
            lines[case] = {**study.head(o), **line(o, *case)}
            record.write(json.dumps(lines[case]) + "\n")
            record.flush()
        runs.parallel(o, one, missing)


def report(points):
    """The tables of the groups that have runs."""
    of = lambda *groups: {p: runs for p, runs in points.items() if p.group in groups}
    energy = of("energy", "quick")
    starts = energy if energy and min(map(len, energy.values())) > 2 else {}
    parts = []
    for title, make, chosen in (("Force evaluations per ps for a required bias, at the same kinetic energy", compared.same_kinetic_energy, starts),
                                ("Force evaluations per ps for a required bias, at constant energy", tables.costs, energy),
                                ("Biases at the same kinetic energy", compared.biases_at_same_kinetic_energy, starts),
                                ("Constant energy", compared.constant_energy, energy),
                                ("Starts", tables.starts, of("starts")), ("New starts", tables.new_starts, of("new-starts")), ("Constant temperature", tables.controlled, of("canonical")),
                                ("Constant temperature, differences", compared.controlled, of("canonical")),
                                ("Constant temperature, two formulas", lambda chosen: compared.converted(energy, chosen), of("canonical") if starts else {}),
                                ("Conserved energy", compared.conserved, of("conserved")),
                                ("Estimators of the temperature", compared.estimators, of("half-steps")),
                                ("Friction", tables.friction, of("friction")), ("Structure", tables.structure, of("properties")),
                                ("Structure with Langevin thermostats", tables.structure_seen, of("structure")),
                                ("Compressibility", tables.compressibilities, of("compression")),
                                ("Constant pressure", compared.at_constant_pressure, of("density")),
                                ("Density with and without a time-step bias", compared.decided, of("decision")),
                                ("Density against a shorter step", compared.decided, of("short-step"))):
        if chosen:
            parts += [f"### {title}\n", make(chosen)]
    return "\n".join(parts)


def main():
    groups = [group for group in dict.fromkeys(p.group for p in POINTS) if group != "quick"]
    o = study.options(__doc__, {"runs": 1, "groups": groups}, runs=(4, "runs of each point"), quick=(False, "constant energy only, short runs: a few minutes"),
                      groups=(groups, "kinds of runs"))
    o.record = o.record.with_suffix(".jsonl") if o.record.suffix == ".json" else o.record
    o.groups = ["quick"] if o.quick else o.groups
    lines = known(o.record)
    if not o.report:
        complete(o, lines)
    points = tables.by_point(lines, o.groups)
    print(report(points))
    if o.figure:
        import half_femtosecond_figures as figures
        figures.draw(points, Path(o.figure))


if __name__ == "__main__":
    main()
