# SPDX-License-Identifier: MIT
"""A case whose data are absent ends with 77, which ctest shows as skipped; a case that fails does not."""

import argparse
import os
import subprocess
import tempfile
import unittest

PROGRAM = None  # test_physics
CASE = "--test-case=energies of water by term equal those published by NIST"


def exit_code(folder):
    return subprocess.run([PROGRAM, CASE], env={**os.environ, "POLHODE_NIST_SPCE": folder}, capture_output=True,
                          text=True, check=False).returncode


class Skipped(unittest.TestCase):
    def test_without_its_data_it_is_skipped(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(exit_code(folder), 77)

    def test_with_other_data_it_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            for k in range(1, 5):
                with open(f"{folder}/spce{k}.etomica_HHO.pos", "w", encoding="utf-8") as file:
                    file.write("0 0 0\n1 0 0\n0 1 0\n")
            self.assertEqual(exit_code(folder), 1)

    def test_a_failure_comes_before_a_skip(self):
        with tempfile.TemporaryDirectory() as folder:  # the first configuration is other data, the second is absent
            with open(f"{folder}/spce1.etomica_HHO.pos", "w", encoding="utf-8") as file:
                file.write("0 0 0\n1 0 0\n0 1 0\n")
            self.assertEqual(exit_code(folder), 1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    options, rest = parser.parse_known_args()
    PROGRAM = options.program
    unittest.main(argv=["skipped", *rest])
