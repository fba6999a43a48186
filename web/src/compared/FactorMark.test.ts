// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";

import type { Factor } from "../contract";
import { findProven, isRuledOut, makeFactorScale, markFactor, placeFactor, type Marked } from "./FactorMark";

const row = (method: string, factor: number | null, lower: number | null = null, upper: number | null = null) =>
  ({ method, factor, lower, upper }) as Marked;

describe("marks of factors", () => {
  it("stand before what limit analysis proves of the soil of their method", () => {
    const rows = [row("lem", 1.19, 1.18, 1.22), row("bounds", null, 1.1, 1.12), row("fem", 1.11, 1.09, 1.13)];
    const scale = makeFactorScale(rows)!;
    expect(rows.map((r) => findProven(scale, r))).toEqual([
      [1.18, 1.22],
      [1.1, 1.12],
      [1.1, 1.12],
    ]);
    expect(findProven(makeFactorScale(rows.slice(0, 1))!, rows[2]!)).toEqual([1.18, 1.22]);
    expect(makeFactorScale([row("fem", 1.2, 1.15, 1.21)])?.proven).toEqual({ lem: null, others: null });
    expect(makeFactorScale([row("lem", null)])).toBeNull();
  });

  it("are hollow where that rules them out", () => {
    const proven = row("bounds", null, 1.1, 1.12);
    const judge = (own: Marked, name: string) => isRuledOut(makeFactorScale([own, proven])!, { ...own, name });
    expect(judge(row("lem", 1.08), "spencer")).toBe(true);
    expect(judge(row("lem", 1.11), "spencer")).toBe(false);
    expect(judge(row("fem", 1.08, 1.05, 1.11), "associated")).toBe(false);
    expect(judge(row("fem", 1.18, 1.15, 1.21), "associated")).toBe(true);
    expect(judge(row("fem", 1.05, 1.04, 1.06), "given")).toBe(false);
  });

  it("have a common scale for near values, and stay at its border otherwise", () => {
    const scale = makeFactorScale([row("lem", 1.1, 1.0, 1.2), row("lem", 23.4), row("fem", 1.3, 1.25, 1.31)])!;
    expect(scale.low).toBeLessThan(1);
    expect(scale.high).toBeGreaterThan(1.31);
    expect(scale.high).toBeLessThan(1.4);
    expect(placeFactor(scale, 23.4)).toEqual({ at: 96, inside: false });
    expect(placeFactor(scale, 1.1).inside).toBe(true);
    expect(placeFactor(scale, 1.1).at).toBeLessThan(placeFactor(scale, 1.3).at);
  });

  it("of a later time are not judged by what is proven for the first one", () => {
    const least = { method: "lem", by: "spencer", name: "timeline.least", value: 0.885, lower: null, upper: null };
    const first = { method: "lem", by: "spencer", name: "lem.spencer", value: 1.083, lower: 1.05, upper: 1.072 };
    const rows = [least, first].map((factor) => markFactor(factor as Factor));
    const scale = makeFactorScale(rows)!;
    expect(rows.map((r) => findProven(scale, r))).toEqual([null, [1.05, 1.072]]);
    expect(rows.map((r) => isRuledOut(scale, r))).toEqual([false, true]);
    expect(placeFactor(scale, 1).inside).toBe(true);
  });
});
