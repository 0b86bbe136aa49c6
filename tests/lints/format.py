# SPDX-License-Identifier: MIT
"""C++ is formatted as .clang-format says; skipped (exit 77) without clang-format 14."""

import re
import shutil
import subprocess
import sys

from tree import Finding, files, main

FOLDERS = ("include", "src", "cli", "python", "lammps", "tests", "bench", "examples")
VERSION = "14"  # other versions lay the same style out differently


def check(root):
    paths = files(root, (".hpp", ".cpp"), FOLDERS)
    if not paths:
        return
    run = subprocess.run(["clang-format", "--dry-run", "--style=file", *map(str, paths)], text=True,
                         capture_output=True, check=False)
    seen = set()
    for path, line in re.findall(r"^(.+?):(\d+):\d+: ", run.stderr, re.M):
        if path not in seen:
            seen.add(path)
            yield Finding(root / path, int(line), "not formatted; run clang-format -i on the file")


if __name__ == "__main__":
    program = shutil.which("clang-format")
    version = program and subprocess.run([program, "--version"], text=True, capture_output=True,
                                         check=True).stdout
    if not program or f"version {VERSION}." not in version:
        print(f"skipped: no clang-format {VERSION} on PATH")
        sys.exit(77)
    main(check, __doc__)
