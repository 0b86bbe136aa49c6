#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# python_environment.sh FOLDER REQUIREMENTS [PYTHON]: a virtual environment in FOLDER with the packages of
# REQUIREMENTS, which are pinned. One that has them is left as it is. Packages of the system can be imported, unless the first line of
# REQUIREMENTS says "no packages of the system": those of another numpy are incompatible.
# Exit code 77 if they cannot be installed, as without a network.
set -euo pipefail
folder=$1 requirements=$2 python=${3:-/usr/bin/python3}
stamp=$folder/requirements.stamp
wanted=$("$python" --version; cat "$requirements")
if [[ -f $stamp && $(cat "$stamp") == "$wanted" ]]; then
  exit 0
fi
skip() {
  echo "$*"
  exit 77
}
rm -rf "$folder"
system=--system-site-packages
[[ $wanted == *"no packages of the system"* ]] && system=
"$python" -m venv $system "$folder" || skip "there is no venv: install python3-venv"
"$folder/bin/python" -m pip install --quiet --disable-pip-version-check --retries 1 -r "$requirements" ||
  skip "pip cannot install the packages of $requirements"
printf '%s\n' "$wanted" > "$stamp"
