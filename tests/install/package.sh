#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the Debian packages of a build, installs the program's in a copy of this system that is thrown away, and tries what is in it.
# Needs root and an overlay file system; ends with 77, which is skipped, without them.
set -euo pipefail
build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
(cd "$build" && cpack >"$scratch/log" 2>&1) || { cat "$scratch/log"; exit 1; }
package=$(ls "$build"/packages/talus_*.deb)
# Modules and page that this build has are in the package.
dpkg -c "$package" >"$scratch/content"
for part in bin/libtalus_http.so bin/libtalus_xlsx.so bin/studio/index.html; do
  if [ -e "$build/$part" ] && ! grep -q "${part#bin/}" "$scratch/content"; then echo "the package lacks $part"; exit 1; fi
done
if [ "$(id -u)" -ne 0 ] || ! unshare --mount true 2>/dev/null; then
  echo "SKIP: only root can install packages: they were made, and were NOT installed"
  exit 77
fi

cat >"$scratch/inside" <<'END'
set -euo pipefail
dpkg -i /package.deb >/dev/null
talus version
if ldd "$(command -v talus)" $(find /usr/lib/talus -name '*.so') | grep 'not found'; then exit 1; fi
cp -r /usr/share/doc/talus/examples/sliding_block /tmp/block && cd /tmp/block
talus check case.toml >/dev/null
talus run case.toml -q -o results
test -s results/report.html
cd /
/usr/bin/python3 -c 'import talus; assert len(talus.Results("/tmp/block/results")) > 1; print("python: talus", talus.__version__, "in", talus.__path__[0])'
if ls /usr/lib/talus/libtalus_http.so /usr/lib/talus/*/libtalus_http.so >/dev/null 2>&1; then
  timeout 10 talus studio /tmp/block --no-open >/tmp/studio.log || true
  grep -q 'http://127.0.0.1' /tmp/studio.log
fi
man -w talus >/dev/null || test -s /usr/share/man/man1/talus.1.gz
bash -c 'source /usr/share/bash-completion/completions/talus; COMP_WORDS=(talus ru); COMP_CWORD=1; _talus; test "${COMPREPLY[*]}" = run'
dpkg -r talus >/dev/null
for left in /usr/bin/talus /usr/share/doc/talus /usr/lib/python3/dist-packages/talus; do
  if [ -e $left ]; then echo "$left is still there after the removal"; exit 1; fi
done
END
cat >"$scratch/outside" <<END
set -euo pipefail
mkdir "$scratch/room"
mount -t tmpfs tmpfs "$scratch/room"
mkdir "$scratch/room/upper" "$scratch/room/work" "$scratch/root"
mount -t overlay overlay -o "lowerdir=/,upperdir=$scratch/room/upper,workdir=$scratch/room/work" "$scratch/root" || exit 77
mount --bind /proc "$scratch/root/proc"
mount --bind /dev "$scratch/root/dev"
cp "$package" "$scratch/root/package.deb"
cp "$scratch/inside" "$scratch/root/inside"
env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root chroot "$scratch/root" bash /inside
END
status=0
unshare --mount --propagation private bash "$scratch/outside" || status=$?
[ $status -ne 77 ] || echo "SKIP: there is no overlay file system here: the packages were made, and were NOT installed"
exit $status
