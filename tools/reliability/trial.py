# SPDX-License-Identifier: MIT
"""Common parts of the campaigns: a run of the program with its verdict, comparison of folders, and the table."""
import dataclasses
import hashlib
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CODES = {0, 2, 3, 4, 5, 6, 7}  # of docs/manual/command-line.md; 1 is a defect of the program
TIMES = {"wall", "timing", "started", "seconds", "cpu", "machine", "circles_per_second", "compute", "threads"}

# A run of a wet slope with frames, histories and checkpoints, in a second or two.
SMALL = """title = "small"
geometry.box = [[0, 0], [14, 6]]
geometry.polygon = [{ name = "soil", points = [[0, 0], [14, 0], [14, 1.5], [9, 1.5], [5, 5], [0, 5]] }]
mesh.size = 0.9
regions.soil = "silt"
boundary = [{ on = "bottom", fix = "full" }, { on = "left", fix = "normal" }, { on = "right", fix = "normal" }]
stage = [
  { name = "weight", duration = 3, until = "rest", geometry = "frozen", damping = 0.75 },
  { name = "slide", duration = 2, damping = 0.1, reset_displacement = true }]
[analysis]
methods = ["mpm", "lem"]
[lem]
methods = ["spencer"]
noncircular = false
[materials.silt]
model = "mohr_coulomb"
grain_density = 2650
porosity = 0.42
young_modulus = "15 MPa"
poisson_ratio = 0.3
cohesion = "1 kPa"
friction_angle = "28 deg"
dilatancy_angle = 0
tensile_strength = 0
[output]
frame_interval = 0.2
history_interval = 0.05
checkpoint_interval = 0.02
"""


@dataclasses.dataclass
class Verdict:
    code: int
    said: str
    fault: str = ""  # why this end is a fault of the program; empty where it is none
    printed: str = ""  # standard output
    seconds: float = 0  # processor time, that of child processes as well
    megabytes: float = 0  # the largest memory of one process


def find_fault(code, said):
    """Why an end is a fault of the program: a signal, an internal error, no sentence."""
    if code < 0:
        return f"signal {-code}"
    if code not in CODES:
        return f"code {code}: {said.strip()[-200:]}"
    return f"code {code} without a sentence" if code != 0 and "error: " not in said else ""


class Process:
    """One command in the background, what it prints, and what it uses."""

    def __init__(self, program, arguments, cwd=None, env=None, prefix=()):
        self.out, self.err = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        self.popen = subprocess.Popen([*prefix, str(program), *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=self.out, stderr=self.err,
                                      cwd=cwd, env=env)
        self.usage = None

    def wait(self, limit):
        """True when it has ended within `limit` seconds."""
        end = time.monotonic() + limit
        while self.popen.returncode is None:
            pid, status, usage = os.wait4(self.popen.pid, os.WNOHANG)
            if pid:
                self.popen.returncode, self.usage = os.waitstatus_to_exitcode(status), usage
            elif time.monotonic() > end:
                return False
            else:
                time.sleep(0.003)
        return True

    def signal(self, number):
        if self.popen.returncode is None:
            os.kill(self.popen.pid, number)

    def read_seconds(self):
        """Processor time so far [s], that of child processes as well."""
        if self.usage:
            return self.usage.ru_utime + self.usage.ru_stime
        return sum(map(read_seconds, list_family(self.popen.pid)))

    def catches(self, number):
        """Returns whether the program handles this signal; while it is being loaded it does not."""
        try:
            caught = re.search(r"SigCgt:\s*(\w+)", pathlib.Path(f"/proc/{self.popen.pid}/status").read_text())
        except OSError:
            return False
        return caught is not None and int(caught[1], 16) >> (number - 1) & 1 == 1

    def wait_for_seconds(self, seconds, limit=300):
        """True when it has used so much processor time, false when it ended before."""
        end = time.monotonic() + limit
        while not self.wait(0) and time.monotonic() < end:
            if self.read_seconds() >= seconds:
                return True
        return False

    def judge(self):
        """The verdict when it has ended."""
        texts = []
        for stream in (self.out, self.err):
            stream.seek(0)
            texts.append(stream.read().decode(errors="surrogateescape"))
            stream.close()
        code = self.popen.returncode
        return Verdict(code, texts[1], find_fault(code, texts[1]), texts[0], self.usage.ru_utime + self.usage.ru_stime, self.usage.ru_maxrss / 1e3)


def list_family(pid):
    """A process and its children, as far as they live."""
    family = [pid]
    for one in family:
        try:
            for thread in os.listdir(f"/proc/{one}/task"):
                family += map(int, pathlib.Path(f"/proc/{one}/task/{thread}/children").read_text().split())
        except OSError:  # it ended just now
            pass
    return family


def read_seconds(pid):
    """Processor time [s] of a process and of the children that it has waited for; 0 when it has ended."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0
    return sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")


def run(program, arguments, limit=120, cwd=None, env=None, prefix=(), must_end=False):
    """One command. A signal, an internal error and an end without a sentence are faults; so is more than `limit` seconds, with `must_end` in any case and
    else where it does not end after SIGTERM."""
    process = Process(program, arguments, cwd, env, prefix)
    if not process.wait(limit):
        process.signal(signal.SIGTERM)  # a long run is no fault when it ends in order
        is_ended = process.wait(60)
        if not is_ended:
            process.signal(signal.SIGKILL)
            process.wait(60)
        verdict = process.judge()
        if must_end or not is_ended:
            verdict.fault = f"it does not end in {limit} s" if must_end else "it does not end after SIGTERM"
        return verdict
    return process.judge()


def snapshot(*folders):
    """path → what lies there: the hash of a file, the target of a link, or "folder"."""
    found = {}
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.is_symlink():
                found[str(path)] = f"link to {os.readlink(path)}"
            elif path.is_file():
                found[str(path)] = hashlib.sha256(path.read_bytes()).hexdigest()
            else:
                found[str(path)] = "folder"
    return found


def tell_difference(before, after):
    """The first path that differs in two snapshots; empty where none does."""
    for path in sorted(set(before) | set(after)):
        if before.get(path) != after.get(path):
            return f"{path} is {'new' if path not in before else 'gone' if path not in after else 'changed'}"
    return ""


def strip(tree):
    """A result without what differs from run to run."""
    if isinstance(tree, dict) and "wall time" in str(tree.get("name")):  # a column of a study
        return {}
    if isinstance(tree, dict):
        return {key: strip(value) for key, value in tree.items()
                if key not in TIMES and not key.endswith("_seconds") and not str(value).startswith("Computing time:")}
    return [strip(value) for value in tree] if isinstance(tree, list) else tree


def strip_table(text, separator):
    """The text of a table without its wall times."""
    time_column, lines = None, []
    for line in text.splitlines():
        cells = line.split(separator)
        if any("wall time" in cell for cell in cells):
            time_column = len(cells) - [i for i, cell in enumerate(cells) if "wall time" in cell][0]
        if time_column and len(cells) >= time_column:
            del cells[-time_column]
        lines.append(re.sub(r": [\d.,]+ (s|min|h)\.", "", separator.join(cells)))
    return lines


def read_folder(folder):
    """name → what is the same in two runs of one case: the bytes of a file, or a JSON tree without its times."""
    kept = {}
    for path in sorted(pathlib.Path(folder).rglob("*")):
        if not path.is_file() or path.suffix == ".html" or path.name == "talus.files":  # hashes of files with times
            continue
        name = path.relative_to(folder).as_posix()
        if path.suffix == ".json":
            kept[name] = strip(json.loads(path.read_text()))
        elif path.name in ("study.csv", "study.md"):  # tables with a column of times, and a sentence
            kept[name] = strip_table(path.read_text(), "," if path.suffix == ".csv" else "|")
        else:
            kept[name] = hashlib.sha256(path.read_bytes()).hexdigest()
    return kept


def compare(reference, folder):
    """The first difference of two folders; empty where they hold the same."""
    here = read_folder(folder)
    for name in sorted(set(reference) | set(here)):
        if name not in here or name not in reference:
            return f"{name} is only in one of the folders"
        if reference[name] != here[name]:
            return f"{name} differs"
    return ""


def damage(data, rng):
    """The bytes with one fault of a disk or a transfer."""
    data = bytearray(data)
    at, length = rng.randrange(len(data)), rng.choice((1, 1, 1, 2, 8, 64, 512))
    kind = rng.choice(("flip", "flip", "flip", "zero", "noise", "cut", "move"))
    if kind == "flip":
        data[at] ^= 1 << rng.randrange(8)
    elif kind == "zero":
        data[at:at + length] = bytes(min(length, len(data) - at))
    elif kind == "noise":
        data[at:at + length] = rng.randbytes(min(length, len(data) - at))
    elif kind == "cut":
        del data[at:]
    else:
        other = rng.randrange(len(data))
        data[at:at + length] = data[other:other + length]
    return bytes(data)


class Table:
    """Counts and faults of one campaign."""

    def __init__(self, name, what):
        self.name, self.what, self.tried, self.faults, self.codes = name, what, 0, [], {}

    def add(self, label, verdict, fault=""):
        self.tried += 1
        self.codes[verdict.code] = self.codes.get(verdict.code, 0) + 1
        fault = (fault or verdict.fault).encode(errors="backslashreplace").decode()
        if fault:
            said = verdict.said.strip()[-300:].encode(errors="backslashreplace").decode()
            self.faults.append({"case": label, "fault": fault, "said": said})
            print(f"FAULT {self.name} {label}: {fault}", flush=True)

    def tell(self):
        return {"campaign": self.name, "what": self.what, "tried": self.tried, "codes": {str(k): v for k, v in sorted(self.codes.items())},
                "faults": self.faults}


def seed(name, number):
    return random.Random(f"{name} {number}")
