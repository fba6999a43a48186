#!/usr/bin/env bash
# Says what lies in a result folder.
set -euo pipefail
folder=$1
echo
echo "Results in $folder:"
find "$folder" -type f -printf '  %P  %s bytes\n' | sort
