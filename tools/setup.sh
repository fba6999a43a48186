#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the Debian packages of the given lists (default: tools/apt-packages.txt) that are missing.
# When nothing is missing it only queries dpkg: no network, no rights, well under a second.
set -euo pipefail
cd "$(dirname "$0")/.."
lists=("$@")
[ ${#lists[@]} -gt 0 ] || lists=(tools/apt-packages.txt)

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is no Debian system; install by its own means what ${lists[*]} names, then call make with SETUP=true." >&2
  exit 1
fi

mapfile -t wanted < <(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "${lists[@]}")
# dpkg-query prints one line per known package and complains on stderr about the unknown ones.
installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null | sed -n 's/^installed //p' || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

echo "setup: installing ${missing[*]}"
if [ "$(id -u)" -eq 0 ]; then
  as_root=()
elif command -v sudo >/dev/null; then
  as_root=(sudo)
else
  echo "setup: these packages are missing and neither root nor sudo is at hand; ask an administrator for:" >&2
  echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
  exit 1
fi
install_packages() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
}
# The package lists of a fresh machine are empty or old: fetch them first. Without network the packages may be cached.
"${as_root[@]}" apt-get update -q || echo "setup: the package lists could not be fetched; trying with the old ones." >&2
if ! install_packages; then
  echo "setup: apt-get could not install ${missing[*]}; see its message above." >&2
  exit 1
fi
