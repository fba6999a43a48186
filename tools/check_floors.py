#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the rules of the source that a compiler does not know (docs/architecture.md): who may include whom, where the
preprocessor and threads may be used, and how long a file may be. Exits with 1 and one line per fault.

Usage: check_floors.py [root] | check_floors.py --self-test
"""
import re
import sys
import tempfile
from pathlib import Path

# Includes that are allowed (docs/architecture.md), from the ground up; every floor may include its own files. Others are
# faults: the engines do not include each other, output includes no engine, results include base only.
ALLOWED = {
    "base": [],
    "ranks": ["base"],
    "material": ["base", "input/language"],
    "mesh": ["base"],
    "results": ["base"],
    "input": ["base", "material", "mesh", "results"],
    "mpm": ["base", "material", "mesh", "input"],
    "sparse": ["base"],
    "fem": ["base", "material", "mesh", "input", "sparse"],
    "lem": ["base", "mesh"],
    "bounds": ["base", "mesh", "sparse"],
    "output": ["base", "results", "input"],
    "site": ["base", "material", "mesh", "results", "input", "mpm/state", "fem/seepage", "fem/solid", "lem/section"],
    "run": ["base", "material", "mesh", "results", "input", "mpm", "fem", "lem", "bounds", "output", "site"],
    "laboratory": ["base", "material", "results", "input", "output", "site", "run"],
    "study": ["base", "results", "input", "lem", "output", "run"],
    "report": ["base", "material", "mesh", "results", "input", "output", "site", "run"],
    "drawing": ["base", "mesh", "input/case"],
    "export": ["base", "mesh", "results", "input", "output", "site", "drawing", "report/folder"],
    "studio": ["base", "results", "input", "lem", "site", "output", "run", "report"],
    "gdal": ["base", "drawing"],
    "gmsh": ["base", "mesh"],
    "xlsx": ["base", "results", "export"],
    "http": ["studio"],
    "app": ["base", "drawing", "export", "results", "input", "output", "run", "laboratory", "study", "report", "studio"],
}
# Rooms of one floor that do not know each other: no method owns the run.
APART = [("input/language", "input/case"), ("run/mpm", "run/fem"), ("run/mpm", "run/lem"), ("run/fem", "run/lem"), ("run/bounds", "run/mpm"), ("run/bounds", "run/fem"), ("run/bounds", "run/lem"), ("output/files", "output/plots"), ("mpm/two_velocity", "mpm/darcy")]
# One of them may use the other.
MAY_USE = {("output/plots", "output/files"), ("input/case", "input/language")}
# The folders of a floor from the bottom up, with their own folders: each may include those before it. "" are the files
# beside the folders.
ORDER = {
    "mpm": ["state", "kernels", "pore_water", "backend", "two_velocity", "darcy", "solver"],
    "lem": ["section", "surface", "slices", "search"],
    "fem": ["seepage", "solid", "consolidation"],
    "bounds": ["conic", ""],
    "input": ["language", "case", ""],
    "report": ["folder", "pack", "content", "words", ""],
    "run": ["common", "lem", "fem", "bounds", "seepage", "mpm/start", "mpm/stage", "mpm/record", "mpm/reduction", "mpm", "timeline", "compare", "construction", "forecast", ""],
}
LONGEST = 500
# file → why it may be longer
MAY_BE_LONGER = {}
# file outside base/ → why it may name OpenMP
MAY_NAME_THREADS = {}
SOURCES = {".cpp", ".hpp", ".cu", ".py", ".sh", ".ts"}
GENERATED = "web/src/contract/results.ts"  # by `npm run types`; git ignores it
FOLDERS = ["src", "tests", "bench", "tools", "python", "web", "cuda", "wasm"]


def list_sources(root, folders):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.is_file() and path.suffix in SOURCES and "node_modules" not in path.parts and path != root / GENERATED:
                yield path, path.relative_to(root).as_posix()


def find_neighbours(name, target):
    """The fault of a room that includes one that it must not know; None without one."""
    for pair in APART:
        for one, other in (pair, pair[::-1]):
            if name.startswith(f"src/{one}/") and target.startswith(other + "/") and (one, other) not in MAY_USE:
                return f"{one}/ and {other}/ do not know each other"
    return None


def find_order_fault(name, target):
    """The fault of a folder that includes one above it on its floor; None without one."""
    floor, own, other = name.split("/")[1], *("/".join(path.split("/")[first:-1]) for path, first in ((name, 2), (target, 1)))
    order = ORDER[floor]
    if own not in order or other not in order:
        return f"{floor}/{other if own in order else own} has no place in ORDER"
    return f"{floor}/{own} may not include {floor}/{other}" if order.index(other) > order.index(own) else None


def check_line(root, name, floor, line):
    """The faults of one line of a file in src/<floor>/."""
    include = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
    if include:
        target = include[1]
        other = target.split("/")[0]
        generated = (root / "src" / (target + ".in")).is_file()
        if other not in ALLOWED or "/" not in target:
            yield f'"{target}" must be written "floor/file.hpp"'
        elif other != floor and not any(target.startswith(room + "/") for room in ALLOWED[floor]):
            yield f"{floor}/ may not include {other}/"
        elif fault := find_neighbours(name, target):
            yield fault
        elif floor == other and floor in ORDER and (fault := find_order_fault(name, target)):
            yield fault
        elif not generated and not (root / "src" / target).is_file():
            yield f"there is no src/{target}"
    if floor != "base":
        if re.match(r"\s*#\s*(if|ifdef|ifndef|elif)\b", line):
            yield "conditional compilation belongs into base/"
        if re.match(r"\s*#\s*pragma\s+omp|\s*#\s*include\s+<omp\.h>", line) and name not in MAY_NAME_THREADS:
            yield "threads belong into base/parallel.hpp"


def find_faults(root):
    faults = []
    for path, name in list_sources(root, FOLDERS):
        lines = path.read_text(encoding="utf-8").splitlines()
        if len(lines) > LONGEST and name not in MAY_BE_LONGER:
            faults.append(f"{name}: {len(lines)} lines; over {LONGEST} a file needs a reason in tools/check_floors.py")
        parts = name.split("/")
        if parts[0] != "src" or len(parts) < 3:
            continue
        if parts[1] not in ALLOWED:
            faults.append(f"{name}: src/{parts[1]}/ is not in the list of tools/check_floors.py")
            continue
        for number, line in enumerate(lines, 1):
            faults += [f"{name}:{number}: {fault}" for fault in check_line(root, name, parts[1], line)]
    for name in [*MAY_BE_LONGER, *MAY_NAME_THREADS]:
        if not (root / name).is_file():
            faults.append(f"{name}: tools/check_floors.py grants it an exception, but there is no such file")
    return faults


def run_self_test():
    """Every rule must be able to fail: a small tree with one fault of each kind."""
    tree = {
        "src/base/low.hpp": '#include "mpm/high.hpp"\n',
        "src/mpm/high.hpp": '#include "base/low.hpp"\n#include "low.hpp"\n#include "base/missing.hpp"\n',
        "src/fem/neighbour.cpp": '#include "mpm/high.hpp"\n',
        "src/mpm/state/body.hpp": '#include "mpm/solver/step.hpp"\n',
        "src/mpm/solver/step.hpp": '#include "mpm/state/body.hpp"\n#include "mpm/darcy/flow.hpp"\n',
        "src/mpm/darcy/flow.hpp": '#include "mpm/two_velocity/phases.hpp"\n',
        "src/mpm/two_velocity/phases.hpp": "\n",
        "src/run/mpm/owner.cpp": '#include "run/lem/search.hpp"\n',
        "src/run/lem/search.hpp": "\n",
        "src/run/mpm/start/points.cpp": '#include "run/mpm/stage.hpp"\n#include "run/mpm/start/points.hpp"\n',
        "src/run/mpm/start/points.hpp": "\n",
        "src/run/mpm/stage.hpp": '#include "run/mpm/start/points.hpp"\n#include "run/run_case.hpp"\n',
        "src/run/run_case.hpp": '#include "run/mpm/stage.hpp"\n',
        "src/mesh/threads.cpp": "#include <omp.h>\n#ifdef __AVX__\n#endif\n",
        "src/odd/file.cpp": "\n",
        "tests/unit/long.cpp": "\n" * (LONGEST + 1),
    }
    expected = ["base/low.hpp:1", "mpm/high.hpp:2", "mpm/high.hpp:3", "mesh/threads.cpp:1", "mesh/threads.cpp:2",
                "odd/file.cpp", "unit/long.cpp", "fem/neighbour.cpp:1", "run/mpm/owner.cpp:1", "state/body.hpp:1", "darcy/flow.hpp:1", "start/points.cpp:1", "mpm/stage.hpp:2"]
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in tree.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        faults = [fault for fault in find_faults(root) if "exception" not in fault]
    unseen = [place for place in expected if not any(place in fault for fault in faults)]
    return [f"self-test: the fault in {place} was not found" for place in unseen] + (
        [] if len(faults) == len(expected) else [f"self-test: {len(faults)} faults instead of {len(expected)}: {faults}"])


def main():
    arguments = sys.argv[1:]
    root = Path(arguments[0]) if arguments and arguments[0] != "--self-test" else Path(__file__).resolve().parent.parent
    faults = run_self_test() if arguments == ["--self-test"] else find_faults(root)
    print("\n".join(faults) if faults else "check_floors: no faults.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
