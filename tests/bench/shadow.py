# SPDX-License-Identifier: MIT
"""bench/shadow on four waters goes through all of it, and its table holds what the runs said."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import built_program

BENCH = Path(__file__).resolve().parents[2] / "bench/shadow/shadow.py"
sys.path.insert(0, str(BENCH.parent))

import shadow


class Shadow(unittest.TestCase):
    def test_samples_are_whole_steps_near_4_fs(self):
        self.assertEqual([shadow.sample(h) for h in (1, 2, 3, 4, 6)], [4, 4, 3, 4, 6])

    def test_few_waters(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", BENCH, "--program", built_program.PROGRAM, "--length", "0.3", "--equilibrate", "0.05",
                                  "--system", 'molecules = [{ model = "tip4p", count = 8 }]\ndensity = "0.1 g/cm3"',
                                  "--forces", 'cutoff = "0.6 nm"\nswitch = "0.5 nm"', "--output", "result.json"],
                                 cwd=folder, text=True, capture_output=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            rows = json.loads((Path(folder) / "result.json").read_text(encoding="utf-8"))["runs"]
        self.assertEqual([(r["scheme"], r["step_fs"]) for r in rows], shadow.ROWS)
        self.assertEqual(run.stdout, shadow.table(rows))
        for r in rows:
            self.assertLess(r["shadow"]["rms_kJ_per_mol"], r["rms_total_kJ_per_mol"])  # what the shadow energy is for
            self.assertGreater(r["shadow"]["drift_error"], 0)


if __name__ == "__main__":
    built_program.main()
