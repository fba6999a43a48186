// SPDX-License-Identifier: MIT
// The echo of the input: rows, and the case file made from them.
import { describe, expect, it } from "vitest";

import type { InputTable } from "../contract";
import { formatInput, listBlocks, writeToml } from "./inputRows";

const given = (value: unknown, unit?: string) => ({ value, given: true, ...(unit ? { unit } : {}) });
const assumed = (value: unknown) => ({ value, given: false });

const input: InputTable = {
  title: given('A "cut"'),
  geometry: {
    box: given(
      [
        [0, 0],
        [44, 17],
      ],
      "m",
    ),
    dimension: assumed(2),
    line: assumed([]),
  },
  materials: { "soft clay": { cohesion: given(2, "kPa"), tensile_strength: assumed(null) } },
  stage: [
    { name: given("gravity"), damping: given(0.75), rest: { hold: assumed(0.5) } },
    { name: given("slide"), damping: assumed(0.05), rest: { hold: given(1, "s") } },
  ],
};

describe("listBlocks", () => {
  it("has a row for every value, whatever its depth", () => {
    const rows = listBlocks(input).flatMap((block) => block.groups.flatMap((group) => group.rows));
    expect(rows).toHaveLength(12);
    expect(rows.filter((row) => row.given)).toHaveLength(7);
  });

  it("names the tables of a list by their number and name", () => {
    const stages = listBlocks(input).find((block) => block.name === "stage")!;
    expect(stages.groups.map((group) => group.title)).toEqual(["stage 1 (gravity)", "stage 2 (slide)"]);
    expect(stages.groups[1]!.rows.map((row) => row.key)).toEqual(["name", "damping", "rest.hold"]);
  });
});

describe("writeToml", () => {
  it("writes what the case file gave, and heads only above contents", () => {
    expect(writeToml(input, true)).toBe(
      [
        'title = "A \\"cut\\""',
        "",
        "[geometry]",
        "box = [[0, 0], [44, 17]]  # m",
        "",
        '[materials."soft clay"]',
        "cohesion = 2  # kPa",
        "",
        "[[stage]]",
        'name = "gravity"',
        "damping = 0.75",
        "",
        "[[stage]]",
        'name = "slide"',
        "",
        "[stage.rest]",
        "hold = 1  # s",
        "",
      ].join("\n"),
    );
  });

  it("writes defaults on request, but no empty values", () => {
    const text = writeToml(input, false);
    expect(text).toContain("dimension = 2");
    expect(text).not.toMatch(/tensile_strength|null|line =/);
  });
});

it("shows nothing, empty texts and lists as such", () => {
  expect([null, "", [], [1, [2, 3]], 0.1 + 0.2, true].map(formatInput)).toEqual([
    "–",
    "(empty)",
    "(none)",
    "[1, [2, 3]]",
    "0.3",
    "true",
  ]);
});
