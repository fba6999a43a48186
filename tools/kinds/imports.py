# SPDX-License-Identifier: MIT
"""Tables of lines and boreholes written in random ways, against the section that they describe; and tables that must be refused."""
from reliability.trial import run

from .trial import read_case

UNITS = {"m": 1.0, "ft": 0.3048, "cm": 0.01}


def write_table(rng, headings, rows, unit):
    """A table with one of the separators; comma as decimal sign where that can be told."""
    separator = rng.choice((",", ";", "\t"))
    comma = separator != "," and rng.random() < 0.5
    cells = [[f"{h} [{unit}]" for h in headings]] + [[repr(round(v / UNITS[unit], 6)) for v in row] for row in rows]
    lines = [separator.join(c.replace(".", ",") if comma and i else c for c in row) for i, row in enumerate(cells)]
    return "\n".join(([] if rng.random() < 0.6 else ["# survey"]) + lines) + rng.choice(("", "\n", "\n\n"))


def draw_lines(trial):
    height, run_ = trial.draw(4, 15), trial.draw(5, 40)
    ground = [[0, height], [trial.draw(5, 20), height], [0, 0], [0, 0]]
    ground[2] = [round(ground[1][0] + run_, 3), 0.0]
    ground[3] = [round(ground[2][0] + trial.draw(5, 30), 3), 0.0]
    clay = [[0.0, round(height - trial.draw(1, 3), 3)], [ground[3][0], round(-trial.draw(1, 4), 3)]]
    return ground, clay, -30.0


def read_import(trial, words):
    out = trial.folder / "imported.toml"
    verdict = run(trial.program, ["import", *words, "-o", out], 30)
    return verdict, read_case(out.read_text()) if verdict.code == 0 and out.exists() else None


def is_near(points, right):
    """Whether a line runs as the other does; points within straight parts count for nothing."""
    def level(line, x):
        for (a, ya), (b, yb) in zip(line, line[1:]):
            if a <= x <= b and b > a:
                return ya + (yb - ya) * (x - a) / (b - a)
        return float("nan")
    if len(points) < 2 or abs(points[0][0] - right[0][0]) > 1e-3 or abs(points[-1][0] - right[-1][0]) > 1e-3:
        return False
    xs = [x for x, _ in points[1:-1]] + [x for x, _ in right[1:-1]]
    return all(abs(level(points, x) - level(right, x)) < 2e-3 for x in xs)


def judge_lines(trial):
    """Ground and clay as tables in any separator, unit and decimal sign."""
    ground, clay, base = draw_lines(trial)
    words = []
    for name, line in (("ground", ground), ("clay", clay)):
        x, y = trial.rng.choice((("x", "y"), ("station", "elevation"), ("chainage", "level"), ("distance", "z")))
        path = trial.folder / f"{name}.csv"
        path.write_text(write_table(trial.rng, (x, y), line, trial.rng.choice(list(UNITS))))
        words.append(path)
    verdict, case = read_import(trial, [*words, f"--base={base}"])
    trial.expect(case is not None, f"refused: {verdict.said.strip()[-300:]}")
    if case is None:
        return
    trial.expect(is_near(case["geometry"]["ground"], ground), f"ground {case['geometry']['ground']}, right: {ground}")
    bottom = case["geometry"]["layer"][0].get("bottom", [])
    trial.expect(is_near(bottom, clay), f"bottom of the clay {bottom}, right: {clay}")


def judge_boreholes(trial):
    """Two to five boreholes of three soils, a row for each layer: ground and boundaries pass through them."""
    count = trial.rng.choice((2, 3, 4, 5))
    unit = trial.rng.choice(("m", "ft"))
    x, holes = 0.0, []
    for i in range(count):
        top = trial.draw(90, 110)
        holes.append((f"BH{i + 1}", round(x, 3), top, [trial.draw(0.5, 3), trial.draw(4, 8), trial.draw(9, 14)]))
        x += trial.draw(10, 40)
    rows = [f"hole,x [{unit}],elevation [{unit}],top [{unit}],bottom [{unit}],soil"]
    for name, at, top, depths in holes:
        for soil, start, end in zip(("fill", "clay", "rock"), [0, *depths], depths):
            rows.append(",".join([name, *(repr(round(v / UNITS[unit], 6)) for v in (at, top, start, end)), soil]))
    path = trial.folder / "holes.csv"
    path.write_text("\n".join(rows) + "\n")
    verdict, case = read_import(trial, [path, "--base=60"])
    trial.expect(case is not None, f"refused: {verdict.said.strip()[-300:]}")
    if case is None:
        return
    trial.expect(is_near(case["geometry"]["ground"], [[h[1], h[2]] for h in holes]), f"ground {case['geometry']['ground']}")
    names = [layer["name"] for layer in case["geometry"]["layer"]]
    trial.expect(names == ["fill", "clay", "rock"], f"layers {names}")


def judge_refused(trial):
    """A code for a missing value, a unit that is not known, a base above the ground: refused with a sentence, or the point left out with a remark."""
    ground, clay, base = draw_lines(trial)
    kind = trial.rng.choice(("code", "unit", "base", "text"))
    headings, rows = "x [m],y [m]", [f"{x},{y}" for x, y in ground]
    if kind == "code":
        rows.insert(2, f"{0.5 * (ground[1][0] + ground[2][0])},{trial.rng.choice(('-999', '-9999', '-999.25'))}")
    elif kind == "unit":
        headings = f"x [m],y [{trial.rng.choice(('furlong2', 'kPa', 'ft-XY', 'NAVD88 parsecs'))}]"
    elif kind == "text":
        rows.insert(2, f"{0.5 * (ground[1][0] + ground[2][0])},twelve")
    (trial.folder / "ground.csv").write_text("\n".join([headings, *rows]) + "\n")
    (trial.folder / "clay.csv").write_text("\n".join(["x [m],y [m]", *(f"{x},{y}" for x, y in clay)]) + "\n")
    high = trial.rng.choice(("500", "1e308", "nan"))
    verdict, case = read_import(trial, [trial.folder / "ground.csv", trial.folder / "clay.csv", f"--base={high if kind == 'base' else base}"])
    trial.expect(not verdict.fault and verdict.code in (0, 2), f"{kind}: {verdict.fault or verdict.code}: {verdict.said.strip()[-200:]}")
    if case is None:
        return
    is_remarked = any(words in verdict.said + verdict.printed for words in ("left out", "not used"))
    trial.expect(kind in ("code", "text") and is_remarked and is_near(case["geometry"]["ground"], ground),
                 f"{kind}: read as {case['geometry']['ground']}, base {case['geometry']['layer'][-1]}")
