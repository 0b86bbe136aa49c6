# SPDX-License-Identifier: MIT
"""polhode analyze on the command line: its files, its errors, and that the number of threads changes nothing."""

import csv
import json
import math
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

WATERS = edited(SMALL, ('{ model = "argon", count = 27 }', '{ model = "tip4p", count = 27 }'),
                ('"100 K"', '"300 K"'), ('"0.02 ps"\n\n[output]', '"0.2 ps"\n\n[output]'),
                ('plot = "none"', 'plot = "none"\ntrajectory_every = "8 fs"\nformats = ["gro"]'))


LONG = edited(WATERS, ("tip4p", "spce"), ('box = "2.5 nm"', 'box = "2 nm"\nseed = 1'), ('cutoff = "1.0 nm"', 'cutoff = "0.9 nm"\nelectrostatics = "reaction-field"'),
              ('step = "2 fs"', 'step = "4 fs"'), ('[run]\nlength = "0.2 ps"', '[run]\nequilibrate = "1 ps"\nlength = "1.2 ps"\nsample = "4 fs"'),
              ('"8 fs"\nformats = ["gro"]', '"20 fs"\nformats = ["xyz"]'))


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def dipoles(lines):
    """(time, M [e nm]) of each frame of SPC/E waters."""
    charge = {"O": -0.8476, "H": 0.4238}
    while lines:
        count = int(lines[0])
        time = float(lines[1].split("Time=")[1].split()[0])
        atoms = [line.split() for line in lines[2:2 + count]]
        yield round(time, 6), [sum(charge[atom[0]] * float(atom[1 + k]) / 10 for atom in atoms) for k in range(3)]
        lines = lines[2 + count:]


class Analyze(Sandbox):
    def setUp(self):
        super().setUp()
        self.done("run", WATERS)

    def done_analysis(self, *options):
        process = self.polhode("analyze", *options)
        self.assertEqual(process.returncode, 0, process.err)
        return process

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
        self.assertEqual(head, "time [ps],density [kg/m3],temperature [K]")
        self.assertAlmostEqual(float(rows[-1].split(",")[0]), 26 * 0.008, 9)  # all frames
        before = self.contents()
        process = self.analyze("--run", "run.toml")
        self.assertEqual(process.returncode, 2)
        self.assertIn("would be overwritten", process.err)
        self.assertEqual(self.contents(), before)
        process = self.analyze("--run", "run.toml", "--window", "0.1 ps", "--plot", "none", "--force", "--threads", "1")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertEqual(self.contents(), before)

    def test_the_finite_size_correction_of_a_long_box(self):
        """Along x and y there is none in a box of the published ratio, and the coefficient along z is published."""
        self.done("run", edited(sandbox.SMALL, ('"2.5 nm"', '["2.1 nm", "2.1 nm", "5.86605526437 nm"]'),
                                ('plot = "none"', 'plot = "none"\ntrajectory_every = "2 fs"\nformats = ["gro"]')), "--force")
        report = json.loads(self.analyze("--run", "run.toml", "--what", "msd", "--viscosity", "0.3 mPa s", "--plot", "none",
                                         "--json", "--force").out)
        x, y, z = report["diffusion"]["finite_size_correction_along_axes_1e-9_m2_per_s"]
        kT = 1.380649e-23 * report["temperature_K"]["value"]
        expected = 8.1711245653 * kT / (6 * math.pi * 0.3e-3 * 5.86605526437e-9) * 1e9
        # Edges in a GRO file have five decimals.
        self.assertAlmostEqual(z / expected, 1, 4)
        self.assertLess(max(abs(x), abs(y)), 1e-4 * z)
        self.assertAlmostEqual(report["diffusion"]["finite_size_correction_1e-9_m2_per_s"], (x + y + z) / 3, 12)
        for name in ("value", "unconverged_estimate"):
            part = report["parts"][0]
            if part["D_1e-9_m2_per_s"].get(name) is not None:
                self.assertAlmostEqual(part["D_without_images_1e-9_m2_per_s"][name] - part["D_1e-9_m2_per_s"][name], (x + y + z) / 3, 6)

    def test_too_few_frames(self):
        """Values have no errors, and those that do not exist are null or left out."""
        options = ("--molecules", "tip4p 27", "--from", "0.15 ps", "--plot", "none", "--force")
        process = self.analyze(*options, "--json")
        self.assertEqual(process.returncode, 0, process.err)
        report = json.loads(process.out)
        self.assertLess(report["frames"], 12)
        self.assertIsNone(report["density_g_per_cm3"]["error"])
        self.assertGreater(report["density_g_per_cm3"]["value"], 0)
        self.assertAlmostEqual(report["density_kg_per_m3"]["value"] / report["density_g_per_cm3"]["value"], 1000, places=6)
        process = self.analyze(*options, "--pairs", "OW-OW", "--cutoff", "0.1 nm")
        self.assertRegex(process.out, r"density +[\d.]+ kg/m3, error not known: too few samples")
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
        self.assertRegex(D["reason"], r"^not converged: length 0.2.* ps, maximum lag .* a run of at least .* ps is needed, or a window of at most .* ps$")
        times = [time for axis in report["parts"][0]["relaxation"].values() for time in axis.values()]
        undecayed = [time for time in times if "integral_ps" not in time]
        for time in undecayed:
            self.assertEqual(set(time), {"converged", "reason"})
            self.assertIn("still above 1/e³ at the maximum lag; use a longer window", time["reason"])
        self.assertGreater(len(undecayed), 0)
        for time in times:
            self.assertIsNone(time.get("integral_ps", {}).get("value"))  # 0.2 ps determine none
        text = self.analyze(*options).out
        self.assertIn("not converged: the correlation is still above 1/e³", text)

    def test_a_window_that_is_longer_than_half_of_the_trajectory(self):
        # 26 frames every 8 fs; 10 ps is the default
        for window, lags in (("50 ps", 14), ("10 ps", 14), (None, 14), ("0.104 ps", 14), ("0.05 ps", 7)):
            process = self.analyze("--run", "run.toml", "--what", "msd", *(("--window", window) if window else ()), "--plot", "none", "--force", "--json")
            is_cut = any("is longer than half of the trajectory, so the lags end at 0.104 ps" in note for note in json.loads(process.out)["notes"])
            self.assertEqual(is_cut, window in ("50 ps", "10 ps"), window)
            rows = [line for line in (self.folder / "polhode-analysis-msd.csv").read_text().splitlines() if line[:1].isdigit()]
            self.assertEqual(len(rows), lags)

    def test_velocities_in_some_frames(self):
        """Velocities may be written less often than positions; frames without them have no temperature."""
        self.assertEqual(self.polhode("convert", "out-trajectory.gro", "all.xyz").returncode, 0)
        lines = (self.folder / "all.xyz").read_text(encoding="utf-8").splitlines()
        half = 13 * 110  # lines of half of the frames, of 108 atoms each
        self.write("half.xyz", "\n".join(lines[:half]) + "\n")
        rest = [line.replace(":velo:R:3", "") if "Lattice" in line else " ".join(line.split()[:4]) for line in lines[half:]]
        self.write("some.xyz", "\n".join(lines[:half] + rest) + "\n")
        options = ("--run", "run.toml", "--plot", "none", "--force", "--json")
        expected = json.loads(self.done_analysis("half.xyz", *options, "--what", "density").out)
        some = json.loads(self.done_analysis("some.xyz", *options, "--what", "density,msd").out)
        self.assertEqual(some["frames"], 26)
        self.assertAlmostEqual(some["temperature_K"]["value"], expected["temperature_K"]["value"], 6)
        self.assertIn("the temperature is the mean of the 13 frames with velocities", some["notes"])
        table = (self.folder / "polhode-analysis-density.csv").read_text(encoding="utf-8")
        temperatures = [row["temperature [K]"] for row in csv.DictReader(line for line in table.splitlines() if not line.startswith("#"))]
        self.assertTrue(all(not temperature or float(temperature) > 100 for temperature in temperatures), temperatures)
        self.refused(("analyze", "some.xyz", *options), ["frame 14 has no velocities, but the first frame has them", "choose other observables"])

    def test_a_frame_with_other_atoms_is_named(self):
        text = (self.folder / "out-trajectory.gro").read_text(encoding="utf-8").splitlines()
        text[3 * 111 + 2] = text[3 * 111 + 2].replace("OW", "CW")
        self.write("other.gro", "\n".join(text) + "\n")
        self.refused(("analyze", "other.gro", "--run", "run.toml"), ["in frame 4: atom 1 (1 tip4p) is 'CW' instead of site 'OW'", "other.gro"])

    def test_one_frame_and_one_lag(self):
        options = ("--run", "run.toml", "--plot", "none", "--force")
        self.assertIn("1 frame at 0.2 ps, 27 molecules", self.done_analysis("out-trajectory.gro", *options, "--what", "density", "--start", "0.2 ps").out)
        process = self.done_analysis("out-trajectory.gro", *options, "--what", "msd", "--window", "2 fs")
        self.assertIn("window of 0.002 ps is shorter than the interval between frames, so the only lag is 0.008 ps", process.err)

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
        self.assertIn("g(r) of 'OW' includes the sites of tip4p, spce; 'tip4p:OW' selects one molecule", pooled["notes"])

    def test_names_with_dashes(self):
        self.done("run", edited(WATERS, ("count = 27 }", "count = 25 }, { model = \"na-tip4p-ew\", count = 2 }")), "--force")
        process = self.analyze("--run", "run.toml", "--what", "rdf", "--plot", "none", "--json",
                               "--pairs", "OW-na-tip4p-ew:Na, na-tip4p-ew:Na-tip4p:OW")
        self.assertEqual([pair["pair"] for pair in json.loads(process.out)["rdf"]],
                         [["OW", "na-tip4p-ew:Na"], ["na-tip4p-ew:Na", "tip4p:OW"]])

    def test_bias_of_the_step(self):
        """The covariances of M² and M with the total energy, computed from frames and energies."""
        self.done("run", LONG, "--force")
        options = ("out-trajectory.xyz", "--run", "run.toml", "--energies", "out-energies.csv", "--what", "dielectric,rdf", "--plot", "none", "--force",
                   "--pairs", "OW-OW", "--cutoff", "0.7 nm")
        report = json.loads(self.done_analysis(*options, "--json").out)
        head, *rows = self.rows("out-energies.csv")
        names = head.split(",")
        energies = {round(float(row.split(",")[0]), 6): dict(zip(names, row.split(","))) for row in rows}
        self.assertEqual(report["frames_with_step_error"], report["frames"])
        moments = list(dipoles((self.folder / "out-trajectory.xyz").read_text().splitlines()))
        self.assertEqual(len(moments), report["frames"])
        E = [float(energies[time]["total [kJ/mol]"]) for time, M in moments]
        K = [float(energies[time][f"kinetic_{kind} [kJ/mol]"]) for time, M in moments for kind in ("translation", "rotation")]
        cov = lambda x: mean(a * b for a, b in zip(x, E)) - mean(x) * mean(E)
        kT = 2 * 2 * mean(K) / (6 * 27 - 3)
        along = [[M[k] for time, M in moments] for k in range(3)]
        square = [sum(x * x for x in M) for time, M in moments]
        shift = (cov(square) - 2 * sum(mean(x) * cov(x) for x in along)) / kT / (27 * (0.8476 * 0.057735896651553043)**2)
        found = report["dielectric"]["step_bias"]["kirkwood"]
        self.assertAlmostEqual(found["value"] / shift, 1, places=2)
        self.assertGreater(found["error"], 0)
        peak = report["rdf"][0]["step_bias"]
        self.assertEqual(set(peak), {"peak_nm", "peak_height", "coordination"})
        text = self.done_analysis(*options).out
        self.assertRegex(text, r"time-step bias +height -?0\.\d+ .*, without it \d+\.\d+; position -?0\.\d+ .*, without it 0\.\d+ nm")

    def test_energies_that_do_not_belong_to_the_frames(self):
        self.done("run", edited(LONG, ("seed = 1", "seed = 2"), ('prefix = "out"', 'prefix = "other"')))
        self.done("run", LONG, "--force")
        options = ("out-trajectory.xyz", "--run", "run.toml", "--what", "rdf", "--plot", "none", "--force")
        original = (self.folder / "out-energies.csv").read_text()
        lines = original.splitlines()
        cut = "\n".join(line for line in lines if not line.startswith("0.4,")) + "\n"
        twice = "\n".join(line for l in lines for line in ([l, l.replace("0.4,", "0.4000001,", 1)] if l.startswith("0.4,") else [l])) + "\n"
        larger = original.replace(",8\n", ",8.1\n")
        for energies, said in (((self.folder / "other-energies.csv").read_text(), "kinetic energy"), (cut, "has no row at 0.4 ps"), (twice, "several rows at 0.4 ps"),
                               (larger, "a volume of"), (original[:-5], "has no end of line"), ("time [ps]\n", "must have"), ("", "cannot be read")):
            self.write("wrong.csv", energies)
            process = self.polhode("analyze", *options, "--energies", "wrong.csv")
            self.assertEqual(process.returncode, 2, (said, process.err))
            self.assertIn(said, process.err)
        process = self.polhode("analyze", "out-trajectory.xyz", "--molecules", "spce 27", "--energies", "out-energies.csv")
        self.assertIn("--run water.toml", process.err)

    def test_bias_of_the_step_with_thermostats(self):
        """Known with one kind of thermostat, at frames that are samples of the shadow energy."""
        for ensemble, shadow, said in (("rescaling", "20 fs", ""), ("rescaling", "80 fs", "uses only 11 of 41 frames"), ("rescaling", "0 fs", "has no sample of the shadow energy"),
                                       ("langevin", "", "known only at constant energy")):
            text = edited(LONG, ("[output]", (f'shadow_sample = "{shadow}"\n' if shadow else "") + f'[thermostat]\ntype = "{ensemble}"\n[output]'),
                          ('length = "1.2 ps"', 'length = "0.8 ps"'))
            self.done("run", text, "--force")
            process = self.polhode("analyze", "out-trajectory.xyz", "--run", "run.toml", "--energies", "out-energies.csv", "--what", "rdf", "--plot", "none", "--force")
            self.assertEqual(process.returncode, 2 if ensemble == "langevin" or shadow == "0 fs" else 0, process.err)
            self.assertIn(said, process.err)
        # The run file of constant energy with energies of a thermostat.
        self.write("run.toml", text.replace('[thermostat]\ntype = "langevin"\n', ""))
        process = self.polhode("analyze", "out-trajectory.xyz", "--run", "run.toml", "--energies", "out-energies.csv", "--what", "rdf", "--plot", "none", "--force")
        self.assertEqual(process.returncode, 2)
        self.assertIn("so the run had a thermostat", process.err)

    def test_a_run_without_a_sufficient_window_needs_more_time(self):
        """The time between frames is 8 fs, and a fit needs two lags."""
        for start, window in (("0.05", "0.019 ps"), ("0.1", None)):
            report = json.loads(self.done_analysis("out-trajectory.gro", "--run", "run.toml", "--start", f"{start} ps", "--what", "msd,velocity",
                                                   "--plot", "none", "--json", "--force").out)
            for name in ("D", "D_green_kubo"):
                reason = report["parts"][0][f"{name}_1e-9_m2_per_s"]["reason"]
                self.assertRegex(reason, r"a run of at least \S+ ps is needed" + (f", or a window of at most {window}$" if window else "$"))

    def test_wrong_input(self):
        before = self.contents()
        for options, said in (((), "--run water.toml"),
                              (("--molecules", "tip4p 28"), "only 27 of 28 molecules"),
                              (("--molecules", "tip4p, na-tip4p-ew 2"), "has no count"),
                              (("--molecules", "tip4p many"), "a model and its count"),
                              (("--molecules", "tip4p 27", "--what", "rdf,msf"), "did you mean 'msd'"),
                              (("--molecules", "tip4p 27", "--pairs", "OW"), "two site names"),
                              (("--molecules", "tip4p 27", "--pairs", "OW-OX"), "no site is named 'OX'"),
                              (("--molecules", "tip4p 27", "--pairs", "OW-HW, HW-OW"), "has the pair 'HW-OW' twice"),
                              (("--molecules", "tip4p 27", "--cutoff", "1.3 nm"), "half of the shortest box edge"),
                              (("--molecules", "tip4p 27", "--bin", "1.1 nm"), "bins of 1.1 nm are wider than the maximum distance of g(r), 1 nm by default; give narrower bins"),
                              (("--molecules", "tip4p 27", "--what", "rdf", "--bin", "5 nm"), "bins of 5 nm are wider"),
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
