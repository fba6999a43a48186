#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the engine in WebAssembly with the program: published LEM problems, checks of faulty texts, schema and template.

Usage: same_numbers.py PROGRAM FOLDER [PROBLEM …]

FOLDER has talus.js and talus.wasm. tools/verify_published.py writes the case files of the problems and runs the program on
them; Node runs the same files. Factors must agree to 1e-9. Ends with 77 where Node or the engine is missing.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TOLERANCE = 1e-9
PROBLEMS = ["ACADS-1a", "ACADS-1b", "ACADS-1c", "ACADS-1d", "ACADS-2a", "ACADS-2b", "ACADS-3*", "ACADS-4", "ACADS-5", "AT-2", "FK-*", "LOW-2",
            "BL-42", "LBS-63", "USACE-65", "DW-70a", "DW-74", "DW-73", "ZHU-51"]


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


def list_factors(surfaces):
    return [(s["method"], s["factor"]) for s in surfaces if s.get("factor") is not None]


def compare_case(engine, case, summary):
    """Number of factors, the largest relative difference, and a reason why the case is not compared."""
    answer = json.loads(engine.call("solve", case.read_text(), "{}"))
    if "error" in answer:
        return 0, 0.0, answer["error"]
    lem = summary["lem"]
    native = [s["surface"] if "surface" in s else s for key in ("critical", "noncircular", "given") for s in lem.get(key, [])]
    one, other = list_factors(native), list_factors(answer["surfaces"])
    if [name for name, _ in one] != [name for name, _ in other]:
        return 0, 1.0, f"other surfaces: {one} and {other}"
    return len(one), max((abs(a[1] - b[1]) / abs(a[1]) for a, b in zip(one, other)), default=0.0), None


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, folder, problems = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:] or PROBLEMS
    if shutil.which("node") is None or not (folder / "talus.wasm").is_file():
        print(f"SKIP: there is no Node, or no {folder}/talus.wasm (make studio-web): the engine in WebAssembly was NOT compared with the program")
        return 77
    engine = Engine(folder)
    faults, total, worst, seconds = [], 0, 0.0, 0.0
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
            count, difference, reason = compare_case(engine, case, summary)
            seconds += engine.milliseconds / 1e3
            print(f"{case.stem}: {count} factors, largest difference {difference:.1e}, {engine.milliseconds:.0f} ms" + (f"; {reason}" if reason else ""))
            total, worst = total + count, max(worst, difference)
            if difference > TOLERANCE:
                faults.append(f"{case.stem}: a factor differs by {difference:.1e}")
    print(f"{total} factors of {len(runs)} cases, largest difference {worst:.1e}; {seconds:.1f} s in WebAssembly")
    print(*faults, sep="\n")
    return 1 if faults or not total else 0


if __name__ == "__main__":
    sys.exit(main())
