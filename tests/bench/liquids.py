# SPDX-License-Identifier: MIT
"""The results of bench/liquids are right for lattices and formulas, and its driver runs and stores its results."""

import argparse
import json
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
from math import exp, pi, sqrt
from pathlib import Path

BENCH = Path(__file__).resolve().parents[2] / "bench/liquids"
sys.path.insert(0, str(BENCH))

import analysis
import waters

PROGRAM = None  # the built program, from the command line


class Radial(unittest.TestCase):
    def test_cubic_lattice(self):
        """Shells of a simple cubic lattice: 6 neighbours at a, 12 at a√2, 8 at a√3, including periodic images."""
        n, a = 6, 0.311
        edge = n * a
        # Shifted away from the box faces, and some of them displaced by a box edge.
        places = [((i + 0.3) * a + edge * (i % 2), (j + 0.7) * a - edge * (k % 2), (k + 0.1) * a)
                  for i in range(n) for j in range(n) for k in range(n)]
        counts = analysis.distances(edge, places)
        for distance, neighbours in ((a, 6), (a * sqrt(2), 12), (a * sqrt(3), 8)):
            k = int(distance / analysis.BIN)
            self.assertEqual(counts[k], len(places) * neighbours // 2)
        self.assertEqual(sum(counts[: int(2 * a / analysis.BIN) - 1]), len(places) * 13)
        g = analysis.radial([counts, counts], edge, len(places))
        k = int(a / analysis.BIN)
        shell = 4 / 3 * pi * ((k + 1) ** 3 - k**3) * analysis.BIN**3
        self.assertAlmostEqual(g[k][0], (k + 0.5) * analysis.BIN, 12)
        self.assertAlmostEqual(g[k][1], 6 / (shell * (len(places) - 1) / edge**3), 9)

    def test_ideal_gas(self):
        """g is 1 for random positions: within four Poisson errors of a wide shell."""
        draw, edge, n, frames = random.Random(1), 2.2, 100, 8
        histograms = [analysis.distances(edge, [tuple(edge * draw.random() for _ in range(3)) for _ in range(n)])
                      for _ in range(frames)]
        expected = frames * n * (n - 1) / 2 * 4 / 3 * pi * analysis.REACH**3 / edge**3
        self.assertLess(abs(sum(map(sum, histograms)) - expected), 4 * sqrt(expected))

    def test_peak(self):
        """The maximum of a smooth curve is found to within a small fraction of a bin."""
        top, width = 0.2773, 0.012
        g = [(r, 3 * exp(-((r - top) / width) ** 2 / 2))
             for r in ((k + 0.5) * analysis.BIN for k in range(300))]
        found = analysis.first_peak(g)
        # A cubic through exp(-x²/2) above 0.9 of its height misses x⁴/8 <= 0.9 %, most of which the fit takes up.
        self.assertAlmostEqual(found["height"], 3, delta=3 * 0.005)
        self.assertAlmostEqual(found["place"], top, delta=0.1 * analysis.BIN)


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
        for name, wanted in (("potential", 21 * 300), ("pressure", 0), ("heat_capacity", 30)):
            self.assertAlmostEqual(value[name], wanted, 7)
            self.assertAlmostEqual(error[name], 0, 7)

    def test_jackknife_of_a_mean(self):
        """Its error is that of the mean: sqrt of the sample variance divided by n."""
        value, error = analysis.jackknife([1.0, 2.0, 4.0, 7.0], lambda own: {"mean": sum(own) / len(own)})
        self.assertAlmostEqual(value["mean"], 3.5, 12)
        self.assertAlmostEqual(error["mean"], sqrt(21 / 3 / 4), 12)


class Files(unittest.TestCase):
    def test_frames(self):
        atoms = "O 1 2 3 0 0 0\nH 1 2 4 0 0 0\nH 2 2 3 0 0 0\n"
        text = f'3\nLattice="22 0 0 0 22 0 0 0 22" Time=0\n{atoms}3\nLattice="22 0 0 0 22 0 0 0 22" Time=1\n{atoms}'
        for edge, oxygens in waters.frames(text):
            self.assertAlmostEqual(edge, 2.2, 12)
            self.assertEqual(len(oxygens), 1)
            for x, wanted in zip(oxygens[0], (0.1, 0.2, 0.3)):
                self.assertAlmostEqual(x, wanted, 12)
        self.assertEqual(len(waters.frames(text)), 2)

    def test_quick(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", BENCH / "liquids.py", "--quick", "--polhode", PROGRAM,
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
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    options, rest = parser.parse_known_args()
    PROGRAM = options.program.resolve()
    unittest.main(module="__main__", argv=["liquids", *rest])
