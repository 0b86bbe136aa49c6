# SPDX-License-Identifier: MIT
"""The command line: python -m polhode VERB ..., or polhode VERB ..."""

import os
import sys
from pathlib import Path


def main():
    """Runs the program of this package in place of the interpreter."""
    program = Path(__file__).parent / "bin" / "polhode"
    os.execv(program, ["polhode", *sys.argv[1:]])


if __name__ == "__main__":
    main()
