#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A machine without /proc: `check`, `run`, `--resume` and `report` end as they do with it, and the results are bitwise
# identical. Needs the right to mount; ends with 77, which is skipped, without it.
set -euo pipefail
talus=$1 case=$2
if ! unshare --mount true 2>/dev/null; then
  echo "SKIP: nothing can be mounted here: a machine without /proc was NOT tried"
  exit 77
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/calls" <<'END'
set -euo pipefail
talus=$1 case=$2 folder=$3
"$talus" check "$case" >/dev/null
"$talus" run "$case" -o "$folder" -q --no-report --threads 1
"$talus" run "$case" -o "$folder" -q --no-report --threads 1 --resume
"$talus" report "$folder"
END
bash "$scratch/calls" "$talus" "$case" "$scratch/with"
unshare --mount --propagation private bash -c 'mount -t tmpfs none /proc && [ ! -e /proc/self ] && exec bash "$@"' - \
  "$scratch/calls" "$talus" "$case" "$scratch/without"
for file in results.vtkhdf history.csv; do cmp "$scratch/with/$file" "$scratch/without/$file"; done
test -s "$scratch/without/report.html"
