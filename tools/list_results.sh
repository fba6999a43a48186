#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Says what lies in a result folder: its files, and how much is in the folders of trials.
set -euo pipefail
folder=$1
echo
echo "Results in $folder:"
find "$folder" -maxdepth 1 -type f -printf '  %f  %s bytes\n' | sort
for inner in "$folder"/*/; do
  [ -d "$inner" ] || continue
  echo "  $(basename "$inner")/  $(find "$inner" -type f | wc -l) files"
done
[ ! -f "$folder/report.html" ] || echo "Open $folder/report.html in a browser."
