#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Speed of the engine beside the yardstick, in one run.

    bench/compare.py BUILD_FOLDER [--yardstick FOLDER] [--rounds N] [--only dry|wet|threads]
    bench/compare.py BUILD_FOLDER --against OTHER_BUILD_FOLDER [--rounds N]    this build beside another

Both step the same slope (bench/yardstick_case.hpp, bench/wet_yardstick.hpp); they alternate, because the machine's
speed drifts, and each round has its own ratio. Without the yardstick's sources only Talus is measured, and the script
says so.
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
WET_CASES = [(2, "small", 200, 1000, 5, 0), (2, "mid", 50, 100, 3, 1), (2, "large", 5, 10, 3, 1),
             (3, "small", 200, 300, 3, 0), (3, "large", 5, 10, 2, 1)]
# dimension, case, warm steps, steps, repetitions, flags: what one build is held against another by
AGAINST = [(2, "small", 200, 500, 3, ()), (2, "small", 200, 500, 3, ("mixed",)), (2, "small", 200, 500, 3, ("mixed", "smooth", "objective")),
           (3, "small", 100, 150, 3, ()), (3, "small", 100, 150, 3, ("mixed",)), (2, "small", 200, 300, 3, ("wet",)),
           (2, "small", 200, 300, 3, ("wet", "mixed")), (2, "small", 200, 300, 3, ("saturated", "mixed")),
           (3, "small", 50, 80, 3, ("wet",)), (3, "small", 50, 80, 3, ("wet", "mixed")),
           (2, "small", 200, 300, 3, ("rooted", "mixed", "objective")), (2, "mid", 20, 40, 3, ()), (2, "mid", 10, 20, 3, ("wet",))]
# As the program sets them for itself: waiting threads sleep after a short spin, because the machine may be shared.
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="passive", GOMP_SPINCOUNT="20000")
for name in ("MIXED", "SAT"):  # the yardstick's switches
    ENVIRONMENT.pop(name, None)


def run(command, **extra):
    return subprocess.run(command, env=dict(ENVIRONMENT, **extra), capture_output=True, text=True, check=True).stdout


class Talus:
    """The engine in a build folder."""

    def __init__(self, build):
        self.program = build / "bin" / "step_speed"

    def measure(self, dimension, case, threads, warm, steps, repeats, *flags):
        """Million point-steps per second, bytes per point, points."""
        out = run([str(self.program), str(dimension), case, str(threads), str(warm), str(steps), str(repeats), *flags])
        return (float(re.search(r"best ([0-9.]+) Mpps", out)[1]), int(re.search(r"(\d+) bytes/point", out)[1]),
                int(re.search(r"points=(\d+)", out)[1]))


class Yardstick:
    """One of the prototypes, runW (one phase) or runT (two); compiled when first needed."""

    def __init__(self, source, build, name):
        self.source, self.build, self.name = source / f"{name}.cpp", build, name

    def exists(self):
        return self.source.exists()

    def measure(self, dimension, case, warm, steps, repeats, prefetch, **switches):
        program = self.build / f"yardstick_{self.name}_{prefetch}"
        if not program.exists():
            distance = [f"-DPREF={prefetch}"] if prefetch else []
            subprocess.run(["g++", *FLAGS, *distance, str(self.source), "-o", str(program)], check=True)
        mode = ["0", "0"] if self.name == "runW" else ["W"]
        out = run([str(program), str(dimension), case, *mode, str(warm), str(steps), str(repeats)], **switches)
        return float(re.search(r"=> (?:best )?([0-9.]+) Mpps", out)[1])


def describe_machine():
    model = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "unknown")
    compiler = run(["g++", "--version"]).splitlines()[0]
    return f"{model}, {os.cpu_count()} cores, {compiler}, load {os.getloadavg()[0]:.1f}"


def compare(talus, yardstick, rounds, case, flags, switches):
    """A row's end: speeds, their ratio, bytes per point; the two programs take turns."""
    dimension, name, warm, steps, repeats, prefetch = case
    ours, theirs, ratios = [], [], []
    for _ in range(rounds):
        speed, size, points = talus.measure(dimension, name, 1, warm, steps, repeats, *flags)
        ours.append(speed)
        if yardstick.exists():
            theirs.append(yardstick.measure(dimension, name, warm, steps, repeats, prefetch, **switches))
            ratios.append(ours[-1] / theirs[-1])
    other = f"{statistics.median(theirs):.1f} | {statistics.median(ratios):.2f}" if ratios else "– | –"
    return points, f"{statistics.median(ours):.1f} | {other} | {size} |"


def compare_dry(talus, yardstick, rounds):
    print("\n| case | points | integration | Talus [M/s] | yardstick [M/s] | ratio | bytes/point |\n|---|---|---|---|---|---|---|")
    for case in CASES:
        for flag in ([], ["mixed"]) if case[1] == "small" else ([],):
            points, end = compare(talus, yardstick, rounds, case, flag, {"MIXED": "1"} if flag else {})
            print(f"| {case[0]}D {case[1]} | {points} | {flag[0] if flag else 'points'} | {end}", flush=True)


def compare_wet(talus, yardstick, rounds):
    """The wet yardstick has no mixed integration; there the ratio is to its integration by points."""
    print("\n| case | points | water | integration | Talus [M/s] | yardstick [M/s] | ratio | bytes/point |\n|---|---|---|---|---|---|---|---|")
    for case in WET_CASES:
        for water, flag, switches in (("unsaturated", "wet", {}), ("saturated", "saturated", {"SAT": "1"})):
            for integration in ("points", "mixed") if case[1] == "small" else ("points",):
                flags = [flag] + ([integration] if integration == "mixed" else [])
                points, end = compare(talus, yardstick, rounds, case, flags, switches)
                print(f"| {case[0]}D {case[1]} | {points} | {water} | {integration} | {end}", flush=True)


def compare_rooted(talus, rounds):
    """The rooted-soil model over Mohr-Coulomb, in one engine on one slope, each with mixed integration (the default)."""
    print("\n| case | water | rooted [M/s] | Mohr-Coulomb [M/s] | ratio |\n|---|---|---|---|---|")
    for dimension, name in ((2, "small"), (3, "small")):
        for water in ([], ["wet"]):
            rooted, plain = [], []
            for _ in range(rounds):
                rooted.append(talus.measure(dimension, name, 1, 2000, 500, 3, "mixed", "objective", "rooted", *water)[0])
                plain.append(talus.measure(dimension, name, 1, 2000, 500, 3, "mixed", "objective", *water)[0])
            ratio = statistics.median(r / p for r, p in zip(rooted, plain))
            wet = "unsaturated" if water else "dry"
            print(f"| {dimension}D {name} | {wet} | {statistics.median(rooted):.1f} | {statistics.median(plain):.1f} | {ratio:.2f} |", flush=True)


def compare_builds(ours, other, rounds):
    """The median of the ratios of the turns with its quartiles; who goes first changes from turn to turn."""
    print("\n| case | flags | this [M/s] | other [M/s] | ratio | quartiles |\n|---|---|---|---|---|---|")
    medians = []
    for dimension, name, warm, steps, repeats, flags in AGAINST:
        speeds = {ours: [], other: []}
        for turn in range(rounds):
            for build in (ours, other)[::1 if turn % 2 else -1]:
                speeds[build].append(build.measure(dimension, name, 1, warm, steps, repeats, *flags)[0])
        ratios = [a / b for a, b in zip(speeds[ours], speeds[other])]
        low, middle, high = statistics.quantiles(ratios, n=4)
        medians.append(middle)
        print(f"| {dimension}D {name} | {' '.join(flags) or 'points'} | {statistics.median(speeds[ours]):.1f} | "
              f"{statistics.median(speeds[other]):.1f} | {middle:.3f} | {low:.3f} to {high:.3f} |", flush=True)
    print(f"\nGeometric mean of the ratios: {statistics.geometric_mean(medians):.3f}")


def measure_threads(talus, rounds):
    print("\n| case | threads | Talus [M/s] | speed-up |\n|---|---|---|---|")
    threads = os.cpu_count()
    for dimension in (2, 3):
        for flags in ([], ["wet"]):
            one, many = [], []
            for _ in range(rounds):
                one.append(talus.measure(dimension, "large", 1, 5, 10, 2, *flags)[0])
                many.append(talus.measure(dimension, "large", threads, 5, 10, 2, *flags)[0])
            gain = statistics.median(m / o for m, o in zip(many, one))
            print(f"| {dimension}D large{', wet' if flags else ''} | {threads} | {statistics.median(many):.1f} | {gain:.2f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--yardstick", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2] / "shared" / "ceiling")
    parser.add_argument("--against", type=pathlib.Path, help="another build folder, instead of the yardstick")
    parser.add_argument("--rounds", type=int, default=None, help="turns, 3 of each; 9 with --against")
    parser.add_argument("--only", choices=["dry", "wet", "rooted", "threads"])
    arguments = parser.parse_args()
    talus, rounds = Talus(arguments.build), arguments.rounds or (9 if arguments.against else 3)
    print(describe_machine())
    if arguments.against:
        compare_builds(talus, Talus(arguments.against), rounds)
        return
    for part, name, function in (("dry", "runW", compare_dry), ("wet", "runT", compare_wet)):
        if arguments.only not in (None, part):
            continue
        yardstick = Yardstick(arguments.yardstick, arguments.build, name)
        if not yardstick.exists():
            print(f"SKIP: the yardstick's {name}.cpp is not here; no {part} ratio is measured (--yardstick FOLDER)", file=sys.stderr)
        function(talus, yardstick, rounds)
    if arguments.only in (None, "rooted"):
        compare_rooted(talus, rounds)
    if arguments.only in (None, "threads"):
        measure_threads(talus, rounds)


if __name__ == "__main__":
    main()
