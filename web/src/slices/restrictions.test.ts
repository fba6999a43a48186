// SPDX-License-Identifier: MIT
/** Restrictions of a search as sentences. */
import { beforeEach, describe, expect, it } from "vitest";

import type { Report } from "../contract";
import { report } from "../state";
import { listRestrictions } from "./restrictions";

beforeEach(() => {
  const units = { length: { name: "m", si: 1 }, line_force: { name: "kN/m", si: 1e3 } };
  report.value = { units, model: { bounds: [[0, 0], [90, 40]] } } as unknown as Report;
});

const none = { excluded: [], through: [], impenetrable: [] };
const degree = Math.PI / 180;

describe("restrictions of a search", () => {
  it("names windows and inclinations of blocks", () => {
    const windows = [
      { name: "toe", points: [[44, 25], [50, 27]] as [number, number][], is_box: true },
      { name: "top", points: [[70, 32]] as [number, number][], is_box: false },
    ];
    const block = { windows, active: [45 * degree, 70 * degree], passive: [-5 * degree, 30 * degree], angles: 5 };
    const [sentence] = listRestrictions({ ...none, block: block as never });
    expect(sentence).toContain("toe from (44, 25) to (50, 27); top (70, 32) m");
    expect(sentence).toContain("upper end rises at 45° to 70°, the lower end at −5° to 30°");
    expect(listRestrictions({ ...none, block: { ...block, windows: [], along: "seam" } as never })[0]).toMatch(
      /^Along seam;/,
    );
  });

  it("names tangents, areas, rock, side and size", () => {
    const sentences = listRestrictions({
      excluded: [{ name: "cellar", points: [[1, 2], [3, 2], [3, 4]], is_box: false }],
      through: [],
      impenetrable: ["rock"],
      tangent: { layer: "clay", is_top: false },
      slides_left: true,
      smallest_area: 20,
      smallest_weight: 4e5,
    });
    expect(sentences).toEqual([
      "Circles touch the bottom of clay.",
      "No surface enters cellar (1, 2), (3, 2), (3, 4) m.",
      "Surfaces follow the top of rock.",
      "Only masses that slide to the left.",
      "Area of the mass at least 20 m².",
      "Weight of the mass at least 400 kN/m.",
    ]);
  });
});
