# SPDX-License-Identifier: MIT
"""Signals at random moments of every method, and commands that read a folder while a run calculates in it."""
import shutil
import signal
import subprocess
import time

from reliability.kept_files import CASES, LEM, STUDY, make_command
from reliability.trial import ROOT, SMALL, Process, Table, compare, read_folder, run, seed

MOST_SECONDS, MOST_WALL = 1, 10  # after a signal: processor time, and time on the clock of a busy machine
MOTION = SMALL.replace('methods = ["mpm", "lem"]', 'methods = ["mpm"]').replace("mesh.size = 0.9", "mesh.size = 0.5")
FULL_LEM = """[analysis]
methods = ["lem"]
[lem]
methods = ["spencer", "bishop"]
"""
SEEPAGE = ["--set", "mesh.size=1.5", "--set", "lem.referee=false", "--set", "lem.entry_exit.entries=6", "--set", "lem.entry_exit.exits=6"]
# name → text of the case or its file, command, more options (none: with its report)
METHODS = {
    "slices": (LEM.split("[analysis]")[0] + FULL_LEM, "run", []),
    "FEM": (LEM.split("[analysis]")[0] + '[analysis]\nmethods = ["fem"]\n[fem]\nsize = 1.2\n', "run", []),
    "limit analysis": (LEM.split("[analysis]")[0] + '[analysis]\nmethods = ["bounds"]\n[bounds]\ngap = 0.03\n', "run", []),
    "MPM": (MOTION, "run", []),
    "strength reduction": (CASES["curve"][0].replace("enabled = false", "enabled = true"), "run", []),
    "seepage in time": (ROOT / "examples" / "reservoir_drawdown" / "case.toml", "run", SEEPAGE),
    "initial stress by elements": (MOTION.replace("mesh.size = 0.5", "mesh.size = 0.4").replace("duration = 2,", "duration = 0.1,")
                                   .replace("duration = 3,", "duration = 0.2,") + '[initial]\nstress = "elements"\n', "run", []),
    "samples": (LEM + '[study]\nmode = "sample"\nsamples = 3000\n[[study.random]]\nkey = "materials.soil.cohesion"\ndeviation = 3.6\n', "study", []),
    "report of a run": (MOTION, "run", None),
    "study": (LEM.replace("depths = 9", "depths = 90") + STUDY, "study", []),
}
REPORT = "report"


def make_method_command(name, work, folder):
    """The command of a method, and the same that resumes."""
    case, command, more = METHODS[name]
    path = case
    if isinstance(case, str):
        path = work / f"{name.replace(' ', '_')}.toml"
        path.write_text(case)
    return [command, path, "-o", folder, "-q", "--threads", "1", "--resume", *(["--no-report", *more] if more is not None else [])]


class Undisturbed:
    """Each method once without a signal: its results and its processor time; and a folder to report on."""

    def __init__(self, program, work):
        self.program, self.work, self.known = program, work, {}

    def get(self, name):
        if name not in self.known:
            folder = self.work / f"good_{name.replace(' ', '_')}"
            shutil.rmtree(folder, ignore_errors=True)
            command = make_method_command("MPM" if name == REPORT else name, self.work, folder)
            verdict = run(self.program, command, 300)
            if verdict.code == 0 and name == REPORT:
                verdict = run(self.program, [REPORT, folder])
            if verdict.code != 0:
                raise SystemExit(f"the case '{name}' of the campaigns does not run: {verdict.said}")
            self.known[name] = (read_folder(folder), verdict.seconds)
        return self.known[name]


def interrupt(program, command, share, seconds, number):
    """Sends the signal when the command has used `share` of its seconds. Returns its verdict, and the processor time and the time on the clock until its end."""
    process = Process(program, command)
    while process.wait_for_seconds(share * seconds) and not process.catches(number) and process.read_seconds() < seconds * 0.8:
        time.sleep(0.003)
    if process.wait(0):
        return process.judge(), 0, 0
    before, begin = process.read_seconds(), time.monotonic()
    process.signal(number)
    if not process.wait(120):
        process.signal(signal.SIGKILL)
        process.wait(60)
    wall = time.monotonic() - begin
    return process.judge(), process.read_seconds() - before, wall


def judge_end(verdict, seconds, wall):
    """Why an end after a signal is a fault: another code, or too late."""
    if verdict.fault:
        return verdict.fault
    if verdict.code not in (0, 5):
        return f"code {verdict.code}: {verdict.said.strip()[-200:]}"
    if seconds > MOST_SECONDS or wall > MOST_WALL:
        return f"it ended {seconds:.1f} s of processor time and {wall:.1f} s after the signal"
    return ""


def try_signals(program, numbers, work):
    table = Table("signals", "")
    largest_seconds = largest_wall = 0
    references = Undisturbed(program, work)
    names = [*METHODS, REPORT]
    for trial in numbers:
        rng = seed("signals", trial)
        name = names[trial % len(names)]
        folder = work / "stopped"
        shutil.rmtree(folder, ignore_errors=True)
        reference, total = references.get(name)
        if name == REPORT:
            shutil.copytree(work / "good_report", folder)
            (folder / "report.html").unlink()
            command = [REPORT, folder]
        else:
            command = make_method_command(name, work, folder)
        for turn in range(rng.choice((1, 1, 2))):
            number, share = rng.choice((signal.SIGTERM, signal.SIGINT)), rng.uniform(0.6 if name == "report of a run" else 0.03, 1)
            verdict, seconds, wall = interrupt(program, command, share, total, number)
            largest_seconds, largest_wall = max(largest_seconds, seconds), max(largest_wall, wall)
            table.add(f"{trial} ({name}, {number.name} at {share:.2f} of {total:.1f} s, turn {turn + 1})", verdict, judge_end(verdict, seconds, wall))
        ended = run(program, command, 300)
        table.add(f"{trial} ({name}, resumed)", ended,
                  f"not resumed: {ended.said.strip()[-200:]}" if ended.code != 0 else compare(reference, folder)
                  or ("no report" if name == REPORT and not (folder / "report.html").exists() else ""))
    table.what = (f"SIGTERM and SIGINT at random moments of every method and of a report, then `--resume`: bitwise identical; ends within {largest_seconds:.2f} s of processor "
                  f"time and {largest_wall:.1f} s on the clock")
    return table


READ = """import h5py, sys
for path in sys.argv[1:]:
    with h5py.File(path) as file:
        file.visititems(lambda name, item: item[()] if isinstance(item, h5py.Dataset) else None)
"""


def find_fault_of_hdf5(folder):
    """The error of h5py in reading all result files; empty where it reads every data set, or is not there."""
    python = "/usr/bin/python3"
    paths = sorted(map(str, folder.rglob("*.vtkhdf")))
    if not paths or subprocess.run([python, "-c", "import h5py"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
        return ""
    read = subprocess.run([python, "-c", READ, *paths], stderr=subprocess.PIPE, text=True, check=False)
    return f"h5py: {read.stderr.strip()[-200:]}" if read.returncode else ""


def start_beside(program, name, work, folder, rng, seconds):
    """A run in the folder, begun anew, or resumed after a kill."""
    shutil.rmtree(folder, ignore_errors=True)
    is_resumed = rng.random() < 0.4
    if is_resumed:
        killed = Process(program, make_command(name, work, folder))
        killed.wait_for_seconds(rng.uniform(0.2, 0.7) * seconds)
        killed.signal(signal.SIGKILL)
        killed.wait(60)
        killed.judge()
    return Process(program, make_command(name, work, folder, "--resume")), is_resumed


def try_readers(program, numbers, work):
    table = Table("readers", "`report`, `plot` and `collect` again and again beside a run: an answer or code 3, and the run's end is whole")
    known = {}
    for trial in numbers:
        rng = seed("readers", trial)
        name = rng.choice(("points", "points", "curve", "study"))
        folder = work / "read"
        if name not in known:
            shutil.rmtree(folder, ignore_errors=True)
            verdict = run(program, make_command(name, work, folder))
            known[name] = (read_folder(folder), verdict.seconds)
        reference, seconds = known[name]
        process, is_resumed = start_beside(program, name, work, folder, rng, seconds)
        while not (folder / "talus.lock").exists() and not process.wait(0.01):
            pass
        while not process.wait(0):
            parts = [p.parent for p in folder.rglob("talus.files")] or [folder]
            part = rng.choice((folder, rng.choice(parts)))
            command = [rng.choice(("report", "plot", "collect")), part]
            said = run(program, command)
            codes = (0, 2, 3) if is_resumed or part != folder else (0, 3)
            table.add(f"{trial} ({name}, {command[0]} {part.relative_to(work)})", said, "" if said.code in codes else f"code {said.code}: {said.said.strip()[-200:]}")
        ended = process.judge()
        if ended.code == 3 and is_resumed:  # a reader was first
            ended = run(program, make_command(name, work, folder, "--resume"))
        for drawn in [*folder.rglob("*.svg"), *folder.rglob("*.gp"), *folder.rglob("*.png")]:
            if drawn.relative_to(folder).as_posix() not in reference:
                drawn.unlink()
        table.add(f"{trial} ({name}, end{' of the resumed run' if is_resumed else ''})", ended,
                  f"code {ended.code}: {ended.said.strip()[-200:]}" if ended.code != 0 else compare(reference, folder) or find_fault_of_hdf5(folder))
    return table
