// SPDX-License-Identifier: MIT
/** Scales, levels and bands against numbers worked out by hand. */
import { describe, expect, it } from "vitest";

import { findColour, tabulateCategories, tabulateColours } from "./colours";
import { bandColours, findShare, makeLevels, makeScale } from "./scale";

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
