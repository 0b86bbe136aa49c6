# SPDX-License-Identifier: MIT
"""polhode analyze on the command line: its files, its errors, and that the number of threads changes nothing."""

import json
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

WATERS = edited(SMALL, ('{ model = "argon", count = 27 }', '{ model = "tip4p", count = 27 }'),
                ('"100 K"', '"300 K"'), ('"0.02 ps"\n\n[output]', '"0.2 ps"\n\n[output]'),
                ('plot = "none"', 'plot = "none"\ntrajectory_every = "8 fs"\nformats = ["gro"]'))


class Analyze(Sandbox):
    def setUp(self):
        super().setUp()
        self.done("run", WATERS)

    def analyze(self, *options):
        return self.polhode("analyze", "out-trajectory.gro", *options)

    def test_files_and_numbers(self):
        process = self.analyze("--run", "run.toml", "--window", "0.1 ps", "--json", "--plot", "none")
        self.assertEqual(process.returncode, 0, process.err)
        report = json.loads(process.out)
        self.assertEqual(report["frames"], 26)
        self.assertAlmostEqual(report["interval_ps"], 0.008, 9)
        self.assertEqual([f.rsplit("-", 1)[1] for f in report["files"]],
                         [f"{n}.csv" for n in ("rdf", "msd", "rotation", "velocity", "spectrum", "density")])
        self.assertIn("truncated or switched", " ".join(report["notes"]))
        head, *rows = self.rows("polhode-analysis-msd.csv")
        self.assertEqual(head, "lag [ps],msd [nm2],msd error [nm2]")
        self.assertEqual(len(rows), 13)
        head, *rows = self.rows("polhode-analysis-density.csv")
        self.assertEqual(head, "time [ps],density [g/cm3],temperature [K]")
        self.assertAlmostEqual(float(rows[-1].split(",")[0]), 26 * 0.008, 9)  # all frames
        before = self.contents()
        process = self.analyze("--run", "run.toml")
        self.assertEqual(process.returncode, 2)
        self.assertIn("would be overwritten", process.err)
        self.assertEqual(self.contents(), before)
        process = self.analyze("--run", "run.toml", "--window", "0.1 ps", "--plot", "none", "--force", "--threads", "1")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertEqual(self.contents(), before)

    def test_too_few_frames(self):
        """Values have no errors, and those that do not exist are null or left out."""
        options = ("--molecules", "tip4p 27", "--from", "0.15 ps", "--plot", "none", "--force")
        process = self.analyze(*options, "--json")
        self.assertEqual(process.returncode, 0, process.err)
        report = json.loads(process.out)
        self.assertLess(report["frames"], 12)
        self.assertIsNone(report["density_g_per_cm3"]["error"])
        self.assertGreater(report["density_g_per_cm3"]["value"], 0)
        process = self.analyze(*options, "--pairs", "OW-OW", "--cutoff", "0.1 nm")
        self.assertRegex(process.out, r"density +\d+\.\d+ ± \? g/cm3")
        self.assertIn("g OW-OW               no peak", process.out)
        self.assertNotIn("nan", process.out)
        process = self.analyze(*options, "--pairs", "OW-OW", "--cutoff", "0.1 nm", "--json")
        self.assertEqual(json.loads(process.out)["rdf"],
                         [{"pair": ["OW", "OW"], "peak_nm": None, "peak_height": None, "minimum_nm": None,
                           "coordination": None, "coordination_of_second": None}])

    def test_numbers_that_the_run_does_not_determine(self):
        """They are no values: JSON has the reason, and the estimate under another name."""
        options = ("--run", "run.toml", "--what", "msd,rotation", "--window", "0.1 ps", "--plot", "none", "--force")
        report = json.loads(self.analyze(*options, "--json").out)
        D = report["parts"][0]["D_1e-9_m2_per_s"]
        self.assertFalse(D["converged"])
        self.assertIsNone(D["value"])
        self.assertIsNone(D["error"])
        self.assertGreater(D["unconverged_estimate"], 0)
        self.assertRegex(D["reason"], r"^not converged: length 0.2.* ps, maximum lag .* a run of at least .* ps is needed$")
        times = [time for axis in report["parts"][0]["relaxation"].values() for time in axis.values()]
        undecayed = [time for time in times if "integral_ps" not in time]
        for time in undecayed:
            self.assertEqual(set(time), {"converged", "reason"})
            self.assertIn("does not fall to 1/e³ within the window of lags; use a longer window", time["reason"])
        self.assertGreater(len(undecayed), 0)
        for time in times:
            self.assertIsNone(time.get("integral_ps", {}).get("value"))  # 0.2 ps determine none
        text = self.analyze(*options).out
        self.assertIn("not converged: the function does not fall to 1/e³", text)

    def test_sites_of_equal_names(self):
        """Those of two kinds of molecules are separate, unless they are asked for together."""
        self.write("run.toml", edited(WATERS, ("count = 27 }", "count = 14 }, { model = \"spce\", count = 13 }")))
        self.assertEqual(self.polhode("run", "run.toml", "--force").returncode, 0)
        options = ("--run", "run.toml", "--what", "rdf", "--plot", "none", "--force", "--json")
        report = json.loads(self.analyze(*options).out)
        pairs = [pair["pair"] for pair in report["rdf"]]
        self.assertIn(["tip4p:OW", "spce:OW"], pairs)
        self.assertIn(["tip4p:OW", "tip4p:HW"], pairs)
        self.assertEqual(len(pairs), 10)  # of four selections
        self.assertEqual(report["notes"], [])
        pooled = json.loads(self.analyze(*options, "--pairs", "OW-OW").out)
        self.assertIn("g(r) of 'OW' is of the sites of tip4p, spce together; 'tip4p:OW' selects those of one", pooled["notes"])

    def test_names_with_dashes(self):
        self.done("run", edited(WATERS, ("count = 27 }", "count = 25 }, { model = \"na-tip4p-ew\", count = 2 }")), "--force")
        process = self.analyze("--run", "run.toml", "--what", "rdf", "--plot", "none", "--json",
                               "--pairs", "OW-na-tip4p-ew:Na, na-tip4p-ew:Na-tip4p:OW")
        self.assertEqual([pair["pair"] for pair in json.loads(process.out)["rdf"]],
                         [["OW", "na-tip4p-ew:Na"], ["na-tip4p-ew:Na", "tip4p:OW"]])

    def test_wrong_input(self):
        before = self.contents()
        for options, said in (((), "--run water.toml"),
                              (("--molecules", "tip4p 28"), "only 27 of 28 molecules"),
                              (("--molecules", "tip4p, na-tip4p-ew 2"), "has no count"),
                              (("--molecules", "tip4p many"), "a model and its count"),
                              (("--molecules", "tip4p 27", "--what", "rdf,msf"), "did you mean 'msd'"),
                              (("--molecules", "tip4p 27", "--pairs", "OW"), "two site names"),
                              (("--molecules", "tip4p 27", "--pairs", "OW-OX"), "no site is named 'OX'"),
                              (("--molecules", "tip4p 27", "--cutoff", "1.3 nm"), "half of the shortest box edge"),
                              (("--molecules", "tip4p 27", "--fit", "3 ps"), "must be two lags"),
                              (("--molecules", "tip4p 27", "--window", "10"), "has no unit"),
                              (("--molecules", "tip4p 27", "--from", "9 ps"), "no frame at 9 ps"),
                              (("--molecules", "tip4p 27", "--plot", "pdf"), "svg, png, none")):
            process = self.analyze(*options)
            self.assertEqual(process.returncode, 2, (options, process.err))
            self.assertIn(said, process.err)
            self.assertEqual(self.contents(), before)


if __name__ == "__main__":
    unittest.TestCase.maxDiff = None
    sandbox.main()
