#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that a study in jobs loses nothing when its workers are killed at random, and is bitwise identical to one process.

Usage: tools/verify_jobs.py PROGRAM [--case CASE] [--jobs 100] [--workers 4] [--seed 1]

Calculates a study of samples (examples/probability_of_failure, 10,000 of them by LEM) in one process, then in jobs of the
command line on local workers, of which three in ten are killed by SIGKILL after a random time, and, where Python finds the
package talus (PYTHONPATH), on a ProcessPoolExecutor whose workers are killed as often as nine jobs have ended. Jobs without
a kill, for the time that they cost, come first. Prints a line for each way; ends with 1 where a sample is lost or samples.csv differs
in one bit.
"""
import argparse
import concurrent.futures
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
KILLED = 0.3  # fraction of the processes of the command line
JOBS_BETWEEN_KILLS = 9


class Watch:
    """Wall and processor time since its start, the latter with that of processes that have ended, killed ones among them."""

    def __init__(self):
        self.wall, self.processor = time.monotonic(), self.read_processor()

    @staticmethod
    def read_processor():
        used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
        return sum(u.ru_utime + u.ru_stime for u in used)

    def tell(self):
        return f"{time.monotonic() - self.wall:.1f} s ({self.read_processor() - self.processor:.1f} s of processor time)"


def run_program(program, *words):
    watch = Watch()
    subprocess.run([program, "study", *map(str, words), "-q"], check=True)
    return watch.tell()


def calculate_by_commands(program, folder, options, killed):
    """(kills, time): every job by a process of its own, --workers at a time, until none is missing."""
    draw, watch, kills = random.Random(options.seed), Watch(), 0
    waiting, running, longest = list(range(options.jobs)), {}, 0.3
    while waiting or running:
        while waiting and len(running) < options.workers:
            job, begun = waiting.pop(0), time.monotonic()
            process = subprocess.Popen([program, "study", str(folder), "--job", str(job), "--threads", "1", "-q"])
            end = begun + draw.uniform(0, longest) if draw.random() < killed else None
            running[job] = (process, begun, end)
        for job, (process, begun, end) in list(running.items()):
            if process.poll() is None:
                if end is not None and time.monotonic() > end:
                    process.kill()
                    process.wait()
                    kills += process.returncode == -signal.SIGKILL
                else:
                    continue
            del running[job]
            if process.returncode == 0:
                longest = time.monotonic() - begun
            else:
                waiting.append(job)
        time.sleep(0.002)
    return kills, watch.tell()


def calculate_by_pools(case, folder, options):
    """(broken pools, time): talus.study with a ProcessPoolExecutor, again with another one when it is broken."""
    import talus

    draw, spent, broken = random.Random(options.seed), Watch(), 0
    while True:
        with concurrent.futures.ProcessPoolExecutor(options.workers) as pool:
            ended = []

            def watch(_):
                ended.append(1)
                if len(ended) == JOBS_BETWEEN_KILLS:
                    draw.choice(list(pool._processes.values())).kill()

            try:
                talus.study(case, folder, executor=pool, jobs=options.jobs, resume=True, progress=watch, report=False)
                return broken, spent.tell()
            except talus.Interrupted:
                broken += 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--case", default=str(ROOT / "examples/probability_of_failure/case.toml"))
    parser.add_argument("--jobs", type=int, default=100)
    parser.add_argument("--workers", type=int, default=4)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    program, faults = str(pathlib.Path(options.program).resolve()), 0
    with tempfile.TemporaryDirectory() as name:
        place = pathlib.Path(name)
        seconds = run_program(program, options.case, "-o", place / "one", "--no-report")
        whole = (place / "one/samples.csv").read_bytes()
        print(f"one process, all cores: {seconds}, {len(whole.splitlines()) - 1} samples")
        one_thread = run_program(program, options.case, "-o", place / "one_thread", "--no-report", "--threads", 1)
        print(f"one process, one thread: {one_thread}")

        def collect(way, folder, kills, spent):
            nonlocal faults
            told = run_program(program, folder, "--collect", "--no-report")
            same = (folder / "samples.csv").read_bytes() == whole
            faults += not same
            print(f"{way}: {options.jobs} jobs, {kills}, {spent}, collected in {told}, "
                  + ("bitwise identical" if same else "NOT IDENTICAL"))

        for way, killed in (("commands", 0), ("commands, killed at random", KILLED)):
            folder = place / f"commands_{killed}"
            prepared = run_program(program, options.case, "--prepare", folder, "--jobs", options.jobs)
            kills, spent = calculate_by_commands(program, folder, options, killed)
            collect(f"{way} (prepared in {prepared})", folder, f"{kills} killed", spent)
        try:
            broken, spent = calculate_by_pools(options.case, place / "pools", options)
            collect("ProcessPoolExecutor, killed at random", place / "pools", f"{broken} pools broken", spent)
        except ImportError as error:
            print(f"SKIP: Python executors were NOT tried: {error}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
