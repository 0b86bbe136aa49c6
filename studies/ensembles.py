# SPDX-License-Identifier: MIT
"""A test of whether runs sample their ensemble, for every thermostat, barostat and hybrid Monte Carlo.

Pairs of runs at two temperatures and at two pressures: the log ratio of the densities of potential energy (or volume) has the slope
that theory gives (lib/slopes.py). A second test is at a single temperature: potential energy and pressure agree for all
thermostats, hybrid Monte Carlo and constant energy."""

from math import erfc, sqrt
from pathlib import Path

import numpy as np
from lib import runs, study
from lib.slopes import check
from lib.statistics import correlated_mean, rms

TEMPERATURES = 300, 340  # [K]: potential energies of small systems overlap
SHORT = {"cutoff": "0.52 nm", "switch": "0.46 nm"}  # small boxes; sampling is exact for any potential, also with a short cutoff
FIELD, PME = ({**SHORT, "electrostatics": kind} for kind in ("reaction-field", "pme"))
SYSTEMS = {  # molecules, density [g/cm³], pressures [bar], [forces], compressibility [1/bar]
    "water, reaction field": (("spce", 64), 0.98, (1, 1200), FIELD, 4.5e-5),
    "water, PME": (("spce", 64), 0.98, (1, 1200), PME, 4.5e-5),
    "CO2": (("co2", 64), 0.95, (600, 1000), {"cutoff": "0.7 nm", "switch": "0.6 nm"}, 3e-4),
    "salt water, PME": (("spce", 58, "na-spce", 3, "cl-spce", 3), 1.05, (1, 1200), PME, 4.5e-5),
}
LANGEVIN = {"thermostat": {"type": "langevin", "friction": "2 1/ps"}}
HYBRID = {"hybrid_monte_carlo": {"steps": 20}}


def rescaling(kind="rescaling"):
    return {"thermostat": {"type": kind, "time_constant": "0.2 ps"}}


def barostat(kind, every=80, **more):
    return {"barostat": {"type": kind, "every": f"{every} fs", **more}}


CELL = barostat("cell-rescaling", time_constant="0.5 ps")
PUBLISHED = barostat("cell-rescaling", 20, time_constant="1 ps", metropolis=False)  # its bias is that of the interval
METHODS = {  # name: scheme, tables
    "langevin": ("hoa2-ends", LANGEVIN), "baoab": ("baoab", LANGEVIN), "rescaling": ("hoa2-ends", rescaling()),
    "separate-rescaling": ("hoa2-ends", rescaling("separate-rescaling")), "hybrid Monte Carlo": ("hoa2", HYBRID),
    "langevin, cell-rescaling": ("hoa2-ends", LANGEVIN | CELL),
    "langevin, cell-rescaling as published": ("hoa2-ends", LANGEVIN | PUBLISHED),
    "rescaling, cell-rescaling": ("hoa2-ends", rescaling() | CELL),
    "langevin, monte-carlo": ("hoa2-ends", LANGEVIN | barostat("monte-carlo")),
    "hybrid Monte Carlo, monte-carlo": ("hoa2", HYBRID | barostat("monte-carlo")),
}
CONSTANT_ENERGY = "constant energy"


def quantity(method):
    return "volume" if "barostat" in METHODS[method][1] else "potential"


def series(o, system, method, temperature, pressure, seed):
    """The samples of a run, without an initial part in which the method equilibrates ([run] equilibrate only sets the temperature)."""
    molecules, density, _, forces, compressibility = SYSTEMS[system]
    scheme, bath = METHODS.get(method, ("hoa2", {}))
    if "barostat" in bath:
        bath = bath | {"barostat": bath["barostat"] | {"pressure": f"{pressure} bar", "compressibility": f"{compressibility} 1/bar"}}
    tables = {"system": {"molecules": runs.molecules(*molecules), "density": f"{density} g/cm3", "temperature": f"{temperature} K", "seed": seed},
              "forces": {"precision": "mixed", **forces}, "integrator": {"scheme": scheme, "step": "4 fs"},
              "run": {"equilibrate": f"{o.equilibrate:g} ps", "length": f"{o.length:g} ps", "sample": "80 fs"},
              "output": {"prefix": "run", **runs.QUIET}, **bath}
    with runs.scratch() as folder:
        runs.run(o, tables, folder)
        samples = runs.columns(Path(folder, "run-energies.csv"))
    return samples.iloc[len(samples) // 10:]


def states(system, of):
    """(temperature, pressure) of a pair: two temperatures for the potential energy, two pressures for the volume."""
    pressures = SYSTEMS[system][2]
    return [(T, pressures[0]) for T in TEMPERATURES] if of == "potential" else [(TEMPERATURES[0], P) for P in pressures]


def slopes(o, found):
    """The slope of every pair, and the slope that theory gives."""
    result = []
    for s in o.systems:
        for m in o.methods:
            at, of = states(s, quantity(m)), quantity(m)
            x = [found[s, m, *state][of].to_numpy() for state in at]
            result.append({"system": s, "method": m, "quantity": of, **check(of, *x, *({"temperature": T, "pressure": P} for T, P in at))})
    return result


def agreement(o, found):
    """Means of potential energy and pressure at the lower temperature, by method. Means at constant energy are shifted to this temperature
    with derivatives from a pair of runs."""
    result = []
    for s in o.systems:
        (low, P), (high, _) = states(s, "potential")
        here = [m for m in o.methods if quantity(m) == "potential"]
        for of in ("potential", "pressure"):
            group = [(m, *correlated_mean(found[s, m, low, P][of])) for m in here]
            if here:
                a, b = (np.mean([found[s, m, T, P][of].mean() for m in here]) for T in (low, high))
                x = found[s, CONSTANT_ENERGY, low, 0]
                group.append((CONSTANT_ENERGY, *correlated_mean(x[of] - (b - a) / (high - low) * (x["temperature"] - low))))
            weights = np.array([error ** -2 for *_, error in group])
            for (m, mean, error), w in zip(group, weights):
                common = np.average([value for _, value, _ in group], weights=weights)
                # The common mean includes the compared mean, so the variance of the difference is reduced by the variance of
                # the common mean.
                result.append({"system": s, "method": m, "quantity": of, "mean": mean, "error": error,
                               "deviation": float((mean - common) / sqrt(max(1 / w - 1 / weights.sum(), 1e-300)))})
    return result


def measured(o):
    cases = [(s, m, *state) for s in o.systems for m in o.methods for state in states(s, quantity(m))]
    cases += [(s, CONSTANT_ENERGY, TEMPERATURES[0], 0) for s in o.systems]
    found = dict(zip(cases, runs.parallel(o, lambda case: series(o, *case, seed=o.seed + cases.index(case)), cases)))
    return {"slopes": slopes(o, found), "agreement": agreement(o, found)}


def report(result):
    z = np.array([r["deviation"] for r in result["slopes"]])
    of = {(r["system"], r["method"], r["quantity"]): r for r in result["agreement"]}
    cell = lambda r, d: f"{r['mean']:.{d}f} ± {r['error']:.{d}f} ({r['deviation']:+.1f})"
    return "\n".join([
        study.table(["system", "thermostat, barostat", "of", "slope", "expected", "deviation [standard errors]"],
                    [[r["system"], r["method"], r["quantity"], f"{r['slope']:.5g} ± {r['error']:.2g}", f"{r['expected']:.5g}", f"{r['deviation']:+.2f}"]
                     for r in result["slopes"]]),
        f"{len(z)} pairs: rms deviation {rms(z):.2f}, largest {abs(z).max():.2f}; {sum(abs(z) > 2)} beyond 2 standard errors, "
        f"where chance gives {len(z) * erfc(sqrt(2)):.1f}.\n",
        study.table(["system", f"at {TEMPERATURES[0]} K", "potential energy [kJ/mol]", "pressure [bar]"],
                    [[s, m, cell(of[s, m, "potential"], 2), cell(of[s, m, "pressure"], 0)] for s, m in dict.fromkeys((s, m) for s, m, _ in of)])])


if __name__ == "__main__":
    o = study.options(__doc__, {"systems": ["CO2"], "length": 20.0, "equilibrate": 1.0}, systems=(list(SYSTEMS), "systems"),
                      methods=(list(METHODS), "thermostats and barostats"), length=(400.0, "length of each run [ps]"),
                      equilibrate=(10.0, "time of rescaling before each run [ps]"), seed=(1, "of the first run"))
    study.perform(o, measured, report)
