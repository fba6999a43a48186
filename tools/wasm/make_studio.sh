#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Collects the studio as a static folder: the page, its worker, and the engine in WebAssembly. Any web server delivers it.
# Usage: tools/wasm/make_studio.sh ENGINE OUTPUT      ENGINE has talus.js and talus.wasm.
set -euo pipefail
engine=$(realpath "${1:?"Usage: tools/wasm/make_studio.sh ENGINE OUTPUT"}")
output=$(realpath -m "${2:?"Usage: tools/wasm/make_studio.sh ENGINE OUTPUT"}")
cd "$(dirname "$0")/../.."
rm -rf "$output"
mkdir -p "$output"
if [ -f web/studio/index.html ]; then
  [ -d web/node_modules ] || npm --prefix web ci --no-audit --no-fund
  TALUS_STUDIO_DIR="$output" npm --prefix web run --silent studio
else
  echo "make_studio: there is no page in web/studio: the folder has the engine only" >&2
fi
install -m 644 "$engine/talus.js" "$engine/talus.wasm" "$output/"
compressed=$(tar -cf - -C "$output" . | gzip -9 | wc -c)
echo "The studio is in $output: $(du -sh "$output" | cut -f1), $((compressed / 1000)) kB compressed. Try it: python3 -m http.server -d $output"
