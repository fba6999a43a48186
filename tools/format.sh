#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Formats every C++ file in place and brings docs/where-is.md up to date; with --check only says what is not so.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=(-i)
[ "${1:-}" != --check ] || mode=(--dry-run --Werror)
find src tests bench -name '*.[ch]pp' -print0 | xargs -0 --no-run-if-empty clang-format "${mode[@]}"
tools/where_is.py "$@"
