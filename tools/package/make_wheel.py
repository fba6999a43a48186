#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a Python wheel of the builds of `make package`: program, Python package and every library that they need but the C library's.

Usage: tools/package/make_wheel.py PREFIX FOLDER

PREFIX is the tree in which tools/package/release.sh has installed the builds of the presets package-v4, package-v3 and package. The wheel
follows the manylinux rules as far as they can be met on Debian 12: what is carried is found by a path relative to itself, and the tag
names the C library that it was built with. Needs patchelf.
"""
import base64
import hashlib
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

# The C library and the compiler's own are the system's: two of them in one process do not go well.
NOT_CARRIED = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|util|resolv|stdc\+\+|gcc_s)\.so.*)")
STAND_IN = '''# SPDX-License-Identifier: MIT
"""The command `talus` of an installed wheel."""
import os
import sys


def main() -> None:
    program = os.path.join(os.path.dirname(__file__), "levels", "talus")
    os.execv(program, ["talus", *sys.argv[1:]])
'''


def list_needed(path):
    """Name → file of every shared library that a program or library is loaded with."""
    told = subprocess.run(["ldd", str(path)], check=True, capture_output=True, text=True).stdout
    if "not found" in told:
        raise SystemExit(f"make_wheel: {path} lacks libraries:\n{told}")
    return {name: pathlib.Path(file) for name, file in re.findall(r"^\s*(\S+) => (/\S+)", told, re.M)}


def set_path(file, libraries):
    depth = len(file.parent.relative_to(libraries.parent).parts)
    path = "$ORIGIN" if file.parent == libraries else "$ORIGIN/" + "../" * depth + libraries.name
    # --force-rpath: it holds for what the libraries need, too, and comes before LD_LIBRARY_PATH.
    subprocess.run(["patchelf", "--force-rpath", "--set-rpath", path, str(file)], check=True)


def collect(prefix, root):
    """Package, programs and libraries in the folder of a wheel; the version."""
    package = root / "talus"
    found = next(prefix.glob("lib/python3*/*-packages/talus"))
    shutil.copytree(found, package, ignore=shutil.ignore_patterns("levels", "__pycache__"))
    shutil.copytree(prefix / "lib" / "talus", package / "levels")
    (package / "command.py").write_text(STAND_IN)
    binaries = [file for file in (package / "levels").rglob("*") if file.is_file()]
    libraries = root / "talus.libs"
    libraries.mkdir()
    for binary in binaries:
        subprocess.run(["strip", "--strip-unneeded", str(binary)], check=True)
        for name, file in list_needed(binary).items():
            if not NOT_CARRIED.fullmatch(name) and not (libraries / name).exists():
                shutil.copy(file.resolve(), libraries / name)
    for file in [*binaries, *libraries.iterdir()]:
        file.chmod(0o755)
        set_path(file, libraries)
    # The units' database, which the library looks for where Debian has it; the program looks here first.
    shutil.copytree("/usr/share/xml/udunits", package / "levels" / "units")
    version = subprocess.run([package / "levels" / "talus", "version"], check=True, capture_output=True, text=True).stdout.split()[1]
    return version


def write_metadata(root, version, tag):
    info = root / f"talus-{version}.dist-info"
    info.mkdir()
    readme = (pathlib.Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")
    (info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: talus\nVersion: {version}\n"
        "Summary: Slope stability and runout by LEM, FEM, limit analysis and MPM\n"
        "License: MIT; the libraries that this wheel carries have their own, Gmsh the GNU GPL version 2 or later\n"
        "Requires-Python: ==3.11.*\nRequires-Dist: numpy\nRequires-Dist: tomli-w\nDescription-Content-Type: text/markdown\n\n" + readme,
        encoding="utf-8")
    (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: talus make_wheel\nRoot-Is-Purelib: false\nTag: {tag}\n")
    (info / "entry_points.txt").write_text("[console_scripts]\ntalus = talus.command:main\n")
    shutil.copy(pathlib.Path(__file__).resolve().parents[2] / "LICENSE", info / "LICENSE")
    return info


def pack(root, info, wheel):
    """A zip with the list of what is in it, and the same bytes for the same files."""
    record = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for file in sorted(file for file in root.rglob("*") if file.is_file()):
            name, data = file.relative_to(root).as_posix(), file.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(data)}")
            entry = zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0))
            entry.external_attr = (0o100000 | (file.stat().st_mode & 0o777)) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
        name = f"{info.name}/RECORD"
        archive.writestr(name, "\n".join([*record, f"{name},,"]) + "\n")


def main():
    prefix, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    libc = "_".join(platform.libc_ver()[1].split(".")[:2])
    python = f"cp{sysconfig.get_python_version().replace('.', '')}"
    tag = f"{python}-{python}-manylinux_{libc}_{platform.machine()}"
    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch) / "wheel"
        root.mkdir()
        version = collect(prefix, root)
        info = write_metadata(root, version, tag)
        folder.mkdir(parents=True, exist_ok=True)
        wheel = folder / f"talus-{version}-{tag}.whl"
        pack(root, info, wheel)
    print(f"{wheel}: {wheel.stat().st_size / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
