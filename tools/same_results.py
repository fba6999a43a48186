#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the output of the examples and the published problems before and after a restructuring.

Usage: same_results.py store PROGRAM FOLDER [--only NAME …] [--jobs N]
       same_results.py compare FOLDER OTHER [--renamed OLD=NEW …] [--added KEY …]

`store` runs every example in a short form, and the published problems by LEM, and keeps per case: what was printed,
every JSON and CSV file, the data of the report page, and a SHA-256 of every other file. Times, machine and commit are
left out. `compare` names each value that differs, with its path; numbers must be bitwise identical, but 0 and 0.0 are
one. --renamed, --added: keys that moved or are new on purpose. Ends with 1 on a difference.
"""
import argparse
import concurrent.futures
import csv
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
COARSE = ["mesh.size=2", "strength_reduction.curve.step=0.25", "strength_reduction.curve.refine=false",
          "strength_reduction.curve.window=1", "strength_reduction.frozen.resolution=0.1"]
ONE_MESH = ["strength_reduction.frozen.meshes=1"]
# name → (command, case file below examples/ or tests/, overrides)
CASES = {
    "dry_slope": ("run", "examples/dry_slope/case.toml", COARSE),
    "dry_four_methods": ("run", "examples/dry_slope/four_methods.toml",
                          [*COARSE, *ONE_MESH, "strength_reduction.curve.runout=[1.75]", "fem.size=2", "fem.resolution=0.05"]),
    "dry_study": ("study", "examples/dry_slope/study.toml",
                  [*COARSE, *ONE_MESH, "strength_reduction.curve.runout=[]", "strength_reduction.curve.to=1.25"]),
    "dry_convergence_elements": ("study", "examples/dry_slope/convergence_elements.toml", ["fem.resolution=0.1"]),
    "unsaturated_three_methods": ("run", "examples/unsaturated_slope/three_methods.toml",
                                  [*COARSE, *ONE_MESH, "fem.size=2", "fem.resolution=0.05"]),
    "layered_embankment": ("run", "examples/layered_embankment/case.toml", ["fem.size=2", "fem.resolution=0.05"]),
    "storm_on_a_bank": ("run", "examples/storm_on_a_bank/case.toml", ["mesh.size=0.8"]),
    "season_before_a_storm": ("run", "examples/season_before_a_storm/case.toml", ["mesh.size=0.8"]),
    "vegetated_slope": ("study", "examples/vegetated_slope/case.toml", ["stage.1.duration=20"]),
    "centrifuge_slope": ("run", "examples/centrifuge_slope/case.toml", ["mesh.size=0.08"]),
    "triaxial_loess": ("point", "examples/triaxial_loess/case.toml", []),
    "triaxial_rooted_clay": ("point", "examples/triaxial_rooted_clay/case.toml", []),
    "calibrate_loess": ("calibrate", "examples/calibrate_loess/case.toml", []),
    "probability_of_failure": ("study", "examples/probability_of_failure/case.toml", ["study.samples=200"]),
    "column_collapse": ("run", "examples/column_collapse/case.toml", ["mesh.size=0.4"]),
    "sliding_block": ("run", "examples/sliding_block/case.toml", ["mesh.size=0.5"]),
    "slope_3d": ("run", "examples/slope_3d/case.toml", [*COARSE[1:], "mesh.size=4", *ONE_MESH]),
    "water_wave": ("run", "examples/verification/wave/case.toml", []),
    "water_darcy": ("run", "examples/verification/darcy/case.toml", ["mesh.size=0.2"]),
    "wet_bank": ("run", "tests/page/wet_bank.toml", []),
    "three_methods_page": ("run", "tests/page/three_methods.toml", []),
    "banks": ("study", "tests/page/banks.toml", []),
    "uncertain": ("study", "tests/page/uncertain.toml", []),
}
# Keys that differ from run to run, at any level of a JSON file.
VOLATILE = {"machine", "started", "commit", "version", "build_type", "compiler", "seconds", "wall", "cpu", "circles_per_second",
            "timing", "stage_steps", "date", "folder", "case_file"}
PAGE_DATA = re.compile(r'<script type="application/json" id="talus-report">(.*?)</script>', re.S)


SECONDS = re.compile(r"([:;]) [0-9.e+-]+ s\.$")  # of computing, at the end of a sentence


def strip_lines(text):
    """Tables without their column of the wall time, sentences without their seconds."""
    column = None
    for line in text.splitlines():
        if not line.startswith("|"):
            column = None
            yield SECONDS.sub(r"\1 … s.", line)
            continue
        cells = line.split("|")
        column = next((i for i, cell in enumerate(cells) if cell.strip().startswith("wall time")), column)
        if column is not None and column < len(cells):
            cells[column] = "…"
        yield "|".join(cells)


def strip(node):
    """Without what differs from run to run."""
    if isinstance(node, dict):
        if node.get("title") in ("wall time", "Wall time"):  # a column of a study's table
            return "wall time"
        return {key: strip(value) for key, value in node.items() if key not in VOLATILE}
    if isinstance(node, list):
        return [strip(entry) for entry in node
                if not (isinstance(entry, str) and entry.startswith("Computing time"))
                and not (isinstance(entry, dict) and entry.get("topic") in ("Computing time", "seconds"))]
    return SECONDS.sub(r"\1 … s.", node) if isinstance(node, str) else node


def strip_text(text):
    """Lines with seconds of computing end before them."""
    kept = []
    for line in strip_lines(text):
        if line.startswith("Computing time") or " done in " in line or "wall" in line:
            continue
        # A row of the table of methods ends with its seconds.
        kept.append(re.sub(r"(\d\.\d{3}|none)\s+[0-9.e+-]+$", r"\1", line) if line.startswith("  ") else line)
    return "\n".join(kept)


def strip_csv(text):
    """Without the column of the wall time."""
    rows = list(csv.reader(text.splitlines()))
    if not rows:
        return text
    drop = {i for i, name in enumerate(rows[0]) if name.startswith("wall time")}
    return "\n".join(",".join(cell for i, cell in enumerate(row) if i not in drop) for row in rows)


def keep_file(path):
    """(kind, content) of a file of results."""
    name = path.name
    if name == "report.html":
        found = PAGE_DATA.search(path.read_text(encoding="utf-8"))
        return ("json", strip(json.loads(found[1]))) if found else ("hash", "a page without data")
    if path.suffix == ".json":
        return "json", strip(json.loads(path.read_text(encoding="utf-8")))
    if path.suffix == ".csv":
        return "text", strip_csv(path.read_text(encoding="utf-8"))
    if path.suffix == ".md":
        return "text", "\n".join(strip_lines(path.read_text("utf-8")))
    return "hash", hashlib.sha256(path.read_bytes()).hexdigest()


def start_case(program, name, work, threads):
    """The folder of the results of a case, and how its program ended."""
    command, case, overrides = CASES[name]
    out = work / name
    arguments = [program, command, str(ROOT / case), "-o", str(out)]
    if command in ("run", "study"):
        arguments += ["--overwrite", "--threads", str(threads)]
    for override in overrides:
        arguments += ["--set", override]
    return out, subprocess.run(arguments, capture_output=True, text=True, check=False)


def run_case(program, name, work):
    out, done = start_case(program, name, work, 1)
    kept = {"code": done.returncode, "printed": strip_text(done.stdout.replace(str(work), "…")),
            "complaints": "" if done.returncode == 0 else done.stderr.replace(str(work), "…"), "files": {}}
    for path in sorted(out.rglob("*")):
        if path.is_file() and path.name != "talus.files":  # hashes of files with times
            kind, content = keep_file(path)
            kept["files"][path.relative_to(out).as_posix()] = {"kind": kind, "content": content}
    return kept


def run_published(program):
    """The table of the published problems by slices."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, str(ROOT / "tools" / "verify_published.py"), program, "--jobs", "1", "--only", "slices",
                        "--out", folder], capture_output=True, text=True, check=False)
        kept = {"code": 0, "printed": "", "complaints": "", "files": {}}
        root = pathlib.Path(folder)
        for path in sorted(root.rglob("*")):
            if path.is_file() and path.name in ("published.csv", "summary.json"):
                kind, content = keep_file(path)
                kept["files"][path.relative_to(root).as_posix()] = {"kind": kind, "content": content}
        return kept


def store(options):
    folder = pathlib.Path(options.folder)
    folder.mkdir(parents=True, exist_ok=True)
    names = options.only or [*CASES, "published"]

    def one(name):
        with tempfile.TemporaryDirectory() as work:
            kept = run_published(options.program) if name == "published" else run_case(options.program, name, pathlib.Path(work))
        (folder / f"{name}.json").write_text(json.dumps(kept, indent=1, ensure_ascii=False, sort_keys=True), encoding="utf-8")
        return f"{name}: code {kept['code']}, {len(kept['files'])} files {kept['complaints']}"

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for line in pool.map(one, names):
            print(line, flush=True)
    return 0


def find_differences(a, b, path, renamed, added):
    if isinstance(a, dict) and isinstance(b, dict):
        a = {renamed.get(key, key): value for key, value in a.items()}
        for key in sorted(a.keys() | b.keys()):
            if key not in b:
                yield f"{path}.{key}: gone, was {str(a[key])[:80]}"
            elif key not in a:
                if key in added:
                    continue
                yield f"{path}.{key}: new, {str(b[key])[:80]}"
            else:
                yield from find_differences(a[key], b[key], f"{path}.{key}", renamed, added)
    elif isinstance(a, list) and isinstance(b, list):
        if len(a) != len(b):
            yield f"{path}: {len(a)} entries, now {len(b)}"
        for i, (x, y) in enumerate(zip(a, b)):
            yield from find_differences(x, y, f"{path}[{i}]", renamed, added)
    elif isinstance(a, str) and isinstance(b, str) and "\n" in a + b:
        for i, (x, y) in enumerate(zip(a.splitlines(), b.splitlines()), 1):
            if x != y:
                yield f"{path}, line {i}: {x[:150]!r}, now {y[:150]!r}"
        if len(a.splitlines()) != len(b.splitlines()):
            yield f"{path}: {len(a.splitlines())} lines, now {len(b.splitlines())}"
    elif a != b or isinstance(a, bool) != isinstance(b, bool):
        yield f"{path}: {str(a)[:100]}, now {str(b)[:100]}"


def compare(options):
    one, other = pathlib.Path(options.folder), pathlib.Path(options.other)
    renamed = dict(pair.split("=") for pair in options.renamed)
    faults = 0
    for path in sorted(one.glob("*.json")):
        if not (other / path.name).is_file():
            print(f"{path.stem}: not run the second time")
            faults += 1
            continue
        a, b = (json.loads((folder / path.name).read_text(encoding="utf-8")) for folder in (one, other))
        found = list(find_differences(a, b, path.stem, renamed, set(options.added)))
        faults += len(found)
        for line in found[:options.most]:
            print(line)
        if len(found) > options.most:
            print(f"{path.stem}: and {len(found) - options.most} more")
    print(f"{faults} differences")
    return 1 if faults else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    keep = commands.add_parser("store")
    keep.add_argument("program")
    keep.add_argument("folder")
    keep.add_argument("--only", nargs="*")
    keep.add_argument("--jobs", type=int, default=2)
    hold = commands.add_parser("compare")
    hold.add_argument("folder")
    hold.add_argument("other")
    hold.add_argument("--renamed", nargs="*", default=[])
    hold.add_argument("--added", nargs="*", default=[])
    hold.add_argument("--most", type=int, default=20)
    options = parser.parse_args()
    return store(options) if options.command == "store" else compare(options)


if __name__ == "__main__":
    sys.exit(main())
