# SPDX-License-Identifier: MIT
"""Mixing rule and pairs of a run file apply in every verb, and appear in the log and in the record of a study."""

import json

import sandbox
from sandbox import SMALL, Sandbox, edited

MIXTURE = edited(SMALL, ('[{ model = "argon", count = 27 }]', '[{ model = "argon", count = 20 }, { model = "neon", count = 20 }]'))
GEOMETRIC = edited(MIXTURE, ('cutoff = "1.0 nm"\n', 'cutoff = "1.0 nm"\nmixing = "geometric"\n'))
PAIR = '[[pair]]\nsites = ["argon.Ar", "neon.Ne"]\nsigma = "0.35 nm"\nepsilon = "0.5 kJ/mol"\n'
# The parameters of argon in data/molecules/argon.toml.
ITSELF = '[[pair]]\nsites = ["argon.Ar", "argon.Ar"]\nsigma = "0.3405 nm"\nepsilon = "0.996072621655 kJ/mol"\n'


class Mixing(Sandbox):
    def energy(self, text):
        return json.loads(self.done("energy", text, "--json").out)["van_der_waals_kJ_per_mol"]

    def test_energies(self):
        usual = self.energy(MIXTURE)
        energies = [usual, self.energy(GEOMETRIC), self.energy(MIXTURE + PAIR)]
        self.assertEqual(len(set(energies)), 3, energies)
        self.assertEqual(self.energy(MIXTURE + ITSELF), usual)  # to the bit

    def test_no_lennard_jones_term_at_all(self):
        atoms = edited(SMALL, ("count = 27", "count = 64"))
        self.assertNotEqual(self.energy(atoms), 0)
        self.assertEqual(self.energy(atoms + edited(ITSELF, ("0.996072621655 kJ", "0 kJ"))), 0)

    def test_logs(self):
        for verb, options in (("run", ["--force"]), ("energy", []), ("study", ["--force"])):
            self.assertNotIn("Lennard-Jones:", self.done(verb, MIXTURE, *options).err, verb)
            log = self.done(verb, GEOMETRIC + PAIR, *options).err
            self.assertIn("Lennard-Jones: geometric mixing; argon.Ar with neon.Ne: sigma 0.35 nm, epsilon 0.5 kJ/mol\n", log, verb)
        self.assertIn("geometric mixing; argon.Ar with neon.Ne", (self.folder / "study.json").read_text())

    def test_a_study_with_other_mixing_is_another_study(self):
        self.done("study", MIXTURE)
        self.write("run.toml", GEOMETRIC)
        process = self.polhode("study", "run.toml")
        self.assertEqual(process.returncode, 2)
        self.assertIn("another study", process.err)


if __name__ == "__main__":
    sandbox.main()
