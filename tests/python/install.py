# SPDX-License-Identifier: MIT
"""Installs the package by pip in a virtual environment, with the library and program of this build.

The same folder is used again: what has not changed is not compiled again. Exit code 77, a skip,
if pip cannot work here.
"""

import argparse
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--environment", type=Path, required=True)
    arguments = parser.parse_args()
    build, environment = arguments.build.resolve(), arguments.environment.resolve()
    (environment / "installed").unlink(missing_ok=True)
    done = subprocess.run([ROOT / "scripts/python_environment.sh", environment,
                           ROOT / "python/requirements-test.txt", sys.executable])
    if done.returncode:
        sys.exit(done.returncode)
    prefix = environment / "polhode"
    shutil.rmtree(prefix, ignore_errors=True)
    subprocess.run(["cmake", "--install", build, "--prefix", prefix], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([environment / "bin/python", "-m", "pip", "install", "--quiet", "--no-deps",
                    "--disable-pip-version-check", "--no-build-isolation", "--force-reinstall",
                    f"--config-settings=cmake.define.POLHODE_INSTALLED={prefix}",
                    f"--config-settings=build-dir={build}/python-module", ROOT], check=True)
    (environment / "installed").touch()


if __name__ == "__main__":
    main()
