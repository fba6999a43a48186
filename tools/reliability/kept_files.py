# SPDX-License-Identifier: MIT
"""Folders of results after an end or a kill, with foreign files in them or listed files damaged: --overwrite, --resume and collect against the list of files."""
import os
import shutil
import signal

from reliability.trial import SMALL, Process, Table, compare, damage, read_folder, run, seed, snapshot, tell_difference

LEM = """title = "circles"
geometry.polygon = [{ name = "soil", points = [[-10, 0], [40, 0], [40, 15], [15, 15], [5, 5], [-10, 5]] }]
regions.soil = "soil"
[materials.soil]
model = "mohr_coulomb"
unit_weight = 18
cohesion = 18
friction_angle = 30
young_modulus = "20 MPa"
poisson_ratio = 0.3
dilatancy_angle = 0
tensile_strength = 0
[analysis]
methods = ["lem"]
[lem]
methods = ["bishop"]
noncircular = false
referee = false
entry_exit = { entries = 15, exits = 15, depths = 9 }
"""
STUDY = '[[study.vary]]\nkey = "materials.soil.cohesion"\nvalues = [16, 18, 20]\n'
SAMPLES = '[study]\nmode = "sample"\nsamples = 200\n[[study.random]]\nkey = "materials.soil.cohesion"\ndeviation = 3.6\n'
CURVE = SMALL.replace('methods = ["mpm", "lem"]', 'methods = ["mpm"]\nkind = "strength_reduction"').replace("frame_interval = 0.2\n", "") + """
[strength_reduction.curve]
smoothing = "none"
from = 0.8
to = 1.0
step = 0.2
refine = false
window = 0.3
[strength_reduction.frozen]
enabled = false
[[output.section]]
name = "cut"
from = [5, 0]
to = [5, 4]
"""
# name → text of the case, its command and the option before its folder of results
CASES = {
    "points": (SMALL, "run", "-o"),
    "curve": (CURVE, "run", "-o"),
    "circles": (LEM, "run", "-o"),
    "elements": (LEM.replace('["lem"]', '["lem", "fem"]') + "[fem]\nsize = 3\nresolution = 0.1\n", "run", "-o"),
    "study": (LEM + STUDY, "study", "-o"),
    "samples": (LEM + SAMPLES, "study", "-o"),
    "jobs": (LEM + STUDY, "study", "--prepare"),
}
STREWN = ("thesis.txt", "IMG_0012.png", "site_2023.png", "curve.png", "curve.csv", "section.gp", "section.svg", "notes.json", "summary.json.bak", "frames/photo.jpg",
          "frames/x.h5", "frames/000000.h5", "frames/000017.h5", "sections/mine.csv", "sections/cut.csv", "trials/a/b.txt", "trials/srf_0.8000/d.txt", "frozen/e.h5",
          "elements_1/f.txt", "released_later/g", "case/notes.md", "case/case.toml", "jobs/offer.txt", "jobs/0/log", "jobs/0/result.json", "results.vtkhdf.part",
          "results.vtkhdf", "report.html", "checkpoint.h5", "history.csv", "base/h.txt", "base/lem.json", "cohesion_16/lem.json", "mine/history.csv", "talus.lock.old", "stages.json", "lem.json", "study.csv", ".hidden", "a b\nc")
# Names that a command beside the run may renew, or that hold times.
OF_THE_HOUSE = ("talus.files", "talus.lock")


def make_command(name, work, folder, *more):
    """The command of a case; its file is written where it is missing."""
    text, command, option = CASES[name]
    path = work / f"{name}.toml"
    if not path.exists():
        path.write_text(text)
    return [command, path, option, folder, "-q", *([] if option == "--prepare" else ["--threads", "1", "--no-report"]), *more]


class References:
    """The undisturbed results of each case, calculated once, and the processor time that they took."""

    def __init__(self, program, work):
        self.program, self.work, self.known = program, work, {}

    def get(self, name):
        if name not in self.known:
            folder = self.work / f"good_{name}"
            shutil.rmtree(folder, ignore_errors=True)
            verdict = run(self.program, make_command(name, self.work, folder))
            if verdict.code != 0:
                raise SystemExit(f"the case '{name}' of the campaigns does not run: {verdict.said}")
            self.known[name] = (folder, read_folder(folder), verdict.seconds)
        return self.known[name]


def calculate(program, name, work, folder, rng, references):
    """A run that ends, or that a signal or a kill ends at a random fraction of its processor time. Returns how it ended."""
    shutil.rmtree(folder, ignore_errors=True)
    ends = rng.choice(("finished", "killed", "interrupted"))
    seconds = references.get(name)[2]
    process = Process(program, make_command(name, work, folder))
    share = rng.uniform(0.2, 1)
    while not (folder / "talus.files").exists() and not process.wait(0.003):
        pass
    if ends != "finished" and process.wait_for_seconds(share * seconds):
        process.signal(signal.SIGKILL if ends == "killed" else signal.SIGTERM)
    process.wait(300)
    process.judge()
    return ends


def strew(folder, rng):
    """Puts files of a user into a folder, and may edit results in it; returns their names and bytes."""
    placed = {}
    for name in rng.sample(STREWN, rng.choice((1, 2, 4, 8))):
        path = folder / name
        if path.exists() or any(parent.is_file() for parent in path.parents):
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"content of " + name.encode())
        placed[name] = path.read_bytes()
    own = sorted(p for p in folder.rglob("*") if p.is_file() and p.name not in OF_THE_HOUSE and p.relative_to(folder).as_posix() not in placed)
    if own and rng.random() < 0.3:
        path = rng.choice(own)
        path.write_bytes(path.read_bytes() + b"edited")
        placed[path.relative_to(folder).as_posix()] = path.read_bytes()
    return placed


def judge_overwrite(verdict, before, folder, placed, reference):
    """After --overwrite: all is as before, or what a new folder has, beside the files of the user."""
    if verdict.code == 3:
        return tell_difference(before, drop_own(snapshot(folder), folder))
    if verdict.code != 0:
        return f"code {verdict.code}: {verdict.said.strip()[-200:]}"
    for name, content in placed.items():
        if not (folder / name).is_file() or (folder / name).read_bytes() != content:
            return f"the file of the user {name!r} is gone or changed"
    fresh, names = reference
    left = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()} - set(placed)
    expected = {p.relative_to(fresh).as_posix() for p in fresh.rglob("*") if p.is_file()}
    if left - {"talus.lock"} != expected - {"talus.lock"}:
        return f"differs from a new folder in {sorted((left ^ expected) - {'talus.lock'})[:5]}"
    aside = folder.parent / "aside"
    for name in placed:
        (folder / name).rename(aside)
    return compare(names, folder)


def drop_own(found, folder):
    """A snapshot without the list and the lock of a folder."""
    return {path: what for path, what in found.items() if path not in {str(folder / name) for name in OF_THE_HOUSE}}


def refuse_target(program, name, work, folder, rng):
    """--overwrite of a folder that is not to be replaced: the label, the verdict and the fault."""
    kind = rng.choice(("case inside", "current folder", "below the current folder", "home", "repository", "no list"))
    inside = folder / "sub"
    inside.mkdir(exist_ok=True)
    (inside / "x").write_text("mine")
    command, cwd, env = make_command(name, work, folder, "--overwrite"), work, dict(os.environ)
    if kind == "case inside":
        shutil.copy(work / f"{name}.toml", inside / "case.toml")
        command[1] = inside / "case.toml"
    elif kind == "current folder":
        cwd, command[3] = folder, "."
    elif kind == "below the current folder":
        cwd = inside
    elif kind == "home":
        env["HOME"] = str(rng.choice((folder, inside)))
    elif kind == "no list":
        (folder / "talus.files").unlink(missing_ok=True)
    else:
        path = rng.choice((folder, inside)) / ".git" / "HEAD"
        path.parent.mkdir()
        path.write_text("ref: refs/heads/main")
    before = drop_own(snapshot(folder), folder)
    verdict = run(program, command, cwd=cwd, env=env)
    fault = tell_difference(before, drop_own(snapshot(folder), folder)) or ("" if verdict.code == 3 else f"code {verdict.code} where 3 was expected")
    return kind, verdict, fault


def try_files(program, numbers, work):
    table = Table("files", "`--overwrite` of finished, killed and interrupted results among files of a user, of the case, in a home, in a repository")
    references = References(program, work)
    for number in numbers:
        rng = seed("files", number)
        first, then = rng.choice(list(CASES)), rng.choice(list(CASES))
        folder = work / "out"
        ends = calculate(program, first, work, folder, rng, references)
        if not folder.exists():
            continue
        references.get(then)
        if rng.random() < 0.3:
            kind, verdict, fault = refuse_target(program, then, work, folder, rng)
            table.add(f"{number} ({first}, {ends}; {then}: {kind})", verdict, fault)
            continue
        placed = strew(folder, rng)
        before = drop_own(snapshot(folder), folder)
        verdict = run(program, make_command(then, work, folder, "--overwrite"))
        table.add(f"{number} ({first}, {ends}; {then} over {sorted(placed)})", verdict, judge_overwrite(verdict, before, folder, placed, references.get(then)[:2]))
    return table


def read_listed(folder):
    """The files of a folder and of the folders in it that a list names and that are there."""
    found = []
    for path in sorted(folder.rglob("talus.files")):
        names = {line.split(" ", 3 if line.startswith("write ") else 1)[-1] for line in path.read_text(errors="replace").splitlines()[1:] if " " in line}
        found += [path.parent / name for name in sorted(names) if (path.parent / name).is_file()]
    return sorted({p for p in found if p.stat().st_size > 0} | set(folder.rglob("talus.files")))


def damage_listed(folder, rng):
    """Loses, swaps, cuts or changes a listed file; returns what was done and the names that a sentence may have."""
    paths = read_listed(folder)
    path = rng.choice(paths)
    kind = rng.choice(("lost", "swapped", "cut", "changed", "changed"))
    names = [path.name]
    if kind == "lost":
        path.unlink()
    elif kind == "swapped":
        other = rng.choice([p for p in paths if p.suffix == path.suffix and p != path] or [p for p in paths if p != path] or paths)
        content = path.read_bytes()
        path.write_bytes(other.read_bytes())
        other.write_bytes(content)
        names.append(other.name)
    elif kind == "cut":
        path.write_bytes(path.read_bytes()[:rng.randrange(path.stat().st_size)])
    else:
        content = path.read_bytes()
        while path.read_bytes() == content:
            path.write_bytes(damage(content, rng))
    return f"{path.relative_to(folder)} {kind}", names


def is_kept_as_edited(label):
    """Reports and pictures, which may be edited."""
    return label.split(" ")[0].endswith((".html", ".svg", ".gp", ".png"))


def judge_resume(verdict, folder, label, names, reference):
    """After --resume of a damaged folder: a sentence that names a damaged file, or the undisturbed results."""
    if verdict.code != 0:
        return "" if any(name in verdict.said for name in names) or "talus.files" in label else f"names no damaged file: {verdict.said.strip()[-200:]}"
    if is_kept_as_edited(label) or label == "end_state.h5 lost":  # as docs/manual/results.md says
        return ""
    return compare(reference, folder)


def try_damage(program, numbers, work):
    table = Table("damage", "a listed file lost, swapped, cut or changed after an interruption; `--resume` and `collect` name it, or end bitwise identical")
    references = References(program, work)
    for number in numbers:
        rng = seed("damage", number)
        name = rng.choice([name for name in CASES if name != "jobs"])
        folder, same = work / "out", work / "same"
        ends = calculate(program, name, work, folder, rng, references)
        if not folder.exists() or not read_listed(folder):
            continue
        shutil.rmtree(same, ignore_errors=True)
        shutil.copytree(folder, same)
        what, names = damage_listed(folder, rng)
        label = f"{number} ({name}, {ends}: {what}"
        if rng.random() < 0.25:
            expected = run(program, ["collect", same])
            verdict = run(program, ["collect", folder])
            fault = ""
            if verdict.code == 0:
                made = {path.relative_to(same): path.read_bytes() for path in same.rglob("results.*")}
                fault = next((f"{path} differs" for path, content in made.items() if not (folder / path).is_file() or (folder / path).read_bytes() != content), "")
            elif expected.code == 0 and not any(one in verdict.said for one in names) and "talus.files" not in what:
                fault = f"names no damaged file: {verdict.said.strip()[-200:]}"
            table.add(f"{label}, collect)", verdict, fault)
            continue
        verdict = run(program, make_command(name, work, folder, "--resume"))
        table.add(f"{label}, --resume)", verdict, judge_resume(verdict, folder, what, names, references.get(name)[1]))
    return table
