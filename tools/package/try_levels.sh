#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks that an installed package chooses the right level on emulated processors, and that the lowest level is bitwise identical
# on an emulated old processor and on this one. Usage: tools/package/try_levels.sh PREFIX/lib/talus
# Needs qemu-x86_64 (Debian: qemu-user); ends with 77, loudly, without it.
set -euo pipefail
levels=$1
cd "$(dirname "$0")/../.."
command -v qemu-x86_64 >/dev/null || { echo "SKIP: there is no qemu-x86_64: older processors were NOT tried"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset TALUS_LEVEL GLIBC_TUNABLES
for pair in Nehalem=x86-64-v2 Haswell=x86-64-v3; do
  found=$(qemu-x86_64 -cpu "${pair%=*}" "$levels/talus" --level 2>/dev/null)
  [ "$found" = "${pair#*=}" ] || { echo "${pair%=*}: $found"; exit 1; }
  echo "${pair%=*} takes $found"
done
said=$(qemu-x86_64 -cpu Conroe "$levels/talus" --level 2>&1) && { echo "a processor without SSE 4.2 is taken"; exit 1; }
grep -q "no SSE 4.2" <<<"$said" || { echo "Conroe: $said"; exit 1; }
# The program of the level by itself: the launcher would start it outside the emulator.
case=(run examples/sliding_block/case.toml --set mesh.size=1 -q -o)
TALUS_WAIT_POLICY_SET=1 qemu-x86_64 -cpu Nehalem "$levels/x86-64-v2/talus" "${case[@]}" "$scratch/old" 2>/dev/null
TALUS_LEVEL=x86-64-v2 "$levels/talus" "${case[@]}" "$scratch/here"
cmp "$scratch/old/history.csv" "$scratch/here/history.csv"
cmp "$scratch/old/results.vtkhdf" "$scratch/here/results.vtkhdf"
echo "x86-64-v2 is bitwise identical on an emulated Nehalem and here"
