# SPDX-License-Identifier: MIT
"""The same run file gives the same bytes, every instruction set the same energies, and --json valid JSON."""

import json
import os

import sandbox
from sandbox import SMALL, Sandbox, edited

WATER = edited(SMALL, ('"argon"', '"tip4p"'), ('"100 K"', '"297 K"'))
# The loops sum pairs in different orders: sums of 10⁵ partly cancelling terms agree to at least 12 digits.
AGREEMENT = 1e-12
# Rounding errors grow along a chaotic trajectory, but only little in 10 steps.
AFTER_STEPS = 1e-10


class Repeatable(Sandbox):
    def body(self, name):
        """All lines except the comments, one of which contains the command."""
        return [line for line in (self.folder / name).read_text().splitlines() if line[:1] != "#"]

    def test_the_same_run_twice(self):
        self.write("run.toml", WATER)
        for name in ("one", "two"):
            process = self.polhode("run", "run.toml", "--output", name)
            self.assertEqual(process.returncode, 0, process.err)
        for kind in ("energies.csv", "trajectory.xyz", "trajectory.gro", "final.gro"):
            one, two = (self.body(f"{name}-{kind}") for name in ("one", "two"))
            self.assertEqual(one, two, kind)
        self.assertIn("# command: polhode run run.toml --output one\n", (self.folder / "one-energies.csv").read_text())

    def test_instruction_sets(self):
        self.write("run.toml", WATER)
        energies, totals = {}, {}  # of 512 waters, and along a run of a few
        for target in ("scalar", "sse4", "avx2", "avx512", "neon"):
            process = self.polhode("energy", "--json", POLHODE_INSTRUCTION_SET=target)
            if process.returncode == 2 and target != "scalar":
                self.assertIn("on this processor", process.err)
                continue
            report = json.loads(process.out)
            self.assertEqual(report["instruction_set"], target)
            energies[target] = [report[k + "_kJ_per_mol"] for k in ("van_der_waals", "coulomb", "potential")]
            process = self.polhode("run", "run.toml", "--output", target, POLHODE_INSTRUCTION_SET=target)
            totals[target] = [float(row.split(",")[1]) for row in self.rows(f"{target}-energies.csv")[1:]]
        for target, values in energies.items():
            for value, scalar in zip(values, energies["scalar"], strict=True):
                self.assertLess(abs(value - scalar), AGREEMENT * abs(scalar), target)
            for value, scalar in zip(totals[target], totals["scalar"], strict=True):
                self.assertLess(abs(value - scalar), AFTER_STEPS * abs(scalar), target)

    def test_numbers_of_threads(self):
        # More than a block of bodies, so that threads share them.
        self.write("run.toml", edited(WATER, ("count = 27", "count = 1331"), ('"2.5 nm"', '"4 nm"')))
        for threads, options in (("one", ("--threads", "1")), ("all", ())):
            process = self.polhode("run", "run.toml", "--output", threads, *options, "--json", POLHODE_THREADS="")
            self.assertEqual(process.returncode, 0, process.err)
            report = json.loads(process.out)
            self.assertIn(report["threads"], [1] if threads == "one" else range(1, os.cpu_count() + 1))
            self.assertIn(report["instruction_set"], ("scalar", "sse4", "avx2", "avx512", "neon"))
        for kind in ("energies.csv", "trajectory.gro", "final.gro"):
            self.assertEqual(self.body(f"one-{kind}"), self.body(f"all-{kind}"), kind)

    def test_studies_by_numbers_of_threads(self):
        self.write("run.toml", SMALL)
        for threads, options in (("one", ("--threads", "1")), ("all", ())):
            process = self.polhode("study", "run.toml", "--output", threads, *options, POLHODE_THREADS="")
            self.assertEqual(process.returncode, 0, process.err)
        self.assertEqual(self.body("one.csv"), self.body("all.csv"))
        self.assertEqual(sorted(self.body("one-runs.csv")), sorted(self.body("all-runs.csv")))

    def test_unknown_instruction_set(self):
        self.write("run.toml", SMALL)
        before = self.contents()
        for verb in ("run", "energy", "study"):
            process = self.polhode(verb, "run.toml", POLHODE_INSTRUCTION_SET="mmx")
            self.assertEqual(process.returncode, 2)
            for word in ("POLHODE_INSTRUCTION_SET", "'mmx'", "scalar"):
                self.assertIn(word, process.err)
            self.assertEqual(self.contents(), before)

    def test_json(self):
        self.write("run.toml", SMALL)
        for arguments in (("run", "run.toml"), ("study", "run.toml"), ("energy", "run.toml"), ("schemes",),
                          ("schemes", "gier4"), ("verify", "hoa2"), ("molecules",), ("molecules", "co2")):
            process = self.polhode(*arguments, "--json")
            self.assertEqual(process.returncode, 0, process.err)
            self.assertTrue(json.loads(process.out), arguments)

    def test_json_of_a_run_names_its_files(self):
        self.write("run.toml", SMALL)
        report = json.loads(self.polhode("run", "run.toml", "--json").out)
        self.assertEqual(set(report["files"]), set(self.contents()) - {"run.toml"})
        self.assertEqual(report["steps"], 10)
        self.assertEqual(report["force_evaluations"], 2 * 10)


if __name__ == "__main__":
    sandbox.main()
