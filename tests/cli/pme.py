# SPDX-License-Identifier: MIT
"""PME on the command line: energy terms, log, effect of pme_accuracy, a run, identity of a study."""

import json
import math

import sandbox
from sandbox import Sandbox

WATER = """
[system]
molecules = [{ model = "spce", count = 64 }]
density = "0.9 g/cm3"
temperature = "250 K"

[forces]
cutoff = "0.6 nm"
electrostatics = "pme"
pme_accuracy = ACCURACY
"""
RUN = """
[integrator]
scheme = "gier4"
step = "2 fs"

[run]
length = "0.2 ps"
"""


def water(accuracy="1e-4", more=""):
    return WATER.replace("ACCURACY", accuracy) + more


class Pme(Sandbox):
    def energy(self, text):
        return json.loads(self.done("energy", text, "--json").out)

    def test_terms_add_up_and_do_not_depend_on_the_accuracy(self):
        coarse, fine = self.energy(water("1e-5")), self.energy(water("1e-7"))
        for result in (coarse, fine):
            terms = result["terms_kJ_per_mol"]
            self.assertEqual(set(terms), {"real space", "mesh", "self", "intramolecular", "background"})
            self.assertAlmostEqual(sum(terms.values()), result["coulomb_kJ_per_mol"], delta=1e-8)
        self.assertNotEqual(coarse["terms_kJ_per_mol"]["mesh"], fine["terms_kJ_per_mol"]["mesh"])
        # Forces on a charge in water are about 3000 kJ/mol/nm: errors of 1e-5 of that on 192 charges, times 0.1 nm and
        # with random signs, give 0.04 kJ/mol; in the pressure, times the 0.6 nm of a pair, three times that divided by
        # the volume.
        self.assertAlmostEqual(coarse["coulomb_kJ_per_mol"], fine["coulomb_kJ_per_mol"], delta=0.05)
        self.assertAlmostEqual(coarse["pressure_bar"], fine["pressure_bar"], delta=0.75)

    def test_the_damped_shifted_force_comes_near_the_sum_over_all_images(self):
        more = (water().replace('"0.6 nm"', '"0.9 nm"').replace("spce", "tip4p").replace("count = 64", "count = 512")
                .replace('density = "0.9 g/cm3"', 'initial_configuration = "w512"'))
        ewald = self.energy(more)
        damped = self.energy(more.replace('"pme"', '"damped-shifted-force"').replace("pme_accuracy = 1e-4", ""))
        terms = damped["terms_kJ_per_mol"]
        self.assertEqual(set(terms), {"pairs", "self", "intramolecular"})
        self.assertAlmostEqual(sum(terms.values()), damped["coulomb_kJ_per_mol"], delta=1e-8)
        # At the cutoff the damping leaves erfc(2 x 0.9) = 1.1 % of a charge.
        off = abs(damped["coulomb_kJ_per_mol"] / ewald["coulomb_kJ_per_mol"] - 1)
        self.assertLess(off, math.erfc(1.8))
        self.assertGreater(off, 1e-5)

    def test_dispersion_lowers_energy_and_pressure(self):
        plain = self.energy(water())
        tail = self.energy(water(more="dispersion_correction = true\n"))
        energy = tail["terms_kJ_per_mol"]["dispersion tail"]
        self.assertLess(energy, 0)
        self.assertAlmostEqual(tail["van_der_waals_kJ_per_mol"] - plain["van_der_waals_kJ_per_mol"], energy, delta=1e-9)
        volume = 64 * 18.0154 / (0.9 * 602.214076)  # nm3
        self.assertAlmostEqual(tail["pressure_bar"] - plain["pressure_bar"], energy / volume * 16.6053907,
                               delta=1e-3 * abs(energy))

    def test_the_log_names_the_mesh_and_a_run_keeps_its_energy(self):
        done = self.done("run", water(more=RUN), "--json", "--force")
        self.assertRegex(done.err, r"PME: pairs of charges up to [.0-9]+ nm, grid \d+ x \d+ x \d+, order \d, split exponent \d+, .* 0.0001")
        summary = json.loads(done.out)
        self.assertLess(summary["R"], 0.002)
        self.assertIn("pressure_bar", summary)


if __name__ == "__main__":
    sandbox.main()
