#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The rules a machine can check: floors and file lengths, names in documents, formatting, spelling, terms, and clang-tidy with .clang-tidy.
# Usage: tools/lint.sh [--changed | files …]; without files: every .cpp of src; --changed: those that the last ten commits changed.
set -uo pipefail
cd "$(dirname "$0")/.."
build=build/lint
status=0
# Each source by itself, with clang's flags and without compiled headers: clang-tidy reads no others.
ranks=OFF
if pkg-config --exists PETSc 2>/dev/null; then ranks=ON; else echo "SKIP: PETSc is not here (tools/apt-packages-mpi.txt): src/ranks was NOT linted"; fi
cmake --preset release-clang -B $build -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DTALUS_UNITY=OFF -DTALUS_MPI=$ranks >/dev/null || exit 1

tools/check_floors.py || status=1
tools/check_claims.py || status=1
tools/format.sh --check || { echo "lint: make format mends the formatting."; status=1; }

# tests/input has misspelled words on purpose.
if command -v codespell >/dev/null; then
  git ls-files -z -- . ':!tests/input' ':!*.csv' ':!*-lock.json' ':!*.svg' | xargs -0 codespell --ignore-words tools/lint/words.txt ||
    { echo "lint: misspelled words; those that are right go into tools/lint/words.txt."; status=1; }
else
  echo "SKIP: codespell is missing (tools/apt-packages-dev.txt): spelling was NOT checked"
fi
# Terms in the pages that the last ten commits changed; older pages are rewritten one by one.
base=$(git rev-list --max-count=11 HEAD | tail -1)
mapfile -t pages < <(git diff --name-only --diff-filter=d "$base" -- 'docs/*.md' 'examples/*.md')
if [ ${#pages[@]} -eq 0 ]; then
  :
elif [ -x tools/lint/node_modules/.bin/textlint ]; then
  tools/lint/node_modules/.bin/textlint --config tools/lint/textlintrc.cjs --format unix "${pages[@]}" || status=1
else
  echo "SKIP: tools/lint/node_modules is missing (npm ci in tools/lint): terms in the pages were NOT checked"
fi

files=("$@")
if [ "${1-}" = --changed ]; then
  # A header is read with one source that includes it.
  mapfile -t files < <({
    git diff --name-only --diff-filter=d "$base" -- 'src/*.cpp'
    git diff --name-only --diff-filter=d "$base" -- 'src/*.hpp' | while read -r header; do
      git grep -lF "#include \"${header#src/}\"" -- 'src/*.cpp' | head -1
    done
  } | sort -u)
  [ ${#files[@]} -gt 0 ] || { echo "lint: the last ten commits changed no source."; exit $status; }
fi
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(find src -name '*.cpp' | sort)
# Its table is generated where WebAssembly is built.
mapfile -t files < <(printf '%s\n' "${files[@]}" | grep -v '^src/base/unit_table\.cpp$')
if [ $ranks = OFF ]; then mapfile -t files < <(printf '%s\n' "${files[@]}" | grep -v '^src/ranks/'); fi
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p $build 2>/dev/null || status=1

[ $status -eq 0 ] && echo "lint: nothing found."
exit $status
