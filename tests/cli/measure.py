# SPDX-License-Identifier: MIT
"""polhode measure and merge, with 64 argon atoms: each replica takes about a second."""

import html.parser
import json
import time
import unittest

import sandbox
from sandbox import Sandbox

LIQUID = ("measure", "argon", "density", "1 %", "--molecules", "64", "--at", "160 K, 500 bar", "--output", "out")


class Text(html.parser.HTMLParser):
    """The words of a page, and all addresses in it."""

    def __init__(self):
        super().__init__()
        self.words, self.addresses, self.tags = [], [], []

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.addresses += [value for name, value in attributes if name in ("src", "href")]

    def handle_data(self, data):
        self.words.append(data)


class Measure(Sandbox):
    base = None  # the finished process of LIQUID, its files and its time [s]

    def measured_before(self):
        """The same as measured(), which is performed once for all tests: the finished process, with its files in the folder."""
        if not Measure.base:
            start = time.monotonic()
            process = self.measured()
            Measure.base = process, self.contents(), time.monotonic() - start
        for name, data in self.base[1].items():
            self.write(name, data)
        return self.base[0]

    def records(self):
        return {name: data for name, data in self.contents().items() if name.endswith(".replica")}

    def measured(self, *options, verb="measure"):
        process = self.polhode(verb, *LIQUID[1:], *options)
        self.assertEqual(process.returncode, 0, process.err)
        return process

    def test_a_density_with_its_error(self):
        process = self.measured_before()
        self.assertIn("plan at 160 K, 500 bar: 4 replicas of 64 molecules", process.err)
        self.assertRegex(process.err, r"note: the box of 64 molecules allows a cutoff of only 0.\d+ nm, .* 180 molecules have the usual cutoff of 0.9 nm")
        self.assertRegex(process.err, r"plan at .*, about \d+ s; longer")
        self.assertIn("density", process.out)
        self.assertIn("replicas of 64 molecules", process.out)
        found = json.loads(self.measured("--json").out)["points"][0]
        density = found["properties"][0]
        self.assertTrue(density["reached"])
        self.assertLessEqual(density["value"]["error"], density["requested_error"])

    def test_the_density_is_that_of_a_run_with_other_ensemble_moves(self):
        """Langevin dynamics at 10 fs with Monte Carlo moves of the volume, of the same molecules and forces."""
        self.write("run.toml", """[system]
molecules = [{ model = "argon", count = 64 }]
density = "1.3 g/cm3"
temperature = "160 K"
[forces]
cutoff = "0.65 nm"
dispersion_correction = true
[integrator]
scheme = "baoab"
step = "10 fs"
[run]
equilibrate = "20 ps"
length = "2 ns"
sample = "100 fs"
[thermostat]
type = "langevin"
[barostat]
type = "monte-carlo"
pressure = "500 bar"
[output]
prefix = "run"
trajectory_every = "0 ps"
plot = "none"
""")
        run = self.polhode("run", "run.toml", "--json")
        self.assertEqual(run.returncode, 0, run.err)
        density = json.loads(run.out)["ensemble"]["barostat"]["density_kg_per_m3"]
        process = self.polhode("measure", "run.toml", "density", "0.5 %", "--at", "160 K, 500 bar", "--json", "--output", "out")
        self.assertEqual(process.returncode, 0, process.err)
        found = json.loads(process.out)["points"][0]["properties"][0]["value"]
        # Four standard errors of the difference: in 1 of 10,000 tests by chance, and the seeds are fixed.
        self.assertLess(abs(found["value"] - density["value"]), 4 * (found["error"]**2 + density["error"]**2)**0.5)

    def test_nothing_is_measured_twice(self):
        self.measured_before()
        records = self.records()
        again = self.measured()
        self.assertEqual(self.records(), records)
        self.assertNotIn("a pilot chooses", again.err)
        self.assertIn("plan at", again.err)
        self.assertNotIn(", about", again.err)  # no time is known: nothing was computed
        self.assertNotIn("continues", again.err)
        self.measured("--json", "compressibility", "30 %")  # from the same records, which may grow
        for name, data in self.records().items():
            self.assertGreaterEqual(len(data), len(records[name]))

    def test_killed_and_resumed_it_has_the_same_records(self):
        self.measured_before()
        whole = self.records()
        for path in self.folder.glob("out*"):
            path.unlink()
        self.kill_at_random_moments(3, self.base[2] / 2, *LIQUID)
        self.measured()
        self.assertEqual(self.records(), whole)

    def test_threads_and_shards_have_the_same_bits(self):
        self.measured("--threads", "1", "--time-limit", "1000 s")
        whole = self.records()
        for path in self.folder.glob("out*"):
            path.unlink()
        for shard in ("1/2", "2/2"):
            self.measured("--shard", shard, "--threads", "2")
        merged = json.loads(self.measured("--json", verb="merge").out)["points"][0]
        self.assertEqual(merged["replicas"], 4)
        self.assertEqual(set(self.records()), set(whole))
        common = [name for name in whole if self.records()[name] == whole[name]]
        self.assertIn("out-160K-500bar-pilot.replica", common)

    def test_a_record_with_another_step_is_refused(self):
        """Without its pilot, a new one chooses a shorter step for a smaller error."""
        self.measured_before()
        for name in ("pilot", "r1"):
            (self.folder / f"out-160K-500bar-{name}.replica").unlink()
        process = self.polhode("measure", "argon", "density", "0.02 %", "--scheme", "hoa2", *LIQUID[4:], "--time-limit", "60 s")
        self.assertEqual(process.returncode, 2, process.err)
        for words in ("out-160K-500bar-r0.replica", "has the time step", "out-160K-500bar-pilot.replica", "restore the pilot"):
            self.assertIn(words, process.err)

    def test_scheme_and_step_can_be_given(self):
        arguments = (*LIQUID[1:-1], "verlet", "--scheme", "velocity-verlet", "--step", "20 fs")
        process = self.polhode("measure", *arguments)
        self.assertEqual(process.returncode, 0, process.err)
        self.assertIn("velocity-verlet at 20 fs", " ".join(process.out.split()))
        found = json.loads(self.polhode("merge", *arguments, "--json").out)["points"][0]["properties"][0]
        self.measured_before()
        other = json.loads(self.measured("--json", verb="merge").out)["points"][0]["properties"][0]
        # The bias of velocity Verlet is larger, and subtracted. Four standard errors of the difference, and the seeds are fixed.
        self.assertGreater(abs(found["step_bias"]["value"]), abs(other["step_bias"]["value"]))
        one, two = found["value"], other["value"]
        self.assertLess(abs(one["value"] - two["value"]), 4 * (one["error"]**2 + two["error"]**2)**0.5)
        mixed = self.polhode(*LIQUID, "--step", "20 fs")
        self.assertEqual(mixed.returncode, 2)
        self.assertIn("step", mixed.err)

    def test_merge_names_the_replicas_that_are_missing(self):
        self.measured_before()
        for k in (1, 3):
            (self.folder / f"out-160K-500bar-r{k}.replica").unlink()
        merged = self.measured("--json", verb="merge")
        self.assertIn("2 of 4 replicas have no record: 'out-160K-500bar-r1.replica', 'out-160K-500bar-r3.replica'", merged.err)
        point = json.loads(merged.out)["points"][0]
        self.assertEqual(point["replicas"], 2)
        self.assertIsNotNone(point["properties"][0]["value"]["error"])

    def test_a_time_limit_reports_what_is_known(self):
        process = self.measured("--time-limit", "0.01 s")
        self.assertIn("the time limit is reached; the same command resumes", process.err)

    def test_replicas_that_are_missing_do_not_withhold_values(self):
        self.measured_before()
        for k in (0, 3):
            (self.folder / f"out-160K-500bar-r{k}.replica").unlink()
        process = self.measured("--time-limit", "0.01 s")
        self.assertIn("from 2 of 4 replicas, 2 too short so far", " ".join(process.out.split()))
        point = json.loads(self.measured("--time-limit", "0.01 s", "--json").out)["points"][0]
        found = point["properties"][0]
        self.assertEqual(found["contributions"], "from 2 of 4 replicas, 2 too short so far")
        self.assertGreater(found["value"]["error"], 0)
        # Those of the same two replicas alone.
        alone = json.loads(self.measured("--json", verb="merge").out)["points"][0]["properties"][0]
        self.assertEqual(found["value"], alone["value"])

    def test_molecules_that_overlap_on_the_lattice_are_measured(self):
        """Benzene overlaps on the lattice of its estimated density, so the replicas are minimised first."""
        process = self.polhode("measure", "benzene", "density", "5 %", "--molecules", "40", "--time-limit", "0.01 s", "--output", "out")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertIn("the time limit is reached", process.err)

    def test_the_mixing_rule_of_a_mixture(self):
        """Benzene is made for geometric mixing and water for Lorentz-Berthelot, so there is no default."""
        mixture = ("measure", "tip4p 60, benzene 4", "density", "5 %", "--time-limit", "0.01 s", "--output", "out")
        self.refused(mixture, ["do not state the same mixing rule", "--mixing"])
        self.refused((*mixture, "--mixing", "arithmetic"), ["--mixing", "lorentz-berthelot", "geometric"])
        for rule in ("geometric", "lorentz-berthelot"):
            process = self.polhode(*mixture, "--mixing", rule)
            self.assertEqual(process.returncode, 0, process.err)
        self.write("run.toml", sandbox.SMALL)
        self.refused(("measure", "run.toml", "density", "--mixing", "geometric"), ["--mixing", "run file"])

    def test_a_state_point_at_constant_volume(self):
        """The pressure at the density of 500 bar is 500 bar."""
        at_pressure = json.loads(self.measured("compressibility", "10 %", "--json").out)["points"][0]
        density, compressibility = (m["value"] for m in at_pressure["properties"])
        self.assertIsNone(at_pressure["density_kg_per_m3"])
        arguments = ("argon", "pressure", "10 bar", "isochoric-heat-capacity", "5 %", "--molecules", "64", "--at",
                     f"160 K, {density['value']:.6g} kg/m3", "--output", "out")
        process = self.polhode("measure", *arguments, "--json")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertIn("at constant volume", process.err)
        point = json.loads(process.out)["points"][0]
        self.assertIsNone(point["pressure_bar"])
        self.assertAlmostEqual(point["density_kg_per_m3"] / density["value"], 1, delta=1e-5)
        pressure, heat_capacity = (m["value"] for m in point["properties"])
        # An error of the density is one of the pressure by the compressibility. Ensembles of 64 molecules differ by
        # kT times the curvature of p(V), about 1 % of kT/(V compressibility) = 15 bar here. Four standard errors.
        by_density = density["error"] / density["value"] / (1e-6 * compressibility["value"])
        self.assertLess(abs(pressure["value"] - 500), 4 * (pressure["error"]**2 + by_density**2)**0.5 + 5)
        self.assertGreater(heat_capacity["value"], 1.5 * 8.314)  # the ideal gas; the dense liquid has about 2.2 R
        self.assertLess(heat_capacity["value"], 3 * 8.314)
        again = self.polhode("measure", *arguments, "--json")
        self.assertEqual(json.loads(again.out)["points"], json.loads(process.out)["points"])
        self.assertNotIn("a pilot chooses", again.err)

    def test_an_error_that_takes_too_long_is_said_first(self):
        self.measured_before()  # so that the pilot is known
        long = [word if word != "1 %" else "0.0000002 %" for word in LIQUID]
        process = self.polhode(*long)
        self.assertEqual(process.returncode, 2, process.err)
        for words in ("density with an error of 2e-07 %", "years", "less than a year", "ask for an error of"):
            self.assertIn(words, process.err)

    def test_the_page_needs_no_other_file(self):
        self.measured_before()
        self.measured("second-virial-coefficient", "5 %")
        page = Text()
        page.feed((self.folder / "out.html").read_text(encoding="utf-8"))
        words = " ".join(page.words)
        for word in ("Properties of 64 argon", "160 K, 500 bar", "density", "95 % interval", "Convergence",
                     "Equilibration", "polhode measure argon density"):
            self.assertIn(word, words)
        self.assertEqual(page.addresses, [])
        self.assertNotIn("script", page.tags)
        self.assertGreaterEqual(page.tags.count("svg"), 5)

    def test_a_page_without_simulations_cites_no_scheme(self):
        self.measured_before()
        process = self.polhode("measure", "argon", "second-virial-coefficient", "5 %", "--output", "pair")
        self.assertEqual(process.returncode, 0, process.err)
        for name, cited in (("out.html", True), ("pair.html", False)):
            page = (self.folder / name).read_text(encoding="utf-8")
            self.assertEqual("128, 136102 (2008) for the scheme, and the sources that" in page, cited)
            self.assertIn("the sources that the manual names", page)

    def test_names_are_not_evaluated(self):
        self.write("run.toml", """[system]
molecules = [{ model = "own.toml", count = 64 }]
density = "1.3 g/cm3"
temperature = "160 K"
[forces]
cutoff = "0.65 nm"
""")
        self.write("own.toml", """name = "<b>&"
source = "own"
[[site]]
name = "Ar"
element = "Ar"
position = "0 0 0 nm"
mass = "39.948 u"
sigma = "0.3405 nm"
epsilon = "1 kJ/mol"
""")
        process = self.polhode("measure", "run.toml", "second-virial-coefficient", "5 %", "--output", "out")
        self.assertEqual(process.returncode, 0, process.err)
        page = (self.folder / "out.html").read_text(encoding="utf-8")
        self.assertIn("64 &lt;b&gt;&amp;", page)
        self.assertNotIn("<b>", page)

    def test_a_curve_over_temperatures(self):
        """Argon has no maximum of the density; its slopes agree with its fluctuations."""
        arguments = ("argon", "density", "0.5 %", "expansivity", "25 %", "heat-capacity", "25 %", "--replicas", "2", "--molecules", "64",
                     "--at", "150 K to 170 K, 3 points, 500 bar", "--output", "out")
        process = self.polhode("measure", *arguments)
        self.assertEqual(process.returncode, 0, process.err)
        for words in ("temperature of maximum density", "measure at lower temperatures", "slopes over state points"):
            self.assertIn(words, " ".join(process.out.split()))
        found = json.loads(self.polhode("merge", *arguments, "--json").out)
        self.assertIsNotNone(found["density_maxima"][0]["not_known"])
        self.assertEqual([s["property"] for s in found["slopes"]], ["expansivity", "heat-capacity"])
        for slope in found["slopes"]:
            self.assertEqual(slope["temperature_K"], 160)
            self.assertGreater(slope["slope"]["value"], 0)
            # Three standard errors, with the few modes of each: in 1 of 100 tests by chance, and the seeds are fixed.
            self.assertLess(abs(slope["deviation"]), 3.5)
        page = (self.folder / "out.html").read_text(encoding="utf-8")
        self.assertIn("Curves over state points", page)

    def test_paired_runs_bound_the_bias_of_dynamics(self):
        arguments = ("argon", "viscosity", "30 %", "--molecules", "64", "--at", "160 K, 500 bar", "--output", "out")
        process = self.polhode("measure", *arguments)
        self.assertEqual(process.returncode, 0, process.err)
        self.assertIn("an eighth is repeated at half of the step", process.err)
        self.assertRegex(" ".join(process.out.split()), r"time-step bias below \S+ \(paired runs at h/2\)")
        found = json.loads(self.polhode("merge", *arguments, "--json").out)["points"][0]["properties"][0]
        difference = found["step_difference"]
        self.assertGreater(found["step_bias_bound"], 4 / 3 * abs(difference["value"]))
        # Statistical: the difference is within four of its errors, which have at least three degrees of freedom.
        self.assertLess(abs(difference["value"]), 6 * difference["error"])
        process = self.polhode("measure", *arguments[:-1], "without", "--paired-runs", "no", "--time-limit", "0.01 s")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertNotIn("is repeated at half of the step", process.err)

    def test_hybrid_monte_carlo_has_the_same_density_and_no_bias(self):
        self.measured_before()
        before = json.loads(self.measured("--json", verb="merge").out)["points"][0]["properties"][0]
        records = self.records()
        mixed = self.polhode(*LIQUID, "--sampling", "hybrid-monte-carlo")
        self.assertEqual(mixed.returncode, 2, mixed.err)
        self.assertIn("sampling", mixed.err)
        self.assertEqual(self.records(), records)
        arguments = (*LIQUID[1:-1], "hybrid", "--sampling", "hybrid-monte-carlo")
        process = self.polhode("measure", *arguments)
        self.assertEqual(process.returncode, 0, process.err)
        self.assertIn("hybrid Monte Carlo by hoa2 at", process.err)
        self.assertIn("hybrid Monte Carlo by hoa2 at", " ".join(process.out.split()))
        found = json.loads(self.polhode("merge", *arguments, "--json").out)["points"][0]["properties"][0]
        self.assertTrue(found["reached"])
        self.assertIsNone(found["step_bias"])
        one, other = before["value"], found["value"]
        # Four standard errors of the difference, and the seeds are fixed.
        self.assertLess(abs(one["value"] - other["value"]), 4 * (one["error"]**2 + other["error"]**2)**0.5)

    def test_the_thermal_conductivity_of_a_pure_substance(self):
        arguments = ("argon", "thermal-conductivity", "40 %", "--molecules", "32", "--at", "160 K, 500 bar", "--paired-runs", "no", "--output", "out")
        process = self.polhode("measure", *arguments, "--json")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertRegex(process.err, r"plan at .* and \d+ ps for dynamics")
        point = json.loads(process.out)["points"][0]
        found, = point["properties"]
        self.assertEqual((found["name"], found["unit"], found["reached"]), ("thermal-conductivity", "W/m/K", True))
        self.assertGreater(point["dynamics_length_ps"], 0)
        self.assertIn("fewer than 100 molecules", self.polhode("merge", *arguments).out)
        # 256 atoms have 0.0882 +- 0.0008 W/m/K when heat flows through them, and 32 atoms a tenth more.
        self.assertAlmostEqual(found["value"]["value"], 0.089, delta=4 * found["value"]["error"] + 0.01)
        self.assertLess(found["value"]["error"], 0.03)
        self.assertIn("spectrum of the heat flux", (self.folder / "out.html").read_text(encoding="utf-8"))
        again = self.polhode("measure", *arguments, "--json")
        self.assertEqual(json.loads(again.out)["points"], [point])
        self.refused(("measure", "argon 32, n2 32", "thermal-conductivity", "40 %"), ["thermal-conductivity", "partial enthalpies"])

    def test_the_coordination_number_is_that_of_an_analysis(self):
        """Of a run of one trajectory with another scheme and thermostat, at the same density."""
        arguments = ("argon", "coordination-number", "3 %", "density", "1 %", "--paired-runs", "no", "--replicas", "2", "--molecules", "64", "--at", "160 K, 500 bar",
                     "--output", "out", "--json")
        process = self.polhode("measure", *arguments)
        self.assertEqual(process.returncode, 0, process.err)
        point = json.loads(process.out)["points"][0]
        found = point["properties"][0]["value"]
        curve, = point["radial_distributions"]
        self.assertEqual(found, curve["coordination"])
        self.assertEqual(len(curve["g"]), len(curve["r_nm"]))
        self.assertIn("g(r) of argon", (self.folder / "out.html").read_text(encoding="utf-8"))
        self.write("run.toml", f"""[system]
molecules = [{{ model = "argon", count = 64 }}]
density = "{point["properties"][1]["value"]["value"]} kg/m3"
temperature = "160 K"
[forces]
cutoff = "0.65 nm"
[integrator]
scheme = "baoab"
step = "10 fs"
[run]
equilibrate = "20 ps"
length = "4 ns"
sample = "1 ps"
[thermostat]
type = "langevin"
[output]
prefix = "run"
trajectory_every = "1 ps"
formats = ["gro"]
plot = "none"
""")
        run = self.polhode("run", "run.toml")
        self.assertEqual(run.returncode, 0, run.err)
        analysis = self.polhode("analyze", "run-trajectory.gro", "--run", "run.toml", "--what", "rdf", "--json")
        self.assertEqual(analysis.returncode, 0, analysis.err)
        other = json.loads(analysis.out)["rdf"][0]["coordination"]
        # Four standard errors of the difference, and the density is known to 1 %, as is the number at this density.
        allowed = 4 * (found["error"]**2 + other["error"]**2)**0.5 + 0.01 * other["value"]
        self.assertLess(abs(found["value"] - other["value"]), allowed)
        self.assertLess(allowed, 0.15 * other["value"])
        refused = self.polhode("measure", "argon", "coordination-number", "--molecules", "32")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("at least 36 molecules", refused.err)

    def test_a_long_box_needs_no_correction(self):
        """Diffusion in the long box of OrthoBoXY is that of a cubic box with its correction, and so is the viscosity."""
        arguments = ("argon", "diffusion", "10 %", "viscosity", "40 %", "diffusion-orthoboxy", "10 %", "viscosity-orthoboxy", "70 %",
                     "--replicas", "2", "--molecules", "64", "--at", "160 K, 500 bar", "--paired-runs", "no", "--output", "out")
        process = self.polhode("measure", *arguments, "--json")
        self.assertEqual(process.returncode, 0, process.err)
        found = {p["name"]: p for p in json.loads(process.out)["points"][0]["properties"]}
        for name in ("diffusion", "viscosity"):
            cubic, long = found[name]["value"], found[f"{name}-orthoboxy"]["value"]
            # Four standard errors of the difference: in 1 of 10,000 tests by chance, and the seeds are fixed.
            self.assertLess(abs(cubic["value"] - long["value"]), 4 * (cubic["error"]**2 + long["error"]**2)**0.5)
        # Without the correction, the coefficients would differ by more than they may.
        errors = (found["diffusion"]["value"]["error"]**2 + found["diffusion-orthoboxy"]["value"]["error"]**2)**0.5
        self.assertGreater(found["diffusion"]["finite_size_correction"], 4 * errors)
        self.assertIsNone(found["diffusion-orthoboxy"]["finite_size_correction"])
        records = self.records()
        merged = {p["name"]: p for p in json.loads(self.polhode("merge", *arguments, "--json").out)["points"][0]["properties"]}
        self.assertEqual(merged, found)
        self.polhode("measure", *arguments)
        self.assertEqual(self.records(), records)

    def test_wrong_input(self):
        for arguments, words in (
                (("argon", "densty"), ["no property 'densty'", "did you mean 'density'"]),
                (("argn", "density"), ["argn"]),
                (("argon", "density", "--at", "300"), ["--at", "'300' in '300' has no unit", "298.15 K"]),
                (("argon", "density", "--at", "90 K, 1400 kg/m3"), ["density cannot be measured", "constant pressure"]),
                (("argon", "density", "--at", "250 K to 320, 7 points"), ["--at", "'250 K to 320'", "has no unit"]),
                (("argon", "pressure", "--at", "90 K, 1 bar"), ["pressure cannot be measured", "give a density"]),
                (("argon", "pressure", "--at", "90 K, 1 kg/m3"), ["too low for a liquid"]),
                (("argon", "pressure", "--at", "90 K, 1 kg/m3, 1 bar"), ["--at", "a pressure and a density"]),
                (("argon", "density", "--at", "-3 K"), ["above 0 K"]),
                (("argon", "density", "5 kJ"), ["in % or in kg/m3"]),
                (("argon", "dielectric-constant"), ["no molecule has a dipole"]),
                (("argon", "density", "--molecules", "3"), ["--molecules"]),
                (("argon", "density", "--replicas", "1"), ["--replicas"]),
                (("argon", "density", "--shard", "3"), ["--shard", "2/8"]),
                (("argon", "density", "--paired-runs", "some"), ["--paired-runs", "yes or no"]),
                (("argon 64", "density", "--molecules", "100"), ["--molecules", "has a number of molecules"]),
                (("argon", "density", "--scheme", "baoab"), ["--scheme", "is not suitable"]),
                (("argon", "density", "--scheme", "hoa3"), ["--scheme", "hoa3"]),
                (("argon", "density", "--step", "0 fs"), ["--step", "2 fs"]),
                (("argon", "density", "--sampling", "monte-carlo"), ["--sampling", "molecular-dynamics or hybrid-monte-carlo"]),
                (("argon", "density", "--time-limit", "5"), ["--time-limit", "unit"]),
                (("argon 4", "density"), ["has 4 molecules", "at least 32"]),
                (("argon", "density", "--at", "160 K, 1e7 bar"), ["--at", "from -100000 to 1e+06 bar"]),
                (("argon", "density", "--at", "160 K to 160.0002 K, 2 points, 500 bar"), ["--at", "two state points '160 K, 500 bar'", "first six digits"]),
                (("na-spce", "second-virial-coefficient"), ["decays as 1/r", "diverges"]),
                (("argon",), ["no property is requested"])):
            self.refused(("measure", *arguments), words)
        self.refused(("merge", "argon", "density"), ["no record"])
        self.write("mine.html", "<title>My page</title>")
        self.refused(("measure", "argon", "second-virial-coefficient", "--output", "mine"), ["'mine.html' exists and is not a page of measure", "another output"])

    def test_a_state_that_is_no_liquid_is_said(self):
        for molecules, at, words in (
                ("64", "300 K, 1 bar", ["evaporate", "a lower temperature or a higher pressure"]),
                ("64", "40 K, 1 bar", ["is a solid", "a higher temperature"]),
                ("256", "100 K, 600 kg/m3", ["separate into two phases", "the density of the liquid"])):
            name = "density" if "bar" in at else "pressure"
            process = self.polhode("measure", "argon", name, "--molecules", molecules, "--at", at, "--output", "out")
            self.assertEqual(process.returncode, 1, process.err)
            for word in (f"error: at {at} the molecules", *words):
                self.assertIn(word, process.err)

    def test_points_without_results_do_not_withhold_the_others(self):
        points = "300 K, 1 bar; 160 K, 500 bar"
        process = self.polhode("measure", "argon", "density", "9 %", "--molecules", "32", "--at", points, "--replicas", "2", "--output", "two", "--json")
        self.assertEqual(process.returncode, 1, process.err)
        self.assertIn("molecules evaporate", process.err)
        found = json.loads(process.out)
        self.assertEqual([p["temperature_K"] for p in found["points"]], [160])
        self.assertTrue(found["points"][0]["properties"][0]["reached"])
        self.assertFalse(found["reached"])
        self.assertEqual([p["temperature_K"] for p in found["missing_points"]], [300])
        self.assertIn("evaporate", found["missing_points"][0]["reason"])
        self.assertRegex((self.folder / "two.html").read_text(), r"<h2>Not measured</h2>\n<ul>\n<li>300 K, 1 bar: .*evaporate")
        process = self.polhode("measure", "argon", "density", "9 %", "--molecules", "32", "--at", "160 K, 500 bar; 170 K, 500 bar", "--replicas", "2",
                               "--time-limit", "0.001 s", "--output", "two")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertRegex(process.out, r"170 K, 500 bar +the measurement ended before it")
        # An unsuitable point is refused before the others are simulated.
        self.refused(("measure", "argon", "pressure", "--molecules", "32", "--at", "160 K, 1200 kg/m3; 160 K, 1 kg/m3", "--output", "early"),
                     ["too low for a liquid"])
        self.assertFalse(list(self.folder.glob("early*")))

    def test_a_second_virial_coefficient_ends_at_the_time_limit(self):
        process = self.polhode("measure", "spce", "second-virial-coefficient", "1e-7 %", "--at", "300 K", "--time-limit", "0.5 s", "--json")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertIn("time limit is reached", process.err)
        self.assertFalse(json.loads(process.out)["reached"])


if __name__ == "__main__":
    sandbox.main()
