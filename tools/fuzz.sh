#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# libFuzzer on every target of tests/fuzz, with sanitizers. Usage: tools/fuzz.sh [MINUTES [TARGET …]] (default: ten minutes of each)
# The corpus of a target is kept in build/debug/fuzz/TARGET. A find is stored beside it; once fixed, it belongs in tests/fuzz/finds/TARGET,
# whose files every test run reads.
set -euo pipefail
cd "$(dirname "$0")/.."
minutes=${1:-10}
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(case_file mesh_file table summary results checkpoint umat)
cmake --preset debug >/dev/null
cmake --build --preset debug --target talus_cli "${targets[@]/#/fuzz_}"
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1
failed=0
for target in "${targets[@]}"; do
  folder=build/debug/fuzz/$target
  tests/fuzz/seeds.sh "$target" build/debug/bin/talus "$folder"
  end=nothing
  # A look into a file may take twenty seconds of the processor before it is ended, and a busy machine has none to spare.
  build/debug/bin/fuzz_"$target" -max_total_time=$((minutes * 60)) -timeout=300 -rss_limit_mb=8192 -print_final_stats=1 \
    -artifact_prefix="$folder-" "$folder" >"$folder.log" 2>&1 || { end="a find: $folder-*, $folder.log"; failed=1; }
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder.log")
  echo "fuzz: $target: ${runs:-?} inputs in $minutes min: $end"
done
exit $failed
