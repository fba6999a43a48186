#!/usr/bin/env bash
# The speed table: 2D and 3D, small and large, one thread and all of them. The machine's name goes above it, because
# only ratios measured on one machine in one session mean anything (docs/performance.md).
set -euo pipefail
cd "$(dirname "$0")/.."
program=${1:-build/release}/bench/step_speed
[ -x "$program" ] || { echo "bench: there is no $program; was TALUS_BUILD_BENCH off?" >&2; exit 1; }
export OMP_WAIT_POLICY=passive
sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | sort | uniq -c
echo "load before: $(cut -d' ' -f1-3 /proc/loadavg); commit $(git describe --always --dirty 2>/dev/null || echo unknown)"
for dimension in 2 3; do
  for size in small large; do
    for threads in 1 "$(nproc)"; do
      "$program" "$dimension" "$size" "$threads"
    done
  done
done
