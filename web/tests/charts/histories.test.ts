// SPDX-License-Identifier: MIT
// Histories: which tables and frames belong together, and that no column is lost or drawn with another unit.
import { expect, test } from "vitest";

import type { Report, Table } from "../../src/contract";
import { makeColumn } from "./columns";
import { findStageSpans, groupHistories, makePanels } from "../../src/charts/history/histories";

const names: [string, string][] = [
  ["step", "-"], ["kinetic_energy", "J"], ["potential_energy", "J"], ["elastic_energy", "J"], ["plastic_work", "J"],
  ["damping_work", "J"], ["external_work", "J"], ["force_ratio", "-"], ["nodal_speed", "m/s"], ["mass", "kg"],
  ["momentum_x", "kg m/s"], ["momentum_y", "kg m/s"], ["centre_x", "m"], ["largest_displacement", "mm"],
];
const makeTable = (id: string, columns: [string, string][], kind: Table["kind"] = "history"): Table => ({
  id,
  title: id,
  kind,
  sequence: id.includes("runout_1.75") ? "runout_1.75" : "stages",
  x: makeColumn("time", "s", [0, 1]),
  columns: columns.map(([name, unit], i) => makeColumn(name, unit, [10 * i, 1000 + 10 * i])),
});
const sequence = (id: string, axis: "time" | "factor") => ({ id, title: id, axis }) as Report["sequences"][number];

test("tables of a run stand together, with the frames of their time", () => {
  const tables = [
    makeTable("history", names),
    makeTable("monitors", [["crest.displacement_x", "mm"]], "monitors"),
    makeTable("history_runout_1.75", names),
    makeTable("profile_runout_1.75", names, "ground"),
  ];
  const sequences = [sequence("curve", "factor"), sequence("stages", "time"), sequence("runout_1.75", "time")];
  const groups = groupHistories({ tables, sequences });
  expect(groups.map((g) => [g.sequence, ...g.tables.map((t) => t.id)])).toEqual([
    ["stages", "history", "monitors"],
    ["runout_1.75", "history_runout_1.75"],
  ]);
  // Without frames of its time a history moves no viewer.
  expect(groupHistories({ tables: [tables[2]!], sequences: [sequences[1]!] })[0]!.sequence).toBe("");
});

test("every column is in one panel, and a panel has one unit", () => {
  const table = makeTable("history", names);
  const panels = makePanels(table);
  const drawn = panels.flatMap((p) => p.series.map((s) => s.name)).filter((n) => n !== "residual");
  expect(drawn.sort()).toEqual(names.map(([n]) => n).sort());
  for (const panel of panels.slice(1))
    for (const s of panel.series) expect(names.find(([n]) => n === s.name)![1]).toBe(panel.unit);
});

test("energies are changes since the first row, in a unit for people, beside their residual", () => {
  const energy = makePanels(makeTable("history", names))[0]!;
  expect(energy.unit).toBe("kJ");
  for (const s of energy.series.filter((x) => x.name !== "residual")) expect(s.values).toEqual([0, 1]);
  // 1 kJ goes in and four kJ come out: three too many.
  expect(energy.series.find((s) => s.name === "residual")!.values[1]).toBeCloseTo(-3, 12);
  expect(energy.note).toContain("%");
});

test("stages follow each other, and one that was not reached has no place", () => {
  const stage = { text: "", end: "rest", steps: 1, wall: 1 };
  const times = [2, 20, 0];
  const spans = findStageSpans(["a", "b", "c"].map((name, i) => ({ ...stage, name, time: times[i]! })));
  expect(spans).toEqual([{ name: "a", start: 0, end: 2 }, { name: "b", start: 2, end: 20 }]);
});
