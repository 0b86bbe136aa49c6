# SPDX-License-Identifier: MIT
"""Runs at constant temperature and pressure: the summary against the file of energies, by a computation of its own."""

import csv
import json
import math
import re
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

BOLTZMANN = 0.00831446261815324  # kJ/mol/K
BAR = 0.0602214076  # kJ/mol/nm3
LIQUID = edited(SMALL, ('box = "2.5 nm"', 'density = "1.3 g/cm3"'), ('cutoff = "1.0 nm"', 'cutoff = "0.5 nm"\nskin = "0.05 nm"'),
                ("count = 27", "count = 64"), ('length = "0.02 ps"', 'length = "4 ps"\nsample = "10 fs"\nequilibrate = "0.5 ps"'),
                ('step = "2 fs"', 'step = "5 fs"'))
LIQUID_MASS = 64 * 39.948
NPT = LIQUID + '\n[thermostat]\n[barostat]\npressure = "100 bar"\ncompressibility = "2e-4 1/bar"\nevery = "20 fs"\n'
HYBRID = edited(LIQUID, ('step = "5 fs"', 'step = "30 fs"'), ('sample = "10 fs"', 'sample = "90 fs"')) + "\n[hybrid_monte_carlo]\nsteps = 3\n"


def mean(numbers):
    return math.fsum(numbers) / len(numbers)


def variance(numbers):
    about = mean(numbers)
    return mean([(x - about)**2 for x in numbers])


class Ensembles(Sandbox):
    def columns(self):
        """The columns of the file of energies by their name."""
        lines = [line for line in (self.folder / "out-energies.csv").read_text().splitlines() if not line.startswith("#")]
        rows = list(csv.reader(lines))
        return {name.split()[0].split("(")[0].split("[")[0]: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}

    def test_summary_at_constant_pressure(self):
        report = json.loads(self.done("run", NPT, "--json").out)
        e, ensemble, energies = report["ensemble"], report["ensemble"]["barostat"], self.columns()
        volume = energies["volume"]
        kg_per_m3 = 1.66053906660
        # Digits of the file: six or more, where differences of volumes have fewer.
        self.assertAlmostEqual(ensemble["volume_nm3"]["value"] / mean(volume), 1, places=6)
        density = mean([LIQUID_MASS / v for v in volume]) * kg_per_m3
        self.assertAlmostEqual(ensemble["density_kg_per_m3"]["value"] / density, 1, places=5)
        compressibility = variance(volume) / (BOLTZMANN * 100 * mean(volume)) * BAR
        self.assertAlmostEqual(ensemble["compressibility_per_bar"]["value"] / compressibility, 1, places=3)
        # 4 ps in steps of 5 fs, a move every 4 steps with one force evaluation each.
        self.assertEqual(ensemble["moves"], 200)
        self.assertEqual(report["force_evaluations_of_moves"], 200)
        self.assertEqual(report["force_evaluations_of_minimisation"], 0)
        self.assertLess(0, ensemble["accepted"])
        exchanged = energies["total"][-1] - energies["conserved"][-1]
        self.assertAlmostEqual(e["heat_kJ_per_mol"] + ensemble["work_kJ_per_mol"], exchanged, places=3)
        ratio = math.sqrt(variance(energies["conserved"]) / variance(energies["potential"]))
        self.assertAlmostEqual(report["R"] / ratio, 1, places=2)
        self.assertEqual(e["settings"]["barostat.pressure"], "100 bar")

    def test_bias_of_the_step_at_constant_energy(self):
        """cov(A, E)/kT, as computed from the energies file."""
        coarse = edited(LIQUID, ('step = "5 fs"', 'step = "20 fs"'), ('sample = "10 fs"', 'sample = "20 fs"'))
        report = json.loads(self.done("run", coarse, "--json").out)
        bias, energies = report["step_bias"], self.columns()
        kT = BOLTZMANN * report["temperature_K"]
        covariance = lambda x: mean([a * b for a, b in zip(x, energies["total"])]) - mean(x) * mean(energies["total"])
        expected = {"potential_kJ_per_mol": covariance(energies["potential"]) / kT / 64, "pressure_bar": covariance(energies["pressure"]) / kT,
                    "temperature_translation_K": covariance(energies["kinetic_translation"]) / kT * 2 / (BOLTZMANN * (3 * 64 - 3))}
        for name, value in expected.items():
            self.assertAlmostEqual(bias[name]["value"] / value, 1, places=2)
            self.assertGreater(bias[name]["error"], 0)
        self.assertEqual(bias["temperature_rotation_all_K"]["value"], 0)  # atoms
        self.assertNotIn("temperature_rotation_all_K", report["corrected"])
        text = self.done("run", coarse, "--force", "--verbose").out
        for words in ("time-step bias", "  potential energy    ", "kJ/mol per molecule, without it -"):
            self.assertIn(words, text)
        self.assertLess(text.index("\nforce evaluations"), text.index("\npotential energy"), "details come first")
        corrected = report["corrected"]
        for name in ("potential_kJ_per_mol", "pressure_bar", "temperature_translation_K"):
            average = report[name] if name in report else report["temperatures_K"]["translation"]["value"]
            average = average["value"] if isinstance(average, dict) else average
            self.assertAlmostEqual(corrected[name]["value"] / (average - bias[name]["value"]), 1, places=9)
            self.assertGreater(corrected[name]["error"], bias[name]["error"])  # and that of the average
        without = float(re.search(r"\n  pressure .*without it (\S+)", text)[1])
        self.assertAlmostEqual(without, corrected["pressure_bar"]["value"], delta=corrected["pressure_bar"]["error"])
        self.assertGreater(abs(bias["pressure_bar"]["value"] / report["pressure_bar"]), 1e-5, msg="the bias is too small for this test")
        self.assertIsNone(json.loads(self.done("run", NPT, "--json", "--force").out)["step_bias"])  # Langevin

    def test_temperature_of_half_steps(self):
        langevin = edited(LIQUID, ('scheme = "hoa2"', 'scheme = "baoab"'), ('step = "5 fs"', 'step = "40 fs"'), ('sample = "10 fs"', 'sample = "40 fs"'),
                          ('length = "4 ps"', 'length = "40 ps"')) + '\n[thermostat]\ntype = "langevin"\n'
        process = self.done("run", langevin)
        self.assertIn("\n  of half steps       ", process.out)
        report = json.loads(self.done("run", langevin, "--json", "--force").out)
        self.assertGreater(report["half_steps"]["temperature_K"], report["temperature_K"])
        self.assertNotIn("half_steps", json.loads(self.done("run", LIQUID, "--json", "--force").out))

    def test_lines_at_constant_pressure(self):
        process = self.done("run", edited(NPT, ("[run]", "[run]\nminimise = true")), "--verbose")
        summary = process.out.split("WARNINGS")[0]
        lines = {line[:22].strip(): line[22:] for line in summary.splitlines() if len(line) > 22}
        for name, words in [("ensemble", ["Langevin thermostat", "stochastic cell rescaling", "100 bar"]), ("density", ["kg/m3"]), ("volume", ["nm3"]),
                            ("compressibility", ["1/bar", "isothermal"]), ("moves of the box", ["of 200 accepted", "%"]),
                            ("heat received", ["kJ/mol"]), ("work received", ["kJ/mol"]), ("drift in this run", ["conserved energy"]),
                            ("pressure", ["requested: 100 bar"]), ("force evaluations", ["200 evaluations for moves of the box", "for the minimisation"])]:
            for word in words:
                self.assertIn(word, lines[name])
        self.assertIn("ensemble: " + lines["ensemble"].strip(), process.err)

    def test_summary_of_hybrid_monte_carlo(self):
        report = json.loads(self.done("run", HYBRID, "--json").out)
        hybrid, energies = report["ensemble"]["hybrid_monte_carlo"], self.columns()
        # One sample for each trajectory of 90 fs: a rejected one returns to the same positions.
        same = sum(a == b for a, b in zip(energies["potential"], energies["potential"][1:]))
        self.assertEqual(hybrid["trajectories"], len(energies["potential"]) - 1)
        self.assertEqual(hybrid["trajectories"] - hybrid["accepted"], same)
        weight = hybrid["mean_weight"]
        self.assertLess(abs(weight["value"] - 1), max(5 * (weight["error"] or 1), 1e-3))
        bounded = hybrid["mean_bounded_weight"]
        self.assertLess(abs(bounded["value"]), max(5 * (bounded["error"] or 1), 1e-3))
        self.assertAlmostEqual(hybrid["work_kJ_per_mol"], energies["total"][-1] - energies["conserved"][-1], places=3)
        # Nothing is conserved over draws and decisions.
        for key in ("R", "R_error", "R_rounding", "rms_total_kJ_per_mol", "drift_kJ_per_mol_ps", "drift_error", "drift_p_value", "drift_significant"):
            self.assertIsNone(report[key], key)
        self.assertEqual(report["drift_verdict"], "not defined")
        self.assertEqual(report["errors_not_known"]["R_error"], "not defined")
        out = self.polhode("run", "run.toml", "--output", "text").out
        self.assertIn(f"{hybrid['accepted']} of {hybrid['trajectories']} accepted", out)
        self.assertIn("<exp(-dH/kT)>", out)
        self.assertIn("effective samples", out)
        self.assertNotIn("energy drift", out)
        self.assertNotIn("\nR  ", out)

    def test_effective_samples_of_hybrid_monte_carlo(self):
        """The effective samples are those by which the error of the mean follows from the fluctuation."""
        report = json.loads(self.done("run", edited(HYBRID, ('length = "4 ps"', 'length = "200 ps"'), ('"0.5 ps"', '"8 ps"')), "--json").out)
        hybrid, n = report["ensemble"]["hybrid_monte_carlo"], report["samples"]
        ratio = (report["rms_potential_kJ_per_mol"] / (64 * report["potential_error_kJ_per_mol"]))**2 + 1
        self.assertAlmostEqual(hybrid["effective_samples"]["value"] / ratio, 1, places=6)
        self.assertAlmostEqual(hybrid["effective_samples"]["value"] * 2 * hybrid["correlation_time_ps"]["value"] / (n * 0.09), 1, places=6)
        self.assertEqual(hybrid["acceptance"]["value"], hybrid["accepted"] / hybrid["trajectories"])
        self.assertGreater(hybrid["acceptance"]["error"], 0)

    def test_moves_of_the_box_between_trajectories(self):
        """Every 50 fs is asked for; trajectories have 90 fs."""
        tables = '[barostat]\npressure = "100 bar"\ncompressibility = "2e-4 1/bar"\nevery = "50 fs"\n'
        process = self.done("run", HYBRID + tables, "--verbose")
        self.assertIn("interval of 50 fs between moves of the box is rounded to 90 fs", process.err)
        self.assertRegex(process.out, r"moves of the box +\d+ of 45 accepted.*; one every 90 fs\n")
        barostat = json.loads(self.done("run", HYBRID + tables, "--json", "--force").out)["ensemble"]["barostat"]
        self.assertEqual((barostat["moves"], round(barostat["interval_fs"], 9), barostat["beyond_shape"]), (45, 90, 0))
        process = self.done("run", HYBRID + tables + 'edges = ["xy", "z"]\n', "--force")
        self.assertIn('For a fluid use edges = ["xyz"]', process.err)

    def test_zero_friction_is_constant_energy(self):
        """The same numbers to the last digit of the files, and no heat."""
        self.done("run", LIQUID)
        text = (self.folder / "out-final.gro").read_bytes()
        report = json.loads(self.done("run", LIQUID, "--thermostat", "langevin", "--friction", "0 1/ps", "--force", "--json").out)
        self.assertEqual((self.folder / "out-final.gro").read_bytes(), text)
        self.assertEqual(report["ensemble"]["heat_kJ_per_mol"], 0)

    def test_negative_pressure(self):
        report = json.loads(self.done("run", NPT, "--pressure", "-50 bar", "--length", "0.1 ps", "--json").out)
        self.assertEqual(report["ensemble"]["settings"]["barostat.pressure"], "-50 bar")

    def test_box_below_twice_the_cutoff(self):
        """The run ends, and says at which step; what it had computed remains."""
        self.write("run.toml", edited(NPT, ('"100 bar"', '"100000 bar"'), ('"0.5 nm"', '"0.7 nm"'), ('"0.05 nm"', '"0.02 nm"')))
        process = self.polhode("run", "run.toml", "--length", "20 ps")
        self.assertEqual(process.returncode, 1, process.out)
        for words in ["at step ", "the barostat moved the box", "cutoff", "larger system", "check the pressure"]:
            self.assertIn(words, process.err)


if __name__ == "__main__":
    sandbox.main()
