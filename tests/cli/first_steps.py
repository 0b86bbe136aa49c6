# SPDX-License-Identifier: MIT
"""Help, run files to start from, options of a run, progress in logs, and numbers with as many digits as they have."""

import json
import re
import time
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

CONF = """two waters
    6
    1SOL     OW    1   0.500   0.500   0.500
    1SOL    HW1    2   0.600   0.500   0.500
    1SOL    HW2    3   0.467   0.594   0.500
    2SOL     OW    4   0.900   0.500   0.500
    2SOL    HW1    5   1.000   0.500   0.500
    2SOL    HW2    6   0.867   0.594   0.500
   2.10000   2.10000   2.10000
"""
TOPOLOGY = """[ defaults ]
1 2 no 1 1
[ atomtypes ]
OW 15.9994 0 A 0.3166 0.650
HW 1.008 0 A 0 0
[ moleculetype ]
SOL 2
[ atoms ]
1 OW 1 SOL OW  1 -0.8476
2 HW 1 SOL HW1 1 0.4238
3 HW 1 SOL HW2 1 0.4238
[ settles ]
1 1 0.1 0.16330
[ system ]
water
[ molecules ]
SOL 2
"""
DATA = """LAMMPS data file: two SPC/E waters

6 atoms
2 atom types
0 21 xlo xhi
0 21 ylo yhi
0 21 zlo zhi

Masses

1 15.9994
2 1.008

Pair Coeffs # lj/cut/coul/long

1 0.1553 3.166
2 0 0

Atoms # full

1 1 1 -0.8476 5 5 5
2 1 2 0.4238 6 5 5
3 1 2 0.4238 4.66667 5.94281 5
4 2 1 -0.8476 9 5 5
5 2 2 0.4238 10 5 5
6 2 2 0.4238 8.66667 5.94281 5
"""
KINDS = ("water", "nvt", "npt", "mixture", "gromacs", "lammps")


class FirstSteps(Sandbox):
    def text(self, *arguments):
        process = self.polhode(*arguments)
        self.assertEqual(process.returncode, 0, process.err)
        return process.out

    def test_help(self):
        """Without a verb there is a short list of verbs in groups with examples; help of a verb is its --help."""
        overview = self.text("help")
        for words in (("--help",), ("-h",)):
            self.assertEqual(self.text(*words), overview)
        process = self.polhode()
        self.assertEqual((process.returncode, process.out, process.err), (2, "", overview))
        self.assertLess(len(overview.splitlines()), 36)  # a screen
        for word in ("simulate", "choose a scheme and a step", "look up", "examples", "polhode new water", "polhode help VERB"):
            self.assertIn(word, overview)
        verbs = re.findall(r"^  ([\w-]+) ", overview.partition("examples")[0], re.M)
        self.assertEqual(len(verbs), 20)
        for verb in verbs:
            self.assertEqual(self.text("help", verb), self.text(verb, "--help"))
        self.refused(("help", "stdy"), ["'stdy'", "'study'"])
        self.assertRegex(self.text("-V"), r"^polhode \d+\.\d+")
        self.assertEqual(self.text("-V"), self.text("--version"))

    def test_help_has_the_width_of_the_terminal(self):
        for words in (("help",), ("run", "--help"), ("analyze", "--help"), ("verify", "--help")):
            whole = self.text(*words)
            for columns in (50, 80, 132):
                for text in (self.on_terminal(columns, *words), self.polhode(*words, COLUMNS=str(columns)).out):
                    self.assertEqual(text.split(), whole.split())
                    self.assertLessEqual(max(map(len, text.splitlines())), columns, text)
            # Meanings stay in their column, and lines that fit stay as they are.
            self.assertEqual(self.on_terminal(1000, *words), whole)
        narrow = self.on_terminal(60, "run", "--help")
        self.assertRegex(narrow, r"(?m)^  --scheme TEXT {14} *splitting scheme.*\n {30}\S")

    def test_options_that_do_not_exist(self):
        self.write("run.toml", SMALL)
        self.refused(("run", "run.toml", "--steps", "2"), ["polhode run has no option '--steps'", "--length", "'polhode help run'"])
        self.refused(("run", "run.toml", "--lenght", "1 ps"), ["'--lenght'", "did you mean '--length'"])
        self.refused(("run", "run.toml", "more"), ["'more'", "polhode run"])
        for verb, name in (("verify", "SCHEME"), ("analyze", "TRAJECTORY"), ("convert", "IN")):
            self.refused((verb,), [f"error: {name} is required"])

    def test_new_run_files(self):
        for kind in KINDS:
            self.text("new", kind)
            self.text("new", kind, f"{kind}-2.toml")
            text = (self.folder / f"{kind}.toml").read_text()
            self.assertIn(f"polhode run {kind}.toml\n", text)
            self.assertEqual(text.replace(f" {kind}.toml", f" {kind}-2.toml"), (self.folder / f"{kind}-2.toml").read_text())
            self.assertLess(max(map(len, text.splitlines())), 120)
            self.refused(("new", kind), [f"'{kind}.toml'", "never overwritten"])
        self.refused(("new", "watr"), ["'watr'", "'water'", "gromacs"])
        self.refused(("new", "water", "nowhere/a.toml"), ["'nowhere'"])

    def test_new_run_files_run(self):
        """A few steps; those of other programs end at the file that they name."""
        for kind in ("water", "nvt", "npt", "mixture"):
            self.text("new", kind)
            run = json.loads(self.text("run", f"{kind}.toml", "--equilibrate", "8 fs", "--length", "16 fs", "--json"))
            self.assertEqual(run["steps"], 4)
        for kind, files in (("gromacs", {"conf.gro": CONF, "topol.top": TOPOLOGY}), ("lammps", {"system.data": DATA})):
            self.text("new", kind)
            for name, text in files.items():
                self.refused(("energy", f"{kind}.toml"), [name])
                self.write(name, text)
            self.assertEqual(json.loads(self.text("energy", f"{kind}.toml", "--json"))["molecules"], 2)

    def test_new_run_files_in_other_ensembles(self):
        self.text("new", "gromacs", "--npt")
        text = (self.folder / "gromacs.toml").read_text()
        self.assertIn("[barostat]", text)
        self.assertNotIn("constant energy", text)
        self.write("conf.gro", CONF)
        self.write("topol.top", TOPOLOGY)
        self.assertEqual(json.loads(self.text("energy", "gromacs.toml", "--json"))["molecules"], 2)
        self.refused(("new", "nvt", "--npt"), ["'nvt'", "kind 'npt'"])
        self.refused(("new", "lammps", "--npt", "--nvt"), ["exclude each other"])
        self.write("md.mdp", "nsteps = 10\nfreezegrps = A\n")
        self.refused(("new", "lammps", "--mdp", "md.mdp"), ["--mdp is a file of GROMACS parameters", "'lammps'", "kind gromacs"])
        self.refused(("new", "gromacs", "--mdp", "md.mdp", "--npt"), ["tcoupl"])
        self.refused(("new", "gromacs", "--mdp", "gone.mdp"), ["gone.mdp"])
        made = self.polhode("new", "gromacs", "own.toml", "--mdp", "md.mdp")
        self.assertIn("note: freezegrps = A: not available", made.err)
        self.assertIn("#   freezegrps = A: not available", (self.folder / "own.toml").read_text())
        self.assertEqual(json.loads(self.text("energy", "own.toml", "--json"))["molecules"], 2)

    def test_dielectric_constant_of_a_run_to_start_from(self):
        """Its trajectory has no velocities, so the temperature is that of the run file."""
        self.text("new", "nvt")
        text = edited((self.folder / "nvt.toml").read_text(), ("count = 512", "count = 64"), ("0.9 nm", "0.55 nm"))
        self.write("small.toml", text)
        self.text("prepare", "small.toml", "--nvt", "0.1 ps")
        self.text("run", "nvt-prepared.toml", "--length", "1 ps")
        analysis = ("analyze", "nvt-trajectory.xtc", "--run", "nvt-prepared.toml", "--plot", "none")
        report = json.loads(self.text(*analysis, "--what", "dielectric", "--json"))
        self.assertEqual(report["files"], ["polhode-analysis-dielectric.csv"])
        self.assertEqual(report["temperature_source"], "of the run file")
        self.assertIn("constant", report["dielectric"])
        # Epsilon - 1 is proportional to 1/T.
        hot = json.loads(self.text(*analysis, "--what", "dielectric", "--json", "--force", "--temperature", "596 K"))
        self.assertEqual(hot["temperature_source"], "as given")
        last = [float(self.rows("polhode-analysis-dielectric.csv")[-1].split(",")[1])]
        self.text(*analysis, "--what", "dielectric", "--force")
        last.append(float(self.rows("polhode-analysis-dielectric.csv")[-1].split(",")[1]))
        self.assertAlmostEqual((last[1] - 1) / (last[0] - 1), 2, places=4)
        self.refused((*analysis, "--what", "dielectric", "--electrostatics", "coulomb", "--force"),
                     ["nothing was computed", "truncated"])

    def test_seed_temperature_and_equilibration_of_a_run(self):
        """Options are as the keys of the run file."""
        def energies(text, *options):
            self.write("run.toml", text)
            self.text("run", "run.toml", "--force", *options)
            return self.rows("out-energies.csv")
        changed = edited(SMALL, ('"100 K"', '"120 K"\nseed = 5'), ('"0.02 ps"\n\n[output]', '"0.02 ps"\nequilibrate = "10 fs"\n\n[output]'))
        options = ("--seed", "5", "--temperature", "120 K", "--equilibrate", "10 fs")
        self.assertEqual(energies(SMALL, *options), energies(changed))
        for k in range(3):
            self.assertNotEqual(energies(SMALL, *options), energies(SMALL, *options[:2 * k], *options[2 * k + 2:]))
        self.refused(("run", "run.toml", "--seed", "-1"), ["--seed", "-1", "0 or more"])
        self.refused(("run", "run.toml", "--seed", "1.5"), ["--seed", "1.5", "whole number"])
        self.refused(("run", "run.toml", "--temperature", "0 K"), ["--temperature", "above 0 K"])
        self.refused(("run", "run.toml", "--equilibrate", "-1 ps"), ["--equilibrate", "0 ps or longer"])

    def test_seed_and_temperature_of_a_study(self):
        def points(text, *options):
            self.write("run.toml", text)
            self.text("study", "run.toml", "--force", *options)
            return sorted(self.rows("study-runs.csv"))  # they end in any order
        changed = edited(SMALL, ('"100 K"', '"120 K"\nseed = 5'))
        self.assertEqual(points(SMALL, "--seed", "5", "--temperature", "120 K"), points(changed))
        self.assertNotEqual(points(SMALL, "--temperature", "120 K"), points(changed))

    def test_progress_in_a_log(self):
        """Where standard error is no terminal, progress is a few lines; a job of 3 s has at least one."""
        length, elapsed = 1, 0
        while elapsed < 3:
            length *= 2
            text = edited(SMALL, ('"0.02 ps"\n\n[output]', f'"{length} ps"\n\n[output]'))
            begin = time.monotonic()
            process = self.done("run", text, "--force")
            elapsed = time.monotonic() - begin
        self.assertNotIn("\r", process.err)
        self.assertNotIn("\033", process.err)
        lines = [line for line in process.err.splitlines() if " % " in line]
        self.assertGreater(len(lines), 0, process.err)
        self.assertRegex(lines[0], r"^[\w ]+ +[\d.]+ %  \d+:\d\d")

    def test_digits(self):
        """Energies have ten digits as text and all in JSON."""
        self.write("run.toml", SMALL)
        text, exact = self.text("energy", "run.toml"), json.loads(self.text("energy", "run.toml", "--json"))
        shown = re.search(r"potential +(\S+) kJ/mol", text)[1]
        self.assertLessEqual(len(shown.strip("-").replace(".", "").strip("0")), 10)
        self.assertAlmostEqual(float(shown) / exact["potential_kJ_per_mol"], 1, delta=1e-9)

    def test_a_dipole_of_rounding_errors_is_zero(self):
        self.assertRegex(self.text("molecules", "benzene"), r"dipole +0 D\n")
        self.assertEqual(json.loads(self.text("molecules", "benzene", "--json"))["dipole"], 0)

    def test_columns_of_molecules_are_apart(self):
        for line in self.text("molecules").splitlines()[2:]:
            self.assertRegex(line, r"^\S+ +\d+ .*  \S+  +\S")
            self.assertNotRegex(line, r"\d{4}five-site|\d{4}[a-z]{4}")


if __name__ == "__main__":
    sandbox.main()
