#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Opens the static studio in headless Chromium. Usage: page.sh SOURCE OUT_DIR      Ends with 77 where something is missing.
set -euo pipefail
source=$1
out=$2
for needed in "$source/build/studio-web/index.html" "$source/build/studio-web/talus.wasm" "$source/web/node_modules/playwright-core" "${TALUS_CHROMIUM:-/usr/bin/chromium}"; do
  if [ ! -e "$needed" ]; then
    echo "SKIP: there is no $needed (make studio-web): the static studio was NOT opened in a browser"
    exit 77
  fi
done
exec node "$source/web/browser/studio/static.mjs" "$source/build/studio-web" "$source/tests/wasm/acads_1a.toml" 0.985 "$out"
