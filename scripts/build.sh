# SPDX-License-Identifier: MIT
# Sourced by ./demo and ./test at the root of the project: functions that install the Debian packages
# that are missing, and build a preset and link ./polhode. What is done is skipped.

say() { printf '== %s\n' "$*"; }
refuse() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# missing_packages FILE...
missing_packages() {
  local package
  grep -hv '^#' "$@" | while read -r package; do
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || echo "$package"
  done
}

# install_packages FILE...: what these files list
install_packages() {
  local wanted=() as_root=()
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: install what $* lists by your own means"
    return
  fi
  wanted=($(missing_packages "$@"))
  if ((${#wanted[@]} == 0)); then
    say "packages: all there"
    return
  fi
  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      refuse "packages are missing and there is no sudo; as root: apt-get install ${wanted[*]}"
    as_root=(sudo)
  fi
  say "packages: installing ${wanted[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${wanted[@]}" >/dev/null
}

# build_preset NAME [OPTION...]: in build/NAME, with options of cmake --build
build_preset() {
  local preset=$1 settings=(-DPOLHODE_QUICK_BUILD=ON)
  shift
  [[ $preset == release && -x /usr/bin/python3 ]] && settings+=(-DPython3_EXECUTABLE=/usr/bin/python3)
  if [[ ! -f build/$preset/build.ninja ]]; then
    say "configure: build/$preset"
    cmake --preset "$preset" "${settings[@]}" >/dev/null
  fi
  say "build: build/$preset"
  cmake --build --preset "$preset" "$@"
  ln -sfn "build/$preset/polhode" polhode
}
