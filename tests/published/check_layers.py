#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Published problems entered by layers have the factors of the same problems entered by polygons.

check_layers.py PROGRAM [--all]      five problems, or all that have layers
"""
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from published.case_file import make_case, points_text  # noqa: E402
from published.problem import read_problem  # noqa: E402

DATA = json.loads((ROOT / "tests/data/published/problems.json").read_text())
FIVE = 5
TOLERANCE = 1e-9
# Both descriptions are searched alike: a search finer than this one finds no more differences.
SEARCH = ("lem.slices=30", "lem.entry_exit.exits=8", "lem.entry_exit.entries=8", "lem.entry_exit.depths=7")


def write_layers(problem, text):
    """The case with its polygons replaced by layers; their tops are the bottoms of those before them."""
    lines = problem.entry["layer_lines"]
    section = ["[geometry]", f"ground = {points_text(problem.ground)}", ""]
    names = []
    for i, (material, _) in enumerate(lines):
        key = problem.materials[material]["key"]
        names.append(key if key not in names else f"{key} below {i}")
        section += ["[[geometry.layer]]", f'name = "{names[-1]}"', "cut = true"]
        if i + 1 < len(lines):
            bottom = sorted(map(tuple, lines[i + 1][1]), key=lambda p: p[0])
            section += [f"bottom = {points_text(problem.scale(bottom))}", ""]
        else:
            section += [f"level = {problem.base!r}", ""]
    regions = ["[regions]"] + [f'"{name}" = "{problem.materials[m]["key"]}"' for name, (m, _) in zip(names, lines)] + [""]
    head, rest = text.split("[[geometry.polygon]]", 1)
    after = rest.split("[regions]", 1)[1].split("\n\n", 1)[1]
    return head + "\n".join(section + regions) + "\n" + after


def run(program, folder, name, text):
    case = folder / f"{name}.toml"
    case.write_text(text)
    settings = [word for setting in SEARCH for word in ("--set", setting)]
    subprocess.run([program, "run", case, "-o", folder / name, "--no-report", "--threads", "1", *settings], check=True, capture_output=True)
    lem = json.loads((folder / name / "summary.json").read_text())["lem"]
    return [(kind, r["method"], r.get("name", ""), r.get("factor")) for kind in ("critical", "given") for r in lem.get(kind) or []]


def main():
    program, takes_all = sys.argv[1], "--all" in sys.argv
    layered = [e for e in DATA["lem"] if len(e.get("layer_lines") or []) > 1 and not e.get("polygons")]
    worst, count = 0.0, 0
    with tempfile.TemporaryDirectory() as scratch:
        for entry in layered if takes_all else layered[:FIVE]:
            problem = read_problem(entry)
            text = make_case(problem)
            text = text[0] if isinstance(text, tuple) else text
            found = [run(program, pathlib.Path(scratch), f"{entry['id']}-{kind}", t)
                     for kind, t in (("polygons", text), ("layers", write_layers(problem, text)))]
            assert [r[:3] for r in found[0]] == [r[:3] for r in found[1]], entry["id"]
            for a, b in zip(*found):
                if a[3] is None and b[3] is None:
                    continue
                difference = abs(b[3] / a[3] - 1)
                worst, count = max(worst, difference), count + 1
                if difference > TOLERANCE:
                    print(f"{entry['id']} {a[:3]}: {a[3]} by polygons, {b[3]} by layers")
            print(f"{entry['id']}: {len(found[0])} factors, largest difference so far {worst:.1e}", flush=True)
    assert count > 0
    return worst > TOLERANCE


if __name__ == "__main__":
    sys.exit(main())
