#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# sanitized.sh BUILD [TEST...]: tests of the Python package, by default all but the tutorials and the wheel, with the module under the
# address and undefined-behaviour sanitizers. BUILD is a build of the program: that of the preset asan or asan-quick, whose library has the
# sanitizers, too, or any other. Everything is written to BUILD/python-sanitized.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$(realpath "$1")
shift
tests=("$@")
[[ $# == 0 ]] && tests=(hostile own_physics settings simulation changes progress jobs)
folder=$build/python-sanitized
flags="-fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=all"

scripts/python_environment.sh "$folder/environment" python/requirements-test.txt
python=$folder/environment/bin/python
rm -rf "$folder/installed"
cmake --install "$build" --prefix "$folder/installed" >/dev/null
cmake -S python -B "$folder/module" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g" \
  "-DCMAKE_CXX_FLAGS=$flags" "-DPOLHODE_INSTALLED=$folder/installed" "-DPython_EXECUTABLE=$python" >/dev/null
cmake --build "$folder/module" --target _core  # without stubs: they need the module in a Python without the sanitizers

package=$folder/package/polhode
rm -rf "$folder/package"
mkdir -p "$package/bin"
cp python/polhode/*.py docs/references.bib "$folder/module/"_core.*.so "$package"
cp "$folder/installed/bin/polhode" "$package/bin"

# Python is built without the sanitizers, so their libraries are loaded before it, and that of C++ with them, whose exceptions they
# intercept. Objects that the interpreter keeps until its end are no leaks. In a library without the sanitizers vectors are not
# annotated, so the overflow of their capacity cannot be checked.
runtime=$(g++ -print-file-name=libasan.so):$(g++ -print-file-name=libubsan.so):$(g++ -print-file-name=libstdc++.so)
container=1
grep -q "^POLHODE_SANITIZE:STRING=.*address" "$build/CMakeCache.txt" || container=0
for test in "${tests[@]}"; do
  echo "$test, with sanitizers"
  LD_PRELOAD=$runtime PYTHONPATH=$folder/package PYTHONMALLOC=malloc OPENBLAS_NUM_THREADS=1 \
    ASAN_OPTIONS="detect_leaks=0:detect_container_overflow=$container:allocator_may_return_null=1" \
    UBSAN_OPTIONS=print_stacktrace=1 "$python" -B "tests/python/$test.py" --program "$package/bin/polhode"
done
