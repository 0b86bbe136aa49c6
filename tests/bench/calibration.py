# SPDX-License-Identifier: MIT
"""bench/calibration: its statistics on numbers whose result is known, and both scripts from end to end on small systems."""

import json
import math
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import built_program

FOLDER = Path(__file__).resolve().parents[2] / "bench/calibration"
sys.path.insert(0, str(FOLDER))

import analyze
import averages
import calibration


def runs_of(error, runs=400, pieces=5):
    """Pieces with scatter 1 about the mean of their run, which itself scatters by 10, and a stated error."""
    draw = random.Random(5)
    result = []
    for _ in range(runs):
        centre = draw.gauss(0, 10)
        result.append([{"x": [centre + draw.gauss(0, 1), error]} for _ in range(pieces)])
    return result


class Statistics(unittest.TestCase):
    # 1600 degrees of freedom know a scatter to 1/√3200 = 1.8 %; three times that is allowed.
    def test_stated_errors_over_the_scatter_within_runs(self):
        for error in (0.5, 1.0, 2.0):
            every, told, scatter, rms, mean = analyze.compared(runs_of(error), "x")
            self.assertEqual((every, told), (2000, 1))
            self.assertAlmostEqual(scatter, 1, delta=0.054)
            self.assertAlmostEqual(rms / error, 1, delta=0.054)
            self.assertAlmostEqual(mean / error, 1, delta=0.054)

    def test_pieces_without_an_error_are_counted_as_such(self):
        runs = runs_of(1.0)
        for run in runs:
            run[0]["x"][1] = None
        every, told, *_ = analyze.compared(runs, "x")
        self.assertEqual((every, told), (2000, 0.8))

    def test_fractions_are_relative_to_their_level(self):
        reports = [{"drift_p_value": p} for p in (0.001, 0.02, 0.04, 0.5, None, 0.7, 0.8, 0.9, 0.95, 0.99)]
        self.assertAlmostEqual(calibration.fired(reports, 0.05), 0.3 / 0.05)
        self.assertAlmostEqual(calibration.fired(reports, 0.01), 0.1 / 0.01)

    def test_errors_over_the_scatter_between_runs(self):
        reports = [{"v": v, "e": e} for v, e in ((1, 1), (3, 2), (5, None), (2, 3))]
        self.assertAlmostEqual(calibration.over_scatter(reports, "v", "e"), math.sqrt(14 / 3))  # the scatter of 1, 3, 2 is 1


class Whole(unittest.TestCase):
    def done(self, folder, *command):
        process = subprocess.run([sys.executable, "-B", *map(str, command)], cwd=folder, text=True, capture_output=True, check=False)
        self.assertEqual(process.returncode, 0, process.stderr)
        return process

    def test_drifts_of_two_runs(self):
        calibration_script = FOLDER / "calibration.py"
        with tempfile.TemporaryDirectory() as folder:
            self.done(folder, calibration_script, "--program", built_program.PROGRAM, "--runs", 2, "--systems", "64 argon", "--lengths", 0.2, 0.4,
                      "--output", "result.json")
            rows = json.loads((Path(folder) / "result.json").read_text(encoding="utf-8"))["rows"]
            text = (Path(folder) / "result.md").read_text(encoding="utf-8")
        self.assertEqual([(r["scheme"], r["length_ps"], r["runs"]) for r in rows],
                         [(scheme, length, 2) for scheme in calibration.SCHEMES for length in (0.2, 0.4)])
        self.assertEqual(text, calibration.table(rows) + "\n")

    def test_averages_of_four_runs(self):
        with tempfile.TemporaryDirectory() as folder:
            out = self.done(folder, FOLDER / "averages.py", "--program", built_program.PROGRAM, "--systems", "nitrogen", "--runs", 4, "--length", 8).stdout
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in out.splitlines()[2:]]
        found = {ensemble: {row[2] for row in rows if row[1] == ensemble} for ensemble in averages.ENSEMBLES}
        for ensemble, names in found.items():
            self.assertIn("pressure", names, ensemble)
        self.assertIn("acceptance", found["constant pressure"])
        self.assertIn("mean_weight", found["hybrid Monte Carlo"])
        for row in rows:
            stated, scatter, ratio = float(row[4]), float(row[5]), float(row[6].split(" ± ")[0])
            self.assertAlmostEqual(stated / scatter / max(ratio, 0.005), 1, delta=1 if ratio < 0.2 else 0.03)

    def test_errors_of_analyze(self):
        with tempfile.TemporaryDirectory() as folder:
            self.done(folder, FOLDER / "analyze.py", "--polhode", built_program.PROGRAM, "--systems", "argon", "--runs", 1, "--length", 6,
                      "--pieces", 3, "--window", 0.4, "--output", "result")
            rows = json.loads((Path(folder) / "result.json").read_text(encoding="utf-8"))["results"]
        # D does not converge in pieces of 2 ps, so they have none
        self.assertLessEqual({"T [K]", "peak of g Ar-Ar: position [nm]", "peak of g Ar-Ar: height"}, {r["quantity"] for r in rows})
        self.assertEqual({r["pieces"] for r in rows}, {2})


if __name__ == "__main__":
    built_program.main()
