# SPDX-License-Identifier: MIT
"""bench/ensembles: its estimator has the slope and the errors of known densities, and short runs sample their ensembles."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy as np
except ImportError:
    sys.exit(77)

import built_program

ENSEMBLES = Path(__file__).resolve().parents[2] / "bench/ensembles/ensembles.py"
sys.path.insert(0, str(ENSEMBLES.parent))

import agreement
import slopes


def correlated(random, n, centre, phi):
    """Normal values of variance 1 with the autocorrelation phi^|k|."""
    noise = np.sqrt(1 - phi * phi) * random.normal(size=n)
    x = np.empty(n)
    x[0] = random.normal()
    for k in range(1, n):
        x[k] = phi * x[k - 1] + noise[k]
    return centre + x


class Estimator(unittest.TestCase):
    def test_inefficiency_of_a_known_correlation(self):
        random = np.random.default_rng(1)
        for phi in (0.0, 0.5, 0.9):
            # g = (1 + phi)/(1 - phi), known to sqrt(4 (2 W + 1)/n) of itself with a window W of 2.5 g: 7 % for g = 19
            g = slopes.inefficiency(correlated(random, 80000, 0, phi))
            self.assertLess(abs(g / ((1 + phi) / (1 - phi)) - 1), 4 * 0.07)

    def test_slope_and_its_error_are_those_of_normal_densities(self):
        # Normal densities of variance 1 at 0 and at d have ln p2/p1 = const + d x.
        random = np.random.default_rng(2)
        d, deviations = 1.5, []
        for _ in range(60):
            first, second = (slopes.independent(correlated(random, 4000, centre, 0.8)) for centre in (0, d))
            s, error = slopes.slope(first, second)
            deviations.append((s - d) / error)
        # The rms of 60 standard normal deviates is 1 +- 1/sqrt(120), and their mean 0 +- 1/sqrt(60); subsampled values keep
        # a correlation below 0.8^9 = 0.13, which makes errors too small by 10 % at most.
        self.assertLess(abs(np.sqrt(np.mean(np.square(deviations))) - 1), 4 / np.sqrt(120) + 0.1)
        self.assertLess(abs(np.mean(deviations)), 4 / np.sqrt(60))

    def test_the_slopes_of_theory(self):
        at = [{"temperature": 300, "pressure": 1}, {"temperature": 300, "pressure": 1001}]
        self.assertAlmostEqual(slopes.expected("volume", *at), -60.2214076 / (0.00831446261815324 * 300))  # 1000 bar
        at[1]["temperature"] = 330
        self.assertAlmostEqual(slopes.expected("potential", *at), (1 / 300 - 1 / 330) / 0.00831446261815324)


class Agreement(unittest.TestCase):
    def test_deviations_from_all_others(self):
        # The mean of the others is 0 with an error of sqrt(3² + 0²)/2 = 1.5; sqrt(2² + 1.5²) = 2.5.
        self.assertAlmostEqual(agreement.deviations([(5, 2), (-1, 3), (1, 0)])[0], 2)
        self.assertEqual(agreement.deviations([(1, 1)] * 3), [0, 0, 0])

    def test_mean_of_blocks(self):
        # Blocks of 100 with the means 1, 3 and 5: variance 4. The 101st value of the last block is left out.
        found = agreement.mean(np.repeat([1.0, 3.0, 5.0], [100, 100, 101]), 3)
        self.assertAlmostEqual(found[0], 3)
        self.assertAlmostEqual(found[1], np.sqrt(4 / 3))

    def test_scaled_velocities(self):
        numbers = lambda r, v: "".join(f"{x:15.10f}" for x in r) + "".join(f"{x:15.11f}" for x in v)
        gro = lambda v: "\n".join(["polhode", "1", "    1spce    OW    1" + numbers((1, 2, 3), v), numbers((3, 3, 3), ()), ""])
        self.assertEqual(agreement.with_scaled_velocities(gro((0.5, -1, 2)), 1.5), gro((0.75, -1.5, 3)))


class Runs(unittest.TestCase):
    # Every thermostat and barostat. A deviation of 4 standard errors, themselves known to 10 %, occurs by chance in 1 of 3,000
    # checks.
    def test_short_runs_sample_their_ensembles(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", ENSEMBLES, "--program", built_program.PROGRAM, "--systems", "CO2",
                                  "--length", "400", "--equilibrate", "4", "--runs", "2", "--output", "result"],
                                 cwd=folder, text=True, capture_output=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            result = json.loads((Path(folder) / "result.json").read_text(encoding="utf-8"))
            table = (Path(folder) / "result.md").read_text(encoding="utf-8")
        self.assertEqual(len(result["slopes"]), 10)
        for found in result["slopes"] + result["agreement"]:
            with self.subTest(**{k: found[k] for k in ("method", "quantity")}):
                self.assertLess(abs(found["deviation"]), 4)
        for found in result["slopes"]:  # not by errors that are too large
            self.assertLess(found["error"], 0.5 * abs(found["expected"]), found["method"])
        self.assertIn("| CO2 | constant energy |", table)

    def test_costs_of_ensembles(self):
        done = subprocess.run([sys.executable, "-B", ENSEMBLES.parent / "costs.py", "--program", built_program.PROGRAM, "--steps", "200",
                               "--rounds", "2", "--electrostatics", "reaction-field"], check=True, text=True, stdout=subprocess.PIPE)
        rows = [line.split("|") for line in done.stdout.splitlines()[2:]]
        self.assertEqual(len(rows), 10)
        for row in rows:
            self.assertGreater(float(row[4]), 0)


if __name__ == "__main__":
    built_program.main()
