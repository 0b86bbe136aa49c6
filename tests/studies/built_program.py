# SPDX-License-Identifier: MIT
"""The built program, and the studies, for tests that run them: --program on the command line."""

import argparse
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "studies"))
PROGRAM = None


def main():
    """Runs the tests of the main module; options other than --program go to unittest."""
    global PROGRAM
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    options, rest = parser.parse_known_args()
    PROGRAM = options.program.resolve()
    unittest.main(module="__main__", argv=[Path(sys.argv[0]).stem, *rest])
