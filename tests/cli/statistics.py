# SPDX-License-Identifier: MIT
"""The summary of a run with few or no samples, and the memory of its statistics."""

import json
import os
import re
import subprocess

import sandbox
from sandbox import SMALL, Sandbox, edited

# Nitrogen molecules 10 nm apart: no forces, so V and every kinetic energy are constant except for rounding.
FREE = edited(SMALL, ('"argon", count = 27', '"n2", count = 8'), ('box = "2.5 nm"', 'box = "20 nm"'),
              ('length = "0.02 ps"', 'length = "0.4 ps"'))
NO_NUMBER = re.compile(r"\b(inf|nan|null)\b", re.IGNORECASE)


class Statistics(Sandbox):
    def both(self, text, *options):
        """The summary as text and as JSON."""
        process = self.done("run", text, "--force", "--verbose", *options)
        return process.out, json.loads(self.done("run", text, "--json", "--force", *options).out)

    def test_too_few_samples(self):
        text, report = self.both(SMALL, "--length", "2 fs")
        self.assertEqual(report["samples"], 2)
        self.assertIn("R                     not known: too few samples", text)
        self.assertIn("energy drift          not known: too few samples", text)
        for key in ("R", "R_error", "drift_kJ_per_mol_ps", "drift_error", "drift_p_value", "drift_significant", "pressure_error_bar"):
            self.assertIsNone(report[key], key)
        self.assertEqual(report["drift_verdict"], "too few samples")

    def test_few_samples_give_values_without_errors(self):
        text, report = self.both(SMALL)  # 0.02 ps: 6 samples
        self.assertEqual(report["samples"], 6)
        self.assertGreater(report["R"], 0)
        for key in ("R_error", "drift_error", "drift_p_value", "drift_significant"):
            self.assertIsNone(report[key], key)
        # R, drift, potential and total energy, temperatures, pressure, and three time-step biases
        self.assertEqual(len(re.findall("error not known: too few samples", text)), 9)
        self.assertNotIn("±", text)
        self.assertNotIn("significant", text)

    def test_every_average_has_an_error_or_the_reason_why_not(self):
        """In JSON each average is followed by its error; errors that are not known are listed with the reason."""
        averages = {"R": "R_error", "pressure_bar": "pressure_error_bar"}
        averages |= {f"{name}_{unit}": f"{name}_error_{unit}" for name, unit in [
            ("potential", "kJ_per_mol"), ("total", "kJ_per_mol"), ("rms_total", "kJ_per_mol"), ("rms_potential", "kJ_per_mol"),
            ("temperature", "K"), ("temperature_translation", "K"), ("temperature_rotation", "K")]}
        text, report = self.both(SMALL)
        for name, error in averages.items():
            if isinstance(report[name], list):
                self.assertEqual(report[error], [None] * 3)
            else:
                self.assertIsNone(report[error], error)
            self.assertEqual(report["errors_not_known"][error], "too few samples")
        text, report = self.both(edited(SMALL, ('length = "0.02 ps"', 'length = "2 ps"\nsample = "4 fs"\nequilibrate = "0.5 ps"')))
        for name, error in averages.items():
            known = report[error] is not None and report[error] != [None] * 3
            self.assertNotEqual(known, error in report["errors_not_known"], error)
            self.assertIn(report["errors_not_known"].get(error, "run too short"), ("run too short", "not defined"))
        shadow = report["shadow"]
        self.assertNotEqual(shadow["rms_error_kJ_per_mol"] is None, "error_not_known" not in shadow)
        for line in ("R", "shadow energy drift", "potential energy", "total energy", "temperature", "pressure"):
            found = next(x for x in text.splitlines() if x.startswith(f"{line:<22}"))
            self.assertRegex(found, "±|error not known: run too short|error not known: too few samples", line)

    def test_without_forces_nothing_is_significant(self):
        text, report = self.both(FREE)
        self.assertIn("not defined: the potential energy is constant", text)
        self.assertNotIn("time-step bias", text)
        self.assertIsNone(report["R"])
        self.assertFalse(report["drift_significant"])
        self.assertIsNone(NO_NUMBER.search(text), text)
        study = self.polhode("study", "run.toml", "--output", "study")
        self.assertEqual(study.returncode, 0, study.err)
        self.assertNotIn("significant energy drift", study.out)  # as a note of a point
        self.assertIsNone(NO_NUMBER.search(study.out), study.out)
        point = json.loads((self.folder / "study.json").read_text())["points"][0]
        self.assertIsNone(point["R"])
        self.assertEqual(point["drift_p_value"], 1)
        self.assertIsNone(NO_NUMBER.search((self.folder / "study.csv").read_text().splitlines()[-1]))

    def test_memory_does_not_grow_with_the_number_of_samples(self):
        # Storing 245 bytes per sample would need 49 MB for the 200,000 samples between the two lengths.
        text = edited(SMALL, ('count = 27', 'count = 2'), ("[run]\n", '[run]\nsample = "2 fs"\nshadow_sample = "20 fs"\n'),
                      ("[output]\n", '[output]\ntrajectory_every = "0 ps"\n'))
        self.write("run.toml", text)

        def largest(length):
            process = subprocess.Popen([sandbox.PROGRAM, "run", "run.toml", "--force", "--threads", "1", "--length", length],
                                       cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, 0)
            return usage.ru_maxrss / 1024  # MB

        self.assertLess(largest("440 ps") - largest("40 ps"), 8)


if __name__ == "__main__":
    Sandbox.maxDiff = None
    sandbox.main()
