#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fetches the source of NLopt, which Debian does not build for WebAssembly, from the Debian mirror that apt uses, and unpacks it.
# Usage: tools/wasm/fetch_nlopt.sh FOLDER      NLOPT_SOURCE=FILE takes an archive that is here already.
set -euo pipefail
archive=nlopt_2.7.1.orig.tar.gz
checksum=db88232fa5cef0ff6e39943fc63ab6074208831dc0031cf1545f6ecd31ae2a1a
folder=${1:?"Usage: tools/wasm/fetch_nlopt.sh FOLDER"}
[ ! -f "$folder/nlopt-2.7.1/CMakeLists.txt" ] || exit 0
mkdir -p "$folder"
if [ -n "${NLOPT_SOURCE:-}" ]; then
  cp "$NLOPT_SOURCE" "$folder/$archive"
else
  # The archive lies beside the package: 'http://MIRROR/pool/main/n/nlopt/libnlopt0_2.7.1-5_amd64.deb' …
  package=$(apt-get download --print-uris libnlopt0 | sed -n "s/^'\([^']*\)'.*/\1/p")
  [ -n "$package" ] || { echo "fetch_nlopt: apt knows no package libnlopt0; run apt-get update, or name an archive in NLOPT_SOURCE" >&2; exit 1; }
  curl -sSfL --retry 3 -o "$folder/$archive" "$(dirname "$package")/$archive"
fi
echo "$checksum  $folder/$archive" | sha256sum --check --quiet
tar -xzf "$folder/$archive" -C "$folder"
