# SPDX-License-Identifier: MIT
"""Runs that are stopped at random, or whose disk is full, and resumed: nothing is lost."""
import json
import signal

from reliability.trial import Process, compare, read_folder, run

from .exits import draw_dam
from .refusals import make_bars, make_motion, make_nails
from .stages import make_column


def make_flow(trial):
    case, _ = draw_dam(trial)
    case["mesh"]["size"] = round(case["mesh"]["size"] * 0.35, 3)
    case["seepage"] = {"times": [1, 3, 10], "section": [{"name": "below", "points": [[4, -2], [4, 3]]}]}
    return case


def make_stages(trial):
    case, width, _, _ = make_column(trial, [0, 6, 8], 0.25)
    case["surcharge"] = [{"name": "fill", "x": [0, width], "load": [5, 5]}]
    case["hydraulic"] = [{"on": "ground", "condition": "total_head", "head": 8}]
    case["initial"]["water_table"] = [[0, 8], [width, 8]]
    case["construction"] = [{"name": n, "duration": 10, "factor": False, **more} for n, more in (("load", {"add": ["fill"]}), ("pause", {}), ("rest", {}))]
    return case


KINDS = {"seepage": make_flow, "stages": make_stages, "LEM": make_bars, "pit": make_nails, "MPM": make_motion}


def find_torn(folder):
    """The first file of JSON that is not whole; empty where all are."""
    for path in sorted(folder.rglob("*.json")):
        try:
            json.loads(path.read_text())
        except ValueError:
            return path.name
    return ""


def judge_stop(trial):
    """SIGTERM or SIGKILL at random moments, or files that may not grow; then `--resume` makes the folder of an undisturbed run, bit by bit."""
    name = list(KINDS)[trial.number % len(KINDS)]
    case = KINDS[name](trial)
    path = trial.write("case", case)
    words = ["run", path, "-q", "--no-report", "--threads", "1", "--resume", "-o"]
    whole = run(trial.program, [*words, trial.folder / "whole"])
    trial.expect(whole.code == 0, f"{name} ends with {whole.code}: {whole.said.strip()[-200:]}")
    if whole.code != 0:
        return
    reference = read_folder(trial.folder / "whole")
    folder, way = trial.folder / "stopped", trial.rng.choice(("SIGTERM", "SIGTERM", "SIGKILL", "disk"))
    if way == "disk":
        largest = max(p.stat().st_size for p in (trial.folder / "whole").rglob("*") if p.is_file()) // 1024 + 1
        blocks = trial.rng.randint(0, largest)
        verdict = run("bash", ["-c", f'ulimit -f {blocks}; exec "$0" "$@"', trial.program, *words, folder])
        trial.expect(verdict.code in (0, 6) and not verdict.fault, f"{name}, files of {blocks} KiB: {verdict.code}, {verdict.fault or verdict.said.strip()[-200:]}")
    for _ in range(trial.rng.choice((1, 1, 2, 3)) if way != "disk" else 0):
        process = Process(trial.program, [*words, folder])
        process.wait_for_seconds(trial.rng.uniform(0, 1.05) * whole.seconds)
        while way == "SIGTERM" and not process.catches(signal.SIGTERM) and not process.wait(0.002):
            pass
        process.signal(getattr(signal, way))
        is_ended = process.wait(60)
        trial.expect(is_ended, f"{name}: it does not end within a minute of {way}")
        if not is_ended:
            process.signal(signal.SIGKILL)
            process.wait(60)
        verdict = process.judge()
        trial.expect(way == "SIGKILL" or verdict.code in (0, 5), f"{name}: {way} ends it with {verdict.code}: {verdict.said.strip()[-200:]}")
        trial.expect(not find_torn(folder), f"{name}: after {way} {find_torn(folder)} is not whole")
    ended = run(trial.program, [*words, folder])
    trial.expect(ended.code == 0, f"{name}: --resume after {way} ends with {ended.code}: {ended.said.strip()[-200:]}")
    if ended.code == 0:
        difference = compare(reference, folder)
        trial.expect(not difference, f"{name}, resumed after {way}: {difference}")
