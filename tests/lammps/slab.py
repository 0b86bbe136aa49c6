# SPDX-License-Identifier: MIT
"""The long-range dispersion of a slab against LAMMPS' mesh for dispersion, which assumes no shape: the same configuration, the same
energy and difference of pressures."""

import json
import random

import engine
from runs import BAR, KCAL, LAMMPS_PRESSURE, RunTest

EDGE, HEIGHT, CELL = 2.4, 7.2, 0.6  # [nm]
SIGMA, EPSILON = 0.3405, 0.996072621655  # of argon [nm], [kJ/mol]
RUN = """[system]
molecules = [{{ model = "argon", count = {count} }}]
initial_configuration = "slab.gro"
temperature = "0.001 K"  # no kinetic part of the pressure

[forces]
cutoff = "{cutoff} nm"
{correction} = true

[integrator]
scheme = "velocity-verlet"
step = "1 fs"

[run]
length = "1 fs"
"""
LAMMPS = f"""units real
atom_style charge
read_data slab.data
mass 1 39.948
kspace_style pppm/disp 1e-6
kspace_modify gewald/disp 0.3 mesh/disp 36 36 108 order/disp 6
pair_style lj/long/coul/long long off 11.9
pair_coeff 1 1 {EPSILON / KCAL:.15g} {10 * SIGMA}
compute virial all pressure NULL virial
thermo_style custom step pe c_virial[1] c_virial[2] c_virial[3]
thermo_modify norm no format float %.15g
run 0
"""


def places():
    """Atoms of a lattice in the middle third of the box, each displaced by chance [nm]."""
    chance = random.Random(3)
    for x in range(4):
        for y in range(4):
            for z in range(4):
                for a, b, c in ((0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)):
                    at = (x + a / 2, y + b / 2, z + c / 2)
                    yield [CELL * u + chance.uniform(-0.08, 0.08) + shift for u, shift in zip(at, (0.1, 0.1, HEIGHT / 3))]


class Slab(RunTest):
    def setUp(self):
        super().setUp()
        atoms = list(places())
        self.count = len(atoms)
        rows = [f"{k + 1:5d}{'argon':5s}{'Ar':>5s}{k + 1:5d}" + "".join(f"{x:14.9f}" for x in at) for k, at in enumerate(atoms)]
        self.write("slab.gro", "slab\n%d\n%s\n%g %g %g\n" % (self.count, "\n".join(rows), EDGE, EDGE, HEIGHT))
        rows = [f"{k + 1} 1 0 " + " ".join(f"{10 * x:.8f}" for x in at) for k, at in enumerate(atoms)]
        self.write("slab.data", f"slab\n\n{self.count} atoms\n1 atom types\n\n0 {10 * EDGE} xlo xhi\n0 {10 * EDGE} ylo yhi\n"
                                f"0 {10 * HEIGHT} zlo zhi\n\nAtoms # charge\n\n" + "\n".join(rows) + "\n")

    def energy_and_difference(self, cutoff, correction):
        """The potential energy [kJ/mol], and the normal minus the tangential pressure times the volume [kJ/mol]."""
        self.write("slab.toml", RUN.format(count=self.count, cutoff=cutoff, correction=correction))
        report = json.loads(self.polhode("energy", "slab.toml", "--json"))
        P = [report["pressure_tensor_bar"][i][i] / BAR for i in range(3)]
        return report["potential_kJ_per_mol"], (P[2] - (P[0] + P[1]) / 2) * EDGE**2 * HEIGHT

    def test_a_slab_has_the_energy_and_the_tension_of_the_whole_potential(self):
        table = self.lammps(LAMMPS)[0]
        exact = table["PotEng"][0] * KCAL
        P = [table[f"c_virial[{i}]"][0] for i in (1, 2, 3)]
        tension = (P[2] - (P[0] + P[1]) / 2) / LAMMPS_PRESSURE * KCAL * 1e3 * EDGE**2 * HEIGHT
        found, uniform = ([self.energy_and_difference(cutoff, correction) for cutoff in (0.85, 1.0, 1.15)]
                          for correction in ("slab_dispersion", "dispersion_correction"))
        # What the density of planes neglects is the structure of the liquid beyond the cutoff. Its sign changes with the cutoff, so
        # the differences between cutoffs show its size.
        for which, reference in ((0, exact), (1, tension)):
            values = [pair[which] for pair in found]
            wrong = min(abs(pair[which] - reference) for pair in uniform)
            for value in values:
                self.assertLess(abs(value - reference), max(values) - min(values))
            self.assertLess(abs(sum(values) / len(values) - reference), 0.2 * wrong)


if __name__ == "__main__":
    engine.main(__doc__)
