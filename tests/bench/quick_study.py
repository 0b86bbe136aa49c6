# SPDX-License-Identifier: MIT
"""bench/quick_study on short runs goes through all of it, and it finds the curves that lack points."""

import io
import subprocess
import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from pathlib import Path

import built_program

BENCH = Path(__file__).resolve().parents[2] / "bench/quick_study/quick_study.py"
sys.path.insert(0, str(BENCH.parent))

import quick_study


def point(scheme, step, usable, p_value=0.5):
    return {"scheme": scheme, "step_fs": step, "usable": usable, "drift_p_value": p_value}


class QuickStudy(unittest.TestCase):
    def test_points_that_are_missing(self):
        points = [point("hoa2", 4, True, 0.001), point("hoa2", 7, False), point("hoa2", 9, False), point("gier4-fd", 3, True)]
        self.assertEqual(quick_study.missing(points, {"hoa2": 7, "gier4-fd": 8}), [("hoa2", 7)])
        self.assertEqual(quick_study.lone_drifts(points), [("hoa2", 4)])
        studies = {("avx2", 1): {"points": points, "guidelines": [{"R": 0.001, "best": "gier4-fd"}]}}
        with redirect_stdout(io.StringIO()) as said:
            self.assertEqual(quick_study.report(studies, {"hoa2": 7, "gier4-fd": 8}), 1)
        self.assertIn("avx2 | 1 | hoa2 7 fs | hoa2 4 fs | gier4-fd", said.getvalue())
        self.assertIn("1 of 2 curves lack points", said.getvalue())

    def test_the_reference_reaches_the_ends_of_the_paper(self):
        last = quick_study.last_steps(quick_study.FIGURE.read_text(encoding="utf-8").splitlines())
        self.assertEqual(last, {"velocity-verlet": 6, "hoa2": 7, "gier4-fd": 8})

    def test_short_runs(self):
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, "-B", BENCH, "--polhode", built_program.PROGRAM, "--seeds", "1", "--instruction-sets", "scalar", "--folder",
                       "studies", "--", "--length", "0.08 ps", "--decorrelate", "0.01 ps", "--runs", "2", "--steps", "4 fs"]
            first, again = (subprocess.run(command, cwd=folder, text=True, capture_output=True, check=False) for _ in range(2))
            self.assertEqual(first.returncode, 0, first.stderr)
            self.assertIn("scalar | 1 | none |", first.stdout)
            self.assertEqual(again.stdout, first.stdout)


if __name__ == "__main__":
    built_program.main()
