# SPDX-License-Identifier: MIT
"""Configurational temperatures of a run and a study, on the command line."""

import json

import sandbox
from sandbox import SMALL, Sandbox, edited

# Energies every 4 fs for 0.4 ps, and configurational temperatures at every fifth of them.
ASKED = edited(SMALL, ("[run]\n", '[run]\nsample = "4 fs"\nconfigurational_sample = "20 fs"\n'), ('length = "0.02 ps"', 'length = "0.4 ps"'))
WATER = edited(SMALL, ('"argon"', '"tip4p"'), ('"100 K"', '"297 K"'))
STUDY = ("study", "run.toml", "--output", "study")


class Configurational(Sandbox):
    def temperatures(self, *options):
        process = self.polhode("run", "run.toml", "--json", *options)
        self.assertEqual(process.returncode, 0, process.err)
        return json.loads(process.out).get("temperature_configurational_K")

    def point(self):
        return json.loads((self.folder / "study.json").read_text())["points"][0]

    def test_a_run_reports_them_only_on_request(self):
        plain = self.done("run", edited(ASKED, ('configurational_sample = "20 fs"\n', "")))
        self.assertNotIn("configurational", plain.out)
        energies = self.rows("out-energies.csv")
        short = self.done("run", ASKED, "--force").out
        self.assertRegex(short, r"configurational +translation [-\d.]+, rotation -, -, - K, error not known: run too short")
        self.assertEqual(self.rows("out-energies.csv"), energies)  # requesting them does not change the run
        long = self.done("run", ASKED, "--force", "--length", "20 ps").out
        self.assertRegex(long, r"configurational +translation [-\d.]+ ± \S+, rotation -, -, - K")
        translation, *rotation = self.temperatures("--force", "--length", "20 ps")
        self.assertGreater(translation["error"], 0)
        self.assertEqual(rotation, [None] * 3)

    def test_a_resumed_run_keeps_its_values(self):
        self.write("run.toml", ASKED)
        whole = self.temperatures()
        for length in ("0.206 ps", "0.2 ps"):  # suspended between two samples, and at one
            self.temperatures("--force", "--length", length)
            self.assertEqual(self.temperatures("--resume"), whole)
        self.write("run.toml", edited(ASKED, ('"20 fs"', '"40 fs"')))
        self.refused(("run", "run.toml", "--resume"), ["another run", "run.configurational_sample was 20 fs and is now 40 fs"])

    def test_a_study_has_them_with_the_kinetic_ones(self):
        self.write("run.toml", WATER)
        self.assertNotIn("configurational", self.done("study", WATER, "--output", "study").out)
        self.assertEqual(self.point()["configurational_excess_K"], [None] * 4)
        # Values that were not measured are not in the record.
        self.refused((*STUDY, "--configurational-sample", "10 fs"), ["another study", "--force"])
        process = self.polhode(*STUDY, "--configurational-sample", "10 fs", "--steps", "1 fs", "2 fs", "--force", "--verbose")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertIn("configurational minus kinetic temperature of translation and of rotation", process.out)
        self.assertEqual(process.out.count("0, k = 2"), 2)  # and the limit of both for zero step
        point = self.point()
        for excess in point["configurational_excess_K"]:
            self.assertGreater(excess["error"], 0)
        self.assertIn("configurational_excess_translation_error", self.rows("study.csv")[0])
        # From the record, or requested in the run file, they are equal to the last digit.
        self.write("run.toml", edited(WATER, ("runs = 2\n", 'runs = 2\nconfigurational_sample = "10 fs"\n')))
        for options in ((), ("--force", "--threads", "2")):
            process = self.polhode(*STUDY, "--steps", "1 fs", "2 fs", *options)
            self.assertEqual(process.returncode, 0, process.err)
            self.assertEqual(self.point(), point)

    def test_impossible_values(self):
        for value, *words in (("-1 fs", "-1 fs", "0 fs"), ("20", "no unit", '"20 fs"'), ("1 nm", "length", "time")):
            self.write("run.toml", edited(ASKED, ('"20 fs"', f'"{value}"')))
            self.refused(("run", "run.toml"), ["run.toml:15", "run.configurational_sample", *words])
        self.write("run.toml", SMALL)
        self.refused((*STUDY, "--configurational-sample", "-1 fs"), ["--configurational-sample", "0 fs or longer"])


if __name__ == "__main__":
    Sandbox.maxDiff = None
    sandbox.main()
