// SPDX-License-Identifier: MIT
/** Tables of points, and what an import adds to a case. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { beforeEach, describe, expect, test } from "vitest";

import { listChains } from "../src/document/chains";
import { emptyCase } from "../src/document/operations";
import { findNode, readTree, toPlain } from "../src/document/tree";
import { pointsOf } from "../src/document/vertices";
import { computeArea, type Point } from "../src/geometry/plane";
import { addPoints, suggestBase } from "../src/imports/imports";
import { readPointTable } from "../src/imports/pointTable";
import * as state from "../src/state";

const survey = readFileSync(join(import.meta.dirname, "../../../tests/data/tables/own_slope_surface.csv"), "utf8");
const rows = survey.trim().split("\n").slice(1).map((row) => row.split(",").map(Number)) as unknown as Point[];
const valueAt = (...path: (string | number)[]) => toPlain(findNode(readTree(state.text.value).tree!, path));

beforeEach(() => state.openText(emptyCase));

describe("Tables of points", () => {
  test("the survey of 60 points", () => {
    const { points, note } = readPointTable(survey);
    expect(points).toHaveLength(60);
    expect(points).toEqual(rows);
    expect(note).toBe("taken as metres");
  });
  test.each([
    ["semicolons and decimal commas", "x;y\n0;1,5\n10;2,5", [[0, 1.5], [10, 2.5]]],
    ["tabs, no heading", "0\t1.5\n10\t2.5\n", [[0, 1.5], [10, 2.5]]],
    ["blanks and comments", "# survey\n0 1.5\n10 2.5", [[0, 1.5], [10, 2.5]]],
    ["columns by their names", "point,elevation,chainage\n1,1.5,0\n2,2.5,10", [[0, 1.5], [10, 2.5]]],
    ["feet", "distance [ft],level (ft)\n0,10\n100,20", [[0, 3.048], [30.48, 6.096]]],
    ["a chainage beside coordinates", "X,Y,Distance,Elevation\n0,0,0,5\n30,40,50,4\n30,90,100,3", [[0, 5], [50, 4], [100, 3]]],
    ["a chainage against the coordinates", "Easting,Northing,Level,Station [ft]\n30,40,5,0\n0,0,4,164.04199475", [[0, 5], [50, 4]]],
    ["a byte order mark", "\ufeffx,y\n0,1\n2,3", [[0, 1], [2, 3]]],
  ])("%s", (_, text, expected) => {
    const { points } = readPointTable(text);
    expect(points!.flat().map((v) => Number(v.toFixed(9)))).toEqual(expected.flat());
  });
  test.each([
    ["positions in plan", "x,y,z\n1,2,3\n4,5,6", /plan/],
    ["eastings and northings", "easting,northing,level\n1,2,3\n4,5,6", /plan/],
    ["a chainage that differs from the coordinates", "X,Y,Distance,Level\n0,0,0,9\n0,44,30.48,8", /30.48 m long by its chainage and 44 m/],
    ["a slope distance beside x and y", "x,y,distance\n0,40,0\n30,0,50", /50 m long by its chainage and 30 m/],
    ["three columns without names", "1,2,3\n4,5,6", /3 columns/],
    ["text", "a,b\nc,d", /no rows of numbers/],
    ["a gap", "x,y\n0,1\n2,\n3,4", /row 3/],
    ["an unknown unit", "x [chain],y\n0,1\n2,3", /no unit of length/],
    ["one point", "x,y\n0,1", /single point/],
  ])("refused: %s", (_, text, why) => {
    expect(readPointTable(text).fault).toMatch(why);
  });
});

describe("Points in a case", () => {
  test("a ground with a layer down to the base, as one step", () => {
    const base = suggestBase(rows);
    expect(base).toBeLessThan(Math.min(...rows.map((p) => p[1])));
    expect(addPoints("survey.csv", rows, "ground", base)).toBe(true);
    expect(valueAt("geometry", "ground")).toEqual(rows);
    expect(valueAt("geometry", "layer", 0)).toEqual({ name: "ground", level: base });
    expect(valueAt("regions", "ground")).toBe("soil");
    expect(state.undoNames.value).toEqual(["Import survey.csv"]);
    state.undo();
    expect(state.text.value).toBe(emptyCase);
  });
  test("a region below the points", () => {
    addPoints("survey.csv", rows, "region", -20);
    const region = listChains(readTree(state.text.value).tree!).find(({ kind }) => kind === "region")!;
    expect(region.points).toHaveLength(62);
    // Trapezium rule between the survey and the base.
    const area = rows.slice(1).reduce((sum, b, i) => sum + (b[0] - rows[i]![0]) * ((b[1] + rows[i]![1]) / 2 + 20), 0);
    expect(Math.abs(computeArea(pointsOf(region)))).toBeCloseTo(area, 6);
  });
  test("a closed outline keeps its corners", () => {
    addPoints("outline.csv", [[0, 0], [10, 0], [10, 5], [0, 5], [0, 0]], "region", -1);
    expect(valueAt("geometry", "polygon", 0, "points")).toEqual([[0, 0], [10, 0], [10, 5], [0, 5]]);
  });
  test("from right to left is turned round, and a base above the points is refused", () => {
    addPoints("water.csv", [[10, 1], [5, 2], [0, 3]], "water", 0);
    expect(valueAt("initial", "water_table")).toEqual([[0, 3], [5, 2], [10, 1]]);
    const before = state.text.value;
    expect(addPoints("survey.csv", rows, "region", 39.5)).toBe(false);
    expect(state.notice.value?.text).toMatch(/below the lowest point/);
    expect(state.text.value).toBe(before);
  });
  test("a case with regions takes no ground", () => {
    addPoints("a.csv", rows, "region", -20);
    expect(addPoints("b.csv", rows, "ground", -20)).toBe(false);
    expect(state.notice.value?.text).toMatch(/as a region/);
  });
});
