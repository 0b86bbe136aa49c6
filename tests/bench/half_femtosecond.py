#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bench/half_femtosecond: costs from curves, means over runs, and a record that is continued and not repeated."""

import sys
import tempfile
import unittest
from pathlib import Path

import built_program

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench/half_femtosecond"))

import points  # noqa: E402
import study  # noqa: E402
import tables  # noqa: E402


class Tables(unittest.TestCase):
    def test_cost_at_a_bias(self):
        law = lambda *costs: [(cost, 8e6 / cost**2) for cost in costs]  # second order
        for curve in (law(250, 500, 1000), law(1000, 500, 250), law(2000, 4000), law(100, 200), [(c, -b) for c, b in law(250, 500, 1000)]):
            self.assertAlmostEqual(tables.cost_at(curve, 20), 632.455532, places=5)
        self.assertIsNone(tables.cost_at(law(500), 20))

    def test_means_over_runs(self):
        value, error = tables.mean([1, 2, 3])
        self.assertAlmostEqual(value, 2)
        self.assertAlmostEqual(error, 1 / 3**0.5)
        self.assertEqual(tables.cell((1.23456, 0.012), 3), "1.235 ± 0.012")
        self.assertEqual(tables.cell(tables.mean([1.5]), 1), "1.5")

    def test_maximum_of_a_parabola(self):
        T = [260, 270, 280, 290, 300]
        self.assertAlmostEqual(tables.maximum(T, [1000 - 0.005 * (t - 277) ** 2 for t in T]), 277)

    def test_bias_of_a_density(self):
        run = {"density_kg_per_m3": {"value": 1000}, "volume_nm3": {"value": 6.0}, "step_bias": {"volume_nm3": {"value": 0.003}}}
        self.assertAlmostEqual(tables.density_bias(run), -0.5)


class Record(unittest.TestCase):
    def test_runs_that_are_recorded_are_not_repeated(self):
        class Options:
            quick, groups, jobs, runs, polhode = True, ["quick"], 2, 1, built_program.PROGRAM

        water = ("spce", 298.15, 0.998)
        some = [points.Point("quick", *water, "constant energy", "velocity-verlet", 4, 1),
                points.Point("quick", *water, "rescaling", "velocity-verlet", 4, 1),
                points.Point("quick", *water, "constant pressure", "velocity-verlet", 4, 1)]
        every, points.points = points.points, lambda quick: some
        self.addCleanup(setattr, points, "points", every)
        with tempfile.TemporaryDirectory() as folder:
            Options.record = Path(folder) / "record.jsonl"
            study.complete(Options, study.known(Options.record))
            first = Options.record.read_text(encoding="utf-8")
            self.assertEqual(len(first.splitlines()), 3)
            Options.runs = 2
            study.complete(Options, study.known(Options.record))
            both = Options.record.read_text(encoding="utf-8")
            self.assertTrue(both.startswith(first))
            self.assertEqual(len(both.splitlines()), 6)
            text = tables.markdown(study.known(Options.record).values())
        for word in ("Constant energy", "Constant temperature", "Constant pressure", "| velocity-verlet | 4 | 250 |"):
            self.assertIn(word, text)


if __name__ == "__main__":
    built_program.main()
