# SPDX-License-Identifier: MIT
"""polhode.measure: the same records from threads, processes, dask and MPI, where these are installed."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ProcessPoolExecutor

import package
import polhode

CALL = {"system": "argon", "properties": {"density": "1 %", "compressibility": "30 %"}, "molecules": 64,
        "at": "160 K, 500 bar"}

ON_MPI = """
import polhode
from mpi4py.futures import MPIPoolExecutor
if __name__ == "__main__":
    with MPIPoolExecutor() as pool:
        polhode.measure(**{call}, output="mpi", executor=pool)
"""


class Measure(unittest.TestCase):
    here = None  # the records of CALL by threads, computed once

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def records(self, prefix):
        return {path.name.removeprefix(prefix): path.read_bytes() for path in self.folder.glob(f"{prefix}*.replica")}

    def records_here(self):
        if Measure.here is None:
            polhode.measure(**CALL, output="here", threads=1)
            Measure.here = self.records("here")
        return Measure.here

    def test_a_property_with_its_error(self):
        report = polhode.measure(**CALL)
        density, compressibility = report["points"][0]["properties"]
        self.assertEqual(density["name"], "density")
        self.assertTrue(report["reached"])
        self.assertLess(density["value"]["error"], 0.01 * density["value"]["value"])
        self.assertIn("measure.html", report.files)
        merged = polhode.merge(**CALL)
        self.assertEqual(merged["points"], report["points"])

    def test_an_executor_computes_the_same_bits(self):
        with ProcessPoolExecutor(2) as pool:
            polhode.measure(**CALL, output="pool", executor=pool)
        self.assertEqual(self.records("pool"), self.records_here())
        self.assertNotIn("executor", pathlib.Path("pool.html").read_text(encoding="utf-8"))  # the recorded call has the same results without it

    def test_an_executor_couples_molecules_with_the_same_bits(self):
        call = {**CALL, "properties": {"solvation-free-energy": "0.5 kJ/mol"}, "molecules": 32, "solute": "krypton"}
        here = polhode.measure(**call, output="here", threads=1)
        with ProcessPoolExecutor(2) as pool:
            polhode.measure(**call, output="pool", executor=pool)
        self.assertEqual(self.records("pool"), self.records("here"))
        self.assertEqual(polhode.merge(**{**call, "output": "here"})["points"], here["points"])

    @unittest.skipUnless(importlib.util.find_spec("distributed"), "dask's distributed is not installed")
    def test_dask_computes_the_same_bits(self):
        from distributed import Client, LocalCluster
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            polhode.measure(**CALL, output="dask", executor=client.get_executor())
        self.assertEqual(self.records("dask"), self.records_here())

    @unittest.skipUnless(importlib.util.find_spec("mpi4py"), "mpi4py is not installed")
    def test_mpi_computes_the_same_bits(self):
        """Two processes compute replicas, a third gives them out."""
        pathlib.Path("on_mpi.py").write_text(ON_MPI.format(call=CALL), encoding="utf-8")
        mpiexec = pathlib.Path(sys.executable).parent / "mpiexec"
        subprocess.run([mpiexec, "-n", "3", sys.executable, "-m", "mpi4py.futures", "on_mpi.py"], check=True, timeout=600)
        self.assertEqual(self.records("mpi"), self.records_here())

    def test_paired_runs_can_be_left_out(self):
        call = {**CALL, "properties": {"viscosity": "50 %"}}
        paired = polhode.measure(**call, output="with")["points"][0]["properties"][0]
        self.assertGreater(paired["step_bias_bound"], 0)
        alone = polhode.measure(**call, output="without", paired_runs=False)["points"][0]["properties"][0]
        self.assertIsNone(alone["step_bias_bound"])

    def test_hybrid_monte_carlo(self):
        found = polhode.measure(**CALL, output="hybrid", sampling="hybrid-monte-carlo")["points"][0]["properties"][0]
        self.assertIsNone(found["step_bias"])
        with self.assertRaisesRegex(polhode.Error, 'sampling = "monte-carlo" must be molecular-dynamics or hybrid-monte-carlo'):
            polhode.measure(**CALL, output="other", sampling="monte-carlo")

    def test_scheme_and_step(self):
        found = polhode.measure(**CALL, output="verlet", scheme="velocity-verlet", step="20 fs")["points"][0]
        self.assertEqual((found["scheme"], found["step_fs"]), ("velocity-verlet", 20))

    def test_wrong_input(self):
        with self.assertRaisesRegex(polhode.Error, "did you mean 'density'"):
            polhode.measure("argon", "densty")
        with self.assertRaisesRegex(polhode.Error, "the error '0.05' of density must be in % or in kg/m3"):
            polhode.measure("argon", {"density": 0.05})
        with self.assertRaisesRegex(polhode.Error, "no molecule has a dipole"):
            polhode.measure("argon", ["dielectric-constant"])
        with self.assertRaisesRegex(polhode.Error, "no record"):
            polhode.merge("argon", "density")


if __name__ == "__main__":
    package.main()
