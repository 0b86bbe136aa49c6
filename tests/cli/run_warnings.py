# SPDX-License-Identifier: MIT
"""A wrong simulation says so, at its end, with exit code 0; a right one does not."""

import json

import sandbox
from sandbox import Sandbox, edited

# A lattice of water, whose potential energy heats it by hundreds of kelvin.
LATTICE = """[system]
molecules = [{ model = "tip4p-2005", count = 64 }]
density = "1 g/cm3"
temperature = "298 K"

[forces]
cutoff = "0.6 nm"
truncation = "site-switch"

[integrator]
step = "2 fs"

[run]
length = "0.4 ps"

[output]
plot = "none"
trajectory_every = "0 ps"
"""

BENZENE = """[system]
molecules = [{ model = "benzene", count = 200 }]
density = "0.876 g/cm3"
temperature = "300 K"

[forces]
cutoff = "0.9 nm"

[run]
equilibrate = "0.5 ps"
length = "0.1 ps"

[output]
plot = "none"
trajectory_every = "0 ps"
"""


DEFAULT = """[system]
initial_configuration = "w512"
molecules = [{ model = "tip4p" }]

[run]
length = "0.4 ps"

[output]
plot = "none"
trajectory_every = "0 ps"
"""


class Warnings(Sandbox):
    def both(self, text, *options):
        """The summary as text, the warnings of its JSON by kind, and what was noted."""
        process = self.done("run", text, "--force", *options)
        report = json.loads(self.done("run", text, "--json", "--force", *options).out)
        return process.out, {warning["kind"]: warning for warning in report["warnings"]}, process.err

    def test_a_lattice_that_heats_up(self):
        out, warnings, _ = self.both(LATTICE)
        self.assertEqual(set(warnings), {"temperature", "pressure"})
        self.assertGreater(warnings["temperature"]["value"], 600)
        self.assertIn("equilibrate", warnings["temperature"]["remedy"])
        self.assertLess(out.index("files  "), out.index("WARNINGS"))
        for warning in warnings.values():
            self.assertIn(warning["text"][:20], out)  # the numbers are the same to the last bit
            self.assertIn("-> " + warning["remedy"], out)

    def test_a_good_run(self):
        out, warnings, notes = self.both(DEFAULT)
        self.assertEqual(warnings, {})
        self.assertNotIn("WARNING", out + notes)

    def test_a_temperature_on_the_line_is_for_new_velocities(self):
        self.done("run", DEFAULT, "--length", "20 fs", "--output", "before")
        kept = edited(DEFAULT, ('"w512"', '"before-final.gro"'))
        _, warnings, notes = self.both(kept, "--length", "20 fs", "--temperature", "500 K", "--seed", "3")
        self.assertIn("temperature and seed are not used", notes)
        self.assertIn("warning: the velocities of the initial configuration correspond to", notes)
        self.assertIn("velocities of the initial configuration were used", warnings["temperature"]["remedy"])
        fresh = edited(kept, ("molecules =", 'velocities = "new"\nmolecules ='))
        _, warnings, notes = self.both(fresh, "--length", "20 fs", "--temperature", "300 K", "--seed", "3")
        self.assertNotIn("velocities", notes)

    def test_a_step_that_is_too_long(self):
        out, warnings, notes = self.both(DEFAULT, "--scheme", "velocity-verlet", "--step", "8 fs")
        self.assertLessEqual({"R", "step"}, set(warnings))
        self.assertIn("warning: the step of 8 fs is near the stability limit of velocity-verlet", notes)
        self.assertGreater(warnings["R"]["value"], 0.05)

    def test_ions(self):
        text = edited(LATTICE, ('count = 64 }', 'count = 60 }, { model = "na-tip4p-ew", count = 2 }'))
        _, warnings, notes = self.both(text, "--length", "0.02 ps")
        self.assertIn("ions", warnings)
        self.assertIn("warning: 'na-tip4p-ew' has a charge of +1 e", notes)

    def test_liquid_benzene_from_a_run_file(self):
        refused = edited(BENZENE, ('equilibrate = "0.5 ps"\n', ""))
        self.write("run.toml", refused)
        process = self.polhode("run", "run.toml")
        self.assertEqual(process.returncode, 2)
        self.assertIn("write minimise = true in [run]", process.err)
        _, warnings, _ = self.both(BENZENE)
        self.assertNotIn("temperature", warnings)


if __name__ == "__main__":
    Sandbox.maxDiff = None
    sandbox.main()
