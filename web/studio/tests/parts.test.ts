// SPDX-License-Identifier: MIT
/** Conditions and ranges, tables of forms, units of display, the place of a picture. */
import { afterEach, describe, expect, test } from "vitest";

import { place, placeByPoints, type Placement } from "../src/background/background";
import { listChains } from "../src/document/chains";
import { addCircle, addCondition, addHeave, addSlurry, addWindow, setCentres, setGroundRange, setTangent } from "../src/document/operations";
import { listParts } from "../src/document/parts";
import { type CaseTree, findNode, readTree, toPlain } from "../src/document/tree";
import { pasteInto, readPasted, readRows, writeRows } from "../src/forms/rows";
import { readCoordinates } from "../src/geometry/coordinates";
import { snap } from "../src/geometry/snap";
import { mergeEntries, readEntries } from "../src/library/library";
import { readQuantity, showQuantity, showRange, system, writeQuantity } from "../src/units";

const text = `title = "Parts"

[[geometry.polygon]]
name = "soil"
points = [[0, 0], [40, 0], [40, 5], [30, 5], [12, 14], [0, 14]]

[[geometry.line]]
name = "crest"
points = [[0, 14], [12, 14]]

[materials.clay]
model = "mohr_coulomb"
unit_weight = 18
cohesion = "200 psf"   # of the laboratory

[regions]
soil = "clay"

[[boundary]]
on = "left"
fix = "normal"

[[traction]]
on = "crest"
traction = [0, "-50 kPa"]

[analysis]
methods = ["lem", "fem"]

[[lem.surface]]
name = "arc"
centre = [30, 24]
radius = "60 ft"
`;

function read(from: string): CaseTree {
  const { tree, fault } = readTree(from);
  if (!tree) throw new Error(fault.text);
  return tree;
}
const valueAt = (from: string, ...path: (string | number)[]) => toPlain(findNode(read(from), path));
const partsOf = (from: string) => listParts(read(from), listChains(read(from)), []);

afterEach(() => {
  system.value = "si";
});

describe("Parts", () => {
  test("conditions lie on sides that end where the soil does, and on lines", () => {
    const [left, crest] = partsOf(text);
    expect(left).toMatchObject({ kind: "boundary", word: "normal", line: [[0, 0], [0, 14]] });
    expect(crest).toMatchObject({ kind: "traction", line: [[0, 14], [12, 14]], direction: [0, -50] });
  });
  test("with MPM a side is that of the box", () => {
    const mpm = text.replace('["lem", "fem"]', '["mpm"]').replace("[[geometry.polygon]]", "[geometry]\nbox = [[0, 0], [40, 20]]\n\n[[geometry.polygon]]");
    expect(partsOf(mpm)[0]!.line).toEqual([[0, 0], [0, 20]]);
  });
  test("a circle with its radius in feet", () => {
    const circle = partsOf(text).find(({ kind }) => kind === "circle")!;
    expect(circle.circle!.centre).toEqual([30, 24]);
    expect(circle.circle!.radius.value).toBeCloseTo(18.288, 12);
  });
  test("what is drawn is read again", () => {
    let after = setGroundRange(read(text), "entry", 12, 2);
    after = setGroundRange(read(after), "exit", 28, 38);
    after = setTangent(read(after), 3, 1);
    after = addHeave(read(after), [20, 2], [25, 8]);
    after = addSlurry(read(after), [31, 5], [33, 7]);
    after = addCircle(read(after), [30, 20], [30, 4]);
    after = addCondition(read(after), "hydraulic", "right");
    expect(valueAt(after, "lem", "entry_exit")).toEqual({ entry: [2, 12], exit: [28, 38] });
    expect(valueAt(after, "lem", "tangent", "levels")).toEqual([1, 3]);
    expect(valueAt(after, "seepage", "heave", 0)).toEqual({ name: "heave", x: [20, 25], level: 2 });
    expect(valueAt(after, "slurry", 0)).toEqual({ name: "slurry", x: [31, 33], level: 7 });
    const found = partsOf(after);
    expect(found.map(({ kind }) => kind)).toEqual(["boundary", "traction", "hydraulic", "entry", "exit", "tangent", "slurry", "heave", "circle", "circle"]);
    expect(after).toContain("# of the laboratory");
  });
  test("a search is selected where its range is drawn", () => {
    const grid = setCentres(read(text), [40, 30], [20, 16]);
    expect(valueAt(grid, "lem", "grid", "corners")).toEqual([[20, 16], [40, 30]]);
    expect(valueAt(grid, "lem", "search")).toBe("grid");
    expect(valueAt(addWindow(read(grid), [20, 2], [25, 4]), "lem", "search")).toBe("block");
    expect(valueAt(setGroundRange(read(grid), "entry", 2, 4), "lem", "search")).toBe("entry_exit");
    expect(valueAt(setGroundRange(read(text), "entry", 2, 4), "lem", "search")).toBeUndefined();
  });
});

describe("Tables of forms", () => {
  const table = read('a = [[0, 1], ["10 kPa", 0.8]]\nb = [1, 2.5]\nc = ["x"]\nd = [[1, 2, 3]]');
  test("lists of numbers and pairs", () => {
    expect(readRows(table, ["a"])).toEqual({ columns: 2, cells: [["0", "1"], ["10 kPa", "0.8"]] });
    expect(readRows(table, ["b"])).toEqual({ columns: 1, cells: [["1"], ["2.5"]] });
    expect(readRows(table, ["c"])).toBeNull();
    expect(readRows(table, ["d"])).toBeNull();
  });
  test.each([
    ["1\t2\n3\t4", [["1", "2"], ["3", "4"]]],
    ["depth;su\n0;10,5\n2;12", [["0", "10.5"], ["2", "12"]]],
    ["1,2\r\n3,4\r\n", [["1", "2"], ["3", "4"]]],
    ["1\n2\n3", [["1"], ["2"], ["3"]]],
    ["0\t10 kPa\n1\t20 kPa", [["0", "10 kPa"], ["1", "20 kPa"]]],
  ])("pasted %j", (pasted, expected) => {
    expect(readPasted(pasted)).toEqual(expected);
  });
  test.each(["5", "a\tb\nc\td", "1\t2\n3", ""])("no table: %j", (pasted) => {
    expect(readPasted(pasted)).toBeNull();
  });
  test("a block grows the table, or is refused", () => {
    const rows = { columns: 2 as const, cells: [["0", "1"], ["2", "3"]] };
    expect(writeRows(pasteInto(rows, [["5", "6"], ["7", "8 m"]], 1, 0)!)).toBe('[[0, 1], [5, 6], [7, "8 m"]]');
    expect(pasteInto(rows, [["9"], ["8"]], 0, 1)).toEqual([["0", "9"], ["2", "8"]]);
    expect(pasteInto(rows, [["1", "2", "3"]], 0, 0)).toBeNull();
    expect(pasteInto(rows, [["1"], ["2"], ["3"]], 0, 0)).toBeNull();
    expect(pasteInto({ columns: 1, cells: [] }, [["1", "2", "3"]], 0, 0)).toEqual([["1"], ["2"], ["3"]]);
  });
});

describe("Units of display", () => {
  // 1 lbf = 0.45359237 kg · 9.80665 m/s², 1 ft = 0.3048 m.
  const poundForce = 0.45359237 * 9.80665;
  test("of SI nothing is converted", () => {
    expect(showQuantity(18, "kN/m3")).toEqual({ text: "18", converted: false });
    expect(writeQuantity("18", "kN/m3", null, true)).toBe("18");
  });
  test("values of the file are shown in pounds and feet", () => {
    system.value = "us";
    expect(Number(showQuantity(18, "kN/m3").text)).toBeCloseTo((18e3 * 0.3048 ** 3) / poundForce, 3);
    expect(showQuantity("200 psf", "kPa").text).toBe("200");
    expect(Number(showQuantity(10, "kPa").text)).toBeCloseTo((10e3 * 0.3048 ** 2) / poundForce, 3);
    expect(showQuantity("3 furlong", "m")).toEqual({ text: "3 furlong", converted: false });
    expect(showRange("10 to 28 kN/m3", "kN/m3")).toBe("63.7 to 178 pcf");
    expect(showRange("0.01 to 500 kPa, or 0", "kPa")).toBe("0.209 to 10400 psf, or 0");
  });
  test("a typed number keeps the unit that is written", () => {
    system.value = "us";
    expect(writeQuantity("120", "kN/m3", null, true)).toBe("120 pcf");
    expect(Number(writeQuantity("120", "kN/m3", 18, true))).toBeCloseTo((120 * poundForce) / 0.3048 ** 3 / 1e3, 7);
    expect(writeQuantity("500", "kPa", "2 ksf", true)).toBe("0.5 ksf");
    expect(writeQuantity("25 kPa", "kPa", null, true)).toBe("25 kPa");
  });
  test("units of texts", () => {
    expect(readQuantity("1 tsf", "kPa")!.value).toBeCloseTo((2000 * poundForce) / 0.3048 ** 2 / 1e3, 9);
    expect(readQuantity("5", "kPa")).toBeNull();
  });
  test("coordinates in feet, and a grid of feet", () => {
    expect(readCoordinates("10,20", null, 0.3048).point).toEqual([3.048, 6.096]);
    expect(readCoordinates("@10<0", [3.048, 0], 0.3048).point).toEqual([6.096, 0]);
    const snapped = snap([3.0, 6.0], { vertices: [], segments: [], grid: 0.3048, unit: 0.3048 }, 0.2, 0.01);
    expect(snapped).toEqual({ at: [3.048, 6.096], kind: "grid" });
  });
});

describe("Background pictures", () => {
  const start: Placement = { turn: [0.1, 0], shift: [5, 30] };
  test("two points scale, turn and shift", () => {
    expect(place(start, [10, 20])).toEqual([6, 28]);
    const from = [place(start, [0, 0]), place(start, [100, 0])] as const;
    // A quarter turn, twice as large: the upper edge stands upright.
    const after = placeByPoints(start, from, [[0, 0], [0, 20]])!;
    const [x, y] = place(after, [50, 10]);
    expect(x).toBeCloseTo(2, 12);
    expect(y).toBeCloseTo(10, 12);
    expect(placeByPoints(start, [from[0], from[0]], [[0, 0], [1, 1]])).toBeNull();
  });
});

describe("Own soils", () => {
  test("a file of others holds what is an entry", () => {
    const found = readEntries([{ symbol: "loess", ranges: { cohesion: [5, 10], bad: ["x", 1] }, note: "tests" }, { symbol: "" }, null, 5]);
    expect(found).toEqual([{ symbol: "loess", name: "own entry", ranges: { cohesion: [5, 10] }, note: "tests" }]);
    expect(mergeEntries(found, [{ ...found[0]!, note: "new" }])).toHaveLength(1);
    expect(readEntries("x")).toEqual([]);
  });
});
