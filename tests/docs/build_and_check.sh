#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the manual into a folder of its own and tests it, in a browser too: build_and_check.sh PROGRAM FOLDER.
# Skipped (77) where npm is missing, or where `make docs` has not yet fetched what it needs: a test asks no network.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "$1")
site=$2
if ! command -v npm >/dev/null || [ ! -e "$here/../../docs/site/node_modules" ]; then
  echo "SKIP: docs/site/node_modules is missing; make docs fetches it"
  exit 77
fi
log=$("$here/../../tools/docs.sh" "$program" "$site" 2>&1) || { echo "$log"; exit 1; }
if grep -iE 'warn|deprecat|problem' <<<"$log"; then
  echo "the build of the manual warns"
  exit 1
fi
"$here/check_site.py" "$program" "$site"
# Without a browser all other parts are tested; the last line lists the skipped ones.
node "$here/browse_site.mjs" "$site" "${@:3}" || { code=$?; [ $code = 77 ] || exit $code; }
