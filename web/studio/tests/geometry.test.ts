// SPDX-License-Identifier: MIT
/** Snapping, typed coordinates, pasted tables, splitting. */
import { describe, expect, test } from "vitest";

import { readCoordinates, readPastedPoints } from "../src/geometry/coordinates";
import { computeArea, type Point } from "../src/geometry/plane";
import { cutRing, splitRing } from "../src/geometry/regions";
import { snap, type SnapTargets } from "../src/geometry/snap";

describe("Snapping", () => {
  const targets: SnapTargets = {
    vertices: [[0, 0], [10, 0]],
    segments: [[[0, 0], [10, 0]], [[5, -5], [5, 5]]],
    grid: 1,
  };
  const at = (p: Point, radius = 0.4) => snap(p, targets, radius, 0.01);

  test("a vertex comes before a crossing, a crossing before a line, a line before the grid", () => {
    expect(at([0.2, 0.1])).toEqual({ at: [0, 0], kind: "vertex" });
    expect(at([5.2, 0.1])).toEqual({ at: [5, 0], kind: "intersection" });
    expect(at([7.5, 0.2], 0.3)).toEqual({ at: [7.5, 0], kind: "line" });
    expect(at([3.1, 3.2])).toEqual({ at: [3, 3], kind: "grid" });
  });
  test("on a line the grid is met where it is near", () => {
    expect(at([7.9, 0.2])).toEqual({ at: [8, 0], kind: "line" });
  });
  test("a place nearly level with the anchor is level with it", () => {
    const anchored = { ...targets, anchor: [2, 3.5] as const };
    expect(snap([4.55, 3.45], anchored, 0.4, 0.01)).toEqual({ at: [4.55, 3.5], kind: "aligned" });
    expect(snap([4.1, 3.45], anchored, 0.4, 0.01)).toEqual({ at: [4, 3.5], kind: "aligned" });
    expect(snap([2.1, 2.48], anchored, 0.4, 0.01)).toEqual({ at: [2, 2.48], kind: "aligned" });
    expect(snap([4.1, 4.1], anchored, 0.4, 0.01).kind).toBe("grid");
  });
  test("away from everything the place is rounded to what a pixel shows", () => {
    expect(at([3.5031, 3.4972])).toEqual({ at: [3.5, 3.5], kind: "free" });
    expect(snap([3.14159, 2.71828], { vertices: [], segments: [], grid: 0 }, 1, 0.05)).toEqual({ at: [3.14, 2.72], kind: "free" });
  });
  test("nothing farther than the radius attracts", () => {
    expect(at([0.5, 0.45], 0.4).kind).not.toBe("vertex");
  });
});

describe("Typed coordinates", () => {
  test.each([
    ["12,5", [12, 5]],
    [" -3.5 , 2e1 ", [-3.5, 20]],
    ["12 5", [12, 5]],
    ["12;5", [12, 5]],
    ["@3,-2", [13, 18]],
    ["10<0", [20, 20]],
    ["@10<90", [10, 30]],
    ["2<−90", [10, 18]],
  ] as const)("%s", (text, point) => {
    const { point: found } = readCoordinates(text, [10, 20]);
    expect(found![0]).toBeCloseTo(point[0], 9);
    expect(found![1]).toBeCloseTo(point[1], 9);
  });
  test("a slope of 2 to 1 is met by its angle", () => {
    const { point } = readCoordinates("22.360679775<-26.565051177", [12, 15]);
    expect(point![0]).toBeCloseTo(32, 6);
    expect(point![1]).toBeCloseTo(5, 6);
  });
  test("what is no point is refused with what was expected", () => {
    expect(readCoordinates("12", null).fault).toContain("x,y");
    expect(readCoordinates("1,2,3", null).fault).toContain("x,y");
    expect(readCoordinates("@1,1", null).fault).toContain("absolute");
    expect(readCoordinates("5<30", null).fault).toContain("absolute");
  });
  test("tables of a spreadsheet, with a header and decimal commas", () => {
    expect(readPastedPoints("x\ty\n0,5\t1\n2\t3,25\n")).toEqual([[0.5, 1], [2, 3.25]]);
    expect(readPastedPoints("0, 1\n2, 3")).toEqual([[0, 1], [2, 3]]);
    expect(readPastedPoints("a\nb\nc")).toBeNull();
  });
});

describe("Regions", () => {
  const ring: Point[] = [[0, 0], [10, 0], [10, 10], [0, 10]];
  const total = (rings: readonly (readonly Point[])[]) => rings.reduce((sum, r) => sum + Math.abs(computeArea(r)), 0);

  test("the parts of a split ring have its area", () => {
    for (const line of [[[-1, 5], [11, 5]], [[0, 0], [10, 10]], [[0, 3], [4, 7], [6, 1], [10, 3]], [[5, 10], [5, 0]]] as Point[][]) {
      const rings = splitRing(ring, line)!;
      expect(rings).not.toBeNull();
      expect(total(rings)).toBeCloseTo(100, 9);
      expect(Math.min(...rings.map((r) => Math.abs(computeArea(r))))).toBeGreaterThan(1);
    }
  });
  test("a line along a side or within the ring splits nothing", () => {
    expect(splitRing(ring, [[0, 0], [10, 0]])).toBeNull();
    expect(splitRing(ring, [[2, 2], [8, 8]])).toBeNull();
    expect(splitRing(ring, [[-5, 20], [20, 20]])).toBeNull();
  });
  test("a cut leaves what is outside of the cutter", () => {
    const rest = cutRing(ring, [[4, -1], [6, -1], [6, 11], [4, 11]])!;
    expect(rest).toHaveLength(2);
    expect(total(rest)).toBeCloseTo(80, 9);
    expect(cutRing(ring, [[20, 0], [30, 0], [30, 10]])).toBeNull();
    expect(cutRing(ring, [[2, 2], [4, 2], [4, 4]])).toBeNull();
    // A common side is no overlap.
    expect(cutRing(ring, [[10, 0], [20, 0], [20, 10], [10, 10]])).toBeNull();
  });
});
