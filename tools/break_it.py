#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tries to break the program, and reports runs that ended neither with a result nor with a message.

Usage: tools/break_it.py PROGRAM CAMPAIGN [--count N] [--first N] [--out FOLDER] [--write]

Campaigns:
  cases    case files with words, numbers and lines changed, dropped and doubled: `check` must survive, and `run` must not reject a case that it accepts
  meshes   .msh files, in text and in binary, with bytes and numbers changed
  results  result files with bytes changed, cut and moved: `report`, `plot`, `collect` and `--resume` report it, or give the same numbers
  kills    kill -9 at random moments of a run, after which `--resume` gives bitwise identical results
  disks    files that may grow to a random size only, then `--resume` without the limit: bitwise identical
  calls    the n-th write, rename, sync, open and allocation fails, for every n (of allocations a thousand); then `--resume`: bitwise identical
  names    hostile names in case files and lists of jobs: nothing outside the folder of results changes, and no output controls its reader
  files    `--overwrite` of finished, killed and interrupted results among files of a user, and of folders that it must refuse
  damage   a listed file lost, swapped, cut or changed: `--resume` and `collect` name it, or end bitwise identical
  signals  SIGTERM and SIGINT at random fractions of the processor time of every method, then `--resume`: bitwise identical
  inputs   devices, pipes and folders in place of every file, and oversized case files: a message within 10 s of processor time and 500 MB
  readers  `report`, `plot` and `collect` again and again beside a run, whose end must be whole

Number N of a campaign is always the same. --write puts the counts into docs/verification_data/reliability.json and the table of docs/reliability.md. Ends with 1 where
there was a fault.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from reliability.inputs import try_inputs
from reliability.kept_files import try_damage, try_files
from reliability.names import try_names
from reliability.signals import try_readers, try_signals
from reliability.trial import ROOT, SMALL, Table, compare, damage, read_folder, run, seed

COUNTS = ROOT / "docs" / "verification_data" / "reliability.json"
PAGE = ROOT / "docs" / "reliability.md"
BEGIN, END = "<!-- written by tools/break_it.py -->\n", "<!-- to here -->"
ODD = ["0", "-1", "1e300", "-1e300", "1e-300", "nan", "inf", "-inf", '""', '"sand"', "[]", "{}", "true", "1", "1e9", "[[0, 0]]", "1979-05-27", "-0.0", "3"]
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def list_seeds():
    paths = [*ROOT.glob("examples/*/*.toml"), *ROOT.glob("tests/page/*.toml"), *ROOT.glob("tests/data/misleading/*.toml")]
    return sorted(p for p in paths if p.stat().st_size < 20000)


def mutate(text, rng):
    """The text of a case file with one to three changes."""
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        lines = text.split("\n")
        i = rng.randrange(len(lines))
        kind = rng.randrange(8)
        numbers = list(NUMBER.finditer(text))
        if kind <= 2 and numbers:
            one = rng.choice(numbers)
            text = text[:one.start()] + rng.choice(ODD) + text[one.end():]
            continue
        if kind == 3:
            del lines[i]
        elif kind == 4:
            lines.insert(rng.randrange(len(lines)), lines[i])
        elif kind == 5:
            j = rng.randrange(len(lines))
            lines[i], lines[j] = lines[j], lines[i]
        elif kind == 6 and lines[i]:
            at = rng.randrange(len(lines[i]))
            lines[i] = lines[i][:at] + rng.choice('[]{}="\'#.,\\\t-0\x00é') + lines[i][at + rng.randrange(2):]
        else:
            words = re.findall(r"\w+", text)
            word, other = rng.choice(words), rng.choice(words)
            text = text.replace(word, other, 1)
            continue
        text = "\n".join(lines)
    return text


def try_cases(program, numbers, work):
    table = Table("cases", "case files with one to three changes; `check`, and `run` of what it passes")
    seeds = list_seeds()
    for number in numbers:
        rng = seed("cases", number)
        origin = rng.choice(seeds)
        home = work / "cases" / origin.relative_to(ROOT).parent
        if not home.exists():  # the files that it names
            shutil.copytree(origin.parent, home)
            if (ROOT / "examples" / "data").exists():
                shutil.copytree(ROOT / "examples" / "data", work / "cases" / "examples" / "data", dirs_exist_ok=True)
        path = home / "broken.toml"
        path.write_bytes(mutate(origin.read_text(), rng).encode())
        label = f"{number} ({origin.relative_to(ROOT)})"
        checked = run(program, ["check", path], 60)
        table.add(label, checked)
        if checked.code != 0 or checked.fault or b"[[test]]" in path.read_bytes() or b"[study" in path.read_bytes():
            continue
        shutil.rmtree(work / "run", ignore_errors=True)
        ran = run(program, ["run", path, "-o", work / "run", "-q", "--no-report", "--threads", "1"], 5)
        table.add(label + ", run", ran, "check passed it, run refuses it: " + ran.said.strip()[-300:] if ran.code == 2 else "")
    return table


def try_meshes(program, numbers, work):
    table = Table("meshes", "mesh files with changed bytes and numbers")
    text = (ROOT / "examples" / "data" / "dry_slope_h075.msh").read_bytes()
    (work / "good.msh").write_bytes(text)
    case = (ROOT / "examples" / "dry_slope" / "same_mesh_as_independent_code.toml").read_text()
    case = re.sub(r'file *= *"[^"]*\.msh"', 'file = "bad.msh"', case)
    (work / "case.toml").write_text(case)
    for number in numbers:
        rng = seed("meshes", number)
        bad = text
        for _ in range(rng.choice((1, 1, 2, 5))):
            numbers_of = list(re.finditer(rb"-?\d+(?:\.\d+)?", bad))
            if rng.random() < 0.6 and numbers_of:
                one = rng.choice(numbers_of)
                bad = bad[:one.start()] + rng.choice((b"-1", b"0", b"99999999999", b"1e300", b"nan", b"", b"7", b"-3.5")) + bad[one.end():]
            else:
                bad = damage(bad, rng)
        (work / "bad.msh").write_bytes(bad)
        shutil.rmtree(work / "run", ignore_errors=True)
        table.add(str(number), run(program, ["run", work / "case.toml", "-o", work / "run", "-q", "--no-report", "--threads", "1"], 5))
    return table


def make_reference(program, work):
    (work / "small.toml").write_text(SMALL)
    verdict = run(program, ["run", work / "small.toml", "-o", work / "good", "-q", "--no-report", "--threads", "1"])
    if verdict.code != 0:
        sys.exit(f"the case of the campaigns does not run: {verdict.said}")
    return read_folder(work / "good")


def resume(program, work, folder):
    return run(program, ["run", work / "small.toml", "-o", folder, "-q", "--no-report", "--threads", "1", "--resume"])


def start_and_kill(program, work, folder, seconds):
    process = subprocess.Popen([str(program), "run", str(work / "small.toml"), "-o", str(folder), "-q", "--no-report", "--threads", "1", "--resume"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(seconds)
    process.kill()
    process.wait()


def measure_seconds(program, work):
    begin = time.monotonic()
    run(program, ["run", work / "small.toml", "-o", work / "timed", "-q", "--no-report", "--threads", "1"])
    return time.monotonic() - begin


def try_results(program, numbers, work):
    table = Table("results", "result files with changed, cut and moved bytes; `report`, `plot`, `collect`, `--resume`")
    reference = make_reference(program, work)
    seconds = measure_seconds(program, work)
    shutil.rmtree(work / "half", ignore_errors=True)
    for share in (0.7, 0.6, 0.5, 0.4):
        start_and_kill(program, work, work / "half", share * seconds)
        if list((work / "half").glob("frames/*.h5")) and (work / "half" / "checkpoint.h5").exists():
            break
    for number in numbers:
        rng = seed("results", number)
        is_half = rng.random() < 0.5
        folder = work / "bad"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(work / ("half" if is_half else "good"), folder)
        paths = sorted(p for p in folder.rglob("*") if p.is_file() and p.stat().st_size > 0 and p.name != "talus.lock")
        path = rng.choice(paths)
        path.write_bytes(damage(path.read_bytes(), rng))
        label = f"{number} ({path.relative_to(folder)})"
        if is_half and rng.random() < 0.6:
            verdict = resume(program, work, folder)
            fault = ""
            if verdict.code == 0:
                try:
                    fault = compare(reference, folder)
                except ValueError as error:
                    fault = str(error)
                # a history is text without a checksum
                fault = "" if path.suffix in (".csv", ".json") else fault and f"resumed, and {fault}"
            table.add(label + ", --resume", verdict, fault)
        else:
            command = rng.choice((["report", folder], ["plot", folder], ["collect", folder]))
            table.add(f"{label}, {command[0]}", run(program, command))
    return table


def try_kills(program, numbers, work):
    table = Table("kills", "kill -9 at up to three moments of a run, then `--resume`: bitwise identical")
    reference = make_reference(program, work)
    seconds = measure_seconds(program, work)
    for number in numbers:
        rng = seed("kills", number)
        folder = work / "killed"
        shutil.rmtree(folder, ignore_errors=True)
        for _ in range(rng.choice((1, 1, 2, 3))):
            start_and_kill(program, work, folder, rng.uniform(0, 1.1) * seconds)
        verdict = resume(program, work, folder)
        table.add(str(number), verdict, compare(reference, folder) if verdict.code == 0 else f"not resumed: {verdict.said.strip()[-200:]}")
    return table


def check_half(program, work, folder, reference, verdict):
    """A failed run must resume to bitwise identical results; a run may also have finished."""
    if verdict.code not in (0, 6, 7):
        return f"code {verdict.code}: {verdict.said.strip()[-200:]}"
    ended = resume(program, work, folder)
    if ended.code != 0:
        return f"not resumed: {ended.said.strip()[-200:]}"
    return compare(reference, folder)


def try_disks(program, numbers, work):
    table = Table("disks", "files that may grow to a limit only, then `--resume` without it: bitwise identical")
    reference = make_reference(program, work)
    largest = max(p.stat().st_size for p in (work / "good").rglob("*") if p.is_file()) // 1024 + 1
    for number in numbers:
        blocks = seed("disks", number).randint(0, largest)
        folder = work / "full"
        shutil.rmtree(folder, ignore_errors=True)
        verdict = run("bash", ["-c", f'ulimit -f {blocks}; exec "{program}" run "{work}/small.toml" -o "{folder}" -q --no-report --threads 1'])
        table.add(f"{number} ({blocks} KiB)", verdict, verdict.fault or check_half(program, work, folder, reference, verdict))
    return table


def try_calls(program, numbers, work):
    table = Table("calls", "the n-th write, rename, sync, open and allocation fails, then `--resume`: bitwise identical")
    reference = make_reference(program, work)
    library = work / "fail_nth.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", library, ROOT / "tools" / "reliability" / "fail_nth.c", "-ldl"], check=True)

    def fail(kind, nth, folder):
        shutil.rmtree(folder, ignore_errors=True)
        env = {**os.environ, "LD_PRELOAD": str(library), "TALUS_FAIL": f"{kind}:{nth}", "TALUS_FAIL_COUNT": str(work / "calls"),
               "TALUS_WAIT_POLICY_SET": "1"}
        return run(program, ["run", work / "small.toml", "-o", folder, "-q", "--no-report", "--threads", "1"], env=env)

    for kind in ("write", "rename", "sync", "open", "memory"):
        (work / "calls").unlink(missing_ok=True)
        fail(kind, 0, work / "counted")
        calls = max(int(line) for line in (work / "calls").read_text().split())
        chosen = range(1, calls + 1)
        if len(chosen) > len(numbers):
            rng = seed(f"calls {kind}", numbers[0])
            chosen = sorted(rng.sample(chosen, len(numbers)))
        for nth in chosen:
            folder = work / "failed"
            verdict = fail(kind, nth, folder)
            table.add(f"{kind} {nth} of {calls}", verdict, verdict.fault or check_half(program, work, folder, reference, verdict))
    return table


CAMPAIGNS = {"cases": try_cases, "meshes": try_meshes, "results": try_results, "kills": try_kills, "disks": try_disks, "calls": try_calls,
             "names": try_names, "files": try_files, "damage": try_damage, "signals": try_signals, "inputs": try_inputs, "readers": try_readers}


def write_table(counts):
    lines = ["| campaign | what is tried | tried | answers | sentences | faults | minutes |", "|---|---|--:|--:|--:|--:|--:|"]
    for one in counts:
        answers = one["codes"].get("0", 0)
        lines.append(f"| {one['campaign']} | {one['what']} | {one['tried']:,} | {answers:,} | {one['tried'] - answers - len(one['faults']):,} | {len(one['faults'])} | "
                     f"{one['minutes']} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("campaign", choices=CAMPAIGNS)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    numbers = range(options.first, options.first + options.count)
    with tempfile.TemporaryDirectory() as scratch:
        work = (options.out or pathlib.Path(scratch)).resolve()
        work.mkdir(parents=True, exist_ok=True)
        begin = time.monotonic()
        table = CAMPAIGNS[options.campaign](options.program.resolve(), numbers, work)
    told = json.loads(json.dumps(table.tell()).replace(f"{work}/", ""))
    told["minutes"] = round((time.monotonic() - begin) / 60, 1)
    print(f"{told['campaign']}: {told['tried']} tried in {told['minutes']} minutes, {len(told['faults'])} faults; codes {told['codes']}")
    if options.write:
        known = {one["campaign"]: one for one in json.loads(COUNTS.read_text())} if COUNTS.exists() else {}
        known[told["campaign"]] = told
        counts = [known[name] for name in CAMPAIGNS if name in known]
        COUNTS.write_text(json.dumps(counts, indent=1) + "\n")
        before, rest = PAGE.read_text().split(BEGIN)
        PAGE.write_text(before + BEGIN + write_table(counts) + END + rest.split(END)[1])
    return 1 if table.faults else 0


if __name__ == "__main__":
    sys.exit(main())
