#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that the parts that a page in a browser needs compile for WebAssembly: without POSIX, HDF5, Gmsh and OpenMP.

Usage: tools/check_wasm.py BUILD [FILE …]

Compiles the sources of PARTS with `em++ -fsyntax-only` (Debian: emscripten). BUILD is a configured build folder, for
generated headers. Ends with 1 and the first errors of each file that does not compile, and with 77 where there is no em++.
"""
import concurrent.futures
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PARTS = ["results", "input", "lem", "fem/seepage", "sparse", "bounds", "site", "run/lem"]
# The engine of the studio, and what it needs of other parts.
FILES = ["studio/engine.cpp", "studio/messages.cpp", "studio/section.cpp", "studio/spans.cpp", "run/common/section_of_case.cpp", "run/case_picture.cpp",
         "run/message_places.cpp", "run/picture_conditions.cpp", "run/picture_search.cpp"]
# Libraries of headers only, behind the headers of emscripten itself.
INCLUDES = ["-Isrc", "-idirafter", "/usr/include", "-isystem", "/usr/include/eigen3"]
OPTIONS = ["-std=c++20", "-DTOML_HEADER_ONLY=0", "-Wno-everything"]
# Compiled once, as in the build (cmake/TalusOptions.cmake).
HEADERS = ["<algorithm>", "<functional>", "<map>", "<memory>", "<sstream>", "<variant>", "<fmt/format.h>", '"input/case/case.hpp"',
           '"results/run.hpp"']
BATCH = 8


def compile_source(path, build, *more):
    """The first errors of a source."""
    done = subprocess.run(["em++", *OPTIONS, *INCLUDES, f"-I{build / 'generated'}", *more, str(path)], cwd=ROOT, capture_output=True, text=True)
    return [line for line in done.stderr.splitlines() if "error:" in line][:3] if done.returncode != 0 else []


def group(files):
    """The files of each folder, at most BATCH at a time."""
    folders = {}
    for path in files:
        folders.setdefault(path.parent, []).append(path)
    return [own[i : i + BATCH] for own in folders.values() for i in range(0, len(own), BATCH)]


def compile_all(files, build):
    """File → its first errors; the headers in common are a file too.

    Files of one folder are compiled together, and singly where that fails: names of one may meet those of another.
    """
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        common = pathlib.Path(folder) / "common.hpp"
        common.write_text("".join(f"#include {name}\n" for name in HEADERS), encoding="utf-8")
        faults = {"headers": compile_source(common, build, "-x", "c++-header", "-o", f"{common}.pch")}
        if faults["headers"]:
            return faults
        compiled = ("-fsyntax-only", "-include-pch", f"{common}.pch")

        def compile_group(numbered):
            number, own = numbered
            together = pathlib.Path(folder) / f"group_{number}.cpp"
            together.write_text("".join(f'#include "{ROOT / path}"\n' for path in own), encoding="utf-8")
            if len(own) > 1 and not compile_source(together, build, *compiled):
                return {path: [] for path in own}
            return {path: compile_source(path, build, *compiled) for path in own}

        for found in pool.map(compile_group, enumerate(group(files))):
            faults |= found
        return faults


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if shutil.which("em++") is None:
        print("SKIP: there is no em++ (Debian: emscripten): the sources were NOT compiled for WebAssembly")
        return 77
    build = pathlib.Path(sys.argv[1]).resolve()
    files = [pathlib.Path(name) for name in sys.argv[2:]] or sorted(
        [path.relative_to(ROOT) for part in PARTS for path in (ROOT / "src" / part).rglob("*.cpp")] + [pathlib.Path("src") / name for name in FILES])
    faults = compile_all(files, build)
    for path, errors in faults.items():
        if errors:
            print(f"{path}:", *errors, sep="\n  ")
    failed = sum(bool(errors) for errors in faults.values())
    print(f"{len(faults) - failed} of {len(faults)} sources, with their common headers, compile for WebAssembly")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
