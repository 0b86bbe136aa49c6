# SPDX-License-Identifier: MIT
"""CSV files are read as they are by numpy, gnuplot and, where it is installed, pandas."""

import importlib.util
import shutil
import subprocess
import unittest

import sandbox
from sandbox import SMALL, Sandbox


def missing(module):
    return importlib.util.find_spec(module) is None


class Readers(Sandbox):
    def setUp(self):
        super().setUp()
        self.done("run", SMALL)
        self.done("study", SMALL)
        self.energies, self.study = self.folder / "out-energies.csv", self.folder / "study.csv"
        head, *rows = self.rows("out-energies.csv")
        column = head.split(",").index("potential [kJ/mol]")
        self.potential = [float(row.split(",")[column]) for row in rows]

    @unittest.skipIf(missing("numpy"), "numpy is not installed")
    def test_numpy(self):
        import numpy
        table = numpy.genfromtxt(self.energies, delimiter=",", names=True)
        self.assertEqual(table.dtype.names[:3], ("time_ps", "total_kJmol", "potential_kJmol"))
        self.assertEqual(list(table["potential_kJmol"]), self.potential)
        points = numpy.genfromtxt(self.study, delimiter=",", names=True, dtype=None, encoding="utf-8")
        self.assertEqual(points["scheme"], "velocity-verlet")

    @unittest.skipIf(missing("pandas"), "pandas is not installed")
    def test_pandas(self):
        import pandas
        table = pandas.read_csv(self.energies, comment="#", float_precision="round_trip")
        self.assertEqual(list(table["potential [kJ/mol]"]), self.potential)
        self.assertEqual(list(pandas.read_csv(self.study, comment="#")["scheme"]), ["velocity-verlet"])

    @unittest.skipIf(shutil.which("gnuplot") is None, "gnuplot is not installed")
    def test_gnuplot(self):
        script = ("set datafile separator comma; set table 'table.txt'; "
                  "plot 'out-energies.csv' using 'time [ps]':'potential [kJ/mol]' with lines")
        subprocess.run(["gnuplot", "-e", script], cwd=self.folder, check=True, capture_output=True)
        text = (self.folder / "table.txt").read_text()
        points = [line.split() for line in text.splitlines() if line.strip() and not line.startswith("#")]
        self.assertEqual(len(points), len(self.potential))
        for point, potential in zip(points, self.potential):
            self.assertAlmostEqual(float(point[1]), potential, delta=1e-5 * abs(potential))  # six digits


if __name__ == "__main__":
    sandbox.main()
