# SPDX-License-Identifier: MIT
"""The canonical study and the adviser for hybrid Monte Carlo, on a few atoms and molecules."""

import json
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

TEXT = edited(SMALL, ('schemes = ["velocity-verlet"]', 'ensemble = "nvt"\nschemes = ["baoab", "hoa2"]'), ('["2 fs"]', '["10 fs", "20 fs"]'),
              ('length = "0.1 ps"', 'length = "4 ps"'))

DENSE = edited(TEXT, ("count = 27", "count = 32"), ('box = "2.5 nm"', 'density = "0.9 g/cm3"'), ('temperature = "100 K"', 'temperature = "150 K"'),
               ('cutoff = "1.0 nm"', 'cutoff = "0.65 nm"'), ('decorrelate = "0.02 ps"', 'decorrelate = "1 ps"'))


class Canonical(Sandbox):
    def test_study(self):
        report = json.loads(self.done("study", TEXT, "--json").out)
        self.assertEqual([(p["scheme"], p["step_fs"]) for p in report["points"]],
                         [("baoab", 10), ("baoab", 20), ("hmc-hoa2", 10), ("hmc-hoa2", 20)])
        for p in report["points"]:
            self.assertEqual(set(p["quantities"]), set(report["bounds"]))
            self.assertIsNone(p["quantities"]["kinetic_rotation"]["mean"])  # atoms
            for name in ("potential", "configurational_translation", "kinetic_translation"):
                self.assertGreaterEqual(p["quantities"][name]["bias"]["error"], 0)
                for accuracy in ("accuracy", "loose_accuracy"):
                    self.assertIn(p["quantities"][name][accuracy], ("below the bound", "above the bound", "undecided"))
            self.assertEqual("acceptance" in p, p["hybrid_monte_carlo"])
        for quantity in report["bounds"].values():
            self.assertGreater(quantity["loose"], quantity["value"])
        for claims in ("claims", "loose_claims"):
            self.assertEqual([c.split(":")[0] for c in report[claims][:2]], ["baoab", "hmc-hoa2"])
        for name in ("study.csv", "study.json", "study.gp", "study-runs.csv"):
            self.assertTrue((self.folder / name).exists(), name)
        self.assertEqual(len(self.rows("study.csv")), 5)
        self.assertEqual(json.loads((self.folder / "study.json").read_text(encoding="utf-8")), report)

    def test_resumed_study_and_its_record(self):
        """A run that an interrupt left out is repeated with the same numbers, for any number of threads."""
        whole = self.done("study", TEXT, "--json").out
        record = (self.folder / "study-runs.csv").read_text()
        self.write("study-runs.csv", "\n".join(record.splitlines()[:-3]) + "\n")
        process = self.polhode("study", "run.toml", "--json", "--threads", "2")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertIn("5 runs were read", process.err)
        self.assertEqual(process.out, whole)
        again = self.polhode("study", "run.toml", "--json", "--from-record", "study-runs.csv", "--output", "again")
        self.assertEqual(again.out, whole)

    def test_bad_input(self):
        self.write("run.toml", TEXT)
        self.refused(("study", "run.toml", "--schemes", "B(1) A(1)"), ["palindrome"])
        self.refused(("study", "run.toml", "--steps", "50 fs"), ["hundred steps"])
        self.refused(("study", "run.toml", "--ensemble", "npt"), ["--ensemble", "npt"])
        self.write("run.toml", edited(TEXT, ('"nvt"', '"nvT"')))
        self.refused(("study", "run.toml"), ["run.toml", "ensemble"])
        self.write("run.toml", TEXT + '[barostat]\npressure = "1 bar"\n[thermostat]\n')
        self.refused(("study", "run.toml"), ["[barostat]"])

    def test_options_of_the_other_ensemble_are_refused(self):
        self.write("run.toml", DENSE)
        for option, value, reason in (("--accuracy", "1 %", "exact at any step"), ("--drift", "1 kJ/mol/ns", "exact at any step"),
                                      ("--bias", "0.1 K", "exact at any step"), ("--time", "1", "number of force evaluations"),
                                      ("--length", "1 ps", "number of force evaluations"), ("--output", "mine", "no file is written")):
            self.refused(("advise", "run.toml", "--ensemble", "nvt", "--evaluations", "100", option, value),
                         [f'{option} = "{value}" has no meaning with --ensemble "nvt"', reason, "leave it out"])
        self.refused(("advise", "run.toml", "--accuracy", "1 %", "--evaluations", "100"),
                     ['--evaluations = "100" applies only to hybrid Monte Carlo', '--ensemble "nvt"'])

    def test_advice(self):
        advice = json.loads(self.done("advise", DENSE, "--ensemble", "nvt", "--evaluations", "1000", "--json").out)
        self.assertEqual(advice["scheme"], "hoa2")
        self.assertEqual(len(advice["pilots"]), 24)
        self.assertGreaterEqual(len(advice["finalists"]), 1)
        costs = [c["force_evaluations_per_sample"]["value"] for c in advice["finalists"]]
        self.assertEqual(costs, sorted(costs))
        best = advice["finalists"][0]
        self.assertIn(f"{best['steps']} steps", advice["answer"])
        self.assertGreater(best["acceptance"]["value"], 0.3)
        again = json.loads(self.polhode("advise", "run.toml", "--ensemble", "nvt", "--evaluations", "1000", "--json", "--threads", "1").out)
        self.assertEqual(again, advice)
        text = self.polhode("advise", "run.toml", "--ensemble", "nvt", "--evaluations", "1000").out
        self.assertIn(advice["answer"], text)


if __name__ == "__main__":
    sandbox.main()
