# SPDX-License-Identifier: MIT
"""The shadow energy of a run, tune-scheme, and the temperatures in records of studies, on the command line."""

import json
import math

import sandbox
from sandbox import SMALL, Sandbox, edited

# Energies every 4 fs for 0.4 ps, and the shadow energy at every fifth of them.
SHADOW = edited(SMALL, ("[run]\n", '[run]\nsample = "4 fs"\nshadow_sample = "20 fs"\n'), ('length = "0.02 ps"', 'length = "0.4 ps"'))
TUNE = ("tune-scheme", "run.toml", "--step", "20 fs", "--runs", "2", "--length", "1 ps", "--decorrelate", "0.2 ps",
        "--sample", "40 fs")
PARTS = ("translation [K]", "rotation 1 [K]", "rotation 2 [K]", "rotation 3 [K]")


class Shadow(Sandbox):
    def shadow(self, *options):
        process = self.polhode("run", "run.toml", "--json", *options)
        self.assertEqual(process.returncode, 0, process.err)
        return json.loads(process.out).get("shadow")

    def test_a_run_reports_it_by_default(self):
        plain = json.loads(self.done("run", edited(SHADOW, ('shadow_sample = "20 fs"', 'shadow_sample = "0 fs"')), "--json").out)
        self.assertNotIn("shadow", plain)
        energies = self.rows("out-energies.csv")
        text = self.done("run", SHADOW, "--force", "--verbose").out
        self.assertIn("shadow energy drift", text)
        # Requesting it does not change the run.
        self.assertEqual(self.rows("out-energies.csv"), energies)
        self.assertLess(self.shadow("--force")["rms_kJ_per_mol"], plain["rms_total_kJ_per_mol"])
        # A gas needs longer runs for error estimates; for a liquid, the gain follows from both errors.
        self.assertIsNone(self.shadow("--force")["time_gain"])
        liquid = edited(SHADOW, ("count = 27", "count = 200"), ('length = "0.4 ps"', 'length = "10 ps"\nequilibrate = "4 ps"'))
        report = json.loads(self.done("run", liquid, "--json", "--force").out)
        shadow = report["shadow"]
        self.assertGreater(shadow["drift_error"], 0)
        self.assertGreater(shadow["time_gain"], 1)
        sooner = (report["drift_error"] / shadow["drift_error"]) ** (2 / 3)  # standard errors fall as t^(-3/2)
        self.assertAlmostEqual(shadow["time_gain"] / sooner, 1, places=9)

    def test_every_hundred_steps_by_default(self):
        unasked = edited(SHADOW, ('shadow_sample = "20 fs"\n', ""))  # 200 steps: at the beginning, in the middle, at the end
        told = self.done("run", unasked, "--json")
        every = self.done("run", edited(SHADOW, ('"20 fs"', '"200 fs"')), "--json", "--force")
        self.assertIn("shadow", json.loads(told.out))
        self.assertEqual(json.loads(told.out)["shadow"], json.loads(every.out)["shadow"])
        for scheme in ("gier4", "velocity-verlet / hoa2 x 1 within 0.6 nm"):  # which have none
            self.assertNotIn("shadow", json.loads(self.done("run", unasked, "--json", "--force", "--scheme", scheme).out))

    def test_a_resumed_run_keeps_its_values(self):
        self.write("run.toml", SHADOW)
        whole = self.shadow()
        # Suspended between two samples, at a sample, and at one with a shadow energy.
        for length in ("0.206 ps", "0.208 ps", "0.2 ps"):
            self.shadow("--force", "--length", length)
            self.assertEqual(self.shadow("--resume"), whole)
        self.write("run.toml", edited(SHADOW, ('"20 fs"', '"40 fs"')))
        self.refused(("run", "run.toml", "--resume"), ["another run", "run.shadow_sample was"])

    def test_impossible_values_of_shadow_sample(self):
        for value, *words in (("-1 fs", "-1 fs", "0 fs"), ("20", "no unit", '"20 fs"'), ("1 nm", "length", "time"),
                              ("nan fs", "finite")):
            self.write("run.toml", edited(SHADOW, ('"20 fs"', f'"{value}"')))
            self.refused(("run", "run.toml"), ["run.toml:15", "run.shadow_sample", *words])
        self.write("run.toml", SHADOW)
        self.refused(("run", "run.toml", "--scheme", "gier4"), ["shadow_sample is 20 fs", "gier4", "leave shadow_sample out", "hoa2"])
        self.refused(("run", "run.toml", "--scheme", "B(1) A(1)"), ["palindrome", "hoa2"])

    def test_tuning(self):
        self.write("run.toml", SMALL)
        before = self.contents()
        process = self.polhode(*TUNE, "--json")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertEqual(self.contents(), before)
        report = json.loads(process.out)
        self.assertEqual((report["molecules"], report["step_fs"], report["runs"]), (27, 20, 2))
        self.assertLessEqual(abs(report["correlation"]), 1)
        for found, reference, names in zip(report["families"], ("hoa2", "gier4"), (["eta"], ["eta", "xi"]), strict=True):
            self.assertEqual(found["reference"], reference)
            self.assertEqual(list(found["parameters"]), names)
            self.assertTrue(0 < found["parameters"]["eta"]["value"] < 0.5, found)
            self.assertGreaterEqual(found["parameters"]["eta"]["error"], 0)
            for number in ("predicted_gain", "R_reference", "R", "gain", "gain_error"):
                self.assertTrue(math.isfinite(found[number]) and found[number] >= 0, (number, found))
            # The minimum variance along the measuring runs is not larger than that of the reference.
            self.assertGreaterEqual(found["predicted_gain"], 1)
            # The printed scheme can be run.
            process = self.polhode("run", "run.toml", "--scheme", found["scheme"], "--output", reference)
            self.assertEqual(process.returncode, 0, process.err)
        # The same results for any number of threads; and as text.
        self.assertEqual(json.loads(self.polhode(*TUNE, "--json", "--threads", "1").out), report)
        text = self.polhode(*TUNE).out
        plain, gradient = report["families"]
        for words in ("hoa2", "gier4", f"{plain['parameters']['eta']['value']:.5f}", gradient["scheme"]):
            self.assertIn(words, text)

    def test_tuning_of_ones_own_parameters(self):
        self.write("run.toml", SMALL)
        mine = "mine: free b = 1/5; B(b) A(1/2) B(1 - 2*b) A(1/2) B(b)"
        report = json.loads(self.polhode(*TUNE, "--json", "--scheme", mine).out)
        found, = report["families"]
        self.assertEqual(found["reference"], "mine")
        # The family is that of hoa2, tuned along other runs: its errors are below a tenth of the range of b.
        plain = json.loads(self.polhode(*TUNE, "--json").out)["families"][0]
        self.assertAlmostEqual(found["parameters"]["b"]["value"], plain["parameters"]["eta"]["value"], delta=0.05)
        self.assertRegex(self.polhode(*TUNE, "--scheme", mine).out, r"family of +mine")
        # The run file's scheme is tuned if it has free parameters.
        self.write("run.toml", SMALL.replace('scheme = "hoa2"', f'scheme = "{mine}"'))
        self.assertEqual(json.loads(self.polhode(*TUNE, "--json").out), report)
        # Refused: too many parameters, no palindrome, sums that change, nothing to tune.
        for scheme, *words in [("hoa2", "0 free parameters", "one or two"),
                               ("free a=.1; free b=.1; free c=.1; B(a) B(b) B(c) A(1) B(c) B(b) B(1-a-2*b-2*c)", "3 free parameters"),
                               ("mine: free b = 0.2; B(b) A(1) B(1-b)", "mine is not a palindrome", "order h"),
                               ("free b = 0.5; B(b) A(1) B(1/2)", "when a free parameter", "must sum to 1"),
                               ("free b = 0.5; B(1/2) A(1) B(1/2)", "does not depend on b")]:
            self.refused((*TUNE, "--scheme", scheme), words)

    def test_impossible_tuning(self):
        self.write("run.toml", SMALL)
        for options, *words in [(("--step", "2"), "--step", "no unit"), (("--step", "0 fs"), "longer than 0"),
                                (("--runs", "1"), "--runs", "1"), (("--runs", "two"), "--runs"),
                                (("--length", "0.1 ps"), "100 fs", "20 intervals between samples", "interval between samples"),
                                (("--sample", "0 fs"), "--sample", "longer than 0"), (("--decorrelate", "1 nm"), "time"),
                                (("--threads", "0"), "--threads")]:
            self.refused(("tune-scheme", "run.toml", *options), words)
        self.refused(("tune-scheme", "nowhere.toml"), ["nowhere.toml"])
        self.write("one.toml", edited(SMALL, ("count = 27", "count = 1")))
        self.refused(("tune-scheme", "one.toml", *TUNE[2:]), ["no forces act", "molecules interact", "one.toml"])
        process = self.polhode("tune-scheme", "run.toml", "--step", "1 ps", "--runs", "2", "--length", "400 ps", "--decorrelate", "0.1 ps",
                               "--sample", "2 ps")
        self.assertEqual(process.returncode, 1, process.err)
        self.assertIn("blew up", process.err)

    def test_temperatures_in_records_of_any_age(self):
        study = ("study", "run.toml", "--output", "study")
        self.write("run.toml", edited(SMALL, ('"argon"', '"tip4p"'), ('"100 K"', '"297 K"')))
        report = self.polhode(*study, "--verbose")
        self.assertEqual(report.returncode, 0, report.err)
        self.assertIn("rotation about each principal axis", report.out)
        whole = json.loads((self.folder / "study.json").read_text())
        for excess in whole["points"][0]["excess_K"]:
            self.assertGreater(excess["error"], 0)
        path = self.folder / "study-runs.csv"
        lines = path.read_text().splitlines()
        head = next(k for k, line in enumerate(lines) if line.startswith("scheme;"))
        names = lines[head].split(";")
        self.assertEqual(tuple(names[10:14]), PARTS)

        def cut(columns):
            return [line if k < head else ";".join(line.split(";")[:columns]) for k, line in enumerate(lines)]

        for columns in (9, 10, 14, 15, 19):
            for name in self.contents():
                if name.startswith("study"):
                    (self.folder / name).unlink()
            path.write_text("\n".join(cut(columns)) + "\n")
            process = self.polhode(*study)
            self.assertEqual(process.returncode, 0, process.err)
            point = json.loads((self.folder / "study.json").read_text())["points"][0]
            self.assertEqual(point["R"], whole["points"][0]["R"])
            # Without the temperatures of parts there are no differences, and none are invented.
            self.assertEqual(point["excess_K"], whole["points"][0]["excess_K"] if columns >= 14 else [None] * 3)
            # Read again, it has the current columns, and no run was repeated.
            now = [line for line in path.read_text().splitlines() if line[:1] != "#"]
            self.assertEqual(now[0], lines[head])
            self.assertEqual(len(now), len(lines) - head)
        path.write_text("\n".join(cut(12)) + "\n")
        for name in self.contents():
            if name.startswith("study") and name != "study-runs.csv":
                (self.folder / name).unlink()
        self.refused(study, ["study-runs.csv", "12 columns", "--force"])


if __name__ == "__main__":
    Sandbox.maxDiff = None
    sandbox.main()
