#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs every test of a preset (default: release) and names the ten slowest, and the skipped ones with their reasons: a skipped
# test proves nothing, so it must be seen. With the preset tsan it runs the tests with several threads.
# Usage: tools/test.sh [PRESET [NAMES]], NAMES a regular expression of ctest
set -uo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
names=${2:-}
# The debug preset looks for errors, not leaks: Gmsh keeps some memory until its process ends.
export ASAN_OPTIONS="detect_leaks=0${ASAN_OPTIONS:+:$ASAN_OPTIONS}"
if [ "$preset" = debug ]; then
  # The address sanitizer's memory has a lock that a child of fork() may inherit locked by another thread: it waits for ever. Studies have one
  # thread here; the preset tsan watches threads.
  export OMP_NUM_THREADS=1
fi
if [ "$preset" = tsan ]; then
  names=${names:-Thread|AnyNumber|cases\.Sampling|StudyOfRuns|RootedBank|WetBank|FrozenFactorAgrees}
  # archer reports OpenMP's barriers to the sanitizer; libraries that are not built with it cannot be checked.
  OMP_TOOL_LIBRARIES=$(find /usr/lib/llvm-*/lib -name libarcher.so 2>/dev/null | sort | tail -1)
  export OMP_TOOL_LIBRARIES
  export TSAN_OPTIONS="ignore_noninstrumented_modules=1${TSAN_OPTIONS:+:$TSAN_OPTIONS}"
  [ -n "$OMP_TOOL_LIBRARIES" ] || echo "SKIP: there is no libarcher.so: what the sanitizer says of OpenMP is not to be believed"
fi
ctest --test-dir "build/$preset" --output-on-failure -j "$(nproc)" ${names:+-R "$names"}
status=$?

# GoogleTest prints "file:line: Skipped" and the reason on the next line, pytest "SKIPPED [1] file:line: reason"; ctest keeps it in its log.
awk '
  /^[0-9]+\/[0-9]+ Test: / { name = $0; sub(/^[0-9]+\/[0-9]+ Test: /, "", name) }
  reason_follows { print "SKIP " name ": " $0; reason_follows = 0; next }
  /^SKIP: / { print "SKIP " name ": " substr($0, 7) }
  /: Skipped$/ { reason_follows = 1 }
  /^SKIPPED \[[0-9]+\] / { reason = $0; sub(/^SKIPPED [^ ]+ [^ ]+ /, "", reason); print "SKIP " name ": " reason }
' "build/$preset/Testing/Temporary/LastTest.log" 2>/dev/null

# "12/1041 Test  #7: unit.Name ....   Passed    0.05 sec" stands in the log of the run as "Test time =   0.05 sec".
echo "The ten slowest tests:"
awk '
  /^[0-9]+\/[0-9]+ Test: / { name = $0; sub(/^[0-9]+\/[0-9]+ Test: /, "", name) }
  /^Test time = / { printf "%8.1f s  %s\n", $4, name }
' "build/$preset/Testing/Temporary/LastTest.log" 2>/dev/null | sort -rn | head -10
exit $status
