#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# installed_wheels.sh PYTHON...: tests of the Python package, all but the tutorials, with the wheels of scripts/wheel for these versions
# of Python, each in a new environment with NumPy alone, or with the PACKAGES of the environment, too. Module and program must load no library
# other than those of the wheel, of glibc and of GCC. Everything is written to build/installed-wheels.
set -euo pipefail
cd "$(dirname "$0")/../.."
. scripts/build.sh
root=$PWD
for python in "$@"; do
  tag=$("$python" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
  wheels=(build/wheels/polhode-*-"$tag"-"$tag"-manylinux*.whl)
  [[ ${#wheels[@]} == 1 && -f ${wheels[0]} ]] || refuse "build/wheels must have one wheel for $tag: scripts/wheel $python"
  folder=$root/build/installed-wheels/$tag
  rm -rf "$folder"
  "$python" -m venv "$folder"
  "$folder/bin/python" -m pip install --quiet --disable-pip-version-check "${wheels[0]}" ${PACKAGES-}
  say "$("$folder/bin/python" --version): $("$folder/bin/polhode" --version), $("$folder/bin/python" -m polhode --version)"
  cd "$folder"
  printf '%s\n' '[system]' 'molecules = [{ model = "argon", count = 500 }]' 'density = "1 g/cm3"' '[run]' 'length = "8 fs"' \
    '[output]' 'prefix = "w"' 'formats = ["h5md"]' 'trajectory_every = "4 fs"' 'plot = "none"' > w.toml
  bin/polhode run w.toml >/dev/null 2>&1
  bin/python - "$folder" <<'CODE'
import re, subprocess, sys
from pathlib import Path

import polhode

assert len(list(polhode.read_frames("w-trajectory.h5md"))) == 3
package = Path(polhode.__file__).parent
allowed = re.compile(r"linux-vdso|ld-linux|lib(c|m|stdc\+\+|gcc_s)\.so")
for file in (polhode._core.__file__, package / "bin/polhode"):
    for line in subprocess.run(["ldd", file], check=True, capture_output=True, text=True).stdout.splitlines():
        name, _, path = line.strip().partition(" => ")
        assert sys.argv[1] in path or allowed.search(name), f"{file} loads {line}"
CODE
  for test in simulation changes settings progress own_physics jobs hostile; do
    bin/python -B "$root/tests/python/$test.py" --program bin/polhode 2>&1 | tail -1 | sed "s/^/$test: /"
  done
  cd "$root"
done
