# SPDX-License-Identifier: MIT
"""The pressure tensor in the energies file of a run."""

import json

import sandbox
from sandbox import SMALL, Sandbox, edited

# Energies every 4 fs for 0.4 ps, and the shadow energy at every fifth of them.
PLAIN = edited(SMALL, ('"argon"', '"tip4p"'), ('"100 K"', '"297 K"'), ('length = "0.02 ps"', 'length = "0.4 ps"\nsample = "4 fs"\nshadow_sample = "20 fs"'))
TENSOR = edited(PLAIN, ('plot = "none"', 'plot = "none"\npressure_tensor = true'))
BATH = '[thermostat]\ntype = "rescaling"\n'
COMPONENTS = ["pressure_xx", "pressure_yy", "pressure_zz", "pressure_yz", "pressure_zx", "pressure_xy"]


class PressureTensor(Sandbox):
    def table(self):
        """The samples of the energies file, by the names of the columns; empty fields are left out."""
        head, *rows = self.rows("out-energies.csv")
        names = head.split(",")
        for name in COMPONENTS:
            self.assertIn(f"{name} [bar]", names)
        return [{name.split(" ")[0]: float(x) for name, x in zip(names, row.split(","), strict=True) if x} for row in rows]

    def test_the_mean_of_the_diagonal_is_the_pressure(self):
        self.done("run", PLAIN)
        plain = self.rows("out-energies.csv")
        self.done("run", TENSOR, "--force")
        rows = self.table()
        self.assertEqual(len(rows), 101)
        # Everything else is as without the tensor.
        self.assertEqual([",".join(row.split(",")[:14]) for row in self.rows("out-energies.csv")[1:]], plain[1:])
        for row in rows:
            xx, yy, zz = (row[name] for name in COMPONENTS[:3])
            # Sums of a few hundred terms of double precision, of which the largest may cancel.
            size = abs(xx) + abs(yy) + abs(zz) + 1
            self.assertLess(abs(xx + yy + zz - 3 * row["pressure"]), 1e-11 * size)
            self.assertNotEqual(xx, yy)
        # The energies of the initial configuration have the same tensor, to ten printed digits.
        point = json.loads(self.polhode("energy", "run.toml", "--json").out)["pressure_tensor_bar"]
        for name, (i, j) in zip(COMPONENTS, ((0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)), strict=True):
            expected = (point[i][j] + point[j][i]) / 2
            self.assertLess(abs(rows[0][name] - expected), 1e-8 * max(abs(x) for row in point for x in row))

    def test_a_resumed_run_has_the_same_rows(self):
        self.done("run", TENSOR + BATH)
        whole = self.rows("out-energies.csv")
        self.assertTrue(whole[0].endswith("pressure_xy [bar],step_error [kJ/mol]"))
        self.done("run", TENSOR + BATH, "--force", "--length", "0.2 ps")
        self.done("run", TENSOR + BATH, "--resume")
        self.assertEqual(self.rows("out-energies.csv"), whole)
        self.write("run.toml", PLAIN + BATH)
        self.refused(("run", "run.toml", "--resume"), ["another run", "output.pressure_tensor was true"])

    def test_an_analysis_reads_the_file(self):
        with_bath = edited(TENSOR, ('plot = "none"', 'plot = "none"\ntrajectory_every = "4 fs"\nformats = ["xyz"]')) + BATH
        self.done("run", with_bath)
        options = ("analyze", "out-trajectory.xyz", "--run", "run.toml", "--energies", "out-energies.csv", "--what", "rdf",
                   "--plot", "none", "--json", "--force")
        process = self.polhode(*options)
        self.assertEqual(process.returncode, 0, process.err)
        tensor = json.loads(process.out)["rdf"]
        self.done("run", edited(with_bath, ("\npressure_tensor = true", "")), "--force")
        self.assertEqual(json.loads(self.polhode(*options).out)["rdf"], tensor)
        self.assertIn("step_bias", json.dumps(tensor))


if __name__ == "__main__":
    sandbox.main()
