// SPDX-License-Identifier: MIT
// Numbers as engineers write them.
import { describe, expect, it } from "vitest";

import type { Report } from "../contract";
import { report } from "../state";
import {
  formatCoordinate,
  formatDate,
  formatDifference,
  formatDuration,
  formatFactor,
  formatNumber,
  formatPlace,
  formatQuantity,
  formatSentence,
  roundDown,
  roundUp,
  splitSentences,
} from "./format";

describe("ends of the intervals of limit analysis", () => {
  it("are rounded outward", () => {
    expect([1.2349, 1.235, null].map(roundDown)).toEqual([1.234, 1.235, null]);
    expect([1.2341, 1.235, null].map(roundUp)).toEqual([1.235, 1.235, null]);
  });
});

describe("formatNumber", () => {
  it.each([
    [0, "0"],
    [2650, "2650"],
    [45000, "45\u202f000"],
    [0.4539518, "0.454"],
    [5.454197, "5.454"],
    [91.32258, "91.32"],
    [-12.5, "−12.5"],
    [-45000, "−45\u202f000"],
    [123456.7, "123\u202f457"],
    [0.0002384, "2.384 × 10⁻⁴"],
    [2.15e9, "2.15 × 10⁹"],
    [null, "–"],
    [Number.NaN, "–"],
    [Number.POSITIVE_INFINITY, "∞"],
  ])("writes %s as %s", (value, text) => expect(formatNumber(value)).toBe(text));

  it("keeps the zeros of a result on request", () => {
    expect(formatNumber(2.8, 3)).toBe("2.8");
    expect(formatNumber(2.8, 3, true)).toBe("2.80");
  });
});

it("converts to the unit shown and leaves a missing unit away", () => {
  expect(formatQuantity(0.02974, { name: "mm", si: 1e-3 })).toBe("29.74\u00a0mm");
  expect(formatQuantity(1.393, { name: "-", si: 1 })).toBe("1.393");
  expect(formatQuantity(Math.PI / 6, { name: "deg", si: Math.PI / 180 })).toBe("30°");
  expect(formatQuantity(null, { name: "m", si: 1 })).toBe("–");
});

it("gives factors of safety three decimals", () => {
  expect(formatFactor(1.4)).toBe("1.400");
  expect(formatFactor(null)).toBe("–");
});

it("writes durations in usual units", () => {
  expect(formatDuration(16.887)).toBe("16.9\u00a0s");
  expect(formatDuration(245)).toBe("4\u00a0min 05\u00a0s");
  // Not "60 min": rounding goes first.
  expect(formatDuration(7199.7)).toBe("2\u00a0h 00\u00a0min");
});

it("writes dates in full and leaves other texts alone", () => {
  expect(formatDate("2026-11-20T07:47:57Z")).toBe("20 November 2026, 07:47 UTC");
  expect(formatDate("spring")).toBe("spring");
});

it("makes sentences of the results' lines", () => {
  expect(formatSentence("the mesh is coarse")).toBe("The mesh is coarse.");
  expect(formatSentence("Is it?")).toBe("Is it?");
  expect(formatSentence("λ = 0.45")).toBe("λ = 0.45.");
  expect(formatSentence("f₀ = 1.080")).toBe("f₀ = 1.080.");
});

it("splits a text at the ends of its sentences alone", () => {
  expect(splitSentences("it falls below 1 at 8 h, where F = 1.006. It is least at 16 h, 0.885.")).toEqual([
    "It falls below 1 at 8 h, where F = 1.006.",
    "It is least at 16 h, 0.885.",
  ]);
  expect(splitSentences("suction gives 3.8 % of it")).toEqual(["Suction gives 3.8 % of it."]);
});

it("writes differences with one decimal", () => {
  expect([-4.7e-6, 0.000_4, 0.016, -0.0368].map(formatDifference)).toEqual([
    "±0.0\u00a0%",
    "±0.0\u00a0%",
    "+1.6\u00a0%",
    "−3.7\u00a0%",
  ]);
});

it("writes coordinates to a ten-thousandth of the model, in the unit of lengths, wherever the axes begin", () => {
  const write = (low: number[], high: number[], si: number, place: number[]) => {
    report.value = { model: { bounds: [low, high] }, units: { length: { name: si === 1 ? "m" : "ft", si } } } as Report;
    return formatPlace(place);
  };
  expect(write([0, 0], [44, 17], 1, [12, 15.0625])).toBe("(12, 15.063)\u00a0m");
  expect(write([500_000, 4_000_000], [500_044, 4_000_017], 1, [500_012.5, 4_000_015.062])).toBe(
    "(500\u202f012.5, 4\u202f000\u202f015.062)\u00a0m",
  );
  expect(write([0, 0], [30.48, 12], 0.3048, [3.048, 6.096])).toBe("(10, 20)\u00a0ft");
  expect(formatCoordinate(0)).toBe("0");
});
