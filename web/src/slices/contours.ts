// SPDX-License-Identifier: MIT
/** Lines of equal value on a grid of cells with gaps: marching squares between the middles of the cells. */

export type Segment = [number, number, number, number];

/** `value(column, row)` is NaN where there is none. Segments in units of cells, from the lower left corner. */
export function traceContour(
  columns: number,
  rows: number,
  value: (column: number, row: number) => number,
  level: number,
): Segment[] {
  const segments: Segment[] = [];
  for (let j = 0; j + 1 < rows; ++j)
    for (let i = 0; i + 1 < columns; ++i) {
      const corners = [
        [i, j],
        [i + 1, j],
        [i + 1, j + 1],
        [i, j + 1],
      ] as const;
      const values = corners.map(([a, b]) => value(a, b));
      if (values.some(Number.isNaN)) continue;
      const cuts: [number, number][] = [];
      for (let k = 0; k < 4; ++k) {
        const [a, b] = [values[k]!, values[(k + 1) % 4]!];
        if (a < level === b < level) continue;
        const fraction = (level - a) / (b - a);
        const [from, to] = [corners[k]!, corners[(k + 1) % 4]!];
        cuts.push([from[0] + fraction * (to[0] - from[0]) + 0.5, from[1] + fraction * (to[1] - from[1]) + 0.5]);
      }
      // Four cuts are a saddle: which pairs belong together is open, and either is right.
      for (let k = 0; k + 1 < cuts.length; k += 2) segments.push([...cuts[k]!, ...cuts[k + 1]!]);
    }
  return segments;
}
