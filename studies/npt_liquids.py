# SPDX-License-Identifier: MIT
"""Liquids at constant temperature and pressure, as inputs for polhode and for GROMACS, from one description and the
molecule files of polhode."""

import sys
import tomllib
from math import dist, sqrt
from string import Template
from typing import NamedTuple

from lib.runs import QUIET, molecules
from lib.study import ROOT

sys.path.append(str(ROOT / "bench/peers"))
import gro  # noqa: E402

PRESSURE = 1e5 * 1e-27 * 6.02214076e23 / 1e3  # of 1 bar [kJ/mol/nm³]
BOLTZMANN = 1.380649e-23 * 6.02214076e23 / 1e3  # [kJ/mol/K]
GRAMS = 1e21 / 6.02214076e23  # of 1 u/nm³ [g/cm³]


class Liquid(NamedTuple):
    model: str
    density: float  # of the lattice from which the initial configuration is equilibrated [g/cm³]
    temperature: float  # [K]
    pressure: float  # [bar]
    compressibility: float  # estimated, sets the size of moves of both barostats [1/bar]
    cutoff: float  # [nm]
    gromacs_step: float  # [fs]
    published: str = ""
    count: int = 512

    @property
    def switch(self):
        return 0.85 * self.cutoff

    @property
    def sites(self):
        return tomllib.loads((ROOT / f"data/molecules/{self.model}.toml").read_text(encoding="utf-8"))["site"]

    @property
    def mass(self):
        """The mass of a molecule [u]."""
        return sum(number(s, "mass") for s in self.sites)


LIQUIDS = {liquid.model: liquid for liquid in (
    Liquid("spce", 0.998, 298.15, 1, 4.5e-5, 0.9, 1, "998 [berendsen1987], LJ cutoff 0.9 nm without correction, no Ewald sum"),
    Liquid("tip4p-2005", 0.998, 298.15, 1, 4.5e-5, 0.9, 1, "997.9 at 298 K [abascal2005]"),
    Liquid("co2", 1.05, 250, 100, 2e-4, 1.0, 2))}


def number(site, key):
    """A quantity of a molecule file in its unit there; 0 if it is absent."""
    return float(site.get(key, "0").split()[0])


def position(site):
    return tuple(float(x) for x in site["position"].split()[:3])


def forces(liquid, accuracy=1e-4, precision="mixed"):
    return {"electrostatics": "pme", "pme_accuracy": accuracy, "cutoff": f"{liquid.cutoff:g} nm", "switch": f"{liquid.switch:g} nm",
            "dispersion_correction": True, "precision": precision}


def lattice(liquid, equilibrate):
    """The tables of a run that equilibrates a lattice [ps], for the initial configuration."""
    return {"system": {"molecules": molecules(liquid.model, liquid.count), "density": f"{liquid.density:g} g/cm3",
                       "temperature": f"{liquid.temperature:g} K"},
            "forces": forces(liquid), "integrator": {"scheme": "gier4-fd", "step": "4 fs"},
            "run": {"equilibrate": f"{equilibrate:g} ps", "length": "0.02 ps"}, "output": {"prefix": f"{liquid.model}-start", **QUIET}}


def static(liquid, start, accuracy, precision):
    """The tables for `polhode energy`."""
    return {"system": {"molecules": molecules(liquid.model, liquid.count), "initial_configuration": start}, "forces": forces(liquid, accuracy, precision)}


def production(liquid, start, way, prefix):
    """The tables of a run at constant temperature and pressure; `way` names scheme, step and barostat."""
    return {"system": {"molecules": molecules(liquid.model, liquid.count), "initial_configuration": start, "velocities": "new",
                       "temperature": f"{liquid.temperature:g} K", "seed": way.seed},
            "forces": forces(liquid), "integrator": {"scheme": way.scheme, "step": f"{way.step:g} fs"}, "thermostat": {"type": way.thermostat},
            "barostat": {"type": way.barostat, "pressure": f"{liquid.pressure:g} bar", "compressibility": f"{liquid.compressibility:g} 1/bar",
                         "time_constant": "0.5 ps" if way.barostat == "cell-rescaling" else None},
            "run": {"length": "500 ps", "sample": "0.1 ps"},
            "output": {"prefix": prefix, "trajectory_every": "1 ps", "formats": ["gro"], "velocities": False, "plot": "none", "checkpoint_every": "1 min"}}


# GROMACS

class Atom(NamedTuple):
    name: str
    mass: float  # [u]
    charge: float  # [e]
    sigma: float  # [nm]
    epsilon: float  # [kJ/mol]


def atoms(liquid):
    """The atoms in GROMACS: the sites. A linear molecule has first two mass points, which replace the masses of the sites."""
    linear = is_linear(liquid.sites)
    found = [Atom(s["name"], 0 if linear else number(s, "mass"), *(number(s, k) for k in ("charge", "sigma", "epsilon")))
             for s in liquid.sites]
    return [Atom(f"D{k}", liquid.mass / 2, 0, 0, 0) for k in (1, 2)] + found if linear else found


def is_linear(sites):
    return all(position(s)[1:] == (0, 0) for s in sites)


def mass_points(sites):
    """Places on the axis of two equal masses that have the mass, the centre and the moment of inertia of the molecule."""
    places = [(number(s, "mass"), position(s)[0]) for s in sites]
    mass = sum(m for m, _ in places)
    centre = sum(m * x for m, x in places) / mass
    radius = sqrt(sum(m * (x - centre) ** 2 for m, x in places) / mass)
    return centre - radius, centre + radius


def rigid(liquid):
    """The lines of a topology that make the molecule rigid."""
    sites = liquid.sites
    if is_linear(sites):
        a, b = mass_points(sites)
        virtual = "\n".join(f"{k} 1 2 1 {(position(s)[0] - a) / (b - a):.12f}" for k, s in enumerate(sites, 3))
        return f"[ constraints ]\n1 2 1 {b - a:.12f}\n\n[ virtual_sites2 ]\n{virtual}"
    o, h1, h2 = (position(s) for s in sites[:3])
    text = f"[ settles ]\n1 1 {dist(o, h1):.12f} {dist(h1, h2):.12f}"
    if len(sites) == 4:  # on the bisector
        share = dist(o, position(sites[3])) / dist(o, [(x + y) / 2 for x, y in zip(h1, h2)]) / 2
        text += f"\n\n[ virtual_sites3 ]\n4 1 2 3 1 {share:.12f} {share:.12f}"
    return text


def topology(liquid):
    own = atoms(liquid)
    kind = lambda a: "A" if a.mass else "D"
    numbers = range(1, len(own) + 1)
    return "\n".join([
        "[ defaults ]", "1 2 no 1.0 1.0", "[ atomtypes ]",
        *(f"{a.name} {a.mass:.6f} {a.charge:.6f} {kind(a)} {a.sigma:.14g} {a.epsilon:.14g}" for a in own),
        "[ moleculetype ]", "MOL 1", "[ atoms ]",
        *(f"{k} {a.name} 1 MOL {a.name} {k} {a.charge:.6f} {a.mass:.6f}" for k, a in enumerate(own, 1)),
        rigid(liquid), "[ exclusions ]",
        *(" ".join(map(str, [k, *(n for n in numbers if n != k)])) for k in numbers),
        "[ system ]", liquid.model, "[ molecules ]", f"MOL {liquid.count}", ""])


def coordinates(liquid, text, title=""):
    """Converts a GRO file of polhode to GROMACS: adds the mass points of linear molecules, and removes velocities."""
    read, size, own = gro.read(text), len(liquid.sites), atoms(liquid)
    places = []
    for m in range(liquid.count):
        sites = read.positions[m * size : (m + 1) * size]
        if is_linear(liquid.sites):
            xs = [position(s)[0] for s in liquid.sites]
            axis = [(q - p) / (xs[2] - xs[1]) for p, q in zip(sites[1], sites[2])]
            places += [[c + (x - xs[0]) * e for c, e in zip(sites[0], axis)] for x in mass_points(liquid.sites)]
        places += sites
    return gro_text(title or liquid.model, [("MOL", a.name) for a in own] * liquid.count, len(own), places, read.box)


def expanded(liquid, text, factor):
    """A GRO file with the edges and the centres of mass scaled, molecules unchanged, without velocities."""
    read, size = gro.read(text), len(liquid.sites)
    masses = [number(s, "mass") for s in liquid.sites]
    places = []
    for m in range(liquid.count):
        own = read.positions[m * size : (m + 1) * size]
        centre = [sum(w * r[k] for w, r in zip(masses, own)) / liquid.mass for k in range(3)]
        places += [[x + (factor - 1) * c for x, c in zip(r, centre)] for r in own]
    return gro_text(liquid.model, read.labels, size, places, [factor * edge for edge in read.box])


def gro_text(title, labels, size, positions, box):
    lines = [f"{k // size + 1:5d}{residue:>5}{name:>5}{(k + 1) % 100000:5d}" + "".join(f"{x:15.10f}" for x in r)
             for k, ((residue, name), r) in enumerate(zip(labels, positions))]
    return "\n".join([title, f"{len(lines):5d}", *lines, "".join(f"{edge:15.10f}" for edge in box)]) + "\n"


MDP = Template("""; NPT with potential-switched Lennard-Jones and its dispersion correction, as polhode has them, and an accurate mesh
integrator              = md
dt                      = ${step_ps}
nsteps                  = ${steps}
continuation            = ${continuation}
gen-vel                 = ${new_velocities}
gen-temp                = ${temperature}
gen-seed                = 1
cutoff-scheme           = Verlet
verlet-buffer-tolerance = 2e-4
nstlist                 = 20
vdwtype                 = cut-off
vdw-modifier            = potential-switch
rvdw-switch             = ${switch}
rvdw                    = ${cutoff}
DispCorr                = EnerPres
coulombtype             = PME
rcoulomb                = ${cutoff}
fourierspacing          = 0.10
pme-order               = 5
ewald-rtol              = 1e-6
constraint-algorithm    = lincs
lincs-order             = 6
lincs-iter              = 2
comm-mode               = linear
tcoupl                  = ${thermostat}
tc-grps                 = System
tau-t                   = 0.5
ref-t                   = ${temperature}
ld-seed                 = 1
pcoupl                  = ${barostat}
pcoupltype              = isotropic
tau-p                   = 0.5
compressibility         = ${compressibility}
ref-p                   = ${pressure}
nstcalcenergy           = 10
nsttcouple              = 10
nstpcouple              = 10
nstenergy               = ${sample_steps}
nstlog                  = 100000
""")


def parameters(liquid, steps):
    """The mdp file of a run, or of the energy of the initial configuration: steps = 0."""
    static = steps == 0
    return MDP.substitute(
        step_ps=liquid.gromacs_step / 1000, steps=steps, continuation="yes" if static else "no",
        new_velocities="no" if static else "yes", thermostat="no" if static else "v-rescale",
        barostat="no" if static else "C-rescale", temperature=liquid.temperature, pressure=liquid.pressure,
        compressibility=liquid.compressibility, cutoff=liquid.cutoff, switch=liquid.switch,
        sample_steps=1 if static else round(100 / liquid.gromacs_step))
