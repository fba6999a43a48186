#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests of the page of the reports. run.sh TALUS FOLDER source: the code of web/ by its linter (web/.oxlintrc.jsonc) and its own tests.
# run.sh TALUS FOLDER NAME [--short]: the report of the dry slope on a coarse mesh, or of the case or study NAME.toml beside this script, as the
# program writes it: checked against its contract and its results by the tests of web/, then opened and used in a headless Chromium.
# run.sh TALUS FOLDER studio [--short]: the page of `talus studio` beside the program, used in a headless Chromium.
# FOLDER receives the results and the screenshots, below NAME. What --short leaves out stands in the scripts of web/browser.
set -euo pipefail
talus=$1
name=$3
short=${4:-}
folder=$2/$name$short
root=$(cd "$(dirname "$0")/../.." && pwd)
skip() {
  echo "SKIP: $1" >&2
  exit 77
}
command -v node >/dev/null || skip "there is no Node, so the page of the reports is not tested"
[ -d "$root/web/node_modules" ] || skip "web/node_modules is not there (the build installs it), so the page is not tested"
cd "$root/web"
if [ "$name" = source ]; then
  npx --no-install oxlint
  # One process for all files: a process for each is half of the time.
  exec npx --no-install vitest run --no-isolate --exclude 'tests/{report,results,methods}.test.ts'
fi
if [ "$name" = studio ]; then
  [ -e "$(dirname "$talus")/libtalus_http.so" ] || skip "this build has no cpp-httplib ('make program' adds it), so the studio is not tested"
  [ -e "$(dirname "$talus")/studio/index.html" ] || skip "the page of the studio is not built (target talus_studio_page), so it is not tested"
  [ -x "${TALUS_CHROMIUM:-/usr/bin/chromium}" ] || skip "there is no Chromium, so the studio is not opened"
  exec node browser/studio/check.mjs "$talus" "$root/examples/layered_embankment/case.toml" "$folder/screenshots" $short
fi

case=$root/tests/page/$name.toml
more=()
if [ "$name" = dry_slope ]; then
  case=$root/examples/dry_slope/case.toml
  more=(--set mesh.size=1)
fi
command=run
grep -q '^\[study\]' "$case" && command=study
rm -rf "$folder"
"$talus" $command "$case" -o "$folder/results" --quiet --threads 1 "${more[@]}"
report=$folder/results/report.html
size=$(stat -c %s "$report")
echo "report.html: $size bytes"
[ "$size" -lt 10000000 ] || { echo "the report of $name must stay under 10 MB" >&2; exit 1; }

# A study has no summary.json to compare with.
tests=(tests/report.test.ts)
if [ $command = run ]; then
  export TALUS_RESULTS=$folder/results
  tests+=(tests/results.test.ts tests/methods.test.ts)
fi
TALUS_REPORT=$report npx --no-install vitest run --no-isolate "${tests[@]}"
[ -x "${TALUS_CHROMIUM:-/usr/bin/chromium}" ] || skip "there is no Chromium, so the report is not opened"
node browser/check.mjs "$report" "$folder/results" "$folder/screenshots" $short
