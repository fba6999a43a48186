#!/usr/bin/env python3
"""Speed of the engine beside the throw-away yardstick, in one run.

    bench/compare.py BUILD_FOLDER [--yardstick FOLDER] [--rounds N] [--csv FILE]

Both step the same slope (bench/yardstick_case.hpp); they take turns, because the machine's speed drifts, and the ratio
is taken turn by turn. Without the yardstick's sources only Talus is measured, and the script says so.
"""
import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys

FLAGS = ["-std=c++20", "-O3", "-march=native", "-mprefer-vector-width=512", "-fno-math-errno", "-fno-trapping-math"]
# dimension, case, warm steps, steps, repetitions, prefetch distance of the yardstick (its own best choice)
CASES = [(2, "small", 200, 1000, 5, 0), (2, "mid", 50, 100, 3, 1), (2, "large", 5, 10, 3, 1),
         (3, "small", 200, 300, 3, 0), (3, "mid", 20, 40, 3, 3), (3, "large", 5, 10, 2, 3)]
# As the program sets them for itself: waiting threads sleep after a short spin, because the machine may be shared.
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="passive", GOMP_SPINCOUNT="20000")


def run(command, **extra):
    return subprocess.run(command, env=dict(ENVIRONMENT, **extra), capture_output=True, text=True, check=True).stdout


def measure_talus(build, dimension, case, threads, warm, steps, repeats, *flags):
    out = run([str(build / "bin" / "step_speed"), str(dimension), case, str(threads), str(warm), str(steps), str(repeats), *flags])
    return float(re.search(r"best ([0-9.]+) Mpps", out)[1]), int(re.search(r"(\d+) bytes/point", out)[1]), int(re.search(r"points=(\d+)", out)[1])


def build_yardstick(source, build, prefetch):
    program = build / f"yardstick_{prefetch}"
    if not program.exists():
        subprocess.run(["g++", *FLAGS, *([f"-DPREF={prefetch}"] if prefetch else []), str(source / "runW.cpp"), "-o", str(program)], check=True)
    return program


def measure_yardstick(program, dimension, case, warm, steps, repeats, **extra):
    out = run([str(program), str(dimension), case, "0", "0", str(warm), str(steps), str(repeats)], **extra)
    return float(re.search(r"best ([0-9.]+) Mpps", out)[1])


def describe_machine():
    model = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "unknown")
    compiler = run(["g++", "--version"]).splitlines()[0]
    return f"{model}, {os.cpu_count()} cores, {compiler}, load {os.getloadavg()[0]:.1f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--yardstick", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2] / "shared" / "ceiling")
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    has_yardstick = (arguments.yardstick / "runW.cpp").exists()
    print(describe_machine())
    if not has_yardstick:
        print("SKIP: the yardstick's sources are not here; no ratio is measured (--yardstick FOLDER)", file=sys.stderr)
    print("\n| case | points | integration | Talus [M/s] | yardstick [M/s] | ratio | bytes/point |\n|---|---|---|---|---|---|---|")
    for dimension, case, warm, steps, repeats, prefetch in CASES:
        for flag in ([], ["mixed"]) if case == "small" else ([],):
            ours, theirs, ratios = [], [], []
            for _ in range(arguments.rounds):
                speed, size, points = measure_talus(arguments.build, dimension, case, 1, warm, steps, repeats, *flag)
                ours.append(speed)
                if has_yardstick:
                    program = build_yardstick(arguments.yardstick, arguments.build, prefetch)
                    theirs.append(measure_yardstick(program, dimension, case, warm, steps, repeats, **({"MIXED": "1"} if flag else {})))
                    ratios.append(ours[-1] / theirs[-1])
            other = f"{statistics.median(theirs):.1f} | {statistics.median(ratios):.2f}" if ratios else "– | –"
            print(f"| {dimension}D {case} | {points} | {flag[0] if flag else 'points'} | {statistics.median(ours):.1f} | {other} | {size} |", flush=True)
    print("\n| case | threads | Talus [M/s] | speed-up |\n|---|---|---|---|")
    for dimension in (2, 3):
        one, many = [], []
        threads = os.cpu_count()
        for _ in range(arguments.rounds):
            one.append(measure_talus(arguments.build, dimension, "large", 1, 5, 10, 2)[0])
            many.append(measure_talus(arguments.build, dimension, "large", threads, 5, 10, 2)[0])
        gain = statistics.median(m / o for m, o in zip(many, one))
        print(f"| {dimension}D large | {threads} | {statistics.median(many):.1f} | {gain:.2f} |", flush=True)


if __name__ == "__main__":
    main()
