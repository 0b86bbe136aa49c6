# SPDX-License-Identifier: MIT
"""The evaluation of curves by bench/multiple_time_steps is right for known laws, and its figure labels every curve."""

import json
import sys
import tempfile
import unittest
from math import sqrt
from pathlib import Path

BENCH = Path(__file__).resolve().parents[2] / "bench/multiple_time_steps"
sys.path.insert(0, str(BENCH))

import figure
import curves
import multiple_time_steps


def curve(scheme, evaluations, factor, steps, usable=lambda h: True):
    """Points of a scheme with R = factor h² [fs⁻²] at evaluations per step."""
    return [{"scheme": scheme, "step_fs": h, "force_evaluations_per_ps": 1000 * evaluations / h, "R": factor * h * h,
             "stable": usable(h)} for h in steps]


class Curves(unittest.TestCase):
    def test_a_power_law_is_met_between_its_points(self):
        cost, step = curves.at_ratio(curve("hoa2", 2, 2e-4, (2, 4, 8)), 5e-3)
        self.assertAlmostEqual(step, sqrt(5e-3 / 2e-4), 9)
        self.assertAlmostEqual(cost, 2000 / step, 6)

    def test_nothing_is_read_beyond_what_was_measured(self):
        own = curve("hoa2", 2, 2e-4, (2, 4, 8), usable=lambda h: h < 8)
        self.assertIsNone(curves.at_ratio(own, 2e-4 * 3.9))  # below the smallest R
        cost, step = curves.at_ratio(own, 5e-3)  # with 8 fs it blew up: the longest step before
        self.assertEqual((cost, step), (500, 4))
        self.assertIsNone(curves.at_ratio(curve("hoa2", 2, 2e-4, (2, 4), usable=lambda h: False), 1e-2))

    def test_a_curve_ends_where_its_energy_is_lost_whatever_the_p_value_of_a_drift(self):
        own = curve("hoa2", 2, 2e-4, (2, 4, 8))
        own[1].update(R=1.2, drift_p_value=0.0034)  # two runs with a drift of 185 times its error
        self.assertEqual(len(curves.usable(own)), 1)
        own[1].update(R=3e-3, drift_p_value=0.0034)
        self.assertEqual(len(curves.usable(own)), 3)
        own[1].update(stable=False)
        self.assertEqual(len(curves.usable(own)), 1)

    def test_the_figure_draws_single_schemes_and_the_best_of_each_pair(self):
        pair = "hoa2 / hoa2 x {} within 0.35 to 0.5 nm"
        points = (curve("hoa2", 2, 2e-4, (4, 5)) + curve(pair.format(1), 3, 1e-4, (6, 8))
                  + curve(pair.format(2), 9, 1e-4, (6, 8)))
        with tempfile.TemporaryDirectory() as folder:
            script = figure.script({"laws": {"cutoff": {"points": points}}}, Path(folder) / "a.svg")
        self.assertIn(f'title "{pair.format(1)}"', script)
        self.assertNotIn(pair.format(2), script)
        self.assertIn('title "hoa2"', script)

    def test_the_table_compares_at_equal_ratio(self):
        row = {"R": 0.005, "single": {"scheme": "a", "step_fs": 4, "cost": 500, "seconds_per_ps": 0.2},
               "nested": {"scheme": "b / c", "step_fs": 6, "cost": 400, "seconds_per_ps": 0.1}}
        table = multiple_time_steps.table({"laws": {"pme": {"guideline": [row, {"R": 0.01}]}}})
        self.assertIn("| 1.25 | 2.00 |", table)
        self.assertEqual(len(table.splitlines()), 3)
        json.dumps(row)


if __name__ == "__main__":
    unittest.main()
