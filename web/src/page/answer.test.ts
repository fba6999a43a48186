// SPDX-License-Identifier: MIT
// The first statement of the answer with several methods.
import { describe, expect, it } from "vitest";

import type { DesignStatement, Factor, Report } from "../contract";
import { findMechanism } from "./opening";
import { getResistance, splitFactors } from "./shortFactors";

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
