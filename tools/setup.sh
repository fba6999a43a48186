#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the Debian packages of the given lists that are missing. Without lists: those of tools/apt-packages.txt, which Talus needs,
# and then those of tools/apt-packages-drawings.txt, without which the build goes on and says so.
# When nothing is missing it only queries dpkg: no network, no rights, well under a second.
set -euo pipefail
cd "$(dirname "$0")/.."
needed=tools/apt-packages.txt
optional=tools/apt-packages-drawings.txt
lists=("$@")
[ ${#lists[@]} -gt 0 ] || lists=($needed)

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is no Debian system; install by its own means what ${lists[*]} names, then call make with SETUP=true." >&2
  exit 1
fi

# Fills `missing` with the packages of lists that are not installed.
find_missing() {
  local wanted installed package
  mapfile -t wanted < <(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$@")
  # dpkg-query prints one line per known package and complains on stderr about the unknown ones.
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null | sed -n 's/^installed //p' || true)
  missing=()
  for package in "${wanted[@]}"; do
    grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
  done
}

updated=
install_missing() {
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "setup: installing ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "setup: these packages are missing and neither root nor sudo is at hand; ask an administrator for:" >&2
      echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  # The package lists of a fresh machine are empty or old: fetch them first. Without network the packages may be cached.
  [ -n "$updated" ] || "${as_root[@]}" apt-get update -q || echo "setup: the package lists could not be fetched; trying with the old ones." >&2
  updated=yes
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"; then
    echo "setup: apt-get could not install ${missing[*]}; see its message above." >&2
    return 1
  fi
}

find_missing "${lists[@]}"
install_missing || exit 1
[ $# -eq 0 ] || exit 0

# Every make calls this script: what could not be had is not tried again within a day.
find_missing $optional
[ ${#missing[@]} -gt 0 ] || exit 0
failed_at=build/no_drawings
if [ -z "$(find $failed_at -mtime -1 2>/dev/null)" ]; then
  if install_missing; then exit 0; fi
  mkdir -p build
  touch $failed_at
fi
echo "SKIP: ${missing[*]} are not installed and could not be had, so Talus will read and write no drawings and no workbooks; tools/setup.sh $optional tries again"
