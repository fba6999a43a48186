#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fresh inputs of the kinds of fault that independent campaigns found, each against a right answer from outside the program.

Usage: tools/verify_kinds.py PROGRAM [--count 20] [--seed 1] [--kinds NAME …] [--only N …] [--out FOLDER] [--jobs N] [--shift X] [--write]

Each kind draws --count inputs (seed, kind and number decide the input), runs the program on them with coarse settings, and compares with a closed form, a
conservation law, another method or the same input written otherwise, which tools/kinds/ computes; never with an earlier result. Prints every failure, then a
table; --out keeps the inputs of failures, NAME_NUMBER/. --write stores docs/verification_data/kinds.md; rows of kinds that were not run stay in it. Ends with
1 where an input failed.
"""
import argparse
import concurrent.futures
import pathlib
import shutil
import sys
import tempfile
import time

from kinds import discharge, exits, factors, imports, refusals, resumption, sections, stages, supports, undrained
from kinds.trial import Refused, Trial

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "verification_data" / "kinds.md"
KINDS = {  # name → (judge, right answer)
    "exit layers": (exits.judge_layers, "series of layers"),
    "exit beds": (exits.judge_beds, "ΔH/L"),
    "exit sheet pile": (exits.judge_pile, "elliptic integrals"),
    "exit dam": (exits.judge_dam, "where water leaves; mirror image, other order"),
    "discharge series": (discharge.judge_series, "ΔH / Σ d/k"),
    "discharge tensor": (discharge.judge_tensor, "K ∇h, inclined axes"),
    "discharge whole": (discharge.judge_whole, "conservation"),
    "free drainage": (discharge.judge_drainage, "rain; k_r k = q"),
    "drained cut": (stages.judge_cut, "γ d H / E_oed"),
    "dry cut": (stages.judge_dry_cut, "γ d H / E_oed"),
    "settlement": (stages.judge_layers, "Σ q d/E_oed, and back"),
    "consolidation": (stages.judge_terzaghi, "Terzaghi"),
    "water at rest": (stages.judge_rest, "no excess pressure"),
    "bar on a plane": (supports.judge_plane, "closed form"),
    "more bars": (supports.judge_more, "F does not fall; capacity"),
    "bars in a search": (supports.judge_search, "F does not fall"),
    "prestress": (supports.judge_prestress, "continuous at 0"),
    "partial factors": (factors.judge_sets, "plane, F/γ_R"),
    "timeline": (factors.judge_timeline, "target × γ_R"),
    "hostile changes": (refusals.judge_changes, "check refuses what run refuses"),
    "hostile shapes": (refusals.judge_named, "both refuse"),
    "water by soil": (sections.judge_water, "one table, with and without [water]"),
    "water given": (sections.judge_water_given, "table, line, grids"),
    "stages rewritten": (sections.judge_stages, "mirror image, map"),
    "methods": (sections.judge_methods, "limit analysis"),
    "rewritten": (sections.judge_rewritten, "mirror image, map, feet"),
    "undrained": (undrained.judge_circle, "moments about the centre"),
    "undrained B": (undrained.judge_wet_circle, "moments about the centre"),
    "suction": (undrained.judge_suction, "none unless chosen"),
    "stopped": (resumption.judge_stop, "undisturbed run, bit by bit"),
    "import lines": (imports.judge_lines, "the lines written"),
    "import boreholes": (imports.judge_boreholes, "the holes written"),
    "import refused": (imports.judge_refused, "a sentence"),
}


def judge(options, folder, kind, number):
    trial = Trial(pathlib.Path(options.program).resolve(), folder, kind, options.seed, number, options.shift)
    try:
        KINDS[kind][0](trial)
    except Refused as why:
        trial.expect(False, f"no result: {why}")
    trial.seconds = time.monotonic() - trial.seconds
    for fault in trial.faults:
        print(f"FAULT {kind} {number}: {fault}", flush=True)
    if not trial.faults:
        shutil.rmtree(trial.folder)
    return trial


def write_page(options, trials):
    lines = ["# Fresh inputs of known kinds", "",
             f"`tools/verify_kinds.py PROGRAM --count {options.count} --seed {options.seed} --write`: random inputs of the kinds of fault that independent campaigns "
             "found, against answers from outside the program.", "",
             "| kind | right answer | inputs | comparisons | failed inputs | s |", "|---|---|--:|--:|--:|--:|"]
    kept = {line.split(" | ")[0][2:]: line for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")} if PAGE.exists() else {}
    for kind in KINDS:
        own = [t for t in trials if t.kind == kind]
        if not own:
            lines += [kept[kind]] if options.write and kind in kept else []
            continue
        failed = [str(t.number) for t in own if t.faults]
        lines.append(f"| {kind} | {KINDS[kind][1]} | {len(own)} | {sum(t.checks for t in own)} | {len(failed)}{' (' + ', '.join(failed) + ')' if failed else ''} | "
                     f"{sum(t.seconds for t in own):.0f} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", nargs="+", choices=list(KINDS), default=list(KINDS), metavar="NAME")
    parser.add_argument("--only", nargs="+", type=int, default=[], metavar="N")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--shift", type=float, default=0, help="falsify all right answers by this part: ends with 1 unless every input fails")
    parser.add_argument("--write", action="store_true", help=f"write {PAGE.relative_to(ROOT)}")
    options = parser.parse_args()
    inputs = [(kind, number) for kind in options.kinds for number in options.only or range(1, options.count + 1)]
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        trials = list(pool.map(lambda one: judge(options, options.out or scratch, *one), inputs))
    page = write_page(options, trials)
    print(page)
    if options.write:
        PAGE.write_text(page, encoding="utf-8")
    if options.shift:
        return 0 if all(t.faults for t in trials) else 1
    return 1 if any(t.faults for t in trials) else 0


if __name__ == "__main__":
    sys.exit(main())
