# SPDX-License-Identifier: MIT
"""The centre of mass is at rest: for any initial configuration, with a mesh, and for a single body."""

import json
import re

import sandbox
from sandbox import SMALL, Sandbox, edited

WATER = """
[system]
molecules = [{ model = "tip4p", count = 8 }]
density = "0.3 g/cm3"
temperature = "300 K"

[forces]
cutoff = "0.44 nm"
electrostatics = "pme"
pme_accuracy = 1e-2
dispersion_correction = false

[integrator]
scheme = "velocity-verlet"
step = "1 fs"

[run]
equilibrate = "0.5 ps"
length = "1 ps"

[output]
prefix = "out"
plot = "none"
"""


def moved(gro, velocity):
    """A GRO file with `speed` [nm/ps] added to all velocities along x, in columns of the same width."""
    def line(text):
        numbers = list(re.finditer(r" *-?\d+\.\d+", text[20:]))
        if len(numbers) != 6:
            return text
        old = numbers[3]
        decimals = len(old[0]) - old[0].index(".") - 1
        new = f"{float(old[0]) + velocity:{len(old[0])}.{decimals}f}"
        return text[:20 + old.start()] + new + text[20 + old.end():]
    return "".join(line(text) for text in gro.splitlines(keepends=True))


class Momentum(Sandbox):
    def report(self, text, *options):
        process = self.done("run", text, "--json", "--force", *options)
        return json.loads(process.out), process.err

    def test_a_common_velocity_is_removed_and_noted(self):
        """1 nm/ps of argon is 4800 K for each of three directions, shared by the 78 degrees of freedom of 27 atoms."""
        self.done("run", SMALL)
        start = (self.folder / "out-final.gro").read_text(encoding="utf-8")
        results = []
        for velocity in (0, 1):
            self.write("start.gro", moved(start, velocity))
            report, log = self.report(edited(SMALL, ('box = "2.5 nm"', 'initial_configuration = "start.gro"')))
            self.assertLess(report["momentum"], 1e-9)
            noted = re.search(r"moves at (\S+) nm/ps, equivalent to (\S+) K", log)
            if velocity == 0:
                self.assertIsNone(noted, log)
            else:
                self.assertAlmostEqual(float(noted[1]), 1, delta=1e-3)
                self.assertAlmostEqual(float(noted[2]), 39.948 * 27 / (0.00831446 * 78), delta=3)
            results.append(report)
        rest, moving = results
        self.assertAlmostEqual(rest["temperature_K"], moving["temperature_K"], delta=1e-2)
        self.assertAlmostEqual(rest["pressure_bar"], moving["pressure_bar"], delta=1e-2)
        self.assertGreater(rest["temperature_K"], 50)

    def test_a_coarse_mesh_keeps_the_momentum(self):
        """Rounding of 1000 kicks with forces of about 1e3 kJ/mol/nm, each 1e-3 ps, is below 1e-9."""
        for scheme in ("velocity-verlet", "gier4", "gier4-fd"):
            report, _ = self.report(edited(WATER, ("velocity-verlet", scheme)))
            self.assertLess(report["momentum"], 1e-8 if scheme == "gier4-fd" else 1e-9, scheme)

    def test_a_single_body_has_the_temperature_asked_for(self):
        """All kinetic energy is rotation, which is undisturbed."""
        one = edited(SMALL, ('model = "argon", count = 27', 'model = "tip4p", count = 1'), ("100 K", "297 K"),
                     ('length = "0.02 ps"', 'length = "0.02 ps"\nequilibrate = "0.1 ps"'))
        report, _ = self.report(one)
        self.assertAlmostEqual(report["temperature_K"], 297, delta=1e-6)
        self.assertEqual(report["degrees_of_freedom_translation"], 0)
        self.assertEqual(report["momentum"], 0)

    def test_a_single_atom_has_no_temperature(self):
        report, log = self.report(edited(SMALL, ("count = 27", "count = 1")))
        self.assertIn("no degrees of freedom", log)
        self.assertEqual(report["temperature_K"], 0)


if __name__ == "__main__":
    sandbox.main()
