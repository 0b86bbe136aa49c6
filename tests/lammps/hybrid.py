# SPDX-License-Identifier: MIT
"""pair_style polhode as a part of a hybrid style: rigid water with atoms of another kind, whose pairs another style computes."""

import re

import engine
from runs import RUN, WATER, RunTest

MIXTURE = {**WATER, "molecules": '[{ model = "spce", count = 58 }, { model = "argon", count = 6 }]', "truncation": "site-switch"}
SAMPLE = "thermo_style custom step temp pe ke etotal press\nthermo_modify format float %.16g\nthermo 10\nrun 60\n"
ARGON = 3  # its atom type


class Hybrid(RunTest):
    def setUp(self):
        super().setUp()
        self.write("run.toml", RUN % MIXTURE)
        for name, more in (("sites", ()), ("bodies", ("--pair-style", "polhode"))):
            self.polhode("export", "lammps", "run.toml", "--force", "--output", name, *more)
        self.sites, self.bodies = ((self.folder / f"{name}.in").read_text().partition("fix rigid all")[0] for name in ("sites", "bodies"))

    def pairs(self, script, style):
        """The pair_coeff lines of a script for types of water alone, or for all others."""
        lines = re.findall(r"^pair_coeff (\d+) (\d+) (.*)$", script, re.M)
        return [f"pair_coeff {i} {j} {rest}" for i, j, rest in lines if (str(ARGON) in (i, j)) == (style == "table")]

    def script(self, style="hybrid/overlay", more="", group="water"):
        """Water by polhode, all pairs with argon by tables, and argon integrated by fix nve."""
        table, = re.findall(r"table spline \d+", self.sites)
        coefficients = [line.replace(*self.named(line), 1) for line in self.pairs(self.bodies, "polhode")] + self.pairs(self.sites, "table")
        head = re.sub(r"^pair_coeff .*\n", "", self.bodies, flags=re.M)
        head = re.sub(r"^pair_style polhode ((?:.*&\n)*.*)$", rf"pair_style {style} polhode \1 {table}", head, flags=re.M)
        return f"{head}{chr(10).join(coefficients)}\n{more}{self.integrated(group)}"

    @staticmethod
    def named(line):
        """In a hybrid style, coefficients begin with the name of the style."""
        i, j = line.split()[1:3]
        return f"{i} {j} ", f"{i} {j} polhode "

    @staticmethod
    def integrated(group="water"):
        return (f"group argon type {ARGON}\ngroup water subtract all argon\nfix free argon nve\nfix rigid {group} polhode\n" + SAMPLE)

    def test_the_sum_of_both_styles(self):
        """Tables for all pairs have the same energies, forces and pressure, up to the interpolation of tables."""
        mixed = self.lammps(self.script())[0]
        tables = self.lammps(self.sites + self.integrated())[0]
        for name in ("PotEng", "TotEng"):
            self.assert_close(mixed[name], tables[name], 1e-6, name)
        for one, two in zip(mixed["Press"], tables["Press"]):
            self.assertAlmostEqual(one, two, delta=0.1)  # its terms are 1e5 atm
        self.assertNotEqual(mixed["PotEng"][0], mixed["PotEng"][-1])

    def test_ranks(self):
        one, two = (self.lammps(self.script(), ranks)[0] for ranks in (1, 2))
        for name in ("PotEng", "KinEng"):
            self.assert_close(one[name], two[name], 1e-10, name)

    def test_all_atoms_follow_the_box(self):
        """A second setup, which finds everything again from the positions of atoms, has the energy and the pressure of the last step."""
        script = self.script().replace("fix rigid water polhode", "fix rigid water polhode rescale 0 1e15 7 pressure 9000 30 4.5e-5 every 2")
        for ranks in (1, 2):
            moved, again = self.lammps(script + "run 0\n", ranks)
            self.assert_close(moved["PotEng"][-1:], again["PotEng"], 1e-11)
            self.assertAlmostEqual(moved["Press"][-1], again["Press"][0], delta=1e-5)

    def test_atoms_that_are_held(self):
        """A wall of atoms without forces stays where it is, in both representations."""
        held = "fix wall argon setforce 0 0 0\nfix rigid"
        energies = [self.lammps(script.replace("fix free argon nve\n", "").replace("fix rigid", held, 1))[0]["PotEng"]
                    for script in (self.script(), self.sites + self.integrated())]
        self.assert_close(*energies, 1e-6)

    def test_charges_of_all_atoms_on_one_mesh(self):
        """coul/long has an erfc with errors up to 1.5e-7, of 290,000 kcal/mol of pairs without regard to sign."""
        pme = {**MIXTURE, "electrostatics": "pme", "molecules": '[{ model = "spce", count = 60 }, { model = "na-spce", count = 2 }, { model = "cl-spce", count = 2 }]'}
        self.write("run.toml", RUN % pme)
        for name, more in (("sites", ()), ("bodies", ("--pair-style", "polhode"))):
            self.polhode("export", "lammps", "run.toml", "--force", "--output", name, *more)
        sites, bodies = ((self.folder / f"{name}.in").read_text().partition("fix rigid all")[0] for name in ("sites", "bodies"))
        ions = "group water type 1 2\ngroup ions subtract all water\nfix free ions nve\nfix rigid water polhode\n" + SAMPLE
        coefficients = re.findall(r"^pair_coeff (\d+) (\d+) (.*)$", bodies, re.M)
        styles = re.sub(r"^pair_style polhode (\S+)(.*)$", r"pair_style hybrid/overlay polhode \1\2 lj/cut/coul/long \1\npair_modify pair lj/cut/coul/long table 0",
                        re.sub(r"^pair_coeff .*\n", "", bodies, flags=re.M), flags=re.M)
        water = "".join(f"pair_coeff {i} {j} polhode {rest}\n" for i, j, rest in coefficients if int(i) < 3 and int(j) < 3)
        water += "pair_coeff 1*4 3*4 lj/cut/coul/long 0 1\npair_coeff 1 2 polhode 0 0\n"
        # Without the Lennard-Jones forces of the ions in both, and with the same cutoff and mesh.
        cutoff, = re.findall(r"^pair_style polhode (\S+)", bodies, re.M)
        tables = re.sub(r"coul/long \d\S+", f"coul/long {cutoff}", re.sub(r"^pair_coeff \d+ [34] table .*\n", "", sites, flags=re.M))
        run = "kspace_modify gewald 0.55 mesh 27 27 27 order 7\n" + ions.replace("run 60", "run 0")
        one = self.lammps(styles.replace("kspace_style", water + "kspace_style") + run)[0]["PotEng"][0]
        two = self.lammps(tables + run)[0]["PotEng"][0]
        self.assertLess(abs(one - two), 0.04)

    @staticmethod
    def with_tip4p(script):
        """With a style that has charges, but not 'coul' in its name."""
        script = script.replace(" table spline", " tip4p/cut 1 2 1 1 0.1 5.8 table spline", 1)
        script = script.replace("read_data", "angle_style zero\nread_data").replace("nocoeff", "nocoeff extra/angle/types 1\nangle_coeff *")
        return script.replace("group argon", "pair_coeff * * tip4p/cut\ngroup argon", 1)

    def test_what_is_refused(self):
        script = self.script()
        for words, text in ((["hybrid/scaled does not scale"], self.script("hybrid/scaled 1.0").replace(" table spline", " 1.0 table spline")),
                            (["leaves out atom types 2 and 2"], re.sub(r"^pair_coeff 2 2 polhode .*$", "pair_coeff 2 2 none", script, flags=re.M)),
                            (["some atoms are in no body", "hybrid/overlay"], self.bodies + self.integrated()),
                            (["charges of atom types", "twice"], script.replace(" table spline", " coul/cut 5.8 table spline", 1)
                             .replace("group argon", "pair_coeff * * coul/cut\ngroup argon", 1)),
                            (["charges of atom types", "a style with 'tip4p'"], self.with_tip4p(script))):
            with self.subTest(words=words):
                self.refused(text, words)


if __name__ == "__main__":
    engine.main(__doc__)
