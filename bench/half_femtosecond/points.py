# SPDX-License-Identifier: MIT
"""What is run: water, ensemble, scheme and step of every point, and its run file."""

import zlib
from typing import NamedTuple

MOLECULES = 216
# Of one step, in force evaluations: what points are compared by.
EVALUATIONS = {"velocity-verlet": 1, "hoa2": 2, "bcss3": 3, "gier4-fd": 3, "4mn5fv": 5, "baoab": 1, "obabo": 1}
RESCALING = '[thermostat]\ntype = "rescaling"\ntime_constant = "1 ps"\n'
BAROSTAT = '[barostat]\ntype = "cell-rescaling"\npressure = "1 bar"\ncompressibility = "4.5e-5 1/bar"\ntime_constant = "1 ps"\n'
ENSEMBLES = {
    "constant energy": "",
    "rescaling": RESCALING,
    "separate rescaling": RESCALING.replace("rescaling", "separate-rescaling"),
    "Langevin": '[thermostat]\ntype = "langevin"\nfriction = "1 1/ps"\n',
    "hybrid Monte Carlo": "[hybrid_monte_carlo]\nsteps = 25\n",
    "constant pressure": RESCALING + BAROSTAT,
}
# The correction for the truncated dispersion shifts energy and pressure by constants: it matters at constant pressure alone.
RUN_FILE = """[system]
molecules = [{{ model = "{model}", count = {molecules} }}]
density = "{density} g/cm3"
temperature = "{temperature} K"
seed = {seed}
[forces]
precision = "mixed"
cutoff = "0.85 nm"
electrostatics = "pme"
{correction}
[integrator]
scheme = "{scheme}"
step = "{step} fs"
[run]
equilibrate = "{equilibrate} ps"
length = "{length} ps"
sample = "20 fs"
configurational_sample = "200 fs"
{shadow}
[output]
prefix = "run"
trajectory_every = "0 ps"
plot = "none"
{ensemble}"""


class Point(NamedTuple):
    group: str
    model: str
    temperature: float  # [K]
    density: float  # [g/cm³]
    ensemble: str
    scheme: str
    step: float  # [fs]
    length: float  # of a run [ps]

    @property
    def evaluations_per_ps(self):
        return 1000 * EVALUATIONS[self.scheme] / self.step


def run_file(point, run):
    """At constant energy the n-th runs of all points have a common start, and are compared with each other; with a thermostat, whose
    noise a common seed would share among points, every run has a seed of its own."""
    constant_energy = point.ensemble == "constant energy"
    seed = run if constant_energy else zlib.crc32(repr((*point, run)).encode())
    with_brackets = point.ensemble in ("rescaling", "constant pressure")
    return RUN_FILE.format(**{**point._asdict(), "ensemble": ENSEMBLES[point.ensemble]}, molecules=MOLECULES, seed=seed,
                           equilibrate=10 if constant_energy else 30,
                           correction="dispersion_correction = true" if point.ensemble == "constant pressure" else "",
                           shadow='shadow_sample = "40 fs"' if with_brackets else "")


def points(quick):
    """Every point. Those of one group have the same number of runs of the same length."""
    water = ("spce", 298.15, 0.998)
    return [Point("quick" if quick else group, *water, ensemble, scheme, step, 30 if quick else length)
            for group, ensemble, length, schemes in (QUICK if quick else GROUPS) for scheme, steps in schemes.items() for step in steps
            ] + ([] if quick else densities())


GROUPS = [
    ("energy", "constant energy", 100, {
        "velocity-verlet": (0.5, 1, 2, 3, 4), "hoa2": (2, 3, 4, 5, 6, 7), "bcss3": (3, 4.5, 6, 7.5, 9), "gier4-fd": (3, 4, 5, 6),
        "4mn5fv": (5, 7, 9)}),
    ("canonical", "rescaling", 500, {"velocity-verlet": (2, 4), "hoa2": (4, 6)}),
    ("canonical", "hybrid Monte Carlo", 500, {"hoa2": (4,)}),
    ("canonical", "separate rescaling", 500, {"velocity-verlet": (2, 4)}),
    ("canonical", "Langevin", 500, {"obabo": (2, 4, 6), "baoab": (2, 4, 6, 8, 9)}),
]
QUICK = [("quick", "constant energy", 30, {"velocity-verlet": (0.5, 1, 2, 4), "hoa2": (2, 4, 6), "gier4-fd": (3, 4, 5)})]

# Densities of TIP4P/2005 at 1 bar [abascal2005], to begin with.
TIP4P_2005 = {257: 0.995, 267: 0.999, 277: 1.000, 287: 0.9995, 298: 0.997, 308: 0.994, 318: 0.990}


def densities():
    return [Point("density", "tip4p-2005", T, density, "constant pressure", scheme, step, 500)
            for T, density in TIP4P_2005.items() for scheme, step in (("velocity-verlet", 2), ("velocity-verlet", 4), ("hoa2", 4))]
