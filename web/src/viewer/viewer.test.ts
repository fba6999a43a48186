// SPDX-License-Identifier: MIT
/** The viewer: mesh, scales, slip surface, camera, colours. */
import { describe, expect, it } from "vitest";

import { roundDown } from "./arrows";
import { Camera } from "./camera";
import { findColour, tabulateCategories, tabulateColours } from "./colours";
import { measureSpacing } from "./extent";
import { findEdges } from "./meshEdges";
import { bandColours, findShare, makeLevels, makeScale, makeTicks, writeNumber } from "./scale";
import { findMovedLimit, findMovedLimits, findStrainRidge } from "./slipLines";

it("draws every side of triangles once", () => {
  // Two triangles with a common side.
  expect(findEdges([0, 1, 2, 2, 1, 3], 3, 4).length).toBe(5);
});

it("draws only the surface of tetrahedra", () => {
  // Four tetrahedra around node 4 within a larger one: the lines to the node in the middle are inside.
  const cells = [4, 1, 2, 3, 0, 4, 2, 3, 0, 1, 4, 3, 0, 1, 2, 4];
  const edges = findEdges(cells, 4, 5);
  expect(edges.length).toBe(6);
  expect(edges.some(([a, b]) => a === 4 || b === 4)).toBe(false);
});

it("rounds the length of the key down to 1, 2 or 5", () => {
  expect([9.3, 5, 4.99, 0.31, 0.0012].map(roundDown)).toEqual([5, 5, 2, 0.2, 0.001]);
});

describe("a logarithmic scale", () => {
  const scale = makeScale(0.001, 1, true);

  it("gives each decade the same fraction", () => {
    [0.001, 0.01, 0.1, 1].forEach((value, i) => expect(findShare(value, scale)).toBeCloseTo(i / 3, 10));
    expect(findShare(0, scale)).toBe(0);
    expect(findShare(50, scale)).toBe(1);
    expect(findShare(NaN, scale)).toBeNaN();
  });

  it("starts three decades below its upper end where the lower one is 0", () => {
    expect(makeScale(0, 0.5, true).low).toBeCloseTo(0.0005, 12);
  });

  it("has levels at 1, 2 and 5, or fewer where they are many", () => {
    const write = (count: number) => makeLevels(scale, count).map((level) => level.text).join(" ");
    expect(write(10)).toBe("0.001 0.002 0.005 0.01 0.02 0.05 0.1 0.2 0.5 1");
    expect(write(4)).toBe("0.001 0.003 0.01 0.03 0.1 0.3 1");
  });

  it("is not made where nothing is above 0", () => {
    expect(makeScale(-2, 0, true).logarithmic).toBe(false);
  });
});

it("bands have one colour each, and change at their ends", () => {
  const table = tabulateColours("viridis");
  const banded = bandColours(table, [0, 0.25, 0.5, 1]);
  const at = (colours: Uint8Array, place: number) => [...colours.subarray(4 * place, 4 * place + 3)].join();
  expect(new Set(Array.from({ length: 256 }, (_, i) => at(banded, i))).size).toBe(3);
  expect(at(banded, 63)).not.toBe(at(banded, 64));
  expect(at(banded, 64)).toBe(at(banded, 127));
  expect(at(banded, 127)).not.toBe(at(banded, 128));
  // The first and the last band have the ends of the map.
  expect([at(banded, 0), at(banded, 255)]).toEqual([at(table, 0), at(table, 255)]);
});

it("each of eight materials finds a colour of its own", () => {
  const table = tabulateCategories();
  const scale = makeScale(0, 255);
  const colours = [0, 1, 2, 3, 4, 5, 6, 7].map((material) => {
    expect(findColour(material, scale)).toBe(material);
    return [...table.subarray(4 * material, 4 * material + 3)].join();
  });
  expect(new Set(colours).size).toBe(8);
  // Okabe and Ito, orange.
  expect(colours[0]).toBe("230,159,0");
});

/** A square grid of points in a box of 40 m by 15 m with a band of strain around a height over x. */
function makeBand(height: (x: number) => number, strength: number) {
  const spacing = 0.25;
  const at: number[] = [];
  for (let x = spacing / 2; x < 40; x += spacing) for (let y = spacing / 2; y < 15; y += spacing) at.push(x, y);
  const positions = Float32Array.from(at);
  const strain = Float32Array.from({ length: at.length / 2 }, (_, i) => {
    const [x, y] = [at[2 * i]!, at[2 * i + 1]!];
    const inside = x > 8 && x < 32 ? 1 : 0;
    return 0.002 + 0.001 * Math.sin(7 * x + 3 * y) + strength * inside * Math.exp(-(((y - height(x)) / 0.6) ** 2));
  });
  return { positions, strain, spacing };
}

describe("slip surface", () => {
  it("is the circle above which soil moved", () => {
    const circle = (x: number) => 24 - Math.sqrt(20 ** 2 - (x - 20) ** 2);
    const { positions, spacing } = makeBand(circle, 0);
    const displacement = Float32Array.from({ length: positions.length / 2 }, (_, i) =>
      positions[2 * i + 1]! > circle(positions[2 * i]!) ? 0.5 : 0.02,
    );
    const line = findMovedLimit(positions, displacement, spacing, 0.1);
    expect(line.length).toBeGreaterThan(40);
    for (const [x, y] of line.slice(3, -3)) expect(Math.abs(y - circle(x))).toBeLessThan(spacing);
    expect(findMovedLimit(positions, displacement, spacing, 0.6)).toEqual([]);
  });
});

describe("slip surfaces of soil that moves to both sides", () => {
  const { positions, spacing } = makeBand(() => 0, 0);
  const limit = (x: number) => 3 + 0.05 * (x - 20) ** 2; // a bowl, lowest in the middle
  const heights = Array.from({ length: positions.length / 2 }, (_, i) => [positions[2 * i]!, positions[2 * i + 1]!]);
  const displacement = Float32Array.from(heights, ([x, y]) => (y! > limit(x!) ? 0.5 : 0));

  it("are two, which go up to the ground where they meet", () => {
    const across = Float32Array.from(heights, ([x], i) => (x! < 20 ? -0.8 : 0.8) * displacement[i]!);
    const lines = findMovedLimits(positions, displacement, across, spacing, 0.1);
    expect(lines).toHaveLength(2);
    const [left, right] = lines;
    expect(left![0]![0]).toBeLessThan(8);
    expect(right!.at(-1)![0]).toBeGreaterThan(32);
    for (const top of [left!.at(-1)!, right![0]!]) expect(top[1]).toBeGreaterThan(14);
    expect(left!.at(-1)![0]).toBeGreaterThan(right![0]![0]); // each wedge lies on the other side of the divide
    for (const [x, y] of left!.filter(([at]) => at > 6 && at < 19)) expect(Math.abs(y - limit(x))).toBeLessThan(0.4);
  });

  it("are one where all moves one way, or where that is not known", () => {
    const across = displacement.map((u) => 0.8 * u);
    const one = [findMovedLimit(positions, displacement, spacing, 0.1)];
    expect(findMovedLimits(positions, displacement, across, spacing, 0.1)).toEqual(one);
    expect(findMovedLimits(positions, displacement, null, spacing, 0.1)).toEqual(one);
    expect(findMovedLimits(positions, displacement, across, spacing, 0.6)).toEqual([]);
  });
});

describe("ridge of the strain", () => {
  it("follows a circular band, and only where it is", () => {
    const circle = (x: number) => 24 - Math.sqrt(20 ** 2 - (x - 20) ** 2);
    const { positions, strain, spacing } = makeBand(circle, 0.3);
    const line = findStrainRidge(positions, strain, spacing);
    expect(line.length).toBeGreaterThan(40);
    expect(line[0]![0]).toBeGreaterThan(7);
    expect(line.at(-1)![0]).toBeLessThan(33);
    expect(line.at(-1)![0] - line[0]![0]).toBeGreaterThan(22);
    for (const [x, y] of line.slice(3, -3)) expect(Math.abs(y - circle(x))).toBeLessThan(spacing);
  });

  it("is empty without a band", () => {
    const { positions, strain, spacing } = makeBand(() => 7, 0);
    expect(findStrainRidge(positions, strain, spacing)).toEqual([]);
  });
});

describe("camera", () => {
  it("keeps the point under the pixel when it zooms, also in space", () => {
    const camera = new Camera();
    Object.assign(camera, { width: 800, height: 400, azimuth: 0.7, elevation: 0.4 });
    camera.fit([0, 0, 0], [44, 15, 20]);
    const [x, y] = camera.makeProjection()(30, 5, 12);
    camera.zoom(3, x, y);
    const [x2, y2] = camera.makeProjection()(30, 5, 12);
    expect(x2).toBeCloseTo(x, 8);
    expect(y2).toBeCloseTo(y, 8);
  });

  it("fits the box between its margins, upright and true to scale", () => {
    const camera = new Camera();
    Object.assign(camera, { width: 1000, height: 400, margins: { left: 60, right: 100, top: 30, bottom: 50 } });
    camera.fit([0, 0, 0], [42, 10, 0]);
    const project = camera.makeProjection();
    const [low, high] = [project(0, 0, 0), project(42, 10, 0)];
    expect(low[0]).toBeCloseTo(60, 8);
    expect(high[0]).toBeCloseTo(900, 8);
    expect(low[1] - high[1]).toBeCloseTo(200, 8);
    expect((low[1] + high[1]) / 2).toBeCloseTo(190, 8);
  });

  it("has axes at right angles whose depth points towards the reader", () => {
    const camera = new Camera();
    camera.rotate(90, 50);
    const { right: r, up: u, near: n } = camera.findAxes();
    const cross = [r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]];
    cross.forEach((c, k) => expect(c).toBeCloseTo(n[k]!, 12));
  });
});

describe("colours", () => {
  it("are those of matplotlib", () => {
    const table = tabulateColours("viridis");
    expect([...table.slice(0, 3)]).toEqual([0x44, 0x01, 0x54]);
    // The middle of viridis is #21918c.
    [0x21, 0x91, 0x8c].forEach((c, k) => expect(Math.abs(table[4 * 128 + k]! - c)).toBeLessThanOrEqual(2));
    expect([...table.slice(4 * 255, 4 * 255 + 3)]).toEqual([0xfd, 0xe7, 0x25]);
  });

  it("stay at the ends beyond the limits", () => {
    expect([-5, 0.5, 9, NaN].map((value) => findColour(value, makeScale(0, 1)))).toEqual([0, 128, 255, -1]);
  });
});

describe("texts", () => {
  it("distinguish neighbouring ticks", () => {
    expect(makeTicks(-0.25, 0.5, 4).map((t) => t.text)).toEqual(["−0.2", "0.0", "0.2", "0.4"]);
    expect(makeTicks(0, 0.00247, 5).map((t) => t.text)).toEqual(["0.0000", "0.0005", "0.0010", "0.0015", "0.0020"]);
    expect(makeTicks(-220, -4, 5).map((t) => t.text)).toEqual(["−200", "−150", "−100", "−50"]);
  });

  it("show significant digits only", () => {
    const texts = [0, 0.62, -12.3456, 0.00123456, 1718.4, 3.2e-8, NaN].map(writeNumber);
    expect(texts).toEqual(["0", "0.620", "−12.35", "0.00123", "1718", "3.20e−8", "–"]);
  });
});

it("finds the spacing of a grid", () => {
  const at: number[] = [];
  for (let x = 0; x < 60; ++x) for (let y = 0; y < 60; ++y) at.push(x * 0.5, y * 0.5);
  expect(measureSpacing(Float32Array.from(at), 2, 1)).toBeCloseTo(0.5, 2);
});
