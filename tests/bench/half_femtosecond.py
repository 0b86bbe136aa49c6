#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bench/half_femtosecond: costs from curves, means over runs, and a record that is continued and not repeated."""

import sys
import tempfile
import unittest
from pathlib import Path

import built_program

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench/half_femtosecond"))

import figures  # noqa: E402
import points  # noqa: E402
import properties  # noqa: E402
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

    def test_maximum_of_a_curve_that_falls_faster_on_the_cold_side(self):
        T = [257, 267, 277, 287, 298, 308, 318]
        curve = tables.density_fit(T, [1000 - 0.01 * (t - 277) ** 2 + 1e-4 * (t - 277) ** 3 for t in T])
        self.assertAlmostEqual(tables.maximum(curve), 277)
        self.assertEqual(tables.maximum(tables.density_fit(T, [1000 + t for t in T])), 318)

    def test_bias_of_a_density(self):
        run = {"density_kg_per_m3": {"value": 1000}, "volume_nm3": {"value": 6.0}, "step_bias": {"volume_nm3": {"value": 0.003}}}
        self.assertAlmostEqual(tables.density_bias(run), -0.5)
        self.assertAlmostEqual(tables.unbiased_density(run), 1000.5)

    def test_maxima_with_and_without_a_prediction(self):
        """The scheme with a prediction says that its density is 0.2 % too high; the other has 0.1 % more than the limit, and its
        maximum 4 K above that. Runs that agree have no errors."""
        true = lambda T: 1000 - 0.005 * (T - 277) ** 2
        volume = {"value": 6.0}
        runs = {}
        for T in (257, 267, 277, 287, 297):
            with_prediction = {"density_kg_per_m3": {"value": true(T) / 0.998}, "volume_nm3": volume, "step_bias": {"volume_nm3": {"value": -0.012}}}
            own = {"density_kg_per_m3": {"value": 1.001 * true(T - 4)}, "volume_nm3": volume, "step_bias": None}
            for scheme, run in (("hoa2", with_prediction), ("gier4-fd", own)):
                runs[points.Point("density", "tip4p-2005", T, 1, "constant pressure", scheme, 4, 500)] = [run, run]
        limit, gier4, hoa2 = tables.maxima(runs).splitlines()[2:]
        self.assertEqual(limit, "| limit of short steps | 277.0 ± 0.0 |  |  |")
        self.assertEqual(hoa2.replace("-0.0", "0.0"), "| hoa2, 4 fs | 277.0 ± 0.0 | 0.0 ± 0.0 | 0.200 ± 0.000 |")
        self.assertEqual(gier4, "| gier4-fd, 4 fs | 281.0 ± 0.0 | 4.0 ± 0.0 | 0.092 ± 0.000 |")  # 0.1 % - 0.005 * 16 / 1000

    def test_curves_of_the_density_have_the_colours_of_schemes_and_the_values_of_their_fits(self):
        looks = figures.density_looks(["velocity-verlet, 2 fs", "velocity-verlet, 4 fs", "hoa2, 4 fs"])
        styles = figures.drawing.styles(["velocity-verlet", "hoa2"])
        self.assertEqual(looks["hoa2, 4 fs"], (styles["hoa2"].colour, styles["hoa2"].filled, 1))
        self.assertEqual(looks["velocity-verlet, 2 fs"], (styles["velocity-verlet"].colour, styles["velocity-verlet"].open, 2))
        self.assertEqual(looks["velocity-verlet, 4 fs"], (styles["velocity-verlet"].colour, styles["velocity-verlet"].filled, 1))
        fit = tables.density_fit([257, 267, 277, 287, 298], [997, 1001, 1002, 1001, 998])
        for T in (257, 270, 298):
            self.assertAlmostEqual(eval(figures.polynomial(fit), {"x": T}), fit(T), places=6)

    def test_slope_of_a_weighted_line(self):
        value, error = properties.slope([(0.98, 3 - 0.04, 0.1), (1, 3, 0.1), (1.02, 3 + 0.04, 0.1)])
        self.assertAlmostEqual(value, 2)
        self.assertAlmostEqual(error, 0.1 / (2 * 0.02**2) ** 0.5)
        self.assertAlmostEqual(properties.slope([(0, 0, 1), (1, 5, 1), (2, 100, 1e9)])[0], 5)


class Record(unittest.TestCase):
    def test_runs_that_are_recorded_are_not_repeated(self):
        class Options:
            quick, groups, jobs, runs, polhode = True, ["quick", "canonical", "friction", "properties", "structure", "density"], 2, 1, built_program.PROGRAM

        water = ("spce", 298.15, 0.998)
        some = [points.Point("quick", *water, "constant energy", "velocity-verlet", 4, 1),
                points.Point("canonical", *water, "rescaling", "velocity-verlet", 4, 1),
                points.Point("friction", *water, points.langevin(20), "baoab", 4, 1),
                points.Point("properties", *water, "constant energy", "velocity-verlet", 4, 1),
                points.Point("structure", *water, "hybrid Monte Carlo", "hoa2", 4, 1),
                points.Point("density", *water, "constant pressure", "velocity-verlet", 4, 1)]
        for name, short in ("points", lambda quick: some), ("equilibrate", lambda point: 1):
            self.addCleanup(setattr, points, name, getattr(points, name))
            setattr(points, name, short)
        with tempfile.TemporaryDirectory() as folder:
            Options.record = Path(folder) / "record.jsonl"
            study.complete(Options, study.known(Options.record))
            first = Options.record.read_text(encoding="utf-8")
            self.assertEqual(len(first.splitlines()), 6)
            Options.runs = 2
            study.complete(Options, study.known(Options.record))
            both = Options.record.read_text(encoding="utf-8")
            self.assertTrue(both.startswith(first))
            self.assertEqual(len(both.splitlines()), 12)
            text = study.report(study.known(Options.record).values())
        for word in ("Constant energy", "Constant temperature", "Friction", "Structure", "Structure with Langevin thermostats", "| hybrid Monte Carlo | hoa2 |", "Density", "| velocity-verlet | 4 | 250 |", "| baoab | 4 | 20/ps |"):
            self.assertIn(word, text)


if __name__ == "__main__":
    built_program.main()
