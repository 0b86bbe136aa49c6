# SPDX-License-Identifier: MIT
"""The surface tension by polhode measure: a value with its profile, which resumes, and what is refused."""

import json

import sandbox
from sandbox import Sandbox

CALL = ("measure", "argon", "surface-tension", "25 %", "--molecules", "100", "--at", "95 K, 1 bar", "--threads", "2", "--output", "slab")


class Slab(Sandbox):
    def measured(self, *words):
        done = self.polhode(*CALL, *words, "--json")
        self.assertEqual(done.returncode, 0, done.err)
        return json.loads(done.out)["points"][0], done.err

    def test_surface_tension(self):
        """Argon by its Lennard-Jones potential has 11 to 20 mN/m at this temperature, which is between the value of the real liquid at
        95 K and twice it; a wrong sign, one surface instead of two, or a wrong unit is outside."""
        point, notes = self.measured()
        tension = point["properties"][0]
        self.assertTrue(tension["reached"], tension)
        self.assertIn("of a slab of 200 molecules", notes)
        error = tension["value"]["error"]
        self.assertLess(11 - 3 * error, tension["value"]["value"])
        self.assertLess(tension["value"]["value"], 20 + 3 * error)
        self.assertIsNotNone(tension["step_bias"])
        self.assertGreater(point["slab_length_ps"], 0)
        page = (self.folder / "slab.html").read_text()
        profiles = {p["quantity"]: p for p in point["slab_profiles"]}
        for quantity in profiles:
            self.assertIn(quantity, page)
        within = profiles["tension within a distance"]
        # The profile has a fifth of the samples of the tension, of the same runs. Four of its standard errors.
        self.assertLess(abs(within["value"][-1] - tension["value"]["value"] - tension["step_bias"]["value"]), 4 * within["error"][-1])
        # Nearly all of it is at the surface, and the outer quarter is vapour. In so narrow a box the liquid has a part, too.
        self.assertGreater(within["value"][74] - within["value"][24], 0.7 * within["value"][-1])
        self.assertAlmostEqual(within["value"][74], within["value"][-1], delta=4 * within["error"][-1])
        again, notes = self.measured()
        self.assertEqual(again["properties"][0]["value"], tension["value"])
        self.assertEqual(again["slab_length_ps"], point["slab_length_ps"])

    def test_truncated_charges_are_refused(self):
        self.write("water.toml", '[system]\nmolecules = [{ model = "spce", count = 64 }]\ndensity = "1 g/cm3"\n'
                                 '[forces]\nelectrostatics = "reaction-field"\ncutoff = "0.6 nm"\n')
        done = self.polhode("measure", "water.toml", "surface-tension", "--at", "300 K, 1 bar")
        self.assertEqual(done.returncode, 2, done.err)
        self.assertIn('requires electrostatics = "pme"', done.err)


if __name__ == "__main__":
    sandbox.main()
