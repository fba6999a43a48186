# SPDX-License-Identifier: MIT
"""The page of a slope as Markdown."""
import numpy as np

from roots_checks.tables import table_of

from .effects import compute_clopper_pearson, compute_effects, group_values, list_conflicts, list_failing_sets
from .evaluation import format_verdict
from .statements import format_interval

TITLES = {"unsaturated": ("Unsaturated slope", "3.4.2"), "vegetated": ("Vegetated slope", "4.4"), "centrifuge": ("Centrifuge slope", "4.5")}
SHOWN_EFFECTS, SHOWN_PAIRS, SHOWN_SETS = 3, 12, 8
DOMINANT = 0.5  # fraction of the variance from which the effects beside this one are shown
WEAK = 0.03  # fraction of the variance below which an effect is not shown


def format_number(value, digits=3):
    return "none" if np.isnan(value) else f"{value:.{digits}g}"


def format_share(verdicts):
    """k of n in per cent with the Clopper–Pearson interval."""
    if not verdicts:
        return "–"
    k, n = sum(verdicts), len(verdicts)
    low, high = compute_clopper_pearson(k, n)
    return f"{100 * k / n:.0f} % [{100 * low:.0f}, {100 * high:.0f}]"


def format_effect(effect, digits, log=False):
    """Means are geometric where the effect is one on the logarithm."""
    means = "; ".join(f"{name}: {np.exp(value) if log else value:.{digits}g}" for name, value in effect.means.items())
    where = f" ({effect.where})" if effect.where else ""
    return f"{effect.factor}{where} {effect.share:.2f} [{effect.low:.2f}, {effect.high:.2f}]: {means}"


def format_range(values, digits):
    values = values[np.isfinite(values)]
    return " / ".join(format_number(v, digits) for v in np.quantile(values, [0.05, 0.5, 0.95])) if len(values) else "–"


def format_choices(choices):
    return ", ".join(f"{name} {value:g}" if isinstance(value, float) else f"{name} {value}" for name, value in choices.items())


def make_heading(evaluation):
    title, section = TITLES[evaluation.name]
    done, planned, cases = len(evaluation.finished), len(evaluation.samples), len(evaluation.slope.cases)
    runs = f"{done} of {planned} samples" + (f", {cases} runs each" if cases > 1 else "")
    runs += f"; {len(evaluation.broken)} ended with an error" if evaluation.broken else ""
    state = "" if done + len(evaluation.broken) == planned else " **The study has not finished: numbers are those of the finished samples.**"
    return f"""# {title}: an envelope over what the source leaves open

Written by `tools/verify_envelope.py PROGRAM FOLDER --only {evaluation.name}` ({runs}).{state}
Section {section} of the source. A Latin hypercube draws the choices that the source leaves open (`tools/envelope/design.py`); nothing that it prints is
varied. [Every sample](envelope_{evaluation.name}.csv). Intervals are those of 90 %. The fraction of the variance of a quantity that a choice explains (ω²) is computed
for levels, and for numbers in three bins of equal frequency, with a bootstrap interval; of a ratio, for its logarithm. A choice is tested only where it
acts, and effects below {WEAK} are noise and not shown; beside a choice that explains {DOMINANT} or more, effects of the others in its best level are
shown too. *Strict* is what a careful reader calls reproduced; *project* are the project's bands.
"""


def list_effects(evaluation, statement):
    """The largest effects and, where a choice of levels dominates, those of the others in its level that satisfies the statement most often."""
    shown = [e for e in evaluation.compute_effects(statement) if e.share >= WEAK][:SHOWN_EFFECTS]
    lines = [format_effect(e, statement.digits, statement.log) for e in shown]
    if shown and shown[0].share >= DOMINANT and isinstance(evaluation.finished[0].choices[shown[0].factor], str) and not shown[0].where:
        level = evaluation.find_best_level(statement, shown[0].factor)
        beside = [e for e in evaluation.compute_effects(statement, (shown[0].factor, level)) if e.share >= WEAK][:SHOWN_EFFECTS]
        lines += [f"with {shown[0].factor} {level}: {format_effect(e, statement.digits, statement.log)}" for e in beside]
    return lines


def make_statements(evaluation):
    rows = []
    for s in evaluation.statements:
        rows.append([s.name if s.counts else f"({s.name})", s.place, s.wording, s.quantity, format_interval(s, "strict"),
                     format_share(evaluation.judge(s, "strict")), format_share(evaluation.judge(s, "project")),
                     format_range(evaluation.get_values(s.name), s.digits), "<br>".join(list_effects(evaluation, s)) or "–"])
    return "## Statements\n\n" + table_of(["", "source", "it states", "quantity", "accepted, strict", "holds, strict", "holds, project", "5 / 50 / 95 %",
                                           "largest effects"], rows) + "\nStatements in brackets are not among those that a run has to satisfy together.\n"


def make_levels(evaluation):
    """Share of runs that satisfy each statement, by level of each choice."""
    design = [s.choices for s in evaluation.finished]
    shown = [s for s in evaluation.counted if 0 < sum(evaluation.judge(s, "project")) and not all(evaluation.judge(s, "strict"))]
    verdicts = {(s.name, kind): np.array(evaluation.judge(s, kind)) for s in shown for kind in ("strict", "project")}
    rows = []
    for factor in evaluation.slope.factors:
        other, level = evaluation.slope.acts.get(factor, (None, None))
        used = np.array([other is None or choice[other] == level for choice in design])
        groups, names = group_values([choice[factor] for choice in design])
        for i, name in enumerate(names):
            inside = used & (groups == i)
            if inside.any():
                where = f" ({other} = {level})" if other else ""
                cells = [f"{100 * verdicts[s.name, 'strict'][inside].mean():.0f} ({100 * verdicts[s.name, 'project'][inside].mean():.0f})" for s in shown]
                rows.append([f"{factor}{where}: {name}", str(int(inside.sum())), *cells])
    return "## Passes by level\n\nPer cent of the samples that satisfy a statement, strict (project); statements that hold in all or in none are left out.\n\n" \
        + table_of(["choice", "samples", *(s.name for s in shown)], rows)


def make_readings(evaluation):
    """Samples that satisfy everything, and those that satisfy each statement that depends on the reading."""
    first = evaluation.readings[0]
    shown = [s for s in evaluation.counted if any(not np.array_equal(evaluation.get_values(s.name), evaluation.get_values(s.name, r), equal_nan=True)
                                                  for r in evaluation.readings if r != first)]
    rows = []
    for reading in evaluation.readings:
        counts = [[sum(evaluation.judge(s, kind, reading)) for kind in ("strict", "project")] for s in shown]
        everything = [len(evaluation.list_complete(kind, reading)) for kind in ("strict", "project")]
        rows.append([reading, *(f"{strict} ({project})" for strict, project in [everything, *counts])])
    return f"Of {len(evaluation.finished)} samples satisfy all statements together, and each that depends on the reading, strict (project):\n\n" \
        + table_of(["reading", "all", *(s.name for s in shown)], rows)


def make_central(evaluation):
    kind, reading, sample, distance = evaluation.choose_central()
    found = sample.found[reading]
    values = "; ".join(f"{s.name} {format_number(found[s.name].value, s.digits + 1)}{' ' + s.unit if s.unit else ''}"
                       for s in evaluation.statements if s.name in found)
    numbers = ", ".join(str(evaluation.finished[i].number + 1) for i in evaluation.list_complete(kind, reading))
    return f"""Samples ({kind}, {reading}): {numbers}.

The most central one is sample {sample.number + 1} (sum of ((value – printed)/tolerance)² = {distance:.2f}):
{format_choices(sample.choices)}.

Its quantities: {values}.
"""


def make_meshes(evaluation):
    """The central run with the other mesh generators."""
    _, reading, sample, _ = evaluation.choose_central()
    found = {sample.choices["algorithm"]: sample.found[reading]} | {name: meshes[reading] for name, meshes in evaluation.meshes.items()}
    rows = []
    for s in evaluation.counted:
        cells = [f"{format_number(values[s.name].value, s.digits + 1)}, {format_verdict(s, values[s.name])}" for values in found.values()]
        rows.append([s.name, s.unit, *cells])
    return "The central run with the other mesh generators: quantity, and whether the statement holds.\n\n" + table_of(["", "unit", *found], rows)


def make_conflicts(evaluation, kind):
    held = evaluation.judge_all(kind)
    n = len(evaluation.finished)
    possible = {name: verdicts for name, verdicts in held.items() if any(verdicts)}
    never = [name for name in held if name not in possible]
    lines = [f"Statements that hold in no sample ({kind}): {', '.join(never) or 'none'}."]
    pairs = list_conflicts(possible)[:SHOWN_PAIRS]
    if pairs:
        lines += ["", f"Pairs that hold together less often than independent statements would, {kind}:", "",
                  table_of(["pair", "first", "second", "both", "if independent", "probability by chance"],
                           [[" and ".join(p.names), str(p.counts[0]), str(p.counts[1]), str(p.both), f"{p.expected:.1f}", f"{p.tail:.1g}"] for p in pairs]).rstrip()]
    sets = list_failing_sets(held)[:SHOWN_SETS]
    fewest = len(sets[0][0])
    lines += ["", f"The fewest statements that fail in a sample are {fewest} of {len(held)} ({kind}). Statements to be dropped for a set of samples that is not empty:", "",
              table_of(["dropped", "samples"], [[", ".join(names), f"{count} of {n}"] for names, count in sets if len(names) == fewest or len(sets) <= SHOWN_SETS])]
    return "\n".join(lines)


def make_counts(evaluation):
    """How many statements are satisfied, and what this number depends on."""
    lines = []
    for kind in ("strict", "project"):
        counts = evaluation.count_held(kind)
        found = [e for e in compute_effects([s.choices for s in evaluation.finished], counts, evaluation.slope.acts) if e.share >= WEAK][:SHOWN_EFFECTS]
        numbers = ", ".join(f"{n} in {int((counts == n).sum())}" for n in sorted(set(counts), reverse=True))
        lines.append(f"- {kind}: of {len(evaluation.counted)} statements hold {numbers} samples. Largest effects on the number: "
                     + ("; ".join(f"**{e.factor}** {format_effect(e, 3).removeprefix(e.factor)}" for e in found) or "none") + ".")
    return "\n".join(lines)


def make_together(evaluation):
    parts = ["## All statements together", make_readings(evaluation), make_counts(evaluation)]
    if evaluation.choose_central():
        parts.append(make_central(evaluation))
        if evaluation.meshes:
            parts.append(make_meshes(evaluation))
    for kind in ("strict", "project"):
        if not evaluation.list_complete(kind):
            parts.append(make_conflicts(evaluation, kind))
    return "\n\n".join(part.strip() for part in parts) + "\n"


def make_page(evaluation):
    if not evaluation.finished:
        return make_heading(evaluation)
    return "\n".join([make_heading(evaluation), make_statements(evaluation), make_levels(evaluation), make_together(evaluation)])
