# SPDX-License-Identifier: MIT
"""bench/ensemble_cost measures every thermostat and barostat."""

import subprocess
import sys
import unittest
from pathlib import Path

import built_program

SCRIPT = Path(__file__).resolve().parents[2] / "bench/ensemble_cost/ensemble_cost.py"


class Costs(unittest.TestCase):
    def test_costs_of_ensembles(self):
        done = subprocess.run([sys.executable, "-B", SCRIPT, "--program", built_program.PROGRAM, "--steps", "200", "--rounds", "2",
                               "--electrostatics", "reaction-field"], check=True, text=True, stdout=subprocess.PIPE)
        rows = [line.split("|") for line in done.stdout.splitlines()[2:]]
        self.assertEqual(len(rows), 10)
        for row in rows:
            self.assertGreater(float(row[4]), 0)


if __name__ == "__main__":
    built_program.main()
