#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The program that chooses a level of the instruction set, with scripts in the place of the levels' programs.
# Usage: tests/install/levels.sh LAUNCHER
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp "$1" "$scratch/talus"
for level in x86-64-v2 x86-64-v3 x86-64-v4; do
  mkdir "$scratch/$level"
  printf '#!/bin/sh\necho %s "$@" "$OMP_WAIT_POLICY" "${GLIBC_TUNABLES-}"\n' $level >"$scratch/$level/talus"
  chmod +x "$scratch/$level/talus"
done
fail() { echo "$1"; exit 1; }
unset TALUS_LEVEL GLIBC_TUNABLES OMP_WAIT_POLICY TALUS_WAIT_POLICY_SET

best=$("$scratch/talus" --level)
[ "$("$scratch/talus" run a.toml)" = "$best run a.toml passive " ] || fail "it does not start the program of $best"
ln -s "$scratch/talus" "$scratch/link"
[ "$("$scratch/link" check)" = "$best check passive " ] || fail "it does not find the levels behind a link"
said=$(TALUS_LEVEL=x86-64-v2 GLIBC_TUNABLES=glibc.rtld.nns=5 "$scratch/talus" run)
[ "$said" = "x86-64-v2 run passive glibc.rtld.nns=5:glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4" ] || fail "the lowest level: $said"
[ "$(TALUS_LEVEL=x86-64-v2 "$scratch/talus" --level)" = x86-64-v2 ] || fail "--level does not tell what TALUS_LEVEL asks for"

code=0
said=$(TALUS_LEVEL=fast "$scratch/talus" run 2>&1) || code=$?
[ $code -eq 2 ] || fail "an unknown level has code $code"
grep -q "TALUS_LEVEL is 'fast'; the levels are" <<<"$said" || fail "an unknown level: $said"
rm "$scratch/$best/talus"
code=0
said=$("$scratch/talus" run 2>&1) || code=$?
[ $code -eq 1 ] || fail "a missing program has code $code"
grep -q "$best/talus cannot be started: No such file" <<<"$said" || fail "a missing program: $said"
echo "the level here is $best"
