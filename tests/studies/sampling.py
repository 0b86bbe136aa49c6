# SPDX-License-Identifier: MIT
"""Short runs of CO2 sample their ensembles, with every thermostat and barostat."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import study_path  # first: it says where the others are
import built_program


class Runs(unittest.TestCase):
    # A deviation of 4 standard errors, themselves known to 10 %, occurs by chance in 1 of 3,000 checks.
    def test_short_runs_sample_their_ensembles(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", study_path.ROOT / "studies/ensembles.py", "--program", built_program.PROGRAM, "--systems",
                                  "CO2", "--length", "240", "--equilibrate", "4", "--jobs", "2"], cwd=folder, text=True, capture_output=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            result = json.loads((Path(folder) / "ensembles.json").read_text(encoding="utf-8"))
        self.assertEqual(len(result["slopes"]), 10)
        for found in result["slopes"] + result["agreement"]:
            with self.subTest(**{k: found[k] for k in ("method", "quantity")}):
                self.assertLess(abs(found["deviation"]), 4)
        for found in result["slopes"]:  # not by errors that are too large
            self.assertLess(found["error"], 0.5 * abs(found["expected"]), found["method"])
        self.assertIn("| CO2 | constant energy |", run.stdout)


if __name__ == "__main__":
    built_program.main()
