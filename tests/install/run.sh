#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the build into an empty folder, builds a foreign project against it, and runs that: find_package works.
set -euo pipefail
build=$1
source=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --prefix "$scratch/prefix" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
cmake -S "$source" -B "$scratch/user" -G Ninja -DCMAKE_PREFIX_PATH="$scratch/prefix" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
cmake --build "$scratch/user" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
title=$("$scratch/user/user" "$source/../../examples/dry_slope/case.toml")
[ "$title" = "Dry homogeneous slope" ] || { echo "unexpected title: $title"; exit 1; }
"$scratch/prefix/bin/talus" version
