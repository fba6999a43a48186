#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the cost of a build in user and system seconds, which a busy machine hardly affects.

    tools/build_cost.py                 program, pages and modules, then all that `make test` builds besides
    tools/build_cost.py --program       these only
    tools/build_cost.py --edits         how many sources an edit recompiles, without a build
    tools/build_cost.py -- -DNAME=VALUE ...   with settings for CMake

Builds from empty into a folder of its own, without ccache. Prints the table of CONTRIBUTING.md.
"""
import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COSTLIEST = 10
# Typical edits, each with the file of src/ in which it is made.
EDITS = {"unit, range or sentence of a key": "input/case/support_keys.cpp", "a member of a block": "input/case/support.hpp",
         "a member of a result": "results/slices.hpp", "the equations of a law": "material/tresca.hpp", "`error.hpp`": "base/error.hpp"}
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def children_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def launch(log, command):
    """Runs one compiler for CMake, and appends its seconds and its output file to the log."""
    status = subprocess.call(command)
    output = command[command.index("-o") + 1] if "-o" in command else command[-1]
    with open(log, "a", encoding="utf-8") as file:
        file.write(f"{children_seconds():.2f} {output}\n")
    return status


def run(command):
    """Runs a step of the build; its seconds, those of all its children included."""
    before = children_seconds()
    subprocess.run(command, check=True, stdout=sys.stderr, env=dict(os.environ, CCACHE_DISABLE="1"))
    return children_seconds() - before


def read_log(log):
    """Seconds of each source: tests/CMakeFiles/test_unit.dir/unit/dual.cpp.o is tests/unit/dual.cpp."""
    cost = defaultdict(float)
    for line in log.read_text(encoding="utf-8").splitlines() if log.exists() else []:
        seconds, output = line.split(" ", 1)
        floor, _, rest = output.partition("CMakeFiles/")
        target, _, source = rest.partition(".dir/")
        name = f"headers of {target}" if source.endswith(".gch") else floor + source.removesuffix(".o")
        cost[name] += float(seconds)
    return cost


def find_included(path):
    """The project's files that a file includes by itself."""
    roots = [ROOT / "src", ROOT / "tests", ROOT / "python/src", path.parent]
    for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
        found = next((root / name for root in roots if (root / name).is_file()), None)
        if found:
            yield found.resolve()


def count_recompiled():
    """Number of sources of src/, tests/, python/ and bench/ that each edit recompiles, each source compiled alone."""
    files = [path.resolve() for folder in ("src", "tests", "python/src", "bench") for path in (ROOT / folder).rglob("*.[ch]pp")]
    included = {path: set(find_included(path)) for path in files}
    counts = dict.fromkeys(EDITS, 0)
    sources = [path for path in files if path.suffix == ".cpp"]
    for source in sources:
        reached, waiting = {source}, [source]
        while waiting:
            for path in included.get(waiting.pop(), set()) - reached:
                reached.add(path)
                waiting.append(path)
        for edit, file in EDITS.items():
            counts[edit] += ROOT / "src" / file in reached
    return counts, len(sources)


def write_recompiled():
    counts, all_sources = count_recompiled()
    rows = [f"| {edit} (`{EDITS[edit]}`) | {count} |" for edit, count in counts.items()]
    return "\n".join([f"| an edit of | sources recompiled, of {all_sources} |", "|---|--:|", *rows])


def write_table(steps, cost):
    rows = [f"| {name} | {seconds:.0f} |" for name, seconds in steps]
    rows += [f"| `{name}` | {seconds:.1f} |" for name, seconds in sorted(cost.items(), key=lambda c: -c[1])[:COSTLIEST]]
    return "\n".join(["| | core-seconds |", "|---|--:|", *rows])


def measure(folder, program_only, jobs, settings):
    log = folder / "log"
    launcher = f"{sys.executable};-ISE;{Path(__file__).resolve()};--launch;{log}"
    build = folder / "build"
    steps = [("configuration", run(["cmake", "--preset", "release", "-S", ROOT, "-B", build,
                                    *[f"-DCMAKE_{language}_COMPILER_LAUNCHER={launcher}" for language in ("C", "CXX")],
                                    *settings]))]
    for name, target in (("program, pages, modules", "everyday"), ("tests, benchmarks, Python package", "all"))[: 1 if program_only else 2]:
        before = sum(read_log(log).values())
        seconds = run(["cmake", "--build", build, "-j", str(jobs), "--target", target])
        steps += [(f"{name}: compilers", sum(read_log(log).values()) - before), (f"**{name}**", seconds)]
    return write_table(steps, read_log(log))


def main():
    if sys.argv[1:2] == ["--launch"]:
        return launch(sys.argv[2], sys.argv[3:])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", action="store_true", help="program, pages and modules only")
    parser.add_argument("--edits", action="store_true", help="count what edits recompile, and build nothing")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", type=Path, help="keep the build folder here")
    parser.add_argument("settings", nargs="*")
    chosen = parser.parse_args()
    if chosen.edits:
        print(write_recompiled())
        return 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = (chosen.keep or Path(scratch)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        print(measure(folder, chosen.program, chosen.jobs, chosen.settings))
    print()
    print(write_recompiled())
    return 0


if __name__ == "__main__":
    sys.exit(main())
