# SPDX-License-Identifier: MIT
"""The kernels for 64-bit ARM: compiled by Debian's cross compiler, and their tests run by qemu. What is compiled stays in
the build folder."""

import argparse
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
NEEDED = {"aarch64-linux-gnu-g++": "g++-aarch64-linux-gnu", "qemu-aarch64-static": "qemu-user-static"}
# A run of many steps and two averages over many states, which would take more time than all others.
LONG = ("*long runs at high temperature*", "*minus the gradient of its energy*", "*respect to the volume*")
SKIPPED = 77


def main():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("--build", type=Path, required=True)
    p.add_argument("--jobs", type=int, default=2)
    o = p.parse_args()
    for program, package in NEEDED.items():
        if not shutil.which(program):
            print(f"skipped: {program} is not there (Debian: {package})")
            return SKIPPED
    build = o.build / "arm"
    subprocess.run(["cmake", "-S", HERE, "-B", build, "-G", "Ninja",
                    f"-DCMAKE_TOOLCHAIN_FILE={HERE}/aarch64-linux-gnu.cmake"], check=True)
    subprocess.run(["cmake", "--build", build, "--parallel", str(o.jobs)], check=True)
    run = subprocess.run(["qemu-aarch64-static", build / "test_kernels", f"--test-case-exclude={','.join(LONG)}"],
                         check=False)
    return run.returncode


if __name__ == "__main__":
    sys.exit(main())
