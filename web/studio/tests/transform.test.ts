// SPDX-License-Identifier: MIT
/** Copies, mirrors, parallels and splits, against lengths and areas known in closed form. */
import { describe, expect, test } from "vitest";

import { type Chain, listChains } from "../src/document/chains";
import { copyChain, mapChains, mirrorAt, offsetChain, scaleAbout, shiftBy, splitLine, splitLineBy, turnAbout } from "../src/document/transform";
import { type CaseTree, findNode, readTree, toPlain } from "../src/document/tree";
import { pointsOf } from "../src/document/vertices";
import { offsetLine, offsetRing } from "../src/geometry/offset";
import { computeArea, type Point } from "../src/geometry/plane";

const text = `title = "Parts"

[[geometry.polygon]]
name = "lower"  # a comment
points = [[0, 0], [20, 0], [20, 5], [0, 5]]

[[geometry.polygon]]
name = "upper"
points = [[0, 5], [20, 5], [20, 8], [0, 8]]

[[geometry.line]]
name = "crest"
points = [[0, 8], [10, 8], [20, 8]]

[regions]
lower = "clay"
upper = "sand"

[[traction]]
on = "crest"
traction = [0, "-50 kPa"]   # a footing

[support.nails]
kind = "nail"
first = [4, 6]
lengths = [3]

[[lem.surface]]
name = "own"
points = [[1, 8], [5, 2], [12, 8]]
`;

function read(from: string): CaseTree {
  const { tree, fault } = readTree(from);
  if (!tree) throw new Error(fault.text);
  return tree;
}
const find = (from: string, name: string, kind?: Chain["kind"]) =>
  listChains(read(from)).find((chain) => chain.name === name && (!kind || chain.kind === kind))!;
const valueAt = (from: string, ...path: (string | number)[]) => toPlain(findNode(read(from), path));
const rounded = (points: readonly Point[]) => points.map((p) => p.map((v) => Number(v.toFixed(6)) + 0));

describe("Maps of the plane", () => {
  test.each([
    ["shift", shiftBy(2, -1), [3, 1]],
    ["mirror at x = 4", mirrorAt([4, 0], [4, 1]), [7, 2]],
    ["mirror at y = x", mirrorAt([0, 0], [3, 3]), [2, 1]],
    ["quarter turn about (1, 0)", turnAbout([1, 0], 90), [-1, 0]],
    ["twice as large about (0, 2)", scaleAbout([0, 2], 2), [2, 2]],
  ])("%s", (_, map, expected) => {
    expect(map([1, 2])).toEqual(expected);
  });
});

describe("Parallels", () => {
  test("of a right angle, on both sides", () => {
    expect(rounded(offsetLine([[0, 0], [10, 0], [10, 5]], 1)!)).toEqual([[0, 1], [9, 1], [9, 5]]);
    expect(rounded(offsetLine([[0, 0], [10, 0], [10, 5]], -1)!)).toEqual([[0, -1], [11, -1], [11, 5]]);
  });
  test("of a rectangle: area (a + 2d)(b + 2d)", () => {
    const ring: Point[] = [[0, 0], [20, 0], [20, 5], [0, 5]];
    expect(Math.abs(computeArea(offsetRing(ring, 1)!))).toBeCloseTo(22 * 7, 9);
    expect(Math.abs(computeArea(offsetRing(ring.toReversed(), -1)!))).toBeCloseTo(18 * 3, 9);
    expect(offsetRing(ring, -3)).toBeNull();
  });
  test("every side of the result is at the distance from its own", () => {
    const line: Point[] = [[0, 15], [12, 15], [32, 5], [44, 5]];
    const found = offsetLine(line, -2)!;
    expect(found).toHaveLength(4);
    // Slope 1:2: level sides sink by 2, the corner moves by 2 tan(½ atan ½).
    const shift = 2 * Math.tan(Math.atan(0.5) / 2);
    expect(rounded(found)).toEqual(rounded([[0, 13], [12 - shift, 13], [32 - shift, 3], [44, 3]]));
  });
  test("a side that is shorter than the parallel allows vanishes", () => {
    const notch: Point[] = [[0, 0], [10, 0], [10.5, -0.5], [11, 0], [20, 0]];
    const found = offsetLine(notch, 3)!;
    expect(found.every(([, y]) => y >= 2.4)).toBe(true);
    expect(found.every((p, i) => i === 0 || p[0] > found[i - 1]![0])).toBe(true);
  });
});

describe("Copies", () => {
  test("a named line, with a name of its own", () => {
    const tree = read(text);
    const after = copyChain(tree, find(text, "crest"), shiftBy(0, -2));
    expect(valueAt(after, "geometry", "line", 1)).toEqual({ name: "crest 2", points: [[0, 6], [10, 6], [20, 6]] });
    expect(after).toContain("# a comment");
  });
  test("a region over another cuts it", () => {
    const after = copyChain(read(text), find(text, "upper"), shiftBy(0, 3));
    const copy = find(after, "upper 2");
    expect(copy.soil).toBe("sand");
    expect(Math.abs(computeArea(pointsOf(copy)))).toBeCloseTo(60, 9);
    const areas = listChains(read(after)).filter(({ kind }) => kind === "region").reduce((sum, chain) => sum + Math.abs(computeArea(pointsOf(chain))), 0);
    expect(areas).toBeCloseTo(100 + 60 + 60, 9);
  });
  test("a mirrored slip surface still runs from left to right", () => {
    const after = copyChain(read(text), find(text, "own"), mirrorAt([10, 0], [10, 1]));
    expect(valueAt(after, "lem", "surface", 1)).toEqual({ name: "own 2", points: [[8, 8], [15, 2], [19, 8]] });
  });
  test("nails keep their strengths", () => {
    const after = copyChain(read(text), find(text, "nails"), shiftBy(1, -1));
    expect(valueAt(after, "support", "nails 2")).toEqual({ kind: "nail", first: [5, 5], lengths: [3] });
  });
});

describe("Shapes in place", () => {
  test("neighbours and points on their sides follow: no gap opens", () => {
    const tree = read(text);
    const chains = listChains(tree);
    const after = mapChains(tree, chains, [chains.find(({ name }) => name === "upper")!], shiftBy(0, 1));
    expect(valueAt(after, "geometry", "polygon", 0, "points")).toEqual([[0, 0], [20, 0], [20, 6], [0, 6]]);
    expect(Math.abs(computeArea(pointsOf(find(after, "upper"))))).toBeCloseTo(60, 9);
    expect(valueAt(after, "geometry", "line", 0, "points")).toEqual([[0, 9], [10, 9], [20, 9]]);
  });
  test("several shapes are mirrored together", () => {
    const tree = read(text);
    const chains = listChains(tree);
    const after = mapChains(tree, chains, chains.filter(({ kind }) => kind === "surface"), mirrorAt([10, 0], [10, 1]));
    expect(valueAt(after, "lem", "surface", 0, "points")).toEqual([[8, 8], [15, 2], [19, 8]]);
  });
});

describe("Parallel shapes", () => {
  test("inside of a region: a region of the same soil", () => {
    const after = offsetChain(read(text), find(text, "lower"), -1);
    expect(find(after, "lower 2").soil).toBe("clay");
    expect(Math.abs(computeArea(pointsOf(find(after, "lower 2"))))).toBeCloseTo(18 * 3, 9);
  });
  test("a layer 1.5 m below a line", () => {
    const after = offsetChain(read(text), find(text, "crest"), -1.5);
    expect(valueAt(after, "geometry", "line", 1, "points")).toEqual([[0, 6.5], [10, 6.5], [20, 6.5]]);
  });
  test("nothing is left", () => {
    expect(() => offsetChain(read(text), find(text, "upper"), -2)).toThrow(/Nothing is left/);
  });
});

describe("Split lines", () => {
  test("at a point; the traction acts on both parts", () => {
    const after = splitLine(read(text), find(text, "crest"), 1);
    expect(valueAt(after, "geometry", "line")).toEqual([{ name: "crest", points: [[0, 8], [10, 8]] }, { name: "crest 2", points: [[10, 8], [20, 8]] }]);
    expect(valueAt(after, "traction")).toEqual([{ on: "crest", traction: [0, "-50 kPa"] }, { on: "crest 2", traction: [0, "-50 kPa"] }]);
    expect(after).toContain("# a footing");
  });
  test("where another line crosses", () => {
    const after = splitLineBy(read(text), find(text, "crest"), [[4, 10], [4, 6]]);
    expect(valueAt(after, "geometry", "line", 0, "points")).toEqual([[0, 8], [4, 8]]);
    expect(valueAt(after, "geometry", "line", 1, "points")).toEqual([[4, 8], [10, 8], [20, 8]]);
    expect(() => splitLineBy(read(text), find(text, "crest"), [[4, 3], [4, 6]])).toThrow(/does not cross/);
  });
  test("not at an end", () => {
    expect(() => splitLine(read(text), find(text, "crest"), 0)).toThrow(/between its ends/);
  });
});
