// SPDX-License-Identifier: MIT
/** Water in a section: contours of a field, ponds, and the place of a name. */
import { beforeEach, describe, expect, it } from "vitest";

import type { Report } from "../contract";
import { describeStrength, findRoom } from "../drawing/ground";
import { choosePlace, measureGap } from "../drawing/surfaceLines";
import { joinPonds, writeLevel } from "../drawing/standingWater";
import { report } from "../state";
import { findLimits, takeQuantity, traceLevel, type WaterArrays } from "./waterFields";

/** A square of 2 m in four triangles about its middle. */
const mesh = {
  nodes: Float64Array.from([0, 0, 2, 0, 2, 2, 0, 2, 1, 1]),
  triangles: Uint32Array.from([0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]),
};
/** Hydrostatic under y = 1.25 m. */
const pressure = Float32Array.from([0, 1, 2, 3, 4], (n) => 9810 * (1.25 - mesh.nodes[2 * n + 1]!));

describe("contours", () => {
  it("of a plane of pressure are level lines at the right height, from side to side", () => {
    const pieces = traceLevel(mesh, pressure, 9810 * 0.75);
    const points = pieces.flat();
    for (const [, y] of points) expect(y).toBeCloseTo(0.5, 6);
    const length = pieces.reduce((sum, [a, b]) => sum + Math.abs(b[0] - a[0]), 0);
    expect(length).toBeCloseTo(2, 6);
  });

  it("are not drawn beyond the limits of the field", () => {
    const [low, high] = findLimits({ mesh, values: pressure });
    expect([low, high].map((p) => p / 9810)).toEqual([expect.closeTo(-0.75, 6), expect.closeTo(1.25, 6)]);
    expect(traceLevel(mesh, pressure, high + 1)).toEqual([]);
  });
});

describe("a quantity by element", () => {
  it("has one value at the three corners of each triangle", () => {
    const saturation = Float32Array.from([0.5, 0.6, 0.7, 0.8]);
    const arrays = { mesh, pressure, saturation } as unknown as WaterArrays;
    const { mesh: own, values } = takeQuantity(arrays, "saturation")!;
    expect(own.triangles.length).toBe(12);
    expect(Array.from(values).slice(3, 6)).toEqual([saturation[1], saturation[1], saturation[1]]);
    expect(Array.from(own.nodes.subarray(4, 6)), "third corner of the first triangle").toEqual([1, 1]);
    expect(takeQuantity({ ...arrays, saturation: null }, "saturation")).toBeNull();
  });
});

describe("ponds", () => {
  const piece = (from: [number, number], to: [number, number], level: number) => ({ from, to, level_from: level, level_to: level });

  it("that touch under one level are one pond with one surface", () => {
    const ponds = [piece([29.5, 17], [52, 8], 17), piece([52, 8], [70, 8], 17)];
    expect(joinPonds(ponds)).toEqual([
      { surface: [[29.5, 17], [70, 17]], ground: [[29.5, 17], [52, 8], [52, 8], [70, 8]] },
    ]);
  });

  it("apart, or of another level, are ponds of their own", () => {
    expect(joinPonds([piece([0, 5], [4, 5], 6), piece([8, 5], [9, 5], 6)])).toHaveLength(2);
    expect(joinPonds([piece([0, 5], [4, 5], 6), piece([4, 5], [9, 5], 7)])).toHaveLength(2);
  });
});

describe("texts", () => {
  beforeEach(() => {
    report.value = { units: { length: { name: "m", si: 1 } } } as Report;
  });

  it("write a level in usual form", () => {
    expect([17, 17.256, -0.5].map(writeLevel)).toEqual(["17 m", "17.26 m", "−0.5 m"]);
  });

  it("stand where a polygon is widest, and not under the one that lies over it", () => {
    const outer = [[0, 0], [10, 0], [10, 4], [0, 4]];
    const lens = [[0, 0], [7, 0], [7, 4], [0, 4]];
    const { at, radius } = findRoom(outer, [lens])!;
    expect(at[0]).toBeGreaterThan(7);
    expect(radius).toBeGreaterThan(1);
    const band = [[0, 0], [30, 0], [30, 1], [0, 1]];
    expect(Math.abs(findRoom(band, [])!.at[0] - 4.5), "in a band, away from its end").toBeLessThan(1);
    expect(findRoom(lens, [outer.map(([x, y]) => [x! * 2 - 1, y! * 2 - 1])]), "all of it is covered").toBeNull();
  });
});

describe("labels of slip surfaces", () => {
  const box = (x: number, y: number) => ({ x, y, half: 16, high: 8 });

  it("keep a gap from each other, and else stand where they are farthest apart", () => {
    expect(measureGap(box(0, 0), box(0, 30))).toBe(9);
    expect(measureGap(box(0, 0), box(20, 10))).toBeLessThan(0);
    expect(choosePlace([box(10, 5), box(0, 20), box(0, 30)], [box(0, 0)])).toEqual(box(0, 30));
    expect(choosePlace([box(1, 1), box(5, 8), box(2, 2)], [box(0, 0)])).toEqual(box(5, 8));
  });
});

describe("the strength of a soil on the figure", () => {
  it("is what its law has, with its growth", () => {
    const property = (key: string, unit: string, characteristic: number | null) => ({ key, unit, characteristic });
    const materials = [
      {
        name: "clay",
        properties: [property("cohesion", "kPa", 18), property("friction_angle", "°", 0), property("cohesion_gradient", "kPa/m", 1.5)],
      },
      { name: "mud", properties: [property("undrained_strength", "psf", 400), property("undrained_gradient", "psf/ft", 0)] },
      { name: "rock", properties: [property("young_modulus", "MPa", 900)] },
    ];
    report.value = { model: { materials } } as unknown as Report;
    expect(["clay", "mud", "rock"].map(describeStrength)).toEqual([
      "c = 18\u00a0kPa + 1.5\u00a0kPa/m, φ = 0°",
      "s_u = 400\u00a0psf",
      "",
    ]);
  });
});
