#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the manual as a static site: docs.sh [PROGRAM] [FOLDER]. The pages are docs/, the reference is what the program says
# about itself. The first time npm fetches what docs/site/package-lock.json names; after that no network is needed.
# docs.sh --packages only fetches.
set -euo pipefail
cd "$(dirname "$0")/.."
only_packages=
if [ "${1-}" = --packages ]; then only_packages=yes; shift; fi
TALUS=${1:-build/release/bin/talus}
TALUS_SITE=${2:-build/site}
export TALUS TALUS_SITE
command -v npm >/dev/null || { echo "docs: npm is missing; install Node.js 20 or later with npm." >&2; exit 1; }
modules=docs/site/node_modules
if [ ! -e $modules/.package-lock.json ] || [ docs/site/package-lock.json -nt $modules/.package-lock.json ]; then
  (cd docs/site && npm ci --no-audit --no-fund --loglevel=error)
  touch $modules/.package-lock.json
fi
[ -z "$only_packages" ] || exit 0
rm -rf "$TALUS_SITE"
mkdir -p "$TALUS_SITE"
$modules/.bin/eleventy --config=docs/site/eleventy.config.js
# Editors read it, so it needs no spaces.
"$TALUS" schema | python3 -c 'import json, sys; json.dump(json.load(sys.stdin), sys.stdout, ensure_ascii=False, separators=(",", ":"))' \
  >"$TALUS_SITE/case.schema.json"
"$TALUS" template >"$TALUS_SITE/template.toml"
echo "docs: the manual is in $TALUS_SITE/index.html"
