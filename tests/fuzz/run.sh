#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The test of a target: the finds that were kept, then its seeds and a fixed number of changed ones. Usage: run.sh TARGET RUNS FUZZ_PROGRAM PROGRAM
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
finds=$(dirname "$0")/finds/$1
[ ! -d "$finds" ] || "$3" -runs=0 "-artifact_prefix=fuzz_$1_" "$finds"
"$(dirname "$0")/seeds.sh" "$1" "$4" "$scratch"
"$3" "-runs=$2" "-artifact_prefix=fuzz_$1_" "$scratch"
