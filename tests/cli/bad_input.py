# SPDX-License-Identifier: MIT
"""Wrong input gives exit code 2 and a message with value, bound, remedy and place; no file is created or changed."""

import json
import os
import re
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

ATOMS = """two argon atoms
    2
    1argon   AR    1   0.500   0.500   0.500
    2argon   AR    2   1.500   1.500   1.500
   2.50000   2.50000   2.50000
"""
FROM_GRO = edited(SMALL, ('box = "2.5 nm"', 'initial_configuration = "start.gro"'), ("count = 27", "count = 2"))
BALL = """name = "ball"
source = "user"

[[site]]
name = "X"
element = "Ar"
position = "0 0 0 nm"
mass = "40 u"
sigma = "0.34 nm"
epsilon = "1 kJ/mol"
"""
WITH_BALL = edited(SMALL, ('"argon"', '"ball.toml"'))

PAIR = '[[pair]]\nsites = ["argon.Ar", "argon.Ar"]\nsigma = "0.33 nm"\nepsilon = "0.8 kJ/mol"\n'

# Name of the case, changes of the run file, what the message must contain.
RUN_FILE = [
    ("unknown key", [("cutoff =", "cutof =")], ["'cutof'", "'cutoff'", "run.toml:7"]),
    ("unknown table", [("[forces]", "[force]")], ["'force'", "'forces'", "run.toml:6"]),
    ("missing unit", [('"2 fs"\n\n', "2\n\n")], ["step = 2", "no unit", '"2 fs"', "run.toml:11", "integrator.step"]),
    ("missing unit in quotes", [('"1.0 nm"', '"1.0"')], ["no unit", '"1.0 nm"', "run.toml:7", "forces.cutoff"]),
    ("wrong dimension", [('"1.0 nm"', '"1.0 fs"')], ["1.0 fs", "time", "length", "nm", "run.toml:7"]),
    ("unknown unit", [('"1.0 nm"', '"1.0 nmm"')], ["'nmm'", "'nm'", "run.toml:7"]),
    ("unknown scheme", [('scheme = "hoa2"', 'scheme = "hoa"')], ["'hoa'", "'hoa2'", "run.toml:10", "integrator.scheme"]),
    ("scheme that cannot be read", [('"hoa2"', '"B(1/2) A(1 B(1/2)"')], ["character", "')'", "run.toml:10"]),
    ("scheme that does not sum to one", [('"hoa2"', '"B(1/2) A(1) B(1/3)"')], ["0.83333", "sum to 1", "run.toml:10"]),
    ("scheme with a zero denominator", [('"hoa2"', '"B(1/0) A(1)"')], ["denominator", "run.toml:10"]),
    ("inner scheme without a range", [('"hoa2"', '"hoa2 / hoa2 x 2"')],
     ["'hoa2 x 2'", "within 0.35 to 0.5 nm", "run.toml:10", "integrator.scheme"]),
    ("inner scheme with a bath", [('"hoa2"', '"hoa2 / B(1/2) A(1) O(1) B(1/2) x 2 within 0.5 nm"')],
     ["has a bath", "run.toml:10", "integrator.scheme"]),
    ("baths that do not sum to one", [('"hoa2"', '"B(1/2) A(1) O(1/2) B(1/2)"')], ["baths O to 0.5", "sum to 1", "run.toml:10"]),
    ("unknown inner scheme", [('"hoa2"', '"hoa2 / hoa x 2 within 0.5 nm"')], ["'hoa'", "'hoa2'", "run.toml:10"]),
    ("no inner steps", [('"hoa2"', '"hoa2 / hoa2 x 0 within 0.5 nm"')], ["outer scheme is 0", "from 1 to 1000", "run.toml:10"]),
    ("near forces without a unit", [('"hoa2"', '"hoa2 / hoa2 x 2 within 0.5"')], ["hoa2 x 2 within 0.5", "run.toml:10"]),
    ("near forces with a switching distance beyond their cutoff", [('"hoa2"', '"hoa2 / hoa2 x 2 within 0.6 to 0.5 nm"')],
     ["0.6 to 0.5 nm", "the second must be longer", "run.toml:10"]),
    ("unknown molecule", [('"argon"', '"argn"')], ["'argn'", "'argon'", "run.toml:2"]),
    ("unknown study scheme", [('"velocity-verlet"', '"velocity-verlett"')],
     ["'velocity-verlett'", "'velocity-verlet'", "run.toml", "study.schemes"]),
    ("cutoff above half the box", [('"1.0 nm"', '"1.4 nm"')], ["1.400 nm", "2.500 nm", "1.250 nm", "run.toml:7", "forces.cutoff"]),
    ("default cutoff above half the box", [('"2.5 nm"', '"1.8 nm"'), ('cutoff = "1.0 nm"', "")],
     ["1.000 nm", "0.900 nm", "run.toml"]),
    ("overlapping initial configuration", [("count = 27", "count = 40000")], ["overlap", "nm apart", "lower density", "run.toml"]),
    ("zero step", [('step = "2 fs"', 'step = "0 fs"')], ["0 fs", "longer than 0 fs", "run.toml:11"]),
    ("negative step", [('step = "2 fs"', 'step = "-2 fs"')], ["-2 fs", "longer than 0 fs", "run.toml:11"]),
    ("step that is not finite", [('step = "2 fs"', 'step = "nan fs"')], ["nan fs", "finite", "run.toml:11"]),
    ("infinite cutoff", [('"1.0 nm"', '"inf nm"')], ["inf nm", "finite", "run.toml:7"]),
    ("number that is too large", [('"100 K"', '"1e999 K"')], ["1e999 K", "finite", "run.toml:4"]),
    ("negative temperature", [('"100 K"', '"-1 K"')], ["-1 K", "0 K or more", "run.toml:4"]),
    ("zero count", [("count = 27", "count = 0")], ["count = 0", "1 or more", "run.toml:2"]),
    ("fractional count", [("count = 27", "count = 2.5")], ["2.5", "whole number", "run.toml:2"]),
    ("zero density", [('box = "2.5 nm"', 'density = "0 g/cm3"')], ["above 0 g/cm3", "run.toml:3"]),
    ("no extent", [('box = "2.5 nm"\n', "")], ["density", "run.toml"]),
    ("density beside a box", [('"2.5 nm"\n', '"2.5 nm"\ndensity = "1 g/cm3"\n')], ["leave one of the two out", "run.toml:4"]),
    ("switch beyond the cutoff", [('"1.0 nm"\n', '"1.0 nm"\nswitch = "1.1 nm"\n')], ["1.1 nm", "1 nm", "run.toml:8"]),
    ("unknown precision", [('"1.0 nm"\n', '"1.0 nm"\nprecision = "mixd"\n')], ['"mixd"', "'mixed'", "double", "run.toml:8"]),
    ("small lambda in mixed precision", [('"1.0 nm"\n', '"1.0 nm"\nprecision = "mixed"\n'), ('"2 fs"\n\n', '"2 fs"\nlambda = 0.01\n\n')],
     ["lambda = 0.01", "0.1", "mixed", "double", "run.toml:13", "integrator.lambda"]),
    ("unknown electrostatics", [('"1.0 nm"\n', '"1.0 nm"\nelectrostatics = "coulom"\n')], ["'coulomb'", "reaction-field", "run.toml:8"]),
    ("accuracy beyond mixed precision", [('"1.0 nm"\n', '"1.0 nm"\nelectrostatics = "pme"\nprecision = "mixed"\npme_accuracy = 1e-6\n')],
     ["1e-06", "1e-05", "double", "run.toml"]),
    ("damping without its law", [('"1.0 nm"\n', '"1.0 nm"\ndamping = "2 1/nm"\n')],
     ["damping", "damped-shifted-force", "run.toml:8"]),
    ("damping that leaves nothing", [('"1.0 nm"\n', '"1.0 nm"\nelectrostatics = "damped-shifted-force"\n'
                                      'damping = "0.5 1/A"\n')], ["0.5 1/A", "3 1/nm", "run.toml:9"]),
    ("molecule switch with the damped shifted force",
     [('"1.0 nm"\n', '"1.0 nm"\nelectrostatics = "damped-shifted-force"\ntruncation = "molecule-switch"\n')],
     ["molecule-switch", "damped-shifted-force", "site-switch", "run.toml:9"]),
    ("molecule switch with PME", [('"1.0 nm"\n', '"1.0 nm"\nelectrostatics = "pme"\ntruncation = "molecule-switch"\n')],
     ["molecule-switch", "pme", "site-switch", "run.toml:9"]),
    ("unknown mixing", [('"1.0 nm"\n', '"1.0 nm"\nmixing = "geometrc"\n')],
     ["'geometric'", "lorentz-berthelot", "run.toml:8", "forces.mixing"]),
    ("pair of an unknown molecule", [("[integrator]", PAIR.replace("argon.Ar", "argn.Ar") + "[integrator]")],
     ["'argn.Ar'", "did you mean 'argon.Ar'", "run.toml:10", "pair[0].sites"]),
    ("pair of an unknown site", [("[integrator]", PAIR.replace("argon.Ar", "argon.OW") + "[integrator]")],
     ["'argon.OW'", "argon.Ar", "run.toml:10", "pair[0].sites"]),
    ("pair of negative epsilon", [("[integrator]", PAIR.replace("0.8 kJ", "-0.8 kJ") + "[integrator]")],
     ["-0.8 kJ/mol", "0 or more", "run.toml:12", "pair[0].epsilon"]),
    ("pair given twice", [("[integrator]", PAIR + PAIR + "[integrator]")], ["twice", "delete one", "run.toml:14", "pair[1].sites"]),
    ("zero skin", [('"1.0 nm"\n', '"1.0 nm"\nskin = "0 nm"\n')], ["skin", "0.05 nm", "run.toml:8"]),
    ("not TOML", [("[system]", "[system")], ["not TOML", "run.toml:1"]),
    ("no molecules", [('molecules = [{ model = "argon", count = 27 }]\n', "")], ["no molecules", "tip4p", "run.toml"]),
    ("missing initial configuration", [('box = "2.5 nm"', 'initial_configuration = "none.gro"')], ["none.gro", "w512", "run.toml:3"]),
    ("unknown format of trajectories", [('plot = "none"', 'formats = ["xyzz"]')], ["'xyzz'", "'xyz'", "run.toml:18"]),
    ("unknown key of a study", [("runs = 2", "run = 2")], ["'run'", "'runs'", "run.toml:23"]),
    ("one run per point", [("runs = 2", "runs = 1")], ["runs = 1", "2 or more", "run.toml:23"]),
]

# Name of the case, the initial configuration, what the message must contain.
START_FILE = [
    ("empty file", "", ["start.gro:1", "at least one frame"]),
    ("binary garbage", bytes(range(256)) * 20, ["start.gro:"]),
    ("truncated atoms", ATOMS[:90], ["start.gro:4"]),
    ("no box", "\n".join(ATOMS.splitlines()[:4]) + "\n", ["start.gro:5", "box"]),
    ("count of atoms too small", ATOMS.replace("    2\n", "    1\n", 1), ["start.gro:4", "1"]),
    ("count of atoms too large", ATOMS.replace("    2\n", "    3\n", 1), ["start.gro:5", "3"]),
    ("count of atoms not a number", ATOMS.replace("    2\n", "  two\n", 1), ["start.gro:2", "two"]),
    ("coordinate not a number", ATOMS.replace("0.500", "0.5x0", 1), ["start.gro:3", "0.5x0", "number"]),
    ("coordinate not finite", ATOMS.replace("  0.500", "    nan", 1), ["start.gro:3"]),
    ("triclinic box", ATOMS.replace("2.50000\n", "2.50000 0 0 0.5 0 0 0\n"), ["start.gro:5", "orthorhombic"]),
    ("box of zero length", ATOMS.replace("   2.50000   2", "   0.00000   2"), ["start.gro:5", "longer than 0 nm"]),
    ("atoms of another molecule", ATOMS.replace("AR", "OW"), ["start.gro", "'OW'", "'Ar'"]),
    ("fewer molecules than counted", ATOMS.replace("    2\n", "    1\n", 1).replace("    2argon   AR    2   1.500   1.500   1.500\n", ""),
     ["start.gro", "1 atoms", "2 molecules", "the number in the file"]),
    ("more molecules than counted", ATOMS.replace("    2\n", "    3\n", 1).replace(
        "   2.50000   2.5", "    3argon   AR    3   2.000   2.000   2.000\n   2.50000   2.5"), ["start.gro", "3 atoms", "2 molecules"]),
    ("two atoms at the same position", ATOMS.replace("1.500", "0.510"), ["molecules 1 and 2 overlap", "0.0173 nm", "0.085 nm"]),
]

# Name of the case, changes of a molecule file, what the message must contain.
MOLECULE_FILE = [
    ("zero mass", [('"40 u"', '"0 u"')], ["mass 0 u", "ball.toml"]),
    ("negative mass", [('"40 u"', '"-1 u"')], ["-1 u", "0 or more", "ball.toml:8"]),
    ("mass without unit", [('"40 u"', "40")], ["no unit", '"40 u"', "ball.toml:8"]),
    ("position that is not finite", [("0 0 0 nm", "0 nan 0 nm")], ["finite", "ball.toml:7"]),
    ("position of two numbers", [("0 0 0 nm", "0 0 nm")], ["0 0 nm", "ball.toml:7"]),
    ("Lennard-Jones without diameter", [('sigma = "0.34 nm"\n', "")], ["epsilon", "sigma", "ball.toml"]),
    ("unknown key", [("sigma", "sgima")], ["'sgima'", "'sigma'", "ball.toml:9"]),
    ("no site", [("[[site]]", "[[sites]]")], ["'sites'", "'site'", "ball.toml:4"]),
    ("source missing", [('source = "user"\n', "")], ["no source", "ball.toml"]),
    ("negative epsilon", [('"1 kJ/mol"', '"-1 kJ/mol"')], ["-1 kJ/mol", "0 or more", "ball.toml:10"]),
    ("moments given", [('source = "user"\n', 'source = "user"\nmoments = "1 2 9"\n')], ["'moments'", "site", "ball.toml:3"]),
    ("element missing", [('element = "Ar"\n', "")], ["element", "'X'", "ball.toml"]),
]


class BadInput(Sandbox):
    def each_verb(self, words, title):
        for verb in (("run",), ("energy",), ("study", "--output", "study")):
            self.refused((verb[0], "run.toml", *verb[1:]), words, title)

    def test_run_files(self):
        for title, changes, words in RUN_FILE:
            self.write("run.toml", edited(SMALL, *changes))
            self.each_verb(words, title)

    def test_start_configurations(self):
        self.write("run.toml", FROM_GRO)
        for title, text, words in START_FILE:
            self.write("start.gro", text)
            self.each_verb(words, title)

    def test_molecule_files(self):
        self.write("run.toml", WITH_BALL)
        for title, changes, words in MOLECULE_FILE:
            self.write("ball.toml", edited(BALL, *changes))
            self.each_verb(words, title)

    def test_files_that_cannot_be_read(self):
        (self.folder / "folder").mkdir()
        self.write("empty.toml", "")
        self.write("garbage.toml", os.urandom(2000))
        for verb in ("run", "energy", "study"):
            self.refused((verb, "nowhere.toml"), ["nowhere.toml", "path"], "missing")
            self.refused((verb, "folder"), ["'folder'"], "folder")
            self.refused((verb, "empty.toml"), ["[system]", "empty.toml"], "empty")
            self.refused((verb, "garbage.toml"), ["byte 0x", "garbage.toml:"], "garbage")
        for name, word in (("folder", "'folder'"), ("empty.toml", "name"), ("garbage.toml", "text file")):
            self.write("run.toml", edited(SMALL, ('"argon"', f'"./{name}"')))
            self.each_verb([word], "molecule file " + name)
        self.write("run.toml", edited(SMALL, ('box = "2.5 nm"', 'initial_configuration = "folder"')))
        self.each_verb(["'folder'", "run.toml:3", "system.initial_configuration"], "initial configuration that is a folder")

    def test_options(self):
        self.write("run.toml", SMALL)
        for options, words in [
            (("--step", "2"), ["--step", "no unit", '"2 fs"']),
            (("--step", "-2 fs"), ["--step", "-2 fs", "longer than 0"]),
            (("--step", "2 nm"), ["--step", "2 nm", "length", "time"]),
            (("--length", "1 fs"), ["1 fs", "2 fs", "step"]),
            (("--scheme", "giere4"), ["'giere4'", "'gier4'", "--scheme"]),
            (("--scheme", "A(1) O(1) B(1)"), ["has a bath", "needs a thermostat", "run.toml"]),
            (("--scheme", "hoa2 / hoa2 x 2 within 1.1 nm"), ["1.1 nm", "1 nm", "exceeds the cutoff of all forces"]),
            (("--output", "nowhere/out"), ["'nowhere'", "nowhere/out"]),
            (("--outptu", "out"), ["--outptu"]),
        ]:
            self.refused(("run", "run.toml", *options), words, "run")
        for options, words in [
            (("--steps", "2"), ["--steps", "no unit", '"2 fs"']),
            (("--steps", "0 fs"), ["--steps", "0 fs", "longer than 0"]),
            (("--length", "4 fs"), ["4 fs", "2 fs"]),
            (("--schemes", "giere4"), ["'giere4'", "'gier4'", "--schemes"]),
            (("--schemes", "hoa2 / hoa2 x 2 within 1.1 nm"), ["1.1 nm", "1 nm", "exceeds the cutoff of all forces"]),
            (("--runs", "1"), ["--runs", "1"]),
            (("--output", "nowhere/study"), ["'nowhere'", "nowhere/study"]),
        ]:
            self.refused(("study", "run.toml", *options), words, "study")
        self.refused(("stdy",), ["'stdy'", "'study'"], "unknown verb")

    def test_precision(self):
        self.write("run.toml", SMALL)
        for verb in ("run", "study"):
            self.refused((verb, "run.toml", "--precision", "mixd"), ["--precision", "mixd", "'mixed'"], verb)
        self.write("run.toml", edited(SMALL, ('"2 fs"\n\n', '"2 fs"\nlambda = 0.01\n\n')))
        for verb in ("run", "study"):
            self.refused((verb, "run.toml", "--precision", "mixed"), ["lambda = 0.01", "0.1", "run.toml:12"], verb)
        process = self.polhode("run", "run.toml", "--force", "--precision", "double")
        self.assertEqual(process.returncode, 0, process.err)
        self.write("run.toml", SMALL)
        process = self.polhode("run", "run.toml", "--force", "--precision", "mixed")
        self.assertEqual(process.returncode, 0, process.err)

    def test_threads(self):
        self.write("run.toml", SMALL)
        allowed = json.loads(self.polhode("run", "run.toml", "--json", POLHODE_THREADS="").out)["threads"]
        self.assertGreaterEqual(allowed, 1)
        more = str(allowed + 1)
        for verb in ("run", "study"):
            for value in ("0", "-1", more, "two", "1.5", "99999999999"):
                words = [f"threads = '{value}'", f"1 to {allowed}", "core"]
                self.refused((verb, "run.toml", f"--threads={value}"), [*words, "--threads"], verb)
                self.refused((verb, "run.toml"), [*words, "POLHODE_THREADS"], verb, POLHODE_THREADS=value)
        process = self.polhode("run", "run.toml", "--threads", "1", "--force", POLHODE_THREADS="two")
        self.assertEqual(process.returncode, 0, process.err)  # an option overrides the variable

    def test_length_shorter_than_a_step(self):
        self.write("run.toml", edited(SMALL, ('"0.02 ps"\n\n[output]', '"1.5 fs"\n\n[output]')))
        self.refused(("run", "run.toml"), ["1.5 fs", "2 fs", "shorter step"], "length")

    def test_nested_schemes_where_error_brackets_are_needed(self):
        nested = ('"hoa2"', '"hoa2 / hoa2 x 1 within 0.5 nm"')
        self.write("run.toml", edited(SMALL, nested, ('"0.02 ps"\n\n[output]', '"0.02 ps"\nshadow_sample = "10 fs"\n\n[output]')))
        self.refused(("run", "run.toml"), ["shadow_sample is 10 fs", "hoa2 x 1 within", "has an inner scheme", "a single scheme"], "shadow")
        self.write("run.toml", edited(SMALL, nested))
        self.refused(("tune-scheme", "run.toml"), ["hoa2 x 1 within", "single schemes", "run.toml"], "tune-scheme")

    def test_output_that_exists(self):
        self.write("run.toml", SMALL.replace('plot = "none"', 'plot = "svg"'))
        for name in ("out-energies.csv", "out-final.gro", "out-trajectory.xyz", "out-trajectory.gro",
                     "out-energies.svg", "out-energies.gp"):
            self.write(name, "mine\n")
            self.refused(("run", "run.toml"), [f"'{name}'", "--force"], "run")
            (self.folder / name).unlink()
        for name in ("study.csv", "study.json", "study.svg", "study.png", "study.gp", "study-runs.csv"):
            self.write(name, "mine\n")
            self.refused(("study", "run.toml"), [f"'{name}'", "--force"], "study")
            (self.folder / name).unlink()
        self.write("out-energies.csv", "mine\n")
        self.assertEqual(self.polhode("run", "run.toml", "--force").returncode, 0)
        self.assertNotEqual((self.folder / "out-energies.csv").read_text(), "mine\n")

    def test_output_that_is_a_folder(self):
        self.write("run.toml", SMALL)
        (self.folder / "out-energies.csv").mkdir()
        self.refused(("run", "run.toml", "--force"), ["'out-energies.csv'", "folder"], "run")

    @unittest.skipIf(os.geteuid() == 0, "nothing is unwritable for root")
    def test_unwritable_folder(self):
        self.write("run.toml", SMALL)
        (self.folder / "locked").mkdir(mode=0o500)
        for verb in ("run", "study"):
            self.refused((verb, "run.toml", "--output", "locked/out"), ["'locked'", "locked/out"], verb)

    def test_folder_that_is_unwritable_for_every_user(self):
        self.write("run.toml", SMALL)
        for verb in ("run", "study"):
            self.refused((verb, "run.toml", "--output", "/proc/out"), ["/proc/out"], verb)

    def test_a_run_that_blows_up(self):
        self.write("run.toml", edited(SMALL, ('"100 K"', '"1000 K"'), ("count = 27", "count = 300"), ('"2 fs"\n\n', '"400 fs"\n\n'),
                                      ('"0.02 ps"\n\n[output]', '"400 ps"\n\n[output]')))
        process = self.polhode("run", "run.toml")
        self.assertEqual(process.returncode, 1, process.err)
        for word in ("blew up at step", " ps): ", "(argon) are ", "nm apart, between Ar and Ar", "400 fs", "try ", " fs, or equilibrate"):
            self.assertIn(word, process.err)

    def test_the_step_of_the_warning_is_the_one_of_the_error(self):
        """However far beyond the limit."""
        dense = edited(SMALL, ("count = 27", "count = 200"), ('"0.02 ps"\n\n[output]', '"0.02 ps"\nequilibrate = "1 ps"\n\n[output]'))
        for step in ("500 fs", "1 ps", "5 ps"):
            self.write("run.toml", edited(dense, ('"2 fs"\n\n', f'"{step}"\n\n'), ('length = "0.02 ps"\nequil', 'length = "2000 ps"\nequil')))
            process = self.polhode("run", "run.toml", "--force")
            self.assertEqual(process.returncode, 1, process.err)
            warned = re.search(r"use at most (\S+ fs)", process.err)[1]
            self.assertIn(f"try {warned}, or equilibrate", process.err)

    def test_a_lattice_that_overlaps(self):
        """It is refused with two molecules and a density at which it fits; minimised or equilibrated it runs."""
        dense = edited(SMALL, ('{ model = "argon", count = 27 }', '{ model = "ccl4", count = 108 }'), ('box = "2.5 nm"', 'density = "2 g/cm3"'))
        self.write("run.toml", dense)
        before = self.contents()
        process = self.polhode("run", "run.toml")
        self.assertEqual(process.returncode, 2, process.err)
        self.assertRegex(process.err, r"overlap on the lattice of 2 g/cm3: molecules \d+ \(ccl4\) and \d+ \(ccl4\) are 0\.\d+ nm apart")
        self.assertEqual(self.contents(), before)
        fits = re.search(r"a density of (\S+ g/cm3), at which", process.err)[1]
        self.done("run", edited(dense, ('"2 g/cm3"', f'"{fits}"')), "--force")
        self.done("run", edited(dense, ('length = "0.02 ps"\n\n[output]', 'length = "0.02 ps"\nminimise = true\n\n[output]')), "--force")

    def test_a_lattice_whose_sites_coincide(self):
        text = edited(SMALL, ('{ model = "argon", count = 27 }', '{ model = "benzene", count = 64 }'), ('box = "2.5 nm"', 'density = "0.8 g/cm3"'))
        self.write("run.toml", text)
        process = self.polhode("energy", "run.toml")
        self.assertEqual(process.returncode, 2, process.err)
        fits = re.search(r"molecules 2 and 14 overlap: .*, or a density of (\S+ g/cm3), at which", process.err)[1]
        self.done("energy", edited(text, ('"0.8 g/cm3"', f'"{fits}"')))

    def test_a_start_almost_at_rest_is_no_blow_up(self):
        """Errors of the energy are no larger than what the potential energy sets free."""
        for temperature in ("1e-9 K", "1e-15 K"):
            for precision in ("double", "mixed"):
                text = edited(SMALL, ('"100 K"', f'"{temperature}"'), ("count = 27", "count = 100"), ('"0.02 ps"\n\n[output]', '"10 ps"\n\n[output]'),
                              ('"2 fs"\n\n', '"5 fs"\n\n'))
                self.done("run", text, "--force", "--precision", precision)
        self.write("run.toml", edited(text, ('"5 fs"\n\n', '"300 fs"\n\n'), ('"10 ps"', '"1000 ps"')))
        process = self.polhode("run", "run.toml", "--force")
        self.assertEqual(process.returncode, 1, process.err)
        self.assertIn("blew up", process.err)


if __name__ == "__main__":
    sandbox.main()
