# SPDX-License-Identifier: MIT
"""Figures say what the summary says, and gnuplot draws them without a message, whatever the run has."""

import json
import re
import shutil
import subprocess
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

GNUPLOT = shutil.which("gnuplot")
DRAWN = edited(SMALL, ('plot = "none"', 'plot = "svg"\ntrajectory_every = "4 fs"\nformats = ["gro"]'), ('"0.02 ps"\n\n[output]', '"0.4 ps"\nsample = "4 fs"\n\n[output]'),
               ('box = "2.5 nm"', 'box = "2 nm"'), ('"1.0 nm"', '"0.9 nm"'))
SOLUTION = '{ model = "tip4p", count = 26 }, { model = "na-tip4p-ew", count = 1 }'
ONE_ARGON = '{ model = "argon", count = 27 }'


def of(molecules, *edits):
    return edited(DRAWN, (ONE_ARGON, molecules), ('"100 K"', '"300 K"'), *edits)


class Figures(Sandbox):
    def is_drawn_silently(self):
        """All scripts in the folder."""
        scripts = sorted(self.folder.glob("*.gp"))
        self.assertGreater(len(scripts), 0)
        for script in scripts if GNUPLOT else ():
            drawn = subprocess.run([GNUPLOT, "-d", script.name], cwd=self.folder, text=True, capture_output=True, check=False)
            self.assertEqual((drawn.returncode, drawn.stderr), (0, ""), script.name)
            self.assertIn("</svg>", script.with_suffix(".svg").read_text(encoding="utf-8"))

    def script(self, name):
        return (self.folder / f"{name}.gp").read_text(encoding="utf-8")

    @unittest.skipIf(GNUPLOT is None, "gnuplot is not installed")
    def test_R_of_the_energies_is_that_of_the_summary(self):
        """With a thermostat the total energy fluctuates as the heat does, and R is of the conserved energy."""
        for ensemble in ("", "[thermostat]\nfriction = \"10 1/ps\"\n"):
            run = self.done("run", of(SOLUTION, ("[output]", f"{ensemble}[output]")), "--force", "--json")
            R = 100 * json.loads(run.out)["R"]
            said = re.search(r"R = rms of E / rms of V = ([\d.e-]+)", (self.folder / "out-energies.svg").read_text(encoding="utf-8"))
            self.assertLess(abs(float(said[1]) / R - 1), 0.06)  # two digits of its error
            self.is_drawn_silently()

    def test_hybrid_monte_carlo_has_no_R(self):
        self.done("run", of(SOLUTION, ("[output]", "[hybrid_monte_carlo]\nsteps = 10\n[output]")))
        self.assertIn("ratio = ''", self.script("out-energies"))
        self.assertIn("energy = 'total'", self.script("out-energies"))
        self.is_drawn_silently()

    def analyzed(self, molecules, *options, edits=()):
        self.done("run", of(molecules, *edits), "--force")
        process = self.polhode("analyze", "out-trajectory.gro", "--run", "run.toml", "--window", "0.04 ps", "--force", *options)
        self.assertEqual(process.returncode, 0, process.err)
        self.assertNotIn("warning", process.err.replace("warning: gnuplot is not installed", ""))
        return process

    def test_one_solute_molecule(self):
        """It has no g(r) with itself."""
        report = json.loads(self.analyzed(SOLUTION, "--json").out)
        pairs = [tuple(pair["pair"]) for pair in report["rdf"]]
        self.assertIn(("OW", "Na"), pairs)
        self.assertNotIn(("Na", "Na"), pairs)
        self.is_drawn_silently()
        refused = self.polhode("analyze", "out-trajectory.gro", "--run", "run.toml", "--what", "rdf", "--pairs", "Na-Na", "--force")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("only one molecule has these sites", refused.err)

    def test_poor_data(self):
        """One molecule, atoms, a single frame, and constant values."""
        for molecules, edits in (('{ model = "tip4p", count = 1 }', ()), ('{ model = "argon", count = 1 }', ()), ('{ model = "argon", count = 3 }', ()),
                                 (SOLUTION, (('length = "0.4 ps"', 'length = "0.002 ps"'),))):
            self.analyzed(molecules, edits=edits)
            self.is_drawn_silently()

    def test_bands_and_the_line_of_D(self):
        """P1 and P2 have a panel each; the axis of the displacements begins at 0, and the line is that of D."""
        report = json.loads(self.analyzed(SOLUTION, "--json").out)
        rotation, msd = self.script("polhode-analysis-rotation"), self.script("polhode-analysis-msd")
        self.assertIn("panels = 2\n", rotation)
        self.assertRegex(rotation, r"last_curve\[1\] = 4\n")
        self.assertRegex(rotation, r"last_band\[2\] = \d")
        self.assertRegex(msd, r"low_of\[1\] = 0\.0+\n")
        value = lambda name: float(re.search(rf"^{re.escape(name)} = (\S+)$", msd, re.M)[1])
        slope = (value("line_y[2]") - value("line_y[1]")) / (value("line_x[2]") - value("line_x[1]"))
        D = report["parts"][0]["D_1e-9_m2_per_s"]
        self.assertAlmostEqual(slope / 6 * 1000 / (D["value"] or D["unconverged_estimate"]), 1, 6)


if __name__ == "__main__":
    sandbox.main()
