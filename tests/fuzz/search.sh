#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A search for hostile files with clang's libFuzzer: search.sh SECONDS [BUILD], shared by all readers;
# prints a line for each, and keeps findings and corpora in the build folder.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:?usage: search.sh SECONDS [BUILD]} build=${2:-build/fuzz}
cmake -G Ninja -B "$build" -S . -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release -DPOLHODE_FUZZER=ON \
  -DPOLHODE_DEVELOPER=OFF -DPOLHODE_BENCH=OFF -DPOLHODE_EXAMPLES=OFF >/dev/null
readers=$(ls tests/fuzz/targets | sed 's/\.cpp$//')
cmake --build "$build" --target $(printf 'fuzz_%s ' $readers) >/dev/null
each=$((seconds / $(wc -w <<<"$readers")))
echo "| reader | seconds | inputs | branches | findings |"
echo "| --- | --- | --- | --- | --- |"
for reader in $readers; do
  corpus="$build/corpus/$reader" log="$build/$reader.log"
  mkdir -p "$corpus" "$build/findings"
  "$build/tests/fuzz/fuzz_$reader" "$corpus" "tests/fuzz/seeds/$reader" -max_total_time="$each" -timeout=10 \
    -rss_limit_mb=2048 -max_len=262144 -print_final_stats=1 -artifact_prefix="$build/findings/$reader-" \
    >"$log" 2>&1 || true
  inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  branches=$(grep -o 'cov: [0-9]*' "$log" | tail -1 | cut -d' ' -f2)
  echo "| $reader | $each | ${inputs:-?} | ${branches:-?} | $(ls "$build/findings" | grep -c "^$reader-" || true) |"
done
