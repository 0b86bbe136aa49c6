# SPDX-License-Identifier: MIT
"""bench/engine runs and stores its results."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import built_program

ENGINE = Path(__file__).resolve().parents[2] / "bench/engine/engine.py"


class Engine(unittest.TestCase):
    def test_quick(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", ENGINE, "--quick", "--sizes", "512,600", "--threads", "1",
                                  "--polhode", built_program.PROGRAM, "--json", "numbers.json"],
                                 cwd=folder, text=True, capture_output=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            result = json.loads((Path(folder) / "numbers.json").read_text(encoding="utf-8"))
            self.assertEqual([(s["precision"], s["molecules"]) for s in result["systems"]],
                             [(p, n) for p in ("mixed", "double") for n in (512, 600)])
            for s in result["systems"]:
                for key in ("force_ns_per_molecule", "step_ns_per_molecule", "bytes_per_molecule", "first_energies_s"):
                    self.assertGreater(s[key], 0, key)
            self.assertEqual(len(result["limits"]), 2)


if __name__ == "__main__":
    built_program.main()
