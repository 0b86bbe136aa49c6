# SPDX-License-Identifier: MIT
"""Whether `polhode.bias` corrects averages with Nosé-Hoover and Berendsen thermostats: velocity Verlet at 4 fs against 0.5 fs, over many seeds.

Needs the Python package. The thermostats multiply all momenta by one factor every 8 fs, at constant energy between these times; they are written here, so no
code of polhode knows about them. Each seed equilibrates its own liquid and continues from there with both steps. The criterion was
fixed before the runs. The mean difference of each corrected average is within three of its standard errors of zero. The mean difference of the potential energy
without the correction is not."""

from concurrent.futures import ProcessPoolExecutor
from functools import partial

import numpy as np
from lib import study
from lib.statistics import mean

GAS_CONSTANT = 8.31446261815324e-3  # [kJ/mol/K]
TEMPERATURE = 298  # [K]
INTERVAL = 8  # between actions of a thermostat [fs]
STEPS = (4, 0.5)  # [fs]
TITLES = {"potential": "potential energy [kJ/mol]", "translation": "translational energy [kJ/mol]", "rotation": "rotational energy [kJ/mol]"}


class NoseHoover:
    """The friction follows the kinetic energy K: dξ/dt = (K/K₀ - 1)/τ² [hoover1985]."""

    def __init__(self, time_constant):
        self.tau, self.friction = time_constant, 0.0

    def factors(self, relative_K, t):
        """The factors of velocities for the second half of the last interval and the first half of the next one."""
        first = np.exp(-self.friction * t / 2)
        self.friction += t / self.tau**2 * (relative_K * first**2 - 1)
        return first, np.exp(-self.friction * t / 2)


class Berendsen:
    """The kinetic energy relaxes to K₀ [berendsen1984]."""

    def __init__(self, time_constant):
        self.tau = time_constant

    def factors(self, relative_K, t):
        return np.sqrt(1 + t / self.tau * (1 / relative_K - 1)), 1.0


THERMOSTATS = {"Nosé-Hoover": NoseHoover, "Berendsen": Berendsen}


def scale(simulation, factor):
    with simulation.state.change() as state:
        state.momenta *= factor
        state.angular_momenta *= factor


def series(simulation, thermostat, length, molecules):
    """The energies after each action: columns of time, conserved energy, potential energy and kinetic energies."""
    K0 = (6 * molecules - 3) / 2 * GAS_CONSTANT * TEMPERATURE
    heat, rows = 0.0, []
    for k in range(round(1000 * length / INTERVAL)):
        simulation.run(f"{INTERVAL} fs")
        e = simulation.energies
        kinetic = np.array([e["kinetic_translation"], e["kinetic_rotation"]])
        first, second = thermostat.factors(kinetic.sum() / K0, INTERVAL / 1000)
        heat += (first**2 - 1) * kinetic.sum()
        at_action = first**2 * kinetic
        rows.append([k * INTERVAL / 1000, e["potential"] + at_action.sum() - heat, e["potential"], *at_action])
        heat += (second**2 - 1) * at_action.sum()
        scale(simulation, first * second)
    return np.array(rows).T


def corrected(columns, molecules):
    """The averages of a molecule without and with the correction, with its error."""
    import polhode

    time, conserved, *others = columns
    log = {"time (ps)": time, "conserved (kJ/mol)": conserved} | {f"{name} (kJ/mol)": x for name, x in zip(TITLES, others, strict=True)}
    said = polhode.bias(log, temperature=f"{TEMPERATURE} K", total="conserved", potential="potential")
    of = {column["name"].split(" ")[0]: column for column in said["columns"]}
    return {name: [of[name]["mean"]["value"] / molecules, of[name]["corrected"]["value"] / molecules] for name in TITLES}


def averages(seed, molecules, length, equilibrate):
    """The averages of a seed at both steps, with each thermostat."""
    import polhode

    liquid = {"molecules": "tip4p", "count": molecules, "density": "0.995 g/cm3", "temperature": f"{TEMPERATURE} K", "precision": "mixed",
              "electrostatics": "reaction-field", "cutoff": "0.6 nm", "switch": "0.51 nm", "scheme": "velocity-verlet", "seed": seed}
    start = polhode.Simulation(liquid, step="1 fs", minimise=True, thermostat="rescaling", thermostat_time_constant="0.1 ps", threads=1)
    start.run(f"{equilibrate} ps")
    found = {}
    for name, kind in THERMOSTATS.items():
        for step in STEPS:
            simulation = polhode.Simulation(liquid, step=f"{step} fs", threads=1)
            with simulation.state.change() as state:
                for of in ("positions", "orientations", "momenta", "angular_momenta"):
                    setattr(state, of, getattr(start.state, of))
            thermostat = kind(0.2)
            series(simulation, thermostat, equilibrate, molecules)
            found[f"{name}, {step:g} fs"] = corrected(series(simulation, thermostat, length, molecules), molecules)
    return found


def measured(o):
    one = partial(averages, molecules=o.molecules, length=o.length, equilibrate=o.equilibrate)
    with ProcessPoolExecutor(o.jobs) as pool:
        return {"seeds": list(pool.map(one, range(o.first, o.first + o.seeds)))}


def report(result):
    rows = []
    for name in THERMOSTATS:
        for key, title in TITLES.items():
            long, short = (np.array([seed[f"{name}, {step:g} fs"][key] for seed in result["seeds"]]) for step in STEPS)
            differences = [mean(list(d)) for d in (long - short).T]
            rows.append([name, title, *("{:.3g} ± {:.2g}".format(*d) for d in differences), len(long)])
    return study.table(["thermostat", "average", "4 fs minus 0.5 fs", "corrected", "seeds"], rows)


if __name__ == "__main__":
    o = study.options(__doc__, {"seeds": 2, "length": 2.0, "equilibrate": 0.2}, molecules=(64, "number of waters"), seeds=(60, "number of seeds"),
                      first=(11, "first seed; 1 and 2 were used for a trial"), length=(100.0, "length of each run [ps]"), equilibrate=(10.0, "equilibration [ps]"))
    study.perform(o, measured, report)
