# SPDX-License-Identifier: MIT
"""Ctrl-C and SIGTERM end a run or a study soon and leave complete files; a study resumes from them."""

import json
import signal
import time
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

SOON = 5  # time limit for an interrupted program to end on a busy machine [s]
LONG = edited(SMALL, ('"0.02 ps"\n\n[output]', '"1000 ps"\n\n[output]'))


class Interrupts(Sandbox):
    def interrupted(self, ready, signal_number, *arguments):
        """The process, stopped by the signal as soon as `ready()` is true."""
        process = self.start(*arguments)
        self.addCleanup(process.kill)
        end = time.monotonic() + sandbox.LONGEST
        while not ready():
            self.assertIsNone(process.poll(), "it ended by itself")
            self.assertLess(time.monotonic(), end, "it never came so far")
            time.sleep(0.002)
        sent = time.monotonic()
        process.send_signal(signal_number)
        process.out, process.err = process.communicate(timeout=sandbox.LONGEST)
        self.assertLess(time.monotonic() - sent, SOON)
        self.assertEqual(process.returncode, 130, process.err)
        return process

    def lines(self, name):
        path = self.folder / name
        return path.read_bytes().count(b"\n") if path.exists() else 0

    def check_frames(self, name, head):
        """The trajectory consists of complete frames of 27 atoms, each with `head` other lines."""
        lines = (self.folder / name).read_text().splitlines()
        frame = 27 + head
        self.assertGreater(len(lines), frame)
        self.assertEqual(len(lines) % frame, 0)
        for k in range(0, len(lines), frame):
            self.assertEqual(lines[k if head == 2 and name.endswith("xyz") else k + 1].strip(), "27")

    def test_run(self):
        self.write("run.toml", LONG)
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            process = self.interrupted(lambda: self.lines("out-trajectory.xyz") > 100, signal_number,
                                       "run", "run.toml", "--json", "--force")
            report = json.loads(process.out)
            self.assertTrue(report["interrupted"])
            self.assertIn(f"interrupted after {report['steps']} steps", process.err)
            head, *rows = self.rows("out-energies.csv")
            self.assertTrue(head.startswith("time [ps],total [kJ/mol]"))
            values = [[float(x) for x in row.split(",")] for row in rows]
            self.assertTrue(all(len(row) == len(head.split(",")) for row in values))
            self.assertAlmostEqual(values[-1][0], report["length_ps"], delta=1e-9)
            self.check_frames("out-trajectory.xyz", 2)
            self.check_frames("out-trajectory.gro", 3)
            self.assertEqual((self.folder / "out-final.gro").read_text().count("argon"), 27)
            self.assertEqual([n for n in self.contents() if n.endswith(".part")], [])
            for name in ("out-trajectory.xyz", "out-trajectory.gro"):
                (self.folder / name).unlink()

    def test_rare_samples_do_not_delay_the_end(self):
        self.write("run.toml", edited(LONG, ("[output]", 'sample = "1000 ps"\n\n[output]')))
        self.interrupted(lambda: self.lines("out-trajectory.xyz") > 0, signal.SIGINT, "run", "run.toml")
        self.assertEqual(len(self.rows("out-energies.csv")), 3)  # header, initial state, last step

    def test_equilibration(self):
        self.write("run.toml", edited(LONG, ("[run]\n", '[run]\nequilibrate = "1000 ps"\n')))
        begin = time.monotonic()
        process = self.interrupted(lambda: time.monotonic() > begin + 0.5, signal.SIGINT, "run", "run.toml")
        self.assertIn("--resume", process.err)
        self.assertEqual(set(self.contents()), {"run.toml", "out-checkpoint.bin"})

    def test_tune_scheme(self):
        """The brackets of runs that did not end are not used."""
        self.write("run.toml", SMALL)
        begin = time.monotonic()
        process = self.interrupted(lambda: time.monotonic() > begin + 0.5, signal.SIGINT,
                                   "tune-scheme", "run.toml", "--length", "1000 ps")
        self.assertEqual(process.out, "")
        self.assertTrue(process.err.endswith("interrupted before a result was found\n"), process.err)

    def test_top(self):
        begin = time.monotonic()
        process = self.interrupted(lambda: time.monotonic() > begin + 0.5, signal.SIGINT, "top", "--J", "1,2,3",
                                   "--L", "0.1,0.2,1", "--step", "0.1", "--length", "1e7", "--output", "top")
        self.assertIn("step 0.1", process.out)
        self.assertTrue(process.err.endswith("interrupted; the table ends at the last sample before the interrupt\n"), process.err)
        self.assertEqual(self.contents(), {})

    def test_bench(self):
        begin = time.monotonic()
        process = self.interrupted(lambda: time.monotonic() > begin + 0.5, signal.SIGINT, "bench", "--threads", "1")
        self.assertEqual(process.out, "")
        self.assertTrue(process.err.endswith("interrupted before everything was measured\n"), process.err)

    def test_study_without_a_run(self):
        """There is nothing to tabulate or to draw, and the tables of an earlier study stay."""
        self.write("study.csv", "of an earlier study\n")
        self.write("run.toml", edited(LONG, ('"0.1 ps"', '"1000 ps"')))
        process = self.interrupted(lambda: self.lines("study-runs.csv") > 2, signal.SIGINT, "study", "run.toml", "--force")
        self.assertEqual(process.out, "")
        self.assertEqual(set(self.contents()) - {"study-study.lock"}, {"run.toml", "study.csv", "study-runs.csv"})
        self.assertEqual((self.folder / "study.csv").read_text(), "of an earlier study\n")
        self.assertIn("before the first run ended; the same command resumes from study-runs.csv", process.err)

    def test_study(self):
        study = edited(SMALL, ('["2 fs"]', '["2 fs", "4 fs"]'), ('"0.1 ps"', '"2 ps"'), ("runs = 2", "runs = 12"))
        self.write("run.toml", study)
        self.assertEqual(self.polhode("study", "run.toml", "--output", "whole").returncode, 0)
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            name = f"cut{int(signal_number)}"
            self.interrupted(lambda: self.lines(f"{name}-runs.csv") > 3, signal_number,
                             "study", "run.toml", "--output", name)
            done = self.lines(f"{name}-runs.csv")
            self.assertLess(done, self.lines("whole-runs.csv"), "there was nothing left to interrupt")
            with (self.folder / f"{name}-runs.csv").open("a") as record:
                record.write("velocity-verlet;0.00")  # as after a power failure
            process = self.polhode("study", "run.toml", "--output", name)
            self.assertEqual(process.returncode, 0, process.err)
            self.assertIn("runs were read", process.err)
            self.assertEqual(self.rows(f"{name}.csv"), self.rows("whole.csv"))
            self.assertEqual(sorted(self.rows(f"{name}-runs.csv")), sorted(self.rows("whole-runs.csv")))

    def test_a_killed_study(self):
        self.write("run.toml", edited(SMALL, ('["2 fs"]', '["2 fs", "4 fs"]'), ("runs = 2", "runs = 12")))
        begin = time.monotonic()
        self.assertEqual(self.polhode("study", "run.toml", "--output", "whole").returncode, 0)
        took = time.monotonic() - begin
        for _ in range(sandbox.KILLS):
            self.kill_at_random_moments(1, took, "study", "run.toml", "--output", "out")
        self.assertEqual(self.polhode("study", "run.toml", "--output", "out").returncode, 0)
        self.assertEqual(self.rows("out.csv"), self.rows("whole.csv"))
        self.assertEqual(sorted(self.rows("out-runs.csv")), sorted(self.rows("whole-runs.csv")))

    def test_a_study_of_something_else_is_not_mixed_in(self):
        self.write("ball.toml", 'name = "ball"\nsource = "user"\n[[site]]\nname = "X"\nelement = "Ar"\n'
                   'position = "0 0 0 nm"\nmass = "40 u"\nsigma = "0.34 nm"\nepsilon = "1 kJ/mol"\n')
        self.write("run.toml", edited(SMALL, ('"argon"', '"ball.toml"')))
        self.assertEqual(self.polhode("study", "run.toml").returncode, 0)
        text = (self.folder / "ball.toml").read_text()
        self.write("ball.toml", text.replace("0.34 nm", "0.33 nm"))
        process = self.polhode("study", "run.toml")
        self.assertEqual(process.returncode, 2, process.err)
        self.assertIn("another study", process.err)


if __name__ == "__main__":
    unittest.TestCase.maxDiff = None
    sandbox.main()
