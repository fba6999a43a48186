#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a bare Debian 12 (debootstrap, the archive of this machine) and tries in it the package and the wheel of a release, each in its
# own copy. Usage: tools/package/bare_root.sh PACKAGE.deb WHEEL.whl FOLDER, as root
set -euo pipefail
package=$1 wheel=$2 folder=$3
root=$folder/root
archive=$(sed -n 's/^URIs: *//p; s/^deb \([^ ]*\).*/\1/p' /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list 2>/dev/null | head -1 || true)
mkdir -p "$folder"
if [ ! -e "$root/made" ]; then
  debootstrap --variant=minbase bookworm "$root" "$archive" >"$folder/debootstrap.log"
  # The package sources are those of this machine.
  rm -f "$root/etc/apt/sources.list"
  cp -r /etc/apt/sources.list.d/debian.sources "$root/etc/apt/sources.list.d/" 2>/dev/null || true
  cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  cp -r /etc/ssl "$root/etc/" && cp -r /usr/share/ca-certificates /usr/local/share/ca-certificates "$root/usr/share/" 2>/dev/null || true
  touch "$root/made"
fi

# One try: a copy of the bare system that is thrown away. Arguments: a file to bring, the script.
try() {
  SECONDS=0
  rm -rf "$folder/try" && cp -a "$root" "$folder/try"
  mkdir "$folder/try/talus_try"
  cp "$1" "$folder/try/talus_try/"
  cp -r examples/sliding_block "$folder/try/talus_try/block"
  printf '%s\n' "set -euo pipefail" "cd /talus_try" "$2" 'cd block
    talus version; talus --level
    talus check case.toml >/dev/null && talus run case.toml -q -o results && test -s results/report.html
    for level in x86-64-v2 x86-64-v3; do TALUS_LEVEL=$level talus run case.toml -q -o $level && grep -q "\"level\": \"$level\"" $level/summary.json; done
    cd / && $PYTHON -c "import talus; print(\"python: talus\", talus.__version__, talus._core.level, len(talus.Results(\"/talus_try/block/results\")), \"frames\")"' >"$folder/try/talus_try/script"
  mount --bind /proc "$folder/try/proc" && mount --bind /dev "$folder/try/dev"
  status=0
  env -i PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/talus_try LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$folder/try" bash /talus_try/script || status=$?
  umount "$folder/try/proc" "$folder/try/dev"
  echo "bare_root: $(basename "$1"): $([ $status -eq 0 ] && echo works || echo "FAILED with $status"), $SECONDS s"
  rm -rf "$folder/try"
  return $status
}

try "$package" "apt-get update -qq
  apt-get install -y -qq --no-install-recommends ./$(basename "$package") python3-numpy python3-tomli-w >/dev/null 2>&1
  PYTHON=/usr/bin/python3"
# The wheel: Python, NumPy and tomli-w, and nothing of what Talus is linked with.
try "$wheel" "apt-get update -qq
  apt-get install -y -qq --no-install-recommends python3-venv python3-numpy python3-tomli-w libstdc++6 >/dev/null 2>&1
  python3 -m venv --system-site-packages /opt/talus
  /opt/talus/bin/pip install -q --no-index --no-deps ./$(basename "$wheel")
  ls /usr/lib/x86_64-linux-gnu | grep -c 'libgmsh\|libhdf5\|libTK' || true
  PYTHON=/opt/talus/bin/python PATH=/opt/talus/bin:\$PATH"
