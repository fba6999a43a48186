// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";

import { mergeTexts, otherMark } from "../src/document/merge";

const base = `title = "Slope"   # a comment

[materials.clay]
cohesion = 10
friction_angle = 20
unit_weight = 18

[lem]
methods = ["bishop"]
`;

describe("two changes of one text", () => {
  it("are both kept where they concern different lines", () => {
    const mine = base.replace("cohesion = 10", "cohesion = 12");
    const theirs = base.replace('["bishop"]', '["bishop", "spencer"]').replace("# a comment", "# another");
    const merged = mergeTexts(mine, base, theirs);
    expect(merged.conflicts).toBe(0);
    expect(merged.text).toBe(mine.replace('["bishop"]', '["bishop", "spencer"]').replace("# a comment", "# another"));
  });
  it("keep mine and comment theirs where they concern the same line", () => {
    const merged = mergeTexts(base.replace("cohesion = 10", "cohesion = 12"), base, base.replace("cohesion = 10", "cohesion = 14"));
    expect(merged.conflicts).toBe(1);
    expect(merged.text).toBe(base.replace("cohesion = 10", `cohesion = 12\n${otherMark}cohesion = 14`));
  });
  it("count equal changes once", () => {
    const both = base.replace("cohesion = 10", "cohesion = 12");
    expect(mergeTexts(both, base, both)).toEqual({ text: both, conflicts: 0 });
  });
  it("lose no line of either text", () => {
    // Any mixture of removed, changed and added lines: every line that one side added or changed is in the result.
    let seed = 7;
    const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
    for (let round = 0; round < 200; ++round) {
      const lines = Array.from({ length: 30 }, (_, i) => `key_${i} = ${i}`);
      const edit = (side: string) =>
        lines.flatMap((line, i) => {
          const drawn = random();
          if (drawn < 0.08) return [];
          if (drawn < 0.16) return [`key_${i} = ${side}${i}`];
          return drawn < 0.24 ? [line, `${side}_new_${i} = 1`] : [line];
        });
      const [mine, theirs] = [edit("mine"), edit("theirs")];
      const merged = mergeTexts(mine.join("\n"), lines.join("\n"), theirs.join("\n")).text;
      for (const line of [...mine, ...theirs].filter((l) => /mine|theirs/.test(l))) expect(merged).toContain(line);
    }
  });
});
