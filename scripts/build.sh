# SPDX-License-Identifier: MIT
# Sourced by ./demo and ./test at the root of the project: installs the Debian packages that are
# missing, builds the release preset, links ./polhode. Each step is skipped when it is done.

say() { printf '== %s\n' "$*"; }
refuse() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

missing_packages() {
  local package
  grep -v '^#' packages.txt | while read -r package; do
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || echo "$package"
  done
}

install_packages() {
  local wanted=() as_root=()
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: install what packages.txt lists by your own means"
    return
  fi
  wanted=($(missing_packages))
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

build_release() {
  local python=()
  [[ -x /usr/bin/python3 ]] && python=(-DPython3_EXECUTABLE=/usr/bin/python3)
  if [[ ! -f build/release/build.ninja ]]; then
    say "configure: build/release"
    cmake --preset release "${python[@]}" >/dev/null
  fi
  say "build: build/release"
  cmake --build --preset release
  ln -sfn build/release/polhode polhode
}

install_packages
build_release
