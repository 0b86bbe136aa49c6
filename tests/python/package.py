# SPDX-License-Identifier: MIT
"""Shared by the tests of the Python package: the program, and small systems."""

import argparse
import importlib
import os
import subprocess
import sys
import unittest

PROGRAM = None

WATER = {"system": {"molecules": [{"model": "tip4p", "count": 64}], "density": "1 g/cm3",
                    "temperature": "297 K", "seed": 5},
         "forces": {"cutoff": "0.6 nm", "switch": "0.5 nm"},
         "integrator": {"scheme": "hoa2", "step": "2 fs"},
         "run": {"length": "40 fs", "sample": "4 fs"},
         "output": {"formats": ["gro"], "plot": "none"}}


def program(*arguments, **options):
    """The output of the program of the command line."""
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True,
                          **options).stdout


def python(code, **options):
    """A Python of its own that runs some code; its result is that of subprocess.run()."""
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, **options)


def optional(name):
    """A module; where it is not installed, the test is skipped."""
    try:
        return importlib.import_module(name)
    except ImportError:
        raise unittest.SkipTest(f"{name} is not installed") from None


def main():
    """Runs the tests of the calling file. Exit code 77 if the package is not installed."""
    global PROGRAM
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = os.path.abspath(arguments.program)
    __import__("package").PROGRAM = PROGRAM
    unittest.main(module="__main__", argv=[sys.argv[0], *rest])
