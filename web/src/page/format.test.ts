// SPDX-License-Identifier: MIT
/** Numbers and words of the page; the answer. */
import { describe, expect, it } from "vitest";

import type { DesignStatement, Factor, Report } from "../contract";
import { report } from "../state";
import { getResistance, splitFactors } from "./Answer";
import {
  formatCoordinate, formatDate, formatDifference, formatDuration, formatFactor, formatNumber, formatPlace,
  formatQuantity, formatSentence, roundDown, roundUp, splitSentences,
} from "./format";
import { findMechanism } from "./Page";

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

const makeFactor = (method: Factor["method"], name: string, value: number, kind: Partial<Factor>, main = false) =>
  ({ method, name, title: name, value, lower: null, upper: null, note: "", main, ...kind }) as Factor;
const factors = [
  makeFactor("lem", "lem.bishop", 1.44, { by: "bishop", source: "critical" }),
  makeFactor("lem", "lem.spencer", 1.439, { by: "spencer", source: "critical" }, true),
  makeFactor("lem", "lem.noncircular.janbu", 1.38, { by: "janbu", source: "noncircular" }),
  makeFactor("lem", "lem.noncircular.spencer", 1.434, { by: "spencer", source: "noncircular" }),
  makeFactor("fem", "fem.factor", 1.432, { by: "as_given", measure: "equilibrium" }, true),
  makeFactor("fem", "fem.by_displacement", 1.432, { by: "as_given", measure: "displacement" }),
  makeFactor("fem", "fem.associated.factor", 1.463, { by: "associated", measure: "equilibrium" }),
  makeFactor("mpm", "factor_of_safety.frozen", 1.393, { by: "frozen" }, true),
  makeFactor("mpm", "factor_of_safety.bilinear", 1.593, { by: "bilinear" }),
  makeFactor("mpm", "factor_of_safety.jump", 1.625, { by: "jump" }),
];

describe("the check with design values", () => {
  const partial = { values: [{ key: "resistance", title: "", symbol: "", value: 1.1 }] } as DesignStatement;

  it("divides by the resistance factor, which is 1 without a set", () => {
    expect(getResistance(partial)).toBe(1.1);
    expect(getResistance(null)).toBe(1);
    expect(1.068 / getResistance(partial)).toBeLessThan(1);
  });
});

describe("the short table", () => {
  it("has the main rows and what explains them, the fold all others", () => {
    const { shown, folded } = splitFactors(factors);
    expect(shown.map((f) => f.name)).toEqual([
      "lem.spencer",
      "lem.noncircular.spencer",
      "fem.factor",
      "fem.associated.factor",
      "factor_of_safety.frozen",
      "factor_of_safety.bilinear",
    ]);
    expect(shown.length + folded.length).toBe(factors.length);
  });

  it("has all of MPM alone", () => {
    const own = factors.filter((f) => f.method === "mpm");
    expect(splitFactors(own)).toEqual({ shown: own, folded: [] });
  });
});

describe("the viewer", () => {
  const still = { end: "time", force_ratio: 1e-8, nodal_speed: 1e-8 };
  const moving = { end: "time", force_ratio: 2e-3, nodal_speed: 1e-3 };
  const make = (points: object[], method = "fem") =>
    ({
      answer: { factors },
      methods_read: {},
      result: { input: {}, curve: { points }, methods: { surfaces: [{ method }] } },
      model: { slope_height: 10 },
      sequences: [
        { id: "stages", kind: "stages", frames: [{ factor: null }] },
        { id: "curve", kind: "curve", frames: [1.3, 1.4, 1.5, 1.6].map((factor) => ({ factor })), fields: [] },
      ],
    }) as unknown as Report;
  const points = [1.3, 1.4, 1.5, 1.6].map((srf) => ({ srf, ...(srf < 1.45 ? still : moving) }));

  it("opens on the first trial above the factor that continues to move", () => {
    expect(findMechanism(make(points))).toEqual({ sequence: 1, frame: 2 });
  });
  it("opens on the first above the factor where all come to rest", () => {
    expect(findMechanism(make(points.map((p) => ({ ...p, ...still }))))).toEqual({ sequence: 1, frame: 1 });
  });
  it("is left alone where no other method has a surface", () => {
    expect(findMechanism(make(points, "mpm"))).toBeNull();
  });
});
