# SPDX-License-Identifier: MIT
"""polhode.bias: the same results from a file and from columns."""

import os
import pathlib
import tempfile
import unittest

import package
import polhode

RUN = {"molecules": "argon", "count": 64, "density": "1.3 g/cm3", "temperature": "150 K", "cutoff": "0.65 nm", "scheme": "velocity-verlet",
       "step": "20 fs", "seed": 4}


class Bias(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(temporary.name)
        simulation = polhode.Simulation(**RUN)
        simulation.run("20 ps")
        run = simulation.run("100 ps")
        energies = run.energies
        self.columns = {"time [ps]": energies["time"], "total [kJ/mol]": energies["total"], "potential [kJ/mol]": energies["potential"],
                        "temperature [K]": energies["temperature"]}

    def test_columns_and_a_file_have_the_same_bias(self):
        of_columns = polhode.bias(self.columns)
        path = pathlib.Path("energies.csv")
        rows = zip(*self.columns.values(), strict=True)
        path.write_text("\n".join([",".join(self.columns), *(",".join(repr(float(x)) for x in row) for row in rows)]) + "\n", encoding="utf-8")
        of_file = polhode.bias(path)
        self.assertEqual(of_columns["columns"], of_file["columns"])
        potential = of_columns["columns"][0]["bias"]
        # Verlet's energy is lowest where the force is large, so the potential energy has a positive bias.
        self.assertGreater(potential["value"], 3 * potential["error"])
        self.assertIs(polhode.time_step_bias, polhode.bias)

    def test_a_column_is_named_with_or_without_its_unit(self):
        found = [polhode.bias(self.columns, total=name, potential=of)["columns"] for name, of in (("total", "potential [kJ/mol]"), ("total [kJ/mol]", None))]
        self.assertEqual(found[0], found[1])
        self.assertEqual(found[0], polhode.bias(self.columns)["columns"])

    def test_options(self):
        half = polhode.bias(self.columns, "150 K", start=50.0)
        self.assertEqual(half["temperature"], 150)
        self.assertLess(half["samples"], polhode.bias(self.columns)["samples"])

    def test_energies_of_a_run_and_of_openmm(self):
        run = polhode.Simulation(molecules="spce", count=27, cutoff="0.4 nm", switch="0.3 nm", density="1 g/cm3", step="2 fs",
                                 minimise=True).run("2 ps")
        found = {c["name"]: c["bias"] for c in polhode.bias(run.energies)["columns"]}
        alone = polhode.bias({"total [kJ/mol]": run.energies["total"], "potential [kJ/mol]": run.energies["potential"],
                              "temperature [K]": run.energies["temperature"]})
        self.assertEqual(found["potential"], alone["columns"][0]["bias"])
        self.assertNotIn("time", found)
        titles = ("#\"Time (ps)\"", "Potential Energy (kJ/mole)", "Total Energy (kJ/mole)", "Temperature (K)")
        openmm = dict(zip(titles, (run.energies[name] for name in ("time", "potential", "total", "temperature")), strict=True))
        self.assertEqual(polhode.bias(openmm)["columns"][0]["bias"], found["potential"])

    def test_what_is_no_table(self):
        for log in ({}, None, 3, [1, 2], {"total": "words"}, {"total": 1.0}, {"total": [None]}):
            with self.assertRaises(polhode.Error):
                polhode.bias(log)

    def test_wrong_input(self):
        with self.assertRaisesRegex(polhode.Error, "equally long"):
            polhode.bias({**self.columns, "total [kJ/mol]": self.columns["total [kJ/mol]"][:-1]})
        with self.assertRaisesRegex(polhode.Error, "did you mean 'total'"):
            polhode.bias(self.columns, total="totl")
        pathlib.Path("x.edr").write_bytes(b"")
        with self.assertRaises(Exception):
            polhode.bias("x.edr")


if __name__ == "__main__":
    package.main()
