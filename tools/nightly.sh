#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the checks that take too long for every change: all tests, also with sanitizers and with clang, every source through the linter, and
# the campaigns that try to break the program. The last lines list minutes and result of each part; ends with 1 if one of them failed.
# Usage: tools/nightly.sh [part …]; parts: tests asan asan_cases tsan clang lint arm fuzz invariance kinds cases meshes results kills disks calls
#        names files damage signals inputs readers
set -uo pipefail
cd "$(dirname "$0")/.."
parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(tests asan asan_cases tsan clang lint arm fuzz invariance kinds cases meshes results kills disks calls names files damage signals inputs readers)
program=build/release/bin/talus
told=()
failed=0

do_part() {
  case "$1" in
    tests) make test-all ;;
    asan) make test-all PRESET=debug ;;
    asan_cases) make program PRESET=debug && tools/sanitized_cases.py build/debug/bin/talus ;;
    tsan) make test PRESET=tsan ;;
    clang) make test-all PRESET=release-clang ;;
    lint) make lint ;;
    arm) tools/check_aarch64.py ;;
    fuzz) tools/fuzz.sh 10 ;;
    invariance) tools/verify_invariance.py $program --write ;;
    kinds) tools/verify_kinds.py $program --write ;;
    cases) tools/break_it.py $program cases --count 1000 --write ;;
    meshes) tools/break_it.py $program meshes --count 500 --write ;;
    results) tools/break_it.py $program results --count 1000 --write ;;
    kills | disks) tools/break_it.py $program "$1" --count 100 --write ;;
    names | files | damage | inputs) tools/break_it.py $program "$1" --count 300 --write ;;
    signals | readers) tools/break_it.py $program "$1" --count 60 --write ;;
    calls) tools/break_it.py $program calls --count 200 --write ;;
    *) echo "nightly: there is no part '$1'"; return 2 ;;
  esac
}

for part in "${parts[@]}"; do
  [ -x $program ] || make program || exit 1
  SECONDS=0
  if do_part "$part"; then end=passed; else end=FAILED; failed=1; fi
  told+=("$(printf '%-8s %-6s %3d min' "$part" "$end" $((SECONDS / 60)))")
done
printf '%s\n' "${told[@]}"
exit $failed
