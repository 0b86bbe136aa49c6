# SPDX-License-Identifier: MIT
"""The evaluation of curves by bench/all_schemes is right for known laws, and its tables and figure are labelled."""

import sys
import tempfile
import unittest
from math import sqrt
from pathlib import Path

BENCH = Path(__file__).resolve().parents[2] / "bench/all_schemes"
sys.path.insert(0, str(BENCH))

import all_schemes
import figure


def curve(scheme, evaluations, factor, order, steps, max_step=99):
    """Points of a scheme with R = factor hⁿ at evaluations per step; above the longest step the energy is lost."""
    return [{"scheme": scheme, "step_fs": h, "force_evaluations_per_ps": 1000 * evaluations / h, "stable": True,
             "R": factor * h**order if h <= max_step else 1.2} for h in steps]


class Family(unittest.TestCase):
    def test_steps_cost_the_same_for_every_scheme(self):
        for cheap, dear in zip(all_schemes.steps("pme", 1), all_schemes.steps("pme", 4)):
            self.assertAlmostEqual(4 * cheap / dear, 1, 2)  # three digits
        self.assertAlmostEqual(all_schemes.steps("pme", 2)[0], 1)  # 2,000 evaluations per ps
        self.assertAlmostEqual(all_schemes.steps("co2", 2)[0], 2)

    def test_costs_between_below_and_above_the_points(self):
        own = curve("hoa2", 2, 2e-4, 2, (2, 4, 8), max_step=4)
        cost, step, how = all_schemes.cost_at(own, 2e-4 * 9, 2)
        self.assertAlmostEqual(step, 3, 9)
        self.assertEqual(how, "")
        cost, step, how = all_schemes.cost_at(own, 2e-4 * 1, 2)
        self.assertAlmostEqual(cost, 2000, 6)
        self.assertEqual(how, "*")
        self.assertEqual(all_schemes.cost_at(own, 1, 2), (500, 4, "+"))
        self.assertIsNone(all_schemes.cost_at(curve("hoa2", 2, 2e-4, 2, (2, 4), max_step=1), 1, 2))

    def test_the_figure_tells_the_cheapest_apart_and_marks_what_drifts(self):
        points = curve("hoa2", 2, 2e-4, 2, (2, 4, 8), max_step=4) + curve("bcss3", 3, 1e-5, 2, (2, 4)) + curve(
            "yoshida6", 7, 1e-3, 6, (2, 4))
        ranking = [{"R": 0.01, "schemes": [{"scheme": "bcss3", "cost": 300, "step_fs": 4, "how": ""},
                                           {"scheme": "hoa2", "cost": 500, "step_fs": 4, "how": "+", "seconds_per_ps": 0.2}]}]
        result = {"systems": {"pme": {"points": points, "ranking": ranking}}}
        with tempfile.TemporaryDirectory() as folder:
            script = figure.script(result, Path(folder) / "a.svg")
        self.assertIn('title "bcss3"', script)
        self.assertNotIn('title "yoshida6"', script)
        self.assertIn('title "1 others"', script)  # no line without a name
        self.assertEqual(script.count("pointtype 2 "), 2)  # one curve has points beyond its end; and the legend

    def test_schemes_have_the_styles_of_all_figures(self):
        table = figure.drawing.styles(["hoa2", "a / b", "gier4-fd", "B(1/2) A(1) B(1/2)"])
        self.assertEqual(table["hoa2"], ("#D55E00", 5, 4))
        self.assertEqual(table["a / b"], figure.drawing.styles(["other"])["other"])
        self.assertEqual(len(set(table.values())), 4)
        points = curve("hoa2", 2, 2e-4, 2, (2, 4)) + curve("gier4-fd", 3, 1e-6, 4, (2, 4))
        script = figure.script({"systems": {"pme": {"points": points, "ranking": []}}}, Path("a.svg"))
        for scheme in ("hoa2", "gier4-fd"):
            self.assertIn(f'pointtype {table[scheme].filled} linewidth 1.8 linecolor "{table[scheme].colour}" title "{scheme}"', script)

    def test_table(self):
        ranking = [{"R": 0.01, "schemes": [{"scheme": "bcss3", "cost": 300, "step_fs": 4, "how": ""},
                                           {"scheme": "hoa2", "cost": 500, "step_fs": 4, "how": "+", "seconds_per_ps": 0.2}]}]
        result = {"systems": {"pme": {"points": [], "ranking": ranking}}}
        table = all_schemes.tables(result)
        self.assertIn("| bcss3 | **300** |", table)
        self.assertIn("| hoa2 | 500+ (200 s) |", table)


if __name__ == "__main__":
    unittest.main()
