#!/usr/bin/env bash
# Writes the generated pages of the manual: everything about input keys is declared once, in src/model/declare_*.hpp,
# and the program prints it.
set -euo pipefail
cd "$(dirname "$0")/.."
talus=${1:-build/release/bin/talus}
"$talus" manual >docs/manual/input-keys.md
"$talus" schema >docs/manual/case.schema.json
"$talus" template >docs/manual/template.toml
echo "docs: wrote docs/manual/input-keys.md, case.schema.json and template.toml"
