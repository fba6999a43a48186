#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The code of web/ after the rules of its linter (web/.oxlintrc.jsonc). Then the reports of the dry slope on a coarse mesh, of a small wet
# bank, of a slope by three methods, and of two studies, as the program writes them: checked against their contract and
# their results by the tests of web/, then opened and used in a headless Chromium. The second argument is a folder for
# results and screenshots.
set -euo pipefail
talus=$1
folder=$2
root=$(cd "$(dirname "$0")/../.." && pwd)
skip() {
  echo "SKIP: $1" >&2
  exit 77
}
command -v node >/dev/null || skip "there is no Node, so the page of the reports is not tested"
[ -d "$root/web/node_modules" ] || skip "web/node_modules is not there (the build installs it), so the page is not tested"
(cd "$root/web" && npx --no-install oxlint)

rm -rf "$folder/results" "$folder/wet" "$folder/methods" "$folder/study" "$folder/sampling"
"$talus" run "$root/examples/dry_slope/case.toml" -o "$folder/results" --quiet --set mesh.size=1
size=$(stat -c %s "$folder/results/report.html")
echo "report.html: $size bytes"
[ "$size" -lt 10000000 ] || { echo "the dry slope's report must stay under 10 MB" >&2; exit 1; }
"$talus" run "$root/tests/page/wet_bank.toml" -o "$folder/wet" --quiet
"$talus" run "$root/tests/page/three_methods.toml" -o "$folder/methods" --quiet
"$talus" study "$root/tests/page/banks.toml" -o "$folder/study" --quiet
"$talus" study "$root/tests/page/uncertain.toml" -o "$folder/sampling" --quiet

cd "$root/web"
TALUS_REPORT=$folder/results/report.html TALUS_RESULTS=$folder/results npx --no-install vitest run
TALUS_REPORT=$folder/wet/report.html TALUS_RESULTS=$folder/wet npx --no-install vitest run tests/report.test.ts \
  tests/results.test.ts
TALUS_REPORT=$folder/methods/report.html TALUS_RESULTS=$folder/methods npx --no-install vitest run tests/report.test.ts \
  tests/results.test.ts tests/methods.test.ts
for name in study sampling; do
  TALUS_REPORT=$folder/$name/report.html npx --no-install vitest run tests/report.test.ts
done
[ -x "${TALUS_CHROMIUM:-/usr/bin/chromium}" ] || skip "there is no Chromium, so the report is not opened"
node browser/check.mjs "$folder/results/report.html" "$folder/results" "$folder/screenshots"
node browser/check.mjs "$folder/wet/report.html" "$folder/wet" "$folder/wet_screenshots"
for name in methods study sampling; do
  node browser/check.mjs "$folder/$name/report.html" "$folder/$name" "$folder/${name}_screenshots"
done
