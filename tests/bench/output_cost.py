# SPDX-License-Identifier: MIT
"""bench/output_cost measures each format and the checkpoint, and its tables contain the results."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import built_program

WRITING = Path(__file__).resolve().parents[2] / "bench/output_cost/output_cost.py"
sys.path.insert(0, str(WRITING.parent))

import output_cost


class Writing(unittest.TestCase):
    def test_the_share_is_of_all_else(self):
        self.assertAlmostEqual(output_cost.share({"all": 5.0, "energies_and_output": 1.0}), 0.25)
        self.assertEqual(output_cost.spread([2.0]), {"median": 2.0, "quartiles": [2.0, 2.0]})

    def test_short_runs(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", WRITING, "--program", built_program.PROGRAM, "--formats", "xtc", "h5md", "--every",
                                  "0.02", "--length", "0.08", "--rounds", "2", "--waters", "512", "--steps", "4",
                                  "--folder", folder, "--output", "result"],
                                 cwd=folder, text=True, capture_output=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            result = json.loads((Path(folder) / "result.json").read_text(encoding="utf-8"))
            table = (Path(folder) / "result.md").read_text(encoding="utf-8")
        size = {t["format"]: t["bytes_a_frame"] for t in result["trajectories"]}
        # 2048 sites and 512 bodies: 24 bytes a site, 104 a body, and heads; XTC packs 12 bytes a site to a third.
        self.assertGreater(size["h5md"], 2048 * 24 + 512 * 104)
        self.assertLess(size["xtc"], 2048 * 4)
        self.assertGreater(result["checkpoints"]["bytes"], 176 * 512)
        self.assertIn("| 0.02 ps | xtc |", table)


if __name__ == "__main__":
    built_program.main()
