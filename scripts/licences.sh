#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# licences.sh FOLDER HDF5 ENVIRONMENT: the licences of what a wheel contains, one file each in FOLDER: of the Debian
# packages that packages.txt lists, of the HDF5 and zlib in HDF5, and of nanobind in ENVIRONMENT.
set -euo pipefail
folder=$1 hdf5=$2 environment=$3
rm -rf "$folder"
mkdir -p "$folder"
grep -E -- '-dev$' packages.txt | grep -v hdf5 | while read -r package; do
  cp "$(dpkg-query -L "$package" | grep '/copyright$')" "$folder/$package.txt"
done
grep -oh "[^ \"\`]*common-licenses/[A-Za-z]*-[0-9.]*[0-9]" "$folder"/*.txt | sort -u | xargs cp --target-directory="$folder"
cp "$hdf5"/LICENSE-*.txt "$folder"
cp "$environment/lib/"python*/site-packages/nanobind-*/licenses/LICENSE "$folder/nanobind.txt"
