// SPDX-License-Identifier: MIT
import { strFromU8, unzipSync } from "fflate";
import { describe, expect, it } from "vitest";

import type { Report } from "../../src/contract";
import type { JsonSchema } from "../src/engine/engine";
import { listRunFactors, listValues, type Summary } from "../src/output/summary";
import { writeDocument } from "../src/output/wordDocument";

const materials: JsonSchema = {
  type: "object",
  properties: {
    unit_weight: { anyOf: [{ type: "number" }, { type: "string" }], description: "Unit weight. Unit of plain numbers: kN/m3." },
    cohesion: { anyOf: [{ type: "number" }, { type: "string" }], description: "Cohesion. Unit of plain numbers: kPa." },
    water: { type: "object", properties: { retention: { enum: ["dry", "saturated"] } } },
  },
};

describe("a summary", () => {
  it("lists values with their units; texts keep the unit in which they are written", () => {
    expect(listValues(materials, { unit_weight: 20, cohesion: "500 psf", water: { retention: "dry" } })).toEqual([
      ["Unit weight", "20", "kN/m³"],
      ["Cohesion", "500", "psf"],
      ["Water: Retention", "dry", ""],
    ]);
  });
  it("lists factors of a run with their intervals, and the reason where there is none", () => {
    const factor = { by: "", name: "", main: true } as const;
    const given = {
      method_titles: { lem: "LEM", fem: "FEM", bounds: "Limit analysis", mpm: "MPM" },
      answer: {
        sentences: [],
        results: [],
        factors: [
          { ...factor, method: "fem", title: "non-convergence", value: 1.3456, lower: 1.31, upper: 1.36, note: "" },
          { ...factor, method: "bounds", title: "lower and upper bound", value: null, lower: 1.3, upper: null, note: "no mechanism" },
          { ...factor, method: "lem", title: "critical circle", value: null, lower: null, upper: null, note: "no surface" },
        ],
      },
    } as unknown as Report;
    expect(listRunFactors(given).rows).toEqual([
      ["FEM", "non-convergence", "1.346", "1.310 – 1.360", ""],
      ["Limit analysis", "lower and upper bound", "–", "≥ 1.300", "no mechanism"],
      ["LEM", "critical circle", "none", "", "no surface"],
    ]);
  });
});

describe("a document", () => {
  it("has every part of the summary as text, whatever characters it has", async () => {
    const summary: Summary = {
      title: "Slope <b> & \"quotes\"",
      facts: [["Case file", "slope.toml"]],
      factors: { head: ["Method", "Criterion", "Factor"], rows: [["Bishop", "critical circle", "1.440"]] },
      note: "",
      soils: [{ name: "clay (soil)", table: { head: ["Property", "Value", "Unit"], rows: [["Cohesion", "2", "kPa"]] } }],
      lists: [{ title: "Water", lines: ["Water table through (0, 11) m"] }],
      warnings: ["The mesh is coarse."],
      noWarnings: "No warnings of the quick search.",
    };
    const picture = { data: new Uint8Array([137, 80, 78, 71]), width: 1200, height: 800 };
    const files = unzipSync(new Uint8Array(await (await writeDocument(summary, picture)).arrayBuffer()));
    const text = strFromU8(files["word/document.xml"]!);
    for (const part of ["Slope &lt;b&gt; &amp; ", "slope.toml", "1.440", "clay (soil)", "kPa", "Water table through (0, 11) m", "The mesh is coarse."])
      expect(text).toContain(part);
    expect(text).not.toContain(summary.noWarnings);
    expect(Object.keys(files).some((name) => name.startsWith("word/media/"))).toBe(true);
    const calm = unzipSync(new Uint8Array(await (await writeDocument({ ...summary, warnings: [] }, null)).arrayBuffer()));
    expect(strFromU8(calm["word/document.xml"]!)).toContain(summary.noWarnings);
  });
});
