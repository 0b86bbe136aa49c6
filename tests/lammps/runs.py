# SPDX-License-Identifier: MIT
"""Runs of polhode for the tests in LAMMPS: water and mixtures, their energies, and the comparison with an exported script."""

import csv
import math

from engine import LammpsTest

KCAL = 4.184  # kJ
AVOGADRO = 6.02214076e23  # constants as in base/units.hpp
COULOMB = 1.602176634e-19**2 * AVOGADRO / (4 * math.pi * 8.8541878128e-12) * 1e6  # kJ/mol nm
BAR = 1e25 / AVOGADRO  # a kJ/mol/nm³
LAMMPS_PRESSURE = 68568.415  # its constant in units real: a kcal/mol/Å³ in atmospheres, to 7 digits
VOLUME = 1.914577632688878  # of 64 waters [nm³]

RUN = """[system]
molecules = %(molecules)s
density = "%(density)s"
temperature = "297 K"
seed = 3
[forces]
truncation = "%(truncation)s"
electrostatics = "%(electrostatics)s"
cutoff = "0.58 nm"
switch = "0.45 nm"
precision = "%(precision)s"
mixing = "lorentz-berthelot"
[integrator]
scheme = "%(scheme)s"
step = "%(step)s fs"
lambda = 1
[run]
length = "%(length)s fs"
sample = "%(length)s fs"
[output]
prefix = "run"
plot = "none"
trajectory_every = "0 ps"
%(more)s
"""
WATER = {"molecules": '[{ model = "tip4p", count = 64 }]', "density": "1 g/cm3", "truncation": "molecule-switch",
         "electrostatics": "reaction-field", "precision": "double", "scheme": "velocity-verlet", "step": 1, "length": 20, "more": ""}

# Mixtures of all kinds of tops: asymmetric, linear, symmetric, atoms; one with an explicit pair.
MIXTURES = {
    "water and ions": {"molecules": '[{ model = "spce", count = 60 }, { model = "na-spce", count = 2 }, '
                                    '{ model = "cl-spce", count = 2 }]'},
    "CO2 and argon": {"molecules": '[{ model = "co2", count = 40 }, { model = "argon", count = 24 }]', "density": "0.9 g/cm3",
                      "more": '[[pair]]\nsites = ["co2.C", "argon.Ar"]\nsigma = "0.3 nm"\nepsilon = "0.5 kJ/mol"'},
    "benzene in water": {"molecules": '[{ model = "spce", count = 60 }, { model = "benzene", count = 1 }]', "density": "0.35 g/cm3"},
}


# Potentials other than Lennard-Jones, alone and with water.
OTHER_LAWS = {
    "Buckingham argon": {"molecules": '[{ model = "argon-buckingham", count = 64 }]', "density": "1.2 g/cm3"},
    "Mie CF4": {"molecules": '[{ model = "cf4-mie", count = 64 }]', "density": "1.4 g/cm3"},
    "Mie argon in water": {"molecules": '[{ model = "spce", count = 58 }, { model = "argon-mie", count = 6 }]',
                           "more": '[[pair]]\nsites = ["spce.OW", "argon-mie.Ar"]\nlaw = "mie"\nsigma = "0.33 nm"\nepsilon = "0.8 kJ/mol"\n'
                                   'repulsive_exponent = 14\nattractive_exponent = 6'},
}


class RunTest(LammpsTest):
    def energies_of_polhode(self):
        lines = [line for line in (self.folder / "run-energies.csv").read_text().splitlines() if line[:1] != "#"]
        return list(csv.DictReader(lines))

    def check_export(self, style):
        """The script that export writes performs the run of polhode, in units real: velocities have the constant of LAMMPS, of 11
        digits, and so has the kinetic energy."""
        for title, changes in {"water": {}, "gier4-fd": {"scheme": "gier4-fd"}, **MIXTURES, **OTHER_LAWS}.items():
            values = {**WATER, **changes}
            self.write("run.toml", RUN % values)
            self.polhode("run", "run.toml", "--force")
            self.polhode("export", "lammps", "run.toml", "--pair-style", style, "--force")
            self.assertFalse((self.folder / "run.table").exists())
            data = (self.folder / "run.data").read_text()
            table = self.lammps((self.folder / "run.in").read_text())[0]
            if style == "polhode-particles":  # LAMMPS does not know that they rotate
                table["KinEng"] = [a + b for a, b in zip(table["KinEng"], table["f_rigid[2]"])]
            energies = self.energies_of_polhode()
            scale = max(abs(float(row["van_der_waals [kJ/mol]"])) + abs(float(row["coulomb [kJ/mol]"])) for row in energies)
            self.assertEqual(len(table["E_pair"]), len(energies))
            for k, row in enumerate(energies):
                # 1e-12 at the start; after 20 steps of trajectories in units that agree to 11 digits, ten times that.
                tolerance = scale * (1e-12 if k == 0 else 1e-10)
                self.assertLess(abs(KCAL * table["E_pair"][k] - float(row["potential [kJ/mol]"])), tolerance, f"{title}, sample {k}")
                # LAMMPS's constant of kinetic energies is 7e-11 too large; twice that for the trajectory.
                kinetic = float(row["kinetic_translation [kJ/mol]"]) + float(row["kinetic_rotation [kJ/mol]"])
                self.assertLess(abs(KCAL * table["KinEng"][k] - kinetic), 1.4e-10 * kinetic, f"{title}, sample {k}")
                # The size of its terms, which cancel, is that of the energies; the kinetic one is 7e-11 too large.
                volume = math.prod(float(words[1]) / 10 for words in map(str.split, data.splitlines()) if words and words[-1].endswith("hi"))
                pressure = table["Press"][k] / LAMMPS_PRESSURE * KCAL * 1e3 * BAR  # kcal/mol/Å³ and kJ/mol/nm³
                tolerance *= BAR / volume / 3
                self.assertLess(abs(pressure - float(row["pressure [bar]"])), tolerance + 1e-10 * kinetic * BAR / volume,
                                f"{title}, sample {k}")
