#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Everything that a release has, in build/release_files: Debian packages, a Python wheel, the sources, the list of what is linked
# (SPDX), and checksums of all. Usage: tools/package/release.sh, on a commit without changes
set -euo pipefail
cd "$(dirname "$0")/../.."
out=build/release_files
rm -rf $out build/package/packages
mkdir -p $out
make package
cp build/package/packages/*.deb $out

prefix=$PWD/build/package/prefix
rm -rf "$prefix"
for build in package-v4 package-v3 package; do cmake --install build/$build --prefix "$prefix" --component program >/dev/null; done
/usr/bin/python3 tools/package/make_wheel.py "$prefix" $out

version=$(sed -n 's/^project(talus VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
git archive --prefix="talus-$version/" -o $out/talus-"$version".tar.gz HEAD
/usr/bin/python3 tools/package/make_sbom.py build/package/bin/talus $out/talus-"$version".spdx.json
(cd $out && sha256sum -- *.deb *.whl *.tar.gz *.json >SHA256SUMS && ls -l && cat SHA256SUMS)
