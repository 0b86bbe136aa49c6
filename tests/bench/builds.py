# SPDX-License-Identifier: MIT
"""bench/engine/compare.py runs both programs, and its large liquids are copies of the small one."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import built_program

ARGON = """[system]
molecules = [{ model = "argon", count = 27 }]
box = "2.5 nm"
temperature = "100 K"
[forces]
cutoff = "1.0 nm"
[integrator]
scheme = "velocity-verlet"
step = "2 fs"
[output]
trajectory_every = "0 fs"
plot = "none"
"""
ENGINE = Path(__file__).resolve().parents[2] / "bench/engine"
sys.path.append(str(ENGINE))
import compare  # noqa: E402
import water  # noqa: E402


def energy(folder, molecules, start):
    """Potential energy of a configuration [kJ/mol]."""
    (folder / "run.toml").write_text(water.run_file(molecules, start, forces={"cutoff": "0.9 nm", **compare.FORCES["reaction-field"]}), encoding="utf-8")
    run = subprocess.run([built_program.PROGRAM, "energy", "run.toml", "--json"], cwd=folder, text=True, capture_output=True, check=True)
    return json.loads(run.stdout)["potential_kJ_per_mol"]


class Compare(unittest.TestCase):
    def test_program_against_itself(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, "-B", ENGINE / "compare.py", built_program.PROGRAM, "--polhode", built_program.PROGRAM,
                                  "--forces", "reaction-field", "--precisions", "mixed", "--threads", "1,2", "--rounds", "2", "--seconds", "0.05",
                                  "--json", "numbers.json"],
                                 cwd=folder, text=True, capture_output=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            cases = json.loads((Path(folder) / "numbers.json").read_text(encoding="utf-8"))["cases"]
            self.assertEqual([(c["threads"], c["molecules"]) for c in cases], [(1, 512), (2, 512)])
            for case in cases:
                self.assertGreater(case["steps"], 0)

    def test_run_files_in_place_of_water(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "argon.toml").write_text(ARGON, encoding="utf-8")
            compared = lambda *files: subprocess.run(
                [sys.executable, "-B", ENGINE / "compare.py", built_program.PROGRAM, "--polhode", built_program.PROGRAM, "--run-files", ",".join(files),
                 "--rounds", "1", "--seconds", "0.05", "--json", "numbers.json"], cwd=folder, text=True, capture_output=True, check=False)
            run = compared("argon.toml")
            self.assertEqual(run.returncode, 0, run.stderr)
            (case,) = json.loads((folder / "numbers.json").read_text(encoding="utf-8"))["cases"]
            self.assertEqual(case["forces"], "argon.toml")
            self.assertGreaterEqual(case["steps"], 20)  # the fewest that are timed, on a busy machine
            refused = compared("argon.toml", "nowhere.toml")
            self.assertEqual(refused.returncode, 2)
            self.assertIn("nowhere.toml", refused.stderr)

    def test_copies_have_the_energy_of_the_liquid_each(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "run.toml").write_text(compare.run_file(compare.Case("reaction-field", "double", 512, "", 1), 1), encoding="utf-8")
            subprocess.run([built_program.PROGRAM, "run", "run.toml"], cwd=folder, capture_output=True, check=True)
            water.replicate(folder / "out-final.gro", folder / "w4096.gro", 2)
            energies = energy(folder, 512, "out-final.gro"), energy(folder, 4096, "w4096.gro")
            # Ten decimals of positions and a sum over 4096 molecules.
            self.assertAlmostEqual(energies[1] / energies[0], 8, delta=8e-9)


if __name__ == "__main__":
    built_program.main()
