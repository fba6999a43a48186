#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the engine in WebAssembly with the program: published LEM problems, checks of faulty texts, schema and template.

Usage: same_numbers.py PROGRAM FOLDER [PROBLEM …]

FOLDER has talus.js and talus.wasm. tools/verify_published.py writes the case files of the problems and runs the program on
them; Node runs the same files. Factors of given surfaces must agree to 1e-9. A search compares factors that are equal but for their
last digits, and may then take another path: searched circles agree within 5e-6 (the tolerance of their search is 1e-6), polylines within 1e-3.
Ends with 77 where Node or the engine is missing.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KINDS = {"given surfaces": 1e-9, "circles": 5e-6, "polylines": 1e-3}  # largest relative difference
PROBLEMS = ["ACADS-1a", "ACADS-1c", "ACADS-3a", "BL-42", "FK-*", "LOW-2", "LBS-63", "USACE-65", "DW-70a", "DW-74"]


class Engine:
    """The engine in Node."""

    def __init__(self, folder):
        self.process = subprocess.Popen(["node", str(ROOT / "tests/wasm/answer.mjs"), str(folder / "talus.js")], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True)
        self.milliseconds = 0

    def call(self, name, *values):
        self.process.stdin.write(json.dumps([name, *values]) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            sys.exit(f"the engine ended with {self.process.wait()} in {name}")
        answer = json.loads(line)
        self.milliseconds = answer["milliseconds"]
        return answer["answer"]


def name_kind(is_searched, is_circular):
    return "given surfaces" if not is_searched else "circles" if is_circular else "polylines"


def compare_case(engine, case, lem):
    """Number of factors, the largest relative difference of each kind, and a sentence where the case is not compared."""
    answer = json.loads(engine.call("solve", case.read_text(), "{}"))
    if "error" in answer:
        return 0, {}, answer["error"]
    native = [(s["method"], name_kind(key != "given", s["circular"]), s["factor"])
              for key in ("critical", "noncircular", "given") for s in lem.get(key, [])]
    found = [(s["method"], name_kind(s["searched"], s["circular"]), s["factor"]) for s in answer["surfaces"]]
    if [(*names, factor is None) for *names, factor in native] != [(*names, factor is None) for *names, factor in found]:
        return 0, {"given surfaces": 1.0}, f"other surfaces: {native} and {found}"
    worst = {}
    for (_, kind, one), (_, _, other) in zip(native, found):
        if one is not None:
            worst[kind] = max(worst.get(kind, 0.0), abs(one - other) / abs(one))
    return sum(one is not None for _, _, one in native), worst, None


def describe(worst):
    return ", ".join(f"{kind} {difference:.1e}" for kind, difference in worst.items())


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, folder, problems = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:] or PROBLEMS
    if shutil.which("node") is None or not (folder / "talus.wasm").is_file():
        print(f"SKIP: there is no Node, or no {folder}/talus.wasm (make studio-web): the engine in WebAssembly was NOT compared with the program")
        return 77
    engine = Engine(folder)
    faults, total, compared, worst, milliseconds = [], 0, 0, {}, 0.0
    for name in ("schema", "template"):
        native = subprocess.run([program, name], capture_output=True, text=True, check=True).stdout
        if engine.call(name) != native:
            faults.append(f"talus {name} and {name}() differ")
    with tempfile.TemporaryDirectory() as scratch:
        done = subprocess.run([sys.executable, "-B", str(ROOT / "tools/verify_published.py"), program, "--jobs", "1", "--out", scratch, "--only", *problems],
                              capture_output=True, text=True)
        runs = sorted(path for path in (pathlib.Path(scratch) / "runs").glob("*.toml") if (path.with_suffix("") / "summary.json").is_file())
        if not runs:
            sys.exit("tools/verify_published.py wrote no case:\n" + done.stdout[-2000:] + done.stderr[-2000:])
        for case in runs:
            summary = json.loads((case.with_suffix("") / "summary.json").read_text())
            if "lem" not in summary:
                continue
            count, differences, reason = compare_case(engine, case, summary["lem"])
            milliseconds += engine.milliseconds
            print(f"{case.stem}: {count} factors; {describe(differences)}; {engine.milliseconds:.0f} ms" + (f"; {reason}" if reason else ""))
            total, compared = total + count, compared + (count > 0)
            for kind, difference in differences.items():
                worst[kind] = max(worst.get(kind, 0.0), difference)
                if difference > KINDS[kind]:
                    faults.append(f"{case.stem}: {kind} differ by {difference:.1e}, allowed are {KINDS[kind]:.0e}")
    print(f"{total} factors of {compared} cases; largest differences: {describe(worst)}; {milliseconds / 1e3:.1f} s in WebAssembly")
    print(*faults, sep="\n")
    return 1 if faults or not total else 0


if __name__ == "__main__":
    sys.exit(main())
