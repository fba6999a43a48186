#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Formats every C++ file in place; with --check lists the files that are not formatted and ends with 1.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=(-i)
[ "${1:-}" != --check ] || mode=(--dry-run --Werror)
find src tests bench -name '*.[ch]pp' -print0 | xargs -0 --no-run-if-empty clang-format "${mode[@]}"
