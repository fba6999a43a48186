#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The rules a machine can check: floors and file lengths, names in documents, formatting, and clang-tidy with .clang-tidy.
# Usage: tools/lint.sh [files …]; without files: every .cpp of src.
set -uo pipefail
cd "$(dirname "$0")/.."
build=build/lint
status=0
# Each source by itself, without headers that GCC has compiled: clang-tidy reads neither.
cmake --preset release -B $build -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DTALUS_UNITY=OFF >/dev/null || exit 1

tools/check_floors.py || status=1
tools/check_functions.py || status=1
tools/check_claims.py || status=1
tools/format.sh --check || { echo "lint: make format mends the formatting."; status=1; }

files=("$@")
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(find src -name '*.cpp' | sort)
# The flags are GCC's: clang does not know all of its warnings, which is no finding.
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p $build --extra-arg=-Wno-unknown-warning-option 2>/dev/null || status=1

[ $status -eq 0 ] && echo "lint: nothing found."
exit $status
