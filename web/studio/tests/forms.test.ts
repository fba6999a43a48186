// SPDX-License-Identifier: MIT
/** Forms from the schema, and the library of typical values. */
import { describe, expect, test } from "vitest";

import type { JsonSchema } from "../src/engine/engine";
import { checkTyped, isRelevant, listFields, writeTyped } from "../src/forms/schema";
import { entries } from "../src/library/library";
import { findOffset } from "../src/panels/offsets";

/** As `talus schema` writes it. */
const schema = JSON.parse(`{"allOf": [{
  "if": {"properties": {"model": {"const": "mohr_coulomb"}}, "required": ["model"]}, "then": {"required": ["cohesion"]}
}]}`) as JsonSchema;
Object.assign(schema, {
  properties: {
    unit_weight: {
      anyOf: [{ type: "number", exclusiveMinimum: 0 }, { type: "string", pattern: "x" }],
      description: "γ, weight of the soil. Unit of plain numbers: kN/m3. Usually 10 to 28 kN/m3.",
    },
    cohesion: {
      anyOf: [{ type: "number", minimum: 0 }, { type: "string", pattern: "x" }],
      description: 'Cohesion c. Unit of plain numbers: kPa. Usually 0.01 to 500 kPa, or 0. Only where model = "mohr_coulomb" or "bedding".',
    },
    gsi: { type: "number", description: 'GSI of the rock mass. Usually 5 to 90. Only where model = "hoek_brown".' },
    model: { enum: ["mohr_coulomb", "tresca"], default: "tresca", description: "How stress follows strain. mohr_coulomb: with friction. tresca: without." },
  },
});

describe("Fields", () => {
  const fields = listFields(schema, { model: "mohr_coulomb" });
  const find = (key: string) => fields.find((field) => field.key === key)!;

  test("required keys come first, and those of other models are left out", () => {
    expect(fields.map(({ key }) => key)).toEqual(["cohesion", "unit_weight", "model"]);
    expect(find("cohesion").required).toBe(true);
    expect(listFields(schema, { model: "tresca" }).map(({ key }) => key)).toEqual(["unit_weight", "model"]);
    expect(listFields(schema, { model: "tresca", gsi: 40 }).map(({ key }) => key)).toContain("gsi");
  });
  test("unit, usual range and meaning are taken from the description", () => {
    expect(find("cohesion")).toMatchObject({ unit: "kPa", usual: "0.01 to 500 kPa, or 0", meaning: "Cohesion c.", kind: "quantity" });
    expect(find("model").choices).toEqual([
      { value: "mohr_coulomb", meaning: "with friction" },
      { value: "tresca", meaning: "without" },
    ]);
    expect(find("model").meaning).toBe("How stress follows strain.");
  });
  test("conditions on other keys than the model", () => {
    expect(isRelevant('φᵇ. Only where suction_strength = "phi_b".', { suction_strength: "none" })).toBe(false);
    expect(isRelevant("Only where void_ratio is not given.", {})).toBe(true);
  });
  test("typed values", () => {
    expect(checkTyped(find("cohesion"), "5")).toBe("");
    expect(checkTyped(find("cohesion"), "5 kPa")).toBe("");
    expect(checkTyped(find("cohesion"), "-5")).toBe("At least 0.");
    expect(checkTyped(find("unit_weight"), "0")).toBe("More than 0.");
    expect(checkTyped(find("cohesion"), "2,5")).toContain("decimal point");
    expect(writeTyped(find("cohesion"), ".5")).toBe("0.5");
    expect(writeTyped(find("cohesion"), "3 kPa")).toBe('"3 kPa"');
    expect(writeTyped(find("model"), "tresca")).toBe('"tresca"');
  });
});

describe("Library", () => {
  test("a clay of low plasticity, converted by hand", () => {
    const { ranges } = entries.find(({ symbol }) => symbol === "CL")!;
    // 107 pcf at 17.0 % to 109 pcf at 17.6 %; 0.12 to 0.16 tsf.
    expect(ranges.unit_weight).toEqual([19.7, 20.1]);
    expect(ranges.cohesion).toEqual([11.5, 15.3]);
    expect(ranges.friction_angle).toEqual([26, 30]);
  });
  test("all ranges are within those of real soils", () => {
    for (const { ranges } of entries)
      for (const [key, [low, high]] of Object.entries(ranges)) {
        const [least, most] = { unit_weight: [10, 28], cohesion: [0, 500], friction_angle: [5, 50] }[key]!;
        expect(low).toBeGreaterThanOrEqual(least!);
        expect(high).toBeGreaterThanOrEqual(low);
        expect(high).toBeLessThanOrEqual(most!);
      }
  });
});

test("bytes of UTF-8 become places of the text", () => {
  const text = "φ = 30 # 𝛾, °\nc = 2";
  for (let i = 0; i <= text.length; ++i) {
    const code = text.charCodeAt(i);
    if (code >= 0xdc00 && code < 0xe000) continue;
    expect(findOffset(text, new TextEncoder().encode(text.slice(0, i)).length)).toBe(i);
  }
});
