#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Collects the seeds of a target in a folder: examples, and what the program writes.
# Usage: tests/fuzz/seeds.sh TARGET PROGRAM FOLDER
set -euo pipefail
target=$1 program=$2 folder=$3
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$folder"

# A small run, for what results look like.
run() {
  "$program" run "$root/examples/sliding_block/case.toml" -q -o "$folder/run" --set mesh.size=1 >/dev/null
}

case $target in
  case_file)
    for file in "$root"/examples/*/*.toml "$root"/tests/page/*.toml; do cp "$file" "$folder/$(echo "${file#"$root"/}" | tr / _)"; done
    "$program" template >"$folder/template.toml" ;;
  mesh_file)
    cp "$root"/tests/fuzz/seeds/*.msh "$folder" ;;
  table)
    cp "$root"/examples/calibrate_loess/measured/*.csv "$folder"
    run
    find "$folder/run" -name '*.csv' -exec cp {} "$folder" \;
    rm -r "$folder/run" ;;
  summary)
    run
    cp "$folder/run/summary.json" "$folder"
    rm -r "$folder/run" ;;
  jobs)
    "$program" study "$root/tests/page/uncertain.toml" --prepare "$folder/study" --jobs 3 -q --set lem.referee=false >/dev/null
    "$program" study "$folder/study" --job 1 -q --threads 1 >/dev/null
    cp "$folder/study/jobs.json" "$folder"
    cp "$folder"/study/jobs/*/result.json "$folder"
    rm -r "$folder/study" ;;
  results)
    run
    cp "$folder/run/results.vtkhdf" "$folder"
    rm -r "$folder/run" ;;
  checkpoint)
    run
    cp "$folder/run/"*.h5 "$folder"
    rm -r "$folder/run" ;;
  umat)
    head -c 240 /dev/zero >"$folder/zeros"
    printf '\0\0\0\0\0\0\xf8\x7f' >"$folder/no_number" ;;
esac
