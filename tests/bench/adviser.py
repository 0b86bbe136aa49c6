# SPDX-License-Identifier: MIT
"""The statistics of bench/adviser are right, and a complete run of it on argon works."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import built_program

ADVISER = Path(__file__).resolve().parents[2] / "bench/adviser/adviser.py"
sys.path.insert(0, str(ADVISER.parent))

import adviser


class Adviser(unittest.TestCase):
    def test_the_interval_is_the_one_of_the_binomial_law(self):
        # All of n kept: the lower end is where p^n = 0.025. Half of them: symmetric about 1/2.
        low, high = adviser.binomial_interval(20, 20)
        self.assertAlmostEqual(low, 0.025 ** (1 / 20), 9)
        self.assertEqual(high, 1)
        low, high = adviser.binomial_interval(5, 10)
        self.assertAlmostEqual(low + high, 1, 9)
        self.assertAlmostEqual(sum(adviser.comb(10, k) * low**k * (1 - low) ** (10 - k) for k in range(5, 11)), 0.025, 9)
        self.assertEqual(adviser.binomial_interval(0, 3)[0], 0)

    def test_a_question_without_an_answer_has_its_row(self):
        table = adviser.table([{"system": "co2-125", "accuracy": 0.02, "answer": None, "why": "too slow"}])
        self.assertIn("| co2-125 | 2 | none: too slow |", table)
        self.assertNotIn("new runs met", table)
        head, _, row = table.splitlines()
        self.assertEqual(row.count("|"), head.count("|"))

    def test_the_table_tells_what_was_reached_of_what_was_asked(self):
        case = {"system": "argon-108", "accuracy": 0.01, "answer": {"scheme": "hoa2", "step_fs": 20}, "length_ps": 8,
                "refused": 1, "surpassed": 2, "R_expected": 0.006, "R_expected_error": 0.0002, "bound": 0.0085,
                "reached": 0.85, "R_fresh": [0.006, 0.009], "kept": 2, "below_bound": 1, "runs": 2}
        table = adviser.table([case, {**case, "reached": 0.55}])
        self.assertIn("| 0.85 | 0.75 | 0.90 | 2 of 2 | 1 of 2 |", table)
        self.assertIn("4 of 4 new runs met the required R: 100.0 %", table)
        self.assertIn("2 of 4 new runs stayed below the bound, of which 97.5 % should: 50.0 %", table)
        self.assertIn("Bounds are 0.55 to 0.85 of the requirement, 0.70 on average; 1 of 2 are from 0.8 to 1.", table)

    def test_one_question_on_argon(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", ADVISER, "--program", built_program.PROGRAM, "--systems", "argon-108",
                                  "--accuracies", "5", "--fresh", "2", "--time", "2", "--length", "4", "--equilibrate", "0.5",
                                  "--threads", "1", "--output", "result"],
                                 cwd=folder, text=True, capture_output=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            case, = json.loads((Path(folder) / "result.json").read_text(encoding="utf-8"))["cases"]
            table = (Path(folder) / "result.md").read_text(encoding="utf-8")
        self.assertEqual(case["system"], "argon-108")
        # Runs have a least length, so a slow machine takes longer to answer, and answers.
        self.assertIsNotNone(case["answer"], case.get("why"))
        self.assertAlmostEqual(case["reached"], case["bound"] / 0.05, 12)
        self.assertLessEqual(case["reached"], 1)
        self.assertLess(case["R_expected"], 0.05)
        self.assertEqual(len(case["R_fresh"]), 2)
        for ratio in case["R_fresh"]:  # the guarantee is for one run, with a margin
            self.assertLess(ratio, 2 * case["bound"])
        self.assertIn(f"{case['kept']} of 2", table)


if __name__ == "__main__":
    built_program.main()
