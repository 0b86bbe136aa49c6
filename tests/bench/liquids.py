# SPDX-License-Identifier: MIT
"""The results of bench/liquids are right for straight lines, and its driver runs and stores its results."""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from math import sqrt
from pathlib import Path

import built_program

BENCH = Path(__file__).resolve().parents[2] / "bench/liquids"
sys.path.insert(0, str(BENCH))

import analysis
import waters


class Thermodynamics(unittest.TestCase):
    def made(self, temperature, noise):
        """Samples of a run at constant energy: V = E - kinetic, P linear in T plus noise."""
        found = []
        for k in range(101):
            t = temperature + (noise if k % 2 else -noise)
            found.append({"total": 30 * temperature, "potential": 30 * temperature - 9 * t, "temperature": t,
                          "pressure": 5 * (temperature - 300) + (8 if k % 2 else -8)})
        return found

    def test_at_temperature(self):
        """Exact where T(E), V(E) and P(E) are lines; errors vanish where all blocks lie on them."""
        found = analysis.blocks([self.made(t, 2.0) for t in (290, 297, 309)], 5)
        self.assertEqual(len(found), 15)
        value, error = analysis.jackknife(found, lambda own: analysis.at_temperature(own, 300))
        for name, expected in (("potential", 21 * 300), ("pressure", 0), ("heat_capacity", 30)):
            self.assertAlmostEqual(value[name], expected, 7)
            self.assertAlmostEqual(error[name], 0, 7)

    def test_first_peak(self):
        """Exact where place and height are lines in the temperature; the mean where all runs have the same."""
        runs = [(t, 0.27 + 1e-4 * (t - 298), 3 - 0.01 * (t - 298)) for t in (290, 297, 306)]
        value, error = analysis.first_peak(runs, 298)
        self.assertAlmostEqual(value["place"], 0.27, 12)
        self.assertAlmostEqual(value["height"], 3, 12)
        self.assertAlmostEqual(error["height"], 0, 12)
        self.assertAlmostEqual(analysis.first_peak([(298, 0.27, 3), (298, 0.28, 3.2)], 300)[0]["height"], 3.1, 12)

    def test_jackknife_of_a_mean(self):
        """Its error is that of the mean: sqrt of the sample variance divided by n."""
        value, error = analysis.jackknife([1.0, 2.0, 4.0, 7.0], lambda own: {"mean": sum(own) / len(own)})
        self.assertAlmostEqual(value["mean"], 3.5, 12)
        self.assertAlmostEqual(error["mean"], sqrt(21 / 3 / 4), 12)


class Files(unittest.TestCase):
    def test_table(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "rdf.csv"
            path.write_text("# polhode 0.2\nr [nm],g OW-OW [1]\n0.001,0\n0.003,1.5\n", encoding="utf-8")
            self.assertEqual(waters.table(path), [{"r": 0.001, "g OW-OW": 0}, {"r": 0.003, "g OW-OW": 1.5}])

    def test_quick(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", BENCH / "liquids.py", "--quick", "--polhode", built_program.PROGRAM,
                                  "--output", "numbers", "--figure", "picture.svg"],
                                 cwd=folder, text=True, capture_output=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            result = json.loads((Path(folder) / "numbers.json").read_text(encoding="utf-8"))
            self.assertEqual([w["model"] for w in result["waters"]], ["tip4p", "spce", "tip4p-2005"])
            for w in result["waters"]:
                self.assertEqual(len(w["runs"]), 2)
                # Three picoseconds are enough to detect errors of units or of counting, but no more.
                self.assertLess(abs(w["peak_nm"]["value"] - 0.276), 0.02)
                self.assertLess(abs(w["runs"][0]["potential_kJ_per_mol"] + 44), 5)
            self.assertTrue((Path(folder) / "numbers.md").exists())
            self.assertTrue((Path(folder) / "picture.gp").exists())
            self.assertEqual((Path(folder) / "picture.svg").exists(), bool(shutil.which("gnuplot")))


if __name__ == "__main__":
    built_program.main()
