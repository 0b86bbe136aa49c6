# SPDX-License-Identifier: MIT
"""What was asked for is printed last and fits on a screen; --verbose prints tables before it."""

import re
import subprocess

import sandbox
from advise import GAS
from run_warnings import LATTICE
from sandbox import SMALL, Sandbox, edited

COLUMNS, LINES = 80, 40
RUN_LINES = 24  # of a run, without its warnings
PAPER = edited(SMALL, ('["velocity-verlet"]', '["velocity-verlet", "hoa2", "gier4-fd"]'), ('["2 fs"]', '["2 fs", "4 fs"]'))
WATER = edited(LATTICE, ('cutoff = "0.6 nm"', 'cutoff = "0.5 nm"\nskin = "0.05 nm"'), ('length = "0.4 ps"', 'length = "6 ps"\nequilibrate = "0.5 ps"'),
               ('plot = "none"\ntrajectory_every = "0 ps"', 'plot = "svg"\nformats = ["gro", "xtc"]'))
SHADOW = edited(WATER, ('length = "6 ps"', 'length = "6 ps"\nshadow_sample = "20 fs"'))
BAROSTAT = '\n[barostat]\npressure = "1 bar"\n'
# Ensemble: a run, and the rows that this run must have.
RUNS = {
    "constant energy": (SHADOW, ("potential energy", "temperature", "pressure", "R", "energy drift", "time-step bias", "their difference", "files")),
    "Langevin": (WATER + '\n[thermostat]\ntype = "langevin"\n', ("ensemble", "potential energy", "temperature", "pressure", "R", "energy drift", "files")),
    "NPT, Langevin": (WATER + '\n[thermostat]\n' + BAROSTAT, ("ensemble", "temperature", "pressure", "density", "compressibility", "R", "energy drift", "files")),
    "NPT": (SHADOW + '\n[thermostat]\ntype = "rescaling"\n' + BAROSTAT, ("ensemble", "temperature", "pressure", "density", "R", "time-step bias", "density", "files"))}
CANONICAL = edited(SMALL, ("[study]", '[study]\nensemble = "nvt"'), ('["velocity-verlet"]', '["obabo", "hoa2"]'), ('length = "0.1 ps"', 'length = "1 ps"'))


class Screens(Sandbox):
    def screen(self, text, *arguments):
        """The lines on a terminal, which they fit."""
        self.write("run.toml", text)
        lines = self.on_terminal(COLUMNS, *arguments, error=subprocess.DEVNULL).splitlines()
        self.assertLessEqual(len(lines), LINES)
        self.assertLessEqual(max(map(len, lines)), COLUMNS)
        return lines

    def verbose(self, *arguments):
        """The lines of the same command with --verbose, the last ones of which are those without it, before a terminal breaks them."""
        short, long = self.polhode(*arguments), self.polhode(*arguments, "--verbose")
        self.assertEqual((short.returncode, long.returncode), (0, 0), long.err)
        self.assertIn("--verbose", short.err)
        self.assertTrue(long.out.endswith("\n\n" + short.out), long.out)
        return long.out

    def test_a_study_ends_with_verdicts_and_recommendation(self):
        lines = self.screen(PAPER, "study", "run.toml")
        labels = [line[:22].strip() for line in lines if line[:22].strip()]
        self.assertTrue(lines[0].startswith("the paper's claims [vanzon2008]"), lines[0])
        verdicts = [label for label in labels if label in ("reproduced", "not reproduced", "not decided")]
        self.assertEqual(len(verdicts), 5)
        self.assertEqual(labels[-2:], ["recommendation", "files"])
        self.assertIn("study.csv", " ".join(lines[-2:]))
        whole = self.verbose("study", "run.toml")
        for title in ("points\n", "minimum cost for R"):
            self.assertIn(title, whole)

    def test_a_canonical_study_ends_with_the_strict_bounds(self):
        lines = self.screen(CANONICAL, "study", "run.toml")
        self.assertTrue(lines[0].startswith("strict bounds"), lines[0])
        self.assertTrue(any(line.startswith("  the cheapest ") for line in lines))
        self.assertTrue(lines[-2].startswith("files ") or lines[-1].startswith("files "))
        self.assertIn("loose bounds", self.verbose("study", "run.toml"))

    def test_advice_ends_with_the_answer(self):
        lines = self.screen(GAS, "advise", "run.toml", "--time", "1")
        self.assertRegex(lines[0], "^for an R of at most 2 % use ")
        self.assertTrue(lines[-1].startswith("files "))
        whole = self.polhode("advise", "run.toml", "--time", "1", "--force", "--verbose").out
        self.assertRegex(whole, r"(?s)^candidates\n.*\nfor an R of at most 2 % use ")

    def test_bench_ends_with_speeds(self):
        lines = self.screen(SMALL, "bench", "--quick")
        text = " ".join(lines)
        self.assertRegex(text, r"hoa2 at 4 fs simulates up to [\d.]+ ns/day")
        self.assertNotIn("list build", text)
        whole = self.polhode("bench", "--quick", "--sizes", "216", "--threads", "1", "--verbose").out
        self.assertIn("list build", whole)
        self.assertRegex(whole.splitlines()[-1], "^  .*best times")

    def test_a_run_ends_with_averages_files_and_warnings(self):
        for ensemble, (text, rows) in RUNS.items():
            with self.subTest(ensemble=ensemble):
                lines = self.screen(text, "run", "run.toml", "--force")
                labels = [line[:22].strip() for line in lines]
                end = next((k for k, label in enumerate(labels) if label.startswith("WARNINGS")), len(lines))
                self.assertLessEqual(end, RUN_LINES, "\n".join(lines))
                at = 0
                for row in rows:
                    self.assertIn(row, labels[at:end])
                    at += labels[at:end].index(row) + 1
                self.assertRegex(lines[0], r"^64 molecules, 3000 steps of 2 fs with hoa2\S*: 6 ps in ")
                self.assertFalse({"force evaluations", "speed", "total energy"} & set(labels))

    def test_a_run_has_its_details_before_the_rest(self):
        self.write("run.toml", WATER)
        short, long = (self.polhode("run", "run.toml", "--force", *options).out for options in ((), ("--verbose",)))
        for label in ("total energy", "rms fluctuations", "drift in this run", "force evaluations", "time", "speed"):
            self.assertIn(f"\n{label:<22}", "\n" + long)
            self.assertNotIn(f"\n{label:<22}", "\n" + short)
        rest = short[short.index("\n\n"):]  # without the first line, which has times
        self.assertTrue(long.endswith(rest), long)

    def test_an_analysis_ends_with_its_files(self):
        self.write("run.toml", edited(SMALL, ('plot = "none"', 'plot = "none"\ntrajectory_every = "4 fs"\nformats = ["gro"]')))
        self.assertEqual(self.polhode("run", "run.toml").returncode, 0)
        lines = self.screen(edited(SMALL), "analyze", "out-trajectory.gro", "--run", "run.toml", "--window", "0.008 ps")
        self.assertRegex(" ".join(lines), r"files +polhode-analysis-\w+\.csv")


if __name__ == "__main__":
    sandbox.main()
