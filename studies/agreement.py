# SPDX-License-Identifier: MIT
"""Whether all thermostats, hybrid Monte Carlo and constant energy agree for short steps: potential energy, pressure and first peak
of g(r) of water.

The run at constant energy begins from the last state of another one, whose velocities are scaled once, so that its total energy is
the mean one at the temperature."""

from math import sqrt
from pathlib import Path

import numpy as np
from lib import runs, study
from lib.slopes import BOLTZMANN
from lib.statistics import block_mean, rms, text

TEMPERATURE = 300  # [K]
BLOCK = 10  # several relaxation times of potential energy and pressure [ps]
LANGEVIN = {"thermostat": {"type": "langevin", "friction": "2 1/ps"}}


def rescaling(kind):
    return {"thermostat": {"type": kind, "time_constant": "0.2 ps"}}


METHODS = {  # scheme, step [fs], tables
    "Langevin at the ends": ("obabo", 1, LANGEVIN),
    "Langevin in the middle": ("baoab", 2, LANGEVIN),
    "rescaling": ("hoa2-ends", 2, rescaling("rescaling")),
    "separate rescaling": ("hoa2-ends", 2, rescaling("separate-rescaling")),
    "hybrid Monte Carlo": ("hoa2", 4, {"hybrid_monte_carlo": {"steps": 10}}),
    "constant energy": ("hoa2", 2, {}),
}
QUANTITIES = "potential energy [kJ/mol per molecule]", "pressure [bar]", "first peak of g(r), OW-OW"


def made(o, folder, method, place, seed, length, name=None, equilibrate=None):
    """The prefix of a run, which is performed unless the folder has it."""
    scheme, step, bath = METHODS[method]
    name = name or method.replace(" ", "-")
    tables = {"system": {"molecules": runs.molecules("spce", o.molecules), **place, "temperature": f"{TEMPERATURE} K", "seed": seed},
              "forces": {"precision": "mixed", "electrostatics": "reaction-field", "cutoff": f"{o.cutoff:g} nm", "switch": f"{0.88 * o.cutoff:g} nm"},
              "integrator": {"scheme": scheme, "step": f"{step} fs"},
              "run": {"length": f"{length:g} ps", "sample": "40 fs", "equilibrate": equilibrate},
              "output": {"prefix": name, "trajectory_every": "0.2 ps", "formats": ["xtc"], "plot": "none"}, **bath}
    runs.kept(folder, name, lambda: runs.run(o, tables, folder, name=name))
    return name


def results(o, folder, name):
    """The mean of each quantity, with its standard error."""
    samples = runs.columns(Path(folder, f"{name}-energies.csv"))
    samples = samples[samples["time"] >= o.skip]
    potential, pressure = (block_mean(samples[q], max(2, round((o.length - o.skip) / BLOCK))) for q in ("potential", "pressure"))
    said = runs.asked(o, "analyze", f"{name}-trajectory.xtc", "--run", f"{name}.toml", "--what", "rdf", "--pairs", "OW-OW", "--from", f"{o.skip} ps",
                      "--bin", "0.004 nm", "--output", f"{name}-analysis", "--plot", "none", "--threads", 1, "--force", folder=folder)
    peak = said["rdf"][0]["peak_height"]
    return [tuple(x / o.molecules for x in potential), pressure, (peak["value"], peak["error"] or 0.0)]


def with_scaled_velocities(text, factor):
    """Reads a GRO file of polhode, whose number columns have 15 characters."""
    lines = text.splitlines()
    for k in range(2, len(lines) - 1):
        velocities = [factor * float(lines[k][at:at + 15]) for at in (65, 80, 95)]
        lines[k] = lines[k][:65] + "".join(f"{v:15.11f}" for v in velocities)
    return "\n".join(lines) + "\n"


def match_energy(o, folder, potential):
    """Writes the last state of the rescaling run, scaled to the mean total energy <U> + n kT/2 with n = 6 N - 3."""
    last = runs.columns(Path(folder, "rescaling-energies.csv")).iloc[-1]
    required = potential + (6 * o.molecules - 3) * BOLTZMANN * TEMPERATURE / 2 - last["potential"]
    factor = sqrt(required / (last["kinetic_translation"] + last["kinetic_rotation"]))
    text = Path(folder, "rescaling-final.gro").read_text(encoding="utf-8")
    Path(folder, "matched.gro").write_text(with_scaled_velocities(text, factor), encoding="utf-8")


def measured(o):
    thermal = list(METHODS)[:-1]
    with runs.scratch(o) as folder:
        made(o, folder, "rescaling", {"density": f"{o.density:g} g/cm3"}, o.seed, 1, "start", f"{o.skip} ps")
        place = {"initial_configuration": "start-final.gro", "velocities": "new"}
        one = lambda k: results(o, folder, made(o, folder, thermal[k], place, o.seed + k + 1, o.length))
        found = runs.parallel(o, one, range(len(thermal)))
        match_energy(o, folder, o.molecules * np.mean([r[0][0] for r in found]))
        found.append(results(o, folder, made(o, folder, "constant energy", {"initial_configuration": "matched.gro"}, o.seed, o.length)))
    return {"results": dict(zip(METHODS, found))}


def deviations(values):
    """The deviation of each (mean, error) from the mean of all others, in standard errors of the difference."""
    found = []
    for k, (value, error) in enumerate(values):
        others = values[:k] + values[k + 1:]
        variance = error**2 + sum(e**2 for _, e in others) / len(others)**2
        found.append((value - np.mean([v for v, _ in others])) / sqrt(variance))
    return found


def report(result):
    of = result["results"]
    away = np.array([deviations([r[q] for r in of.values()]) for q in range(len(QUANTITIES))])
    rows = [[name, "{}, {} fs".format(*METHODS[name]), *(f"{text(r[q], d)} ({away[q][k]:+.1f})" for q, d in enumerate((3, 0, 4)))]
            for k, (name, r) in enumerate(of.items())]
    return study.table(["method", "scheme, step", *QUANTITIES], rows) + (
        f"\n{away.size} differences: rms {rms(away):.2f}, largest {abs(away).max():.2f} standard errors.")


if __name__ == "__main__":
    o = study.options(__doc__, {"molecules": 64, "cutoff": 0.6, "length": 4.0, "skip": 1.0}, molecules=(216, "waters"), cutoff=(0.85, "cutoff [nm]"),
                      density=(0.998, "density [g/cm3]"), length=(200.0, "length of each run [ps]"), skip=(10.0, "left out at the beginning [ps]"),
                      seed=(1, "of the first run"))
    study.perform(o, measured, report)
