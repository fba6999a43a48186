# SPDX-License-Identifier: MIT
"""What every campaign needs: a run of the program with its verdict, folders that are compared, and the table."""
import dataclasses
import hashlib
import json
import pathlib
import random
import subprocess

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


def run(program, arguments, limit=120, cwd=None, env=None, prefix=()):
    """One command. A signal, an internal error, an end without a sentence and a timeout are faults."""
    process = subprocess.Popen([*prefix, str(program), *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, cwd=cwd, env=env)
    try:
        said = process.communicate(timeout=limit)[1].decode(errors="replace")
    except subprocess.TimeoutExpired:
        process.terminate()  # a long run is no fault when it ends in order
        try:
            said = process.communicate(timeout=60)[1].decode(errors="replace")
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return Verdict(-9, "", "it does not end after SIGTERM")
    code = process.returncode
    if code < 0:
        return Verdict(code, said, f"signal {-code}")
    if code not in CODES:
        return Verdict(code, said, f"code {code}: {said.strip()[-200:]}")
    if code != 0 and "error: " not in said:
        return Verdict(code, said, f"code {code} without a sentence")
    return Verdict(code, said)


def strip(tree):
    """A result without what differs from run to run."""
    if isinstance(tree, dict):
        return {key: strip(value) for key, value in tree.items() if key not in TIMES}
    return [strip(value) for value in tree] if isinstance(tree, list) else tree


def read_folder(folder):
    """name → what is the same in two runs of one case: the bytes of a file, or a JSON tree without its times."""
    kept = {}
    for path in sorted(pathlib.Path(folder).rglob("*")):
        if not path.is_file() or path.suffix == ".html" or path.name == "talus.files":  # hashes of files with times
            continue
        name = path.relative_to(folder).as_posix()
        if path.suffix == ".json":
            kept[name] = strip(json.loads(path.read_text()))
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
        fault = fault or verdict.fault
        if fault:
            self.faults.append({"case": label, "fault": fault, "said": verdict.said.strip()[-300:]})
            print(f"FAULT {self.name} {label}: {fault}", flush=True)

    def tell(self):
        return {"campaign": self.name, "what": self.what, "tried": self.tried, "codes": {str(k): v for k, v in sorted(self.codes.items())},
                "faults": self.faults}


def seed(name, number):
    return random.Random(f"{name} {number}")
