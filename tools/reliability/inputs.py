# SPDX-License-Identifier: MIT
"""Devices, pipes, folders and links in the place of every file that a user names, and case files that ask for too much: a sentence in bounded time and memory."""
import os
import shutil
import socket

from reliability.kept_files import LEM, STUDY
from reliability.trial import SMALL, Table, run, seed

MOST_SECONDS, MOST_MEGABYTES = 10, 500
# So that a fault does not take the machine along: seconds of processor time, and bytes of address space.
LIMITS = ("prlimit", "--cpu=60", "--as=12000000000")
HEAD = """title = "block"
boundary = [{ on = "bottom", fix = "full" }]
stage = [{ name = "weight", duration = 0.1, damping = 0.3 }]
"""
SECTION = """geometry.box = [[0, 0], [4, 3]]
geometry.polygon = [{ name = "soil", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
mesh.size = 1
"""
SOIL = """regions.soil = "clay"
[materials.clay]
model = "mohr_coulomb"
cohesion = 5
friction_angle = 30
young_modulus = "5 MPa"
poisson_ratio = 0.3
dilatancy_angle = 0
tensile_strength = 0
grain_density = 2700
porosity = 0.37
"""
CURVE = """[[test]]
name = "t"
material = "clay"
kind = "drained_triaxial"
confining_pressure = 100
axial_strain = [10]
[calibration]
[[calibration.parameter]]
key = "materials.clay.cohesion"
min = 1
max = 10
[[calibration.curve]]
test = "t"
x = "axial_strain"
y = "q"
file = "x.csv"
"""
EXTERNAL = """regions.soil = "clay"
[materials.clay]
model = "external"
library = "x.so"
symbol = "umat_"
constants = [0]
constrained_modulus = "8 MPa"
grain_density = 2700
porosity = 0.37
"""
OUTPUT = ("-q", "--threads", "1")
# Keys of a case: the file that one names, the case, the commands that read it.
KEYS = (("x.msh", HEAD + 'mesh = { file = "x.msh", points_per_element = 1 }\n' + SOIL, ("check", "run", "study")),
        ("x.csv", HEAD + SECTION + 'hydraulic = [{ on = "top", condition = "rain", rate = { file = "x.csv", column = "rain" } }]\n' + SOIL, ("check", "run", "plot")),
        ("x.csv", HEAD + SECTION + SOIL + CURVE, ("check", "calibrate", "point")),
        ("x.so", HEAD + SECTION + EXTERNAL, ("check", "run", "point")),
        ("before/end_state.h5", HEAD + SECTION + SOIL + '[initial]\nresult = "before"\n', ("check", "run")),
        ("before/summary.json", HEAD + SECTION + SOIL + '[initial]\nresult = "before"\n', ("check", "run")),
        ("before", HEAD + SECTION + SOIL + '[initial]\nresult = "before"\n', ("check", "run")))
# Arguments of commands: x is no file, good are results, jobs are those of a study, small.toml is a case.
ARGUMENTS = (("check", "x"), ("run", "x"), ("study", "x"), ("point", "x"), ("calibrate", "x"), ("plot", "x"), ("report", "x"), ("collect", "x"), ("study", "x", "--job", "0"),
             ("study", "x", "--collect"), ("study", "circles.toml", "--prepare", "x"), ("run", "circles.toml", "-o", "x", *OUTPUT),
             ("run", "circles.toml", "-o", "x", "--overwrite", *OUTPUT), ("run", "circles.toml", "-o", "x", "--resume", *OUTPUT), ("study", "circles.toml", "-o", "x", *OUTPUT),
             ("plot", "good", "--out", "x.svg"), ("plot", "good", "--out", "x"), ("run", "circles.toml", "-o", "x/y", *OUTPUT))
# Files of results and of jobs, and the commands that read them.
RESULTS = ("summary.json", "results.vtkhdf", "results.xdmf", "history.csv", "lem.json", "mesh.h5", "end_state.h5", "profile.csv", "report.html", "talus.files", "talus.lock",
           "frames", "frames/000000.h5", "checkpoint.h5", "stages.json", "section.svg")
OF_RESULTS = (("report", "good"), ("plot", "good"), ("collect", "good"), ("run", "small.toml", "-o", "good", "--resume", *OUTPUT),
              ("run", "small.toml", "-o", "good", "--overwrite", *OUTPUT))
JOBS = ("jobs.json", "case/case.toml", "case", "surfaces.json", "jobs/0/result.json", "jobs/0", "talus.files", "talus.lock")
OF_JOBS = (("study", "jobs", "--job", "0", "--threads", "1"), ("study", "jobs", "--collect", "--threads", "1"),
           ("study", "circles.toml", "--prepare", "jobs", "--overwrite"))


def make_socket(path):
    here = os.getcwd()
    os.chdir(path.parent)  # names of sockets are short
    with socket.socket(socket.AF_UNIX) as one:
        one.bind(path.name)
    os.chdir(here)


def make_sparse(path):
    path.touch()
    os.truncate(path, 5_000_000_000)


def make_unreadable(path):
    path.write_text("secret")
    path.chmod(0)


KINDS = {
    "/dev/zero": lambda path: path.symlink_to("/dev/zero"),
    "/dev/full": lambda path: path.symlink_to("/dev/full"),
    "/dev/urandom": lambda path: path.symlink_to("/dev/urandom"),
    "/proc/kmsg": lambda path: path.symlink_to("/proc/kmsg"),
    "/proc/self/mem": lambda path: path.symlink_to("/proc/self/mem"),
    "a pipe": os.mkfifo,
    "a folder": os.mkdir,
    "5 GB": make_sparse,
    "a socket": make_socket,
    "a dangling link": lambda path: path.symlink_to("nowhere"),
    "a link to itself": lambda path: path.symlink_to(path.name),
    "a link to a file of the user": lambda path: path.symlink_to(path.parent / "precious"),
    "unreadable": make_unreadable,
}
# Root reads all files unless these rights are taken.
PLAIN_USER = ("setpriv", "--bounding-set=-dac_override,-dac_read_search", "--inh-caps=-dac_override,-dac_read_search")


def remove(path):
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def put(path, kind):
    """Puts a device, a pipe or the like in the place of a file."""
    remove(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    if kind == "a link to a file of the user":
        (path.parent / "precious").write_text("mine")
    KINDS[kind](path)


def judge(verdict, folder):
    """The bound that was passed, or the file of the user behind a link that changed; empty where there is none."""
    if verdict.fault:
        return verdict.fault
    if verdict.seconds > MOST_SECONDS or verdict.megabytes > MOST_MEGABYTES:
        return f"{verdict.seconds:.1f} s of processor time and {verdict.megabytes:.0f} MB"
    if any(path.read_text() != "mine" for path in folder.rglob("precious")):
        return "the file behind a link has changed"
    return ""


def draw_command(rng, folder, work):
    """Puts one kind into one place; the label, the command, and whether it must be refused."""
    kind = rng.choice(list(KINDS))
    what = rng.randrange(4)
    if what == 0:
        name, text, commands = rng.choice(KEYS)
        (folder / "case.toml").write_text(text)
        put(folder / name, kind)
        command = (rng.choice(commands), "case.toml")
        return f"{name} of a case is {kind}, {command[0]}", command, command[0] not in ("plot", "point")
    if what == 1:
        command = rng.choice(ARGUMENTS)
        put(folder / next(one for one in command if one.startswith("x")).split("/")[0], kind)
        if "good" in command:
            shutil.copytree(work / "good", folder / "good")
        return f"{' '.join(command)}, x is {kind}", command, False
    where, names, commands = ("good", RESULTS, OF_RESULTS) if what == 2 else ("jobs", JOBS, OF_JOBS)
    name, command = rng.choice(names), rng.choice(commands)
    shutil.copytree(work / where, folder / where)
    put(folder / where / name, kind)
    return f"{where}/{name} is {kind}, {' '.join(command[:3])}", command, False


def write_list(count, text):
    return "".join(text.replace("N", str(i)) for i in range(count))


def make_large(rng):
    """A case that asks for much: what it is, and its text."""
    count, size = round(10**rng.uniform(2, 5.5)), 10**rng.uniform(-9, 0)
    saw = ", ".join(f"[{4 - 4 * i / count:.7g}, {2 + (i % 2) * 0.1}]" for i in range(count + 1))
    stairs = SECTION.replace("[4, 2], [0, 2]]", saw + "]")
    makers = {
        "corners": lambda: HEAD + stairs + SOIL,
        "corners of circles": lambda: LEM.replace("[40, 15], [15, 15]", "[40, 15], " + ", ".join(f"[{40 - 25 * i / count:.7g}, {15 + (i % 2) * 0.01}]" for i in range(1, count))
                                                  + ", [15, 15]"),
        "materials": lambda: HEAD + SECTION + SOIL + write_list(count, "[materials.mN]\nmodel = 'elastic'\n"),
        "polygons": lambda: HEAD + SECTION.replace("geometry.polygon = [", "geometry.polygon = [" + write_list(count, "{ name = 'pN', points = [[N, 0], [N, 1], [N.5, 1]] },"))
        + SOIL,
        "monitors": lambda: HEAD + SECTION + SOIL + write_list(count, "[[output.monitor]]\nname = 'mN'\nat = [1, 1]\n"),
        "sections": lambda: HEAD + SECTION + SOIL + write_list(count, "[[output.section]]\nname = 'sN'\nfrom = [1, 0]\nto = [1, 2]\n"),
        "stages": lambda: HEAD.replace("stage = [", "stage = [" + write_list(count, "{ name = 'sN', duration = 1 },")) + SECTION + SOIL,
        "loads": lambda: HEAD + SECTION + f"surcharge = [{write_list(count, '{ x = [1, 2], load = [1, 1] },')}]\n" + SOIL,
        "rows": lambda: HEAD + SECTION + f"traction = [{{ on = 'top', traction = [0, 0], factor = [{write_list(count, '[N, 1],')}] }}]\n" + SOIL,
        "surfaces": lambda: LEM + write_list(count, "[[lem.surface]]\nname = 'sN'\ncentre = [10, 20]\nradius = 15\n"),
        "compared": lambda: LEM + write_list(count, "[[compare]]\nname = 'lem.bishop'\nvalue = N\n"),
        "values": lambda: LEM + STUDY.replace("16, 18, 20", write_list(count, "1N,")),
        "samples": lambda: LEM + f"[study]\nmode = 'sample'\nsamples = {count}000\n[[study.random]]\nkey = 'materials.soil.cohesion'\ndeviation = 3\n",
        "tests": lambda: HEAD + SECTION + SOIL + write_list(count, CURVE.split("[calibration]")[0].replace('"t"', '"tN"')),
        "lines": lambda: HEAD + SECTION + f"geometry.line = [{write_list(count, '{ name = ' + chr(39) + 'lN' + chr(39) + ', points = [[0, 1], [4, 1.N]] },')}]\n" + SOIL,
        "mesh size": lambda: HEAD + SECTION.replace("size = 1", f"size = {size:.3e}") + SOIL,
        "bounds size": lambda: LEM.replace('["lem"]', '["bounds"]') + f"[bounds]\nsize = {size:.3e}\n",
        "fem size": lambda: LEM.replace('["lem"]', '["fem"]') + f"[fem]\nsize = {size:.3e}\n",
        "circles": lambda: LEM.replace("entries = 15", f"entries = {count}").replace("depths = 9", f"depths = {count}"),
        "points of an element": lambda: HEAD + SECTION + f"mesh.points_per_element = {count}\n" + SOIL,
        "frames": lambda: HEAD + SECTION + SOIL + f"[output]\nframe_interval = {size:.3e}\n",
        "duration": lambda: HEAD.replace("0.1", f"{1 / size:.3e}") + SECTION + SOIL,
        "box": lambda: HEAD + SECTION.replace("[4, 3]]", f"[{count}, {count}]]") + SOIL,
        "title": lambda: HEAD.replace("block", "x" * count * 10) + SECTION + SOIL,
        "lists in lists": lambda: HEAD.replace('"block"', "[" * count + "]" * count),
        "parts of a key": lambda: ".".join("a" * (count // 2)) + " = 1\n" + HEAD,
        "faults": lambda: write_list(count, "keyN = 1\n") + HEAD,
    }
    kind = rng.choice(list(makers))
    return f"{kind}, {count} or {size:.1e}", makers[kind]()


def make_good(program, work):
    """Results and jobs that the files are put into."""
    (work / "small.toml").write_text(SMALL)
    (work / "circles.toml").write_text(LEM + STUDY)
    for folder in ("good", "jobs"):
        shutil.rmtree(work / folder, ignore_errors=True)
    for command in (["run", "small.toml", "-o", "good", *OUTPUT], ["study", "circles.toml", "--prepare", "jobs"], ["study", "jobs", "--job", "0", "--threads", "1"]):
        verdict = run(program, command, cwd=work)
        if verdict.code != 0:
            raise SystemExit(f"a case of the campaigns does not run: {verdict.said}")


def try_inputs(program, numbers, work):
    table = Table("inputs", "")
    make_good(program, work)
    largest_seconds = largest_megabytes = 0
    for number in numbers:
        rng = seed("inputs", number)
        folder = work / "now"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name in ("small.toml", "circles.toml"):
            shutil.copy(work / name, folder)
        must_fail = False
        if rng.random() < 0.35:
            label, text = make_large(rng)
            (folder / "large.toml").write_text(text)
            command = ("check", "large.toml")
        else:
            label, command, must_fail = draw_command(rng, folder, work)
        prefix = PLAIN_USER if os.geteuid() == 0 and "unreadable" in label else ()
        verdict = run(program, command, 120, cwd=folder, prefix=(*LIMITS, *prefix), must_end=True)
        largest_seconds, largest_megabytes = max(largest_seconds, verdict.seconds), max(largest_megabytes, verdict.megabytes)
        fault = judge(verdict, folder)
        table.add(f"{number} ({label})", verdict, fault or ("code 0 for what is no file" if must_fail and verdict.code == 0 else ""))
    table.what = (f"devices, pipes, folders, sockets, links and files of 5 GB in every place of a file, and case files that ask for too much: at most "
                  f"{largest_seconds:.1f} s of processor time and {largest_megabytes:.0f} MB")
    return table
