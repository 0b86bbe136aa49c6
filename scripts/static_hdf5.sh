#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# static_hdf5.sh FOLDER: static libraries of HDF5 and zlib in FOLDER, position-independent and without network
# libraries, from Debian's sources of the versions below. Other versions are refused: a wheel states what it contains.
set -euo pipefail
hdf5=1.10.8+repack1-1 zlib=1:1.2.13.dfsg-1
folder=$(mkdir -p "$1" && cd "$1" && pwd)
wanted="hdf5 $hdf5, zlib $zlib"
if [[ -f $folder/built && $(cat "$folder/built") == "$wanted" ]]; then
  exit 0
fi
rm -rf "$folder"
mkdir -p "$folder"/{sources.list.d,lists/partial,source}

# The sources are where the packages of this system are from.
eval "$(apt-config shell list Dir::Etc::sourcelist/f parts Dir::Etc::sourceparts/d)"
for list in "$list" "$parts"*.list "$parts"*.sources; do
  [[ ! -f $list ]] || sed 's/^Types:.*/Types: deb-src/; s/^deb /deb-src /' "$list" > "$folder/sources.list.d/${list##*/}"
done
apt=(apt-get -qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$folder/sources.list.d"
     -o Dir::State::lists="$folder/lists" -o APT::Sandbox::User=)
"${apt[@]}" update
(cd "$folder/source" && "${apt[@]}" source "hdf5=$hdf5" "zlib=$zlib" >/dev/null 2>&1) ||
  { echo "error: there are no sources of $wanted" >&2; exit 1; }

# build NAME OPTION...: with position-independent code
build() {
  cd "$folder"/source/"$1"-*/
  CFLAGS="-O2 -fPIC" ./configure --prefix="$folder" "${@:2}"
  make -j "$(nproc)" install
}
(build zlib --static) >/dev/null
(build hdf5 --disable-shared --disable-hl --disable-tools --disable-tests --with-zlib="$folder") >/dev/null 2>&1
cp "$folder/source/"hdf5-*/COPYING "$folder/LICENSE-hdf5.txt"
sed '/\*\//q' "$folder/include/zlib.h" > "$folder/LICENSE-zlib.txt"
rm -rf "$folder"/{source,lists,sources.list.d}
echo "$wanted" > "$folder/built"
