# SPDX-License-Identifier: MIT
"""polhode advise, and a run with an accuracy guarantee: with 32 argon atoms it takes a second or two."""

import json
import signal
import unittest

import sandbox
from sandbox import Sandbox, edited

GAS = """[system]
molecules = [{ model = "argon", count = 32 }]
density = "0.9 g/cm3"
temperature = "150 K"

[forces]
cutoff = "0.65 nm"

[integrator]
accuracy = "2 %"
candidates = ["velocity-verlet", "hoa2"]

[run]
equilibrate = "1 ps"
length = "4 ps"

[output]
prefix = "out"
plot = "none"

[study]
decorrelate = "0.5 ps"
"""
# Seven kicks are empty: eight times as many forces for nothing, which no clock on a busy machine overlooks.
WASTEFUL = "B(1/2) " + 7 * "A(1/8) B(0) " + "A(1/8) B(1/2)"


class Advise(Sandbox):
    def advice(self, text, *options):
        return json.loads(self.done("advise", text, "--json", "--time", "2", *options).out)

    def refused(self, text, *options, words=()):
        self.write("run.toml", text)
        before = self.contents()
        process = self.polhode("advise", "run.toml", *options)
        self.assertEqual(process.returncode, 2, process.err)
        for word in words:
            self.assertIn(word, process.err)
        self.assertEqual(self.contents(), before)

    def test_a_perfect_lattice(self):
        """Its forces are rounding errors, which once proposed a first step of 1e18 fs."""
        self.refused(edited(GAS, ("count = 32", "count = 27"), ("0.65 nm", "0.6 nm"), ('equilibrate = "1 ps"\n', "")), "--accuracy", "2 %",
                     words=("nearly zero", "equilibrate first", "run.toml"))

    def test_answer(self):
        found = self.advice(GAS)
        best = found["best"]
        self.assertIn(best["scheme"], ("velocity-verlet", "hoa2"))
        runs = best["confirmation"]
        self.assertEqual(runs["step_fs"], best["step_fs"])
        self.assertEqual(runs["length_ps"], 4)
        self.assertLess(runs["R"], runs["bound"])
        self.assertLessEqual(runs["bound"], 0.02)
        self.assertGreater(runs["R"], 0.002)  # the accuracy must not be ten times the required one
        self.assertGreater(best["ns_per_day"], 0)
        self.assertEqual(found["runner_up"] is None, any(c["step_fs"] == 0 for c in found["candidates"]))
        self.assertEqual(json.loads((self.folder / "advice.json").read_text())["best"], best)
        self.assertTrue(self.rows("advice.csv")[0].startswith("scheme,step [fs],length [ps]"))

    def test_a_planted_worse_scheme_loses(self):
        found = self.advice(GAS, "--schemes", WASTEFUL, "velocity-verlet")
        self.assertEqual(found["best"]["scheme"], "velocity-verlet")
        worse = found["candidates"][0]
        self.assertEqual(worse["scheme"], WASTEFUL)
        self.assertGreater(worse["step_fs"], 0)  # it was a candidate, rejected for its cost

    def test_a_scheme_that_cannot_win_is_not_studied(self):
        found = self.advice(GAS, "--schemes", WASTEFUL, "velocity-verlet", "hoa2")
        worse, *others = found["candidates"]
        self.assertEqual(worse["step_fs"], 0)
        self.assertIn("more than the best schemes", worse["obstacle"])
        self.assertLess(len(worse["points"]), min(len(c["points"]) for c in others))
        self.assertIsNotNone(found["runner_up"])

    def test_temperatures_and_their_limit_for_zero_step(self):
        found = self.advice(GAS)
        confirmed = found["best"]["confirmation"]
        self.assertEqual(confirmed["excess_K"], [None] * 3)  # atoms do not rotate
        translation, *rotation = confirmed["configurational_excess_K"]
        self.assertEqual(rotation, [None] * 3)
        self.assertGreater(translation["error"], 0)
        # Positions and momenta of a gas at 150 K have the same temperature within the error of eight runs.
        self.assertLess(abs(translation["value"]), 6 * translation["error"])
        self.assertNotIn("equipartition", found)
        limits = {limit["scheme"]: limit for limit in found["configurational"]}
        self.assertIn(found["best"]["scheme"], limits)
        for limit in limits.values():
            self.assertIsNone(limit["axis"])
            self.assertEqual(limit["order"], 2)
            self.assertGreater(limit["without_step_error"], 0)
        header, *rows = self.rows("advice.csv")
        self.assertIn("configurational_excess_translation [K],configurational_excess_translation_error [K]", header)
        last = dict(zip(header.split(","), rows[-1].split(",")))
        self.assertEqual(float(last["configurational_excess_translation [K]"]), translation["value"])
        self.assertEqual(last["excess_1 [K]"], "")

    def test_text_and_figure(self):
        process = self.done("advise", edited(GAS, ('"none"', '"svg"')), "--time", "2", "--output", "here", "--verbose")
        self.assertIn("for an R of at most 2 % use ", process.out)
        self.assertIn("ns/day with", process.out)
        self.assertIn("configurational minus kinetic temperature of translation and of rotation", process.out)
        self.assertIn("0, k = 2", process.out)
        script = (self.folder / "here.gp").read_text()
        self.assertIn("computing time", script)
        process = self.polhode("advise", "run.toml", "--output", "here")
        self.assertEqual(process.returncode, 2)
        self.assertIn("--force", process.err)

    def test_other_qualities(self):
        for option, value in (("--drift", "2 kJ/mol/ns"), ("--temperature-bias", "20 %")):
            found = self.advice(GAS, option, value, "--force", "--schemes", "velocity-verlet")
            self.assertLessEqual(found["best"]["confirmation"]["bound"], found["requested"] * 1e-3
                                 if option == "--drift" else found["requested"])

    def test_bias_of_the_step(self):
        """Biases grow as the square of the step: of two bounds, the smaller one has the shorter step."""
        steps = {}
        for bound in ("energy 0.02 kJ/mol", "energy 0.002 kJ/mol"):
            found = self.advice(GAS, "--bias", bound, "--force", "--schemes", "velocity-verlet")
            self.assertEqual((found["quality"], found["unit"]), ("energy bias", "kJ/mol per molecule"))
            self.assertLessEqual(found["best"]["confirmation"]["bound"], found["requested"])
            steps[bound] = found["best"]["step_fs"]
        self.assertLess(steps["energy 0.002 kJ/mol"], steps["energy 0.02 kJ/mol"])
        found = self.advice(GAS, "--bias", "pressure 20 bar", "--force", "--schemes", "velocity-verlet")
        self.assertAlmostEqual(found["requested"], 20 * 0.0602214076)
        process = self.done("advise", GAS, "--bias", "pressure 20 bar", "--force", "--schemes", "velocity-verlet")
        self.assertIn("for a pressure bias of at most 20 bar use velocity-verlet", process.out)
        barostat = '[barostat]\npressure = "100 bar"\ncompressibility = "1e-4 1/bar"\n[thermostat]\ntype = "rescaling"\n'
        found = self.advice(GAS + barostat, "--bias", "density 0.2 %", "--force", "--schemes", "velocity-verlet")
        self.assertAlmostEqual(found["requested"], 20 * 0.0602214076)

    def test_bias_in_the_ensemble_of_the_run(self):
        """At constant temperature the bias of the energy is larger than at constant energy, so the step is shorter; other ensembles are refused."""
        rescaling, bound = '[thermostat]\ntype = "rescaling"\n', ("--bias", "energy 0.002 kJ/mol", "--force", "--schemes", "velocity-verlet")
        steps = [self.advice(GAS + tables, *bound)["best"]["step_fs"] for tables in ("", rescaling)]
        self.assertLess(steps[1], steps[0])
        process = self.done("advise", GAS + rescaling, *bound)
        self.assertRegex(process.err, r"biases at constant energy are converted to this ensemble: 150 K, stochastic velocity rescaling .* potential energy by 0\.\d+ ± \S+ kJ/mol and the pressure by")
        self.assertNotIn("converted", self.done("advise", GAS, *bound).err)
        for tables, words in (("[thermostat]\n", ["rescaling", "is not known in this ensemble; use constant energy"]), ("[hybrid_monte_carlo]\n", ["has no time-step bias", "--ensemble nvt"])):
            self.refused(GAS + tables, "--bias", "energy 0.01 kJ/mol", words=words)

    def test_the_runs_that_confirm_decide(self):
        """For a bound close to the detectable drift, the proposed step is sometimes too long and is rejected by new runs."""
        refused = 0
        for seed in range(1, 9):
            self.write("run.toml", edited(GAS, ("[forces]", f"seed = {seed}\n[forces]"), ('accuracy = "2 %"', "")))
            process = self.polhode("advise", "run.toml", "--drift", "0.08 kJ/mol/ns", "--time", "0.5", "--json", "--force")
            self.assertIn(process.returncode, (0, 1), process.err)
            found = json.loads(process.out)
            bound = found["requested"] * 1e-3
            if found["best"]:
                self.assertLessEqual(found["best"]["confirmation"]["bound"], bound)
            for runs in found["refused"]:
                self.assertTrue(runs["blew_up"] or runs["bound"] > bound)
            refused += len(found["refused"])
        self.assertGreater(refused, 0)

    def test_what_cannot_be_reached(self):
        """Rounding in mixed precision is a lower limit of R, and the message says so."""
        self.write("run.toml", GAS)
        process = self.polhode("advise", "run.toml", "--accuracy", "0.00001 %", "--precision", "mixed",
                               "--time", "1", "--json")
        self.assertEqual(process.returncode, 1, process.err)
        self.assertIsNone(json.loads(process.out)["best"])
        self.assertIn("no scheme was found that meets an R of at most 1e-05 %", process.err)
        self.assertIn("smallest bound reached", process.err)
        self.assertIn('precision = "double"', process.err)

    def test_run(self):
        report = json.loads(self.done("run", GAS, "--json").out)
        promise = report["guarantee"]
        self.assertEqual(promise["accuracy"], 0.02)
        self.assertEqual(promise["met"], promise["R"] <= 0.02)
        self.assertAlmostEqual(promise["R"], report["R"])
        self.assertGreater(report["step_fs"], 1)
        # A given step replaces the guarantee; with a given scheme only the step is chosen.
        report = json.loads(self.done("run", GAS, "--json", "--force", "--step", "5 fs").out)
        self.assertIsNone(report["guarantee"])
        self.assertEqual(report["step_fs"], 5)
        process = self.done("run", edited(GAS, ("accuracy =", 'scheme = "velocity-verlet"\naccuracy =')), "--force")
        self.assertIn("for an R of at most 2 %: velocity-verlet at", process.err)
        self.assertIn("accuracy guarantee", process.out)

    def test_run_with_a_bound_on_a_bias(self):
        text = edited(GAS, ('accuracy = "2 %"', 'accuracy = "energy 0.02 kJ/mol"\nscheme = "velocity-verlet"'))
        process = self.done("run", text)
        self.assertIn("for an energy bias of at most 0.02 kJ/mol: velocity-verlet at", process.err)
        self.assertRegex(process.out, r"accuracy guarantee    met: bias of the potential energy \S+ .* kJ/mol per molecule; the accuracy guarantee is energy 0.02 kJ/mol")
        promise = json.loads(self.done("run", text, "--json", "--force").out)["guarantee"]
        self.assertEqual((promise["accuracy"], promise["requested"]), (0.02, "energy 0.02 kJ/mol"))
        self.assertEqual(promise["met"], abs(promise["bias"]) <= 0.02)
        self.refused(edited(GAS, ('"2 %"', '"energy 0 kJ/mol"')), words=["above 0", "energy 0.01 kJ/mol", "run.toml:10", "integrator.accuracy"])

    def test_wrong_input(self):
        for wrong, words in (("0 %", ["0 %", "above 0 %"]), ("150 %", ["150 %", "below 100 %"]),
                             ("-1 %", ["above 0 %"]), ("0.5", ["no unit", '"0.5 %"']), ("nan %", ["finite"])):
            self.refused(GAS, "--accuracy", wrong, words=words)
            self.refused(GAS, "--temperature-bias", wrong, words=words)
            self.refused(edited(GAS, ('"2 %"', f'"{wrong}"')), words=[*words, "run.toml:10", "integrator.accuracy"])
        self.refused(GAS, "--drift", "0 kJ/mol/ns", words=["above 0 kJ/mol/ns"])
        self.refused(GAS, "--drift", "1 kJ/mol", words=["energy", "kJ/mol/ns"])
        self.refused(GAS, "--drift", "1 kJ/mol/ns", "--accuracy", "1 %", words=["--accuracy"])
        self.refused(edited(GAS, ('accuracy = "2 %"', "")), words=["--accuracy", "--drift"])
        self.refused(edited(GAS, ('accuracy = "2 %"', 'accuracy = "2 %"\nstep = "2 fs"')),
                     words=["cannot be combined with a step", "integrator.accuracy"])
        for wrong, words in (("0 K", ["above 0", "0.1 K"]), ("0.1", ["no unit"]), ("energy", ["no bound", "energy 0.01 kJ/mol"]), ("energy 0.1 K/ns", ["energy"]),
                             ("pressure -1 bar", ["above 0"]), ("density 0.1 %", ["density", "compressibility", "[barostat]", "pressure 4 bar"]),
                             ("volume 1 %", ["volume"])):
            self.refused(GAS, "--bias", wrong, words=words)
        self.refused(GAS, "--schemes", "hoa3", words=["'hoa3'", "'hoa2'", "--schemes"])
        nested = "hoa2 / hoa2 x 1 within 0.4 nm"
        self.refused(GAS, "--schemes", nested, words=[nested, "single schemes"])
        self.refused(GAS, "--time", "0", words=["--time"])

    def test_interrupt(self):
        self.write("run.toml", edited(GAS, ("count = 32", "count = 500"), ('"0.5 ps"', '"2 ps"')))
        for verb in ("advise", "run"):
            before = self.contents()
            process = self.start(verb, "run.toml")
            self.addCleanup(process.kill)
            first = process.stderr.readline()  # from here on the signal is handled
            self.assertRegex(first, "advice for|choosing a step")
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=sandbox.LONGEST)
            self.assertEqual(process.returncode, 130, err)
            self.assertIn("no file was written", err)
            self.assertEqual(self.contents(), before)


if __name__ == "__main__":
    unittest.TestCase.maxDiff = None
    sandbox.main()
