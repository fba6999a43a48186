#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The speed tables of docs/performance.md. Only ratios measured in one run mean anything; the machine stands above them.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
[ -x "$build/bin/step_speed" ] || { echo "bench: there is no $build/bin/step_speed; was TALUS_BUILD_BENCH off?" >&2; exit 1; }
/usr/bin/python3 bench/compare.py "$build"
echo
echo "The dry slope's whole curve on one thread (stages and 16 trials):"
/usr/bin/time -f "%U s of one core, %M KiB" "$build/bin/talus" run examples/dry_slope/case.toml -o "$build/bench_dry_slope" --overwrite --threads 1 -q \
  --set strength_reduction.frozen.enabled=false --set strength_reduction.curve.runout=[] --set strength_reduction.curve.refine=false
