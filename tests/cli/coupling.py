# SPDX-License-Identifier: MIT
"""The chemical potential by polhode measure: argon against Widom's insertion into configurations of other runs, and what cannot
be coupled in stages."""

import json
import random
from math import exp, log, pi

import sandbox
from sandbox import Sandbox

KB = 0.0083144626  # [kJ/mol/K]
SIGMA, EPSILON, CUTOFF, SWITCH = 0.3405, 0.996072621655, 0.65, 0.55  # [nm], [kJ/mol]
T = 200.0
RUN = f"""[system]
molecules = [{{{{ model = "argon", count = {{count}} }}}}]
density = "0.9 g/cm3"
temperature = "{T:g} K"
seed = 5

[forces]
cutoff = "{CUTOFF} nm"
switch = "{SWITCH} nm"
dispersion_correction = true

[integrator]
scheme = "baoab"
step = "10 fs"

[run]
equilibrate = "20 ps"
length = "2 ns"
sample = "1 ps"

[thermostat]
type = "langevin"

[barostat]
type = "monte-carlo"
pressure = "300 bar"

[output]
formats = ["xyz"]
trajectory_every = "4 ps"
plot = "none"
prefix = "run"
"""


TWIN = f"""name = "twin"
source = "rowley1975"
[[site]]
name = "A"
element = "Ar"
position = "0 0 0 nm"
mass = "39.948 u"
sigma = "{SIGMA} nm"
epsilon = "{EPSILON} kJ/mol"
"""


def lennard_jones(r2):
    x = (SIGMA * SIGMA / r2) ** 3
    return 4 * EPSILON * (x * x - x)


def switched(r2):
    """The energy of a pair, with the polynomial of fifth degree by which the program switches it off."""
    if r2 >= CUTOFF * CUTOFF:
        return 0.0
    r = r2 ** 0.5
    x = max(0.0, (r - SWITCH) / (CUTOFF - SWITCH))
    return lennard_jones(r2) * (1 - x ** 3 * (10 - 15 * x + 6 * x * x))


def tail():
    """The integral of what the switch takes away, by the midpoint rule up to the cutoff [kJ/mol nm3]."""
    steps = 2000
    h = (CUTOFF - SWITCH) / steps
    middles = [SWITCH + (k + 0.5) * h for k in range(steps)]
    inside = sum((lennard_jones(r * r) - switched(r * r)) * r * r for r in middles) * h
    s6, c3 = SIGMA ** 6, CUTOFF ** 3
    return inside + 4 * EPSILON * (s6 * s6 / (9 * c3 ** 3) - s6 / (3 * c3))


def frames(path):
    """Edge and positions of each frame [nm]."""
    lines = iter(path.read_text().splitlines())
    for count in lines:
        edge = float(next(lines).split('Lattice="')[1].split()[0]) / 10
        yield edge, [[float(x) / 10 for x in next(lines).split()[1:4]] for _ in range(int(count))]


def insertion(edge, atoms, choose):
    """The energy of one more atom at a random place [kJ/mol]."""
    new = [choose.uniform(0, edge) for _ in range(3)]
    n, energy = len(atoms), 0.0
    for atom in atoms:
        r2 = 0.0
        for a, b in zip(new, atom):
            d = a - b
            d -= edge * round(d / edge)
            r2 += d * d
        energy += switched(r2)
    return energy + 2 * pi * tail_of_pair * ((n + 1) ** 2 - n * n) / edge ** 3


tail_of_pair = tail()


def excess(path, insertions):
    """The free energy of one more atom by Widom's insertion at constant pressure, with its error [kJ/mol]."""
    kT, choose = KB * T, random.Random(3)
    volumes, weights = [], []
    for edge, atoms in frames(path):
        mean = sum(exp(-insertion(edge, atoms, choose) / kT) for _ in range(insertions)) / insertions
        volumes.append(edge ** 3)
        weights.append(edge ** 3 * mean)
    blocks = 10  # of 200 ps
    size = len(weights) // blocks
    values = [-kT * log(sum(weights[k * size:(k + 1) * size]) / sum(volumes[k * size:(k + 1) * size])) for k in range(blocks)]
    mean = sum(values) / blocks
    return -kT * log(sum(weights) / sum(volumes)), (sum((x - mean) ** 2 for x in values) / (blocks - 1) / blocks) ** 0.5


class Coupling(Sandbox):
    found = None

    def measured(self, *words):
        process = self.polhode("measure", *words, "--json")
        self.assertEqual(process.returncode, 0, process.err)
        return json.loads(process.out)["points"][0]["properties"][0]

    def inserted(self):
        """The residual chemical potential by insertion, with its error; computed once for all tests."""
        if not Coupling.found:
            self.write("run.toml", RUN.format(count=63))
            self.assertEqual(self.polhode("run", "run.toml").returncode, 0)
            # The atom is inserted into 63 atoms; the density of the ideal gas is that of 64.
            value, error = excess(self.folder / "run-trajectory.xyz", 200)
            Coupling.found = value + KB * T * log(64 / 63), error
        return Coupling.found

    def agrees(self, measured, largest):
        """A measured value is that of the insertions within four combined errors."""
        value, error = self.inserted()
        self.assertLess(error, 0.1)
        self.assertTrue(measured["reached"])
        self.assertLess(measured["value"]["error"], largest)
        self.assertLess(abs(measured["value"]["value"] - value), 4 * (error ** 2 + measured["value"]["error"] ** 2) ** 0.5)

    def test_the_chemical_potential_of_argon_is_that_of_widom_insertions(self):
        self.write("liquid.toml", RUN.format(count=64))
        self.agrees(self.measured("liquid.toml", "chemical-potential", "0.15 kJ/mol", "--at", f"{T:g} K, 300 bar"), 0.15)

    def test_hybrid_monte_carlo_has_the_same_free_energy_and_no_bias(self):
        self.write("liquid.toml", RUN.format(count=64))
        found = self.measured("liquid.toml", "chemical-potential", "0.3 kJ/mol", "--at", f"{T:g} K, 300 bar", "--sampling", "hybrid-monte-carlo")
        self.agrees(found, 0.3)
        self.assertIsNone(found["step_bias"])

    def test_a_solute_like_the_solvent_has_the_same_free_energy(self):
        self.write("twin.toml", TWIN)
        self.write("liquid.toml", RUN.format(count=63))
        self.agrees(self.measured("liquid.toml", "solvation-free-energy", "0.2 kJ/mol", "--solute", "twin.toml",
                                  "--at", f"{T:g} K, 300 bar"), 0.2)

    def test_a_resumed_coupling_has_the_same_records(self):
        words = ("argon", "chemical-potential", "0.6 kJ/mol", "--molecules", "32", "--at", "160 K, 500 bar", "--output", "out")
        self.measured(*words)
        whole = {name: data for name, data in self.contents().items() if name.endswith(".replica")}
        self.assertEqual(len(whole), 5)
        for name in whole:
            (self.folder / name).unlink()
        for limit in range(1, 60):  # longer each time, so that also a slow machine completes its segments
            self.polhode("measure", *words, "--time-limit", f"{limit} s")
            if whole == {name: data for name, data in self.contents().items() if name.endswith(".replica")}:
                return
        self.fail("the records differ")

    def test_what_cannot_be_coupled_is_refused(self):
        for words, reason in ((("na-spce", "chemical-potential"), "a charge of 1 e"),
                              (("argon", "solvation-free-energy"), "give the option solute"),
                              (("argon 60, krypton 4", "vapour-pressure"), "differs in composition"),
                              (("argon", "solvation-free-energy", "--solute", "nothing"), "nothing"),
                              (("argon", "vapour-pressure", "--at", "160 K, 1300 kg/m3"), "constant pressure")):
            process = self.polhode("measure", *words)
            self.assertEqual(process.returncode, 2)
            self.assertIn(reason, process.err)


if __name__ == "__main__":
    sandbox.main()
