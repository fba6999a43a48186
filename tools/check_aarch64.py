#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that every source of the program compiles for 64-bit ARM, with a cross compiler and without linking.

Usage: tools/check_aarch64.py [BUILD]   (a configured build folder; default build/release)

Needs aarch64-linux-gnu-g++ (Debian: g++-aarch64-linux-gnu); ends with 77, loudly, without it. Headers are those of this machine, which
are the same on both for all libraries that Talus uses. The Python module is left out: Python's headers are not the same. Nothing
that is compiled here has run.
"""
import concurrent.futures
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

COMPILER = "aarch64-linux-gnu-g++"
# Options of the host machine, and of its precompiled headers.
DROPPED = ("-march=", "-mprefer-vector-width=", "-fpch-preprocess", "-Winvalid-pch", "--param=")


def compile_for_arm(entry):
    words = shlex.split(entry["command"])
    start = next(i for i, word in enumerate(words) if pathlib.Path(word).name in ("c++", "g++", "clang++"))
    arguments, skip = [], False
    for word, after in zip(words[start + 1:], [*words[start + 2:], ""]):
        if skip or word.startswith(DROPPED):
            skip = False
        elif word == "-o" or (word == "-include" and "cmake_pch" in after):
            skip = True
        else:
            arguments.append(word)
    done = subprocess.run([COMPILER, *arguments, "-fsyntax-only"], cwd=entry["directory"], capture_output=True, text=True)
    return entry["file"], done.returncode, done.stderr


def main():
    build = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/release")
    if shutil.which(COMPILER) is None:
        print(f"SKIP: there is no {COMPILER}: whether Talus compiles for ARM was NOT tried")
        return 77
    entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
               if entry["file"].endswith((".cpp", ".cxx")) and "/src/" in entry["file"] and "/python/" not in entry["file"] and "cmake_pch" not in entry["file"]
               and "/app/launch/" not in entry["file"]]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(compile_for_arm, entries))
    for file, code, said in results:
        if code != 0:
            print(f"{file}:\n{said[:1500]}")
    failed = sum(code != 0 for _, code, _ in results)
    print(f"{len(results)} sources for 64-bit ARM: {failed} do not compile")
    return 1 if failed or not results else 0


if __name__ == "__main__":
    sys.exit(main())
