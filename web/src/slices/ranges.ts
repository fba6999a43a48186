// SPDX-License-Identifier: MIT
/** The ranges that a search chose exits and entries from. */
import type { Pen } from "../drawing/pen";
import { strokeLine } from "../viewer/lines";

/** Ranges of x under the section, each on a line of its own unless they are the same. */
export function drawRanges({ context, camera, place, theme }: Pen, exit?: number[], entry?: number[]): void {
  const same = exit && entry && exit[0] === entry[0] && exit[1] === entry[1];
  const ranges: [string, number[] | undefined][] = same
    ? [["exit and entry", exit]]
    : [
        ["exit", exit],
        ["entry", entry],
      ];
  context.font = "600 11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  ranges.forEach(([name, range], i) => {
    if (!range) return;
    const y = camera.height - 27 - 14 * i;
    const [from, to] = range.map((x) => place([x, 0])[0]) as [number, number];
    strokeLine(
      context,
      [
        [from, y],
        [to, y],
      ],
      { colour: theme.accent, width: 2.5 },
    );
    for (const x of [from, to])
      strokeLine(
        context,
        [
          [x, y - 4],
          [x, y + 4],
        ],
        { colour: theme.accent, width: 1.5 },
      );
    context.lineWidth = 4;
    context.strokeStyle = theme.ground;
    context.fillStyle = theme.ink;
    context.strokeText(name, (from + to) / 2, y + 4);
    context.fillText(name, (from + to) / 2, y + 4);
  });
}
