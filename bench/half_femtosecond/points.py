# SPDX-License-Identifier: MIT
"""What is run: water, ensemble, scheme and step of every point, and its run file."""

import zlib
from typing import NamedTuple

SMALL = "constant energy, 64 molecules"
LATE = "constant energy, after 100 ps"
MOLECULES = {SMALL: 64}  # 216 in all others
CUTOFF = {SMALL: 0.6}  # 0.85 nm
# Of one step, in force evaluations: what points are compared by.
EVALUATIONS = {"velocity-verlet": 1, "hoa2": 2, "bcss3": 3, "gier4-fd": 3, "4mn5fv": 5, "baoab": 1, "obabo": 1}
FOURTH_ORDER = ("gier4-fd", "4mn5fv")  # without a shadow energy to be sampled
RESCALING = '[thermostat]\ntype = "rescaling"\ntime_constant = "1 ps"\n'
BAROSTAT = '[barostat]\ntype = "cell-rescaling"\npressure = "1 bar"\ncompressibility = "4.5e-5 1/bar"\ntime_constant = "1 ps"\n'


def langevin(friction):
    """The name of an ensemble."""
    return "Langevin" if friction == 1 else f"Langevin, {friction:g}/ps"


# fs between frames; those of "properties" with a thermostat are samples of the shadow energy, those of hybrid Monte Carlo end its trajectories
FRAMES = {"properties": 40, "structure": 100}
LANGEVIN = '[thermostat]\ntype = "langevin"\nfriction = "{} 1/ps"\n'
FRICTIONS = (0.1, 1, 5, 20)  # [1/ps]
ENSEMBLES = {
    "constant energy": "",
    SMALL: "",
    LATE: "",
    "rescaling": RESCALING,
    "separate rescaling": RESCALING.replace("rescaling", "separate-rescaling"),
    **{langevin(friction): LANGEVIN.format(friction) for friction in FRICTIONS},
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
cutoff = "{cutoff} nm"
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
trajectory_every = "{frames} fs"
formats = ["trr"]
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


def equilibrate(point):
    """[ps]"""
    if point.ensemble == LATE:
        return 100
    return 30 if point.group in ("canonical", "density", "structure") else 10


def run_file(point, run):
    """At constant energy the n-th runs of all points have a common start, and are compared with each other; with a thermostat, whose
    noise a common seed would share among points, every run has a seed of its own."""
    constant_energy = point.ensemble.startswith("constant energy")
    seed = run if constant_energy else zlib.crc32(repr((*point, run)).encode())
    with_brackets = point.ensemble in ("rescaling", "constant pressure") and point.scheme not in FOURTH_ORDER
    return RUN_FILE.format(**{**point._asdict(), "ensemble": ENSEMBLES[point.ensemble]}, seed=seed,
                           molecules=MOLECULES.get(point.ensemble, 216), cutoff=CUTOFF.get(point.ensemble, 0.85),
                           frames=FRAMES.get(point.group, 0),
                           equilibrate=equilibrate(point),
                           correction="dispersion_correction = true" if point.ensemble == "constant pressure" else "",
                           shadow='shadow_sample = "40 fs"' if with_brackets else "")


def points(quick):
    """Every point. Those of one group have the same number of runs of the same length."""
    water = ("spce", 298.15, 0.998)
    return [Point("quick" if quick else group, *water, ensemble, scheme, step, 30 if quick else length)
            for group, ensemble, length, schemes in (QUICK if quick else GROUPS) for scheme, steps in schemes.items() for step in steps
            ] + ([] if quick else compressions() + densities())


GROUPS = [
    ("energy", "constant energy", 100, {
        "velocity-verlet": (0.5, 1, 2, 3, 4), "hoa2": (2, 3, 4, 5, 6, 7), "bcss3": (3, 4.5, 6, 7.5, 9), "gier4-fd": (3, 4, 5, 6),
        "4mn5fv": (5, 7, 9)}),
    ("canonical", "rescaling", 500, {"velocity-verlet": (2, 4), "hoa2": (4, 6)}),
    ("canonical", "hybrid Monte Carlo", 500, {"hoa2": (4,)}),
    ("canonical", "separate rescaling", 500, {"velocity-verlet": (2, 4)}),
    ("canonical", "Langevin", 500, {"obabo": (2, 4, 6), "baoab": (2, 4, 6, 8, 9)}),
]
GROUPS += [("friction", langevin(friction), 250, {"obabo": (4, 8), "baoab": (4, 8)}) for friction in FRICTIONS]
GROUPS += [("starts", ensemble, 400, {"gier4-fd": (5,)}) for ensemble in ("constant energy", LATE, SMALL)]
GROUPS += [("properties", "constant energy", 100, {"velocity-verlet": (0.5, 1, 2, 4), "hoa2": (4,), "gier4-fd": (5,)}),
           ("properties", "rescaling", 100, {"velocity-verlet": (2, 4), "hoa2": (4, 6)})]
GROUPS += [("structure", "hybrid Monte Carlo", 250, {"hoa2": (4,)}), ("structure", "Langevin", 250, {"baoab": (2, 4, 6, 8), "obabo": (4,)})]
QUICK = [("quick", "constant energy", 30, {"velocity-verlet": (0.5, 1, 2, 4), "hoa2": (2, 4, 6), "gier4-fd": (3, 4, 5)})]


def compressions():
    """How the bias of the pressure depends on the density, which is the bias of the compressibility."""
    return [Point("compression", "spce", 298.15, density, "rescaling", scheme, step, 100)
            for density in (0.978, 0.998, 1.018) for scheme, step in (("velocity-verlet", 2), ("velocity-verlet", 4), ("hoa2", 4), ("hoa2", 6))]


# Densities of TIP4P/2005 at 1 bar [abascal2005], to begin with.
TIP4P_2005 = {257: 0.995, 267: 0.999, 277: 1.000, 287: 0.9995, 298: 0.997, 308: 0.994, 318: 0.990}


def densities():
    return [Point("density", "tip4p-2005", T, density, "constant pressure", scheme, step, 500)
            for T, density in TIP4P_2005.items() for scheme, step in (("velocity-verlet", 2), ("velocity-verlet", 4), ("hoa2", 4), ("gier4-fd", 4))]
