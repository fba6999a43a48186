#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the tests of a preset (default: release) and names the ten slowest, and the skipped ones with their reasons: a skipped
# test proves nothing, so it must be seen. With the preset tsan it runs the tests with several threads. Tests of tests/long_tests.txt
# run with --all, or where NAMES chooses them.
# Usage: tools/test.sh [--all] [PRESET [NAMES]], NAMES a regular expression of ctest
set -uo pipefail
cd "$(dirname "$0")/.."
all=
if [ "${1-}" = --all ]; then all=yes; shift; fi
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
# Else each start of the program starts it again with this variable, and threads spin that wait for a core of another test.
export OMP_WAIT_POLICY="${OMP_WAIT_POLICY:-passive}"
long=
if [ -z "$all" ] && [ -z "$names" ]; then
  # The first word of each line is a name, in which ctest's expressions read a dot as any letter.
  long=$(sed -e 's/#.*//' tests/long_tests.txt | awk 'NF { gsub(/\./, "\\.", $1); printf "%s%s", (n++ ? "|" : ""), $1 }')
fi
ctest --test-dir "build/$preset" --output-on-failure -j "$(nproc)" ${names:+-R "$names"} ${long:+-E "^($long)\$"}
status=$?

# GoogleTest prints "file:line: Skipped" and the reason on the next line, pytest "SKIPPED [1] file:line: reason"; ctest keeps it in its log.
log=build/$preset/Testing/Temporary/LastTest.log
awk '
  /^[0-9]+\/[0-9]+ Test: / { name = $0; sub(/^[0-9]+\/[0-9]+ Test: /, "", name) }
  /^\[ RUN      \] / { name = substr(name, 1, index(name, ".")) $4 }
  reason_follows { print "SKIP " name ": " $0; reason_follows = 0; next }
  /^SKIP: / { print "SKIP " name ": " substr($0, 7) }
  /: Skipped$/ { reason_follows = 1 }
  /^SKIPPED \[[0-9]+\] / { reason = $0; sub(/^SKIPPED [^ ]+ [^ ]+ /, "", reason); print "SKIP " name ": " reason }
' "$log" 2>/dev/null

# "12/1041 Test  #7: unit.Name ....   Passed    0.05 sec" stands in the log of the run as "Test time =   0.05 sec". A suite of GoogleTest has
# the times of its tests: "[       OK ] Suite.Name (50 ms)".
times=build/$preset/Testing/seconds.txt
awk '
  function write(seconds, name) { printf "%8.1f s  %s\n", seconds, name }
  /^[0-9]+\/[0-9]+ Test: / { name = $0; sub(/^[0-9]+\/[0-9]+ Test: /, "", name); parts = 0; sum = 0 }
  /^\[ +(OK|FAILED|SKIPPED) +\] .* \([0-9]+ ms\)$/ {
    seconds = substr($(NF - 1), 2) / 1000; sub(/,$/, "", $4); ++parts; sum += seconds
    write(seconds, substr(name, 1, index(name, ".")) $4)
  }
  /^Test time = / { write($4 - sum, parts ? name " without its tests" : name) }
' "$log" 2>/dev/null | sort -rn >"$times"
echo "The ten slowest tests ($times has all):"
head -10 "$times"
[ -z "$long" ] || echo "The $(tr -dc '|' <<<"$long|" | wc -c) tests of tests/long_tests.txt were NOT run: make test-all runs them."
exit $status
