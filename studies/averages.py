# SPDX-License-Identifier: MIT
"""Compares the stated errors of the averages of a run with the scatter of these averages over many runs of the same
system.

Each run begins with the final state of the previous run, so all runs at constant energy have the same energy, and all runs sample the
same equilibrium. The errors that a run states are compared with the scatter of all runs."""

from math import sqrt
from pathlib import Path

from lib import runs, study
from lib.statistics import over_scatter

SYSTEMS = {  # molecules, [system], [forces], step [fs]
    "argon": (("argon", 108), {"density": "1.3 g/cm3", "temperature": "100 K"}, {"cutoff": "0.7 nm"}, 15),
    "nitrogen": (("n2", 32), {"density": "0.6 g/cm3", "temperature": "110 K"}, {"cutoff": "0.6 nm"}, 10),
    "water": (("tip4p", 64), {"density": "0.997 g/cm3", "temperature": "330 K"}, {"cutoff": "0.6 nm", "electrostatics": "reaction-field"}, 4),
}
# A pressure at which the density is about the density in SYSTEMS, and the compressibility, which only sets the size of barostat
# moves. The box of 64 water molecules is too small for simulations at constant pressure.
PRESSURES = {"argon": (200, 2e-4), "nitrogen": (100, 4e-4)}
LANGEVIN = {"thermostat": {"type": "langevin", "friction": "2 1/ps"}}
ENSEMBLES = ("constant energy", "Langevin", "rescaling", "constant pressure", "hybrid Monte Carlo")


def bath(system, ensemble):
    """The tables of an ensemble."""
    if ensemble == "constant pressure":
        pressure, compressibility = PRESSURES[system]
        return {**LANGEVIN, "barostat": {"pressure": f"{pressure} bar", "compressibility": f"{compressibility} 1/bar", "time_constant": "0.5 ps"}}
    return {"constant energy": {}, "Langevin": LANGEVIN, "rescaling": {"thermostat": {"type": "rescaling", "time_constant": "0.5 ps"}},
            "hybrid Monte Carlo": {"hybrid_monte_carlo": {"steps": 10}}}[ensemble]


def averages(report):
    """(name, value, error) of every average of a report; error None where it is not known. The total energy at constant
    energy is left out. Each run begins with rounded coordinates, and rounding changes the total energy by more than its
    fluctuations."""
    for name, unit in (("potential", "kJ_per_mol"), ("total", "kJ_per_mol"), ("temperature", "K"),
                       ("temperature_translation", "K"), ("pressure", "bar"), ("rms_potential", "kJ_per_mol")):
        if report["ensemble"] or name != "total":
            yield name, report[f"{name}_{unit}"], report[f"{name}_error_{unit}"]
    yield "R", report["R"], report["R_error"]
    for k, (value, error) in enumerate(zip(report["temperature_rotation_K"], report["temperature_rotation_error_K"])):
        if report["degrees_of_freedom_rotation"][k] > 0:
            yield f"temperature_rotation_{k + 1}", value, error
    for part in ("barostat", "hybrid_monte_carlo"):
        for name, estimate in ((report["ensemble"] or {}).get(part) or {}).items():
            if isinstance(estimate, dict) and "error" in estimate:
                yield name, estimate["value"], estimate["error"]


def chain(o, system, ensemble):
    """The averages of every run, except for the first, which equilibrates."""
    molecules, place, forces, step = SYSTEMS[system]
    found, place = {}, dict(place)
    with runs.scratch() as folder:
        for k in range(o.runs + 1):
            tables = {"system": {"molecules": runs.molecules(*molecules), **place, "seed": k + 1}, "forces": forces,
                      "integrator": {"scheme": "hoa2", "step": f"{step} fs"},
                      "run": {"equilibrate": f"{0 if k else min(10, o.length):g} ps", "length": f"{o.length:g} ps",
                              "sample": f"{(10 if 'hybrid' in ensemble else 4) * step} fs"},
                      "output": {"prefix": f"run{k % 2}", **runs.QUIET}, **bath(system, ensemble)}
            report = runs.run(o, tables, folder)
            place = {"initial_configuration": str(Path(folder, f"run{k % 2}-final.gro")), "temperature": place["temperature"]}
            for name, value, error in averages(report) if k else ():
                found.setdefault(name, []).append((value, error))
    return found


def rows(system, ensemble, found):
    """For each average: the number of runs with an error, their rms, the scatter, and the ratio with its error by chance."""
    for name, pairs in found.items():
        known = sum(error is not None for _, error in pairs)
        if compared := over_scatter(pairs):
            stated, scatter, ratio = compared
            yield {"system": system, "ensemble": ensemble, "average": name, "known": known, "runs": len(pairs), "stated": stated, "scatter": scatter,
                   "ratio": ratio, "ratio_error": ratio / sqrt(2 * (known - 1))}


def measured(o):
    cases = [(s, e) for s in o.systems for e in o.ensembles if e != "constant pressure" or s in PRESSURES]
    return {"averages": [row for case, found in zip(cases, runs.parallel(o, lambda c: chain(o, *c), cases)) for row in rows(*case, found)]}


def report(result):
    return study.table(["system", "ensemble", "average", "runs with an error", "stated error, rms", "scatter", "stated / scatter"],
                       [[r["system"], r["ensemble"], r["average"], f"{r['known']} of {r['runs']}", f"{r['stated']:.3g}", f"{r['scatter']:.3g}",
                         f"{r['ratio']:.2f} ± {r['ratio_error']:.2f}"] for r in result["averages"]])


if __name__ == "__main__":
    o = study.options(__doc__, {"systems": ["nitrogen"], "runs": 3, "length": 4.0}, systems=(list(SYSTEMS), "systems"),
                      ensembles=(list(ENSEMBLES), "ensembles"), runs=(100, "runs of each"), length=(30.0, "length of a run [ps]"))
    study.perform(o, measured, report)
