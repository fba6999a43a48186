// SPDX-License-Identifier: MIT
/** Selects the rows of a long history for a chart of some hundred pixels. */

/**
 * Rows that give the same picture as all: of every one of `columns` equal groups the first, the smallest and
 * the largest value, and the last row of all. Every peak stays. All rows when there are few.
 */
export function pickRows(values: readonly (number | null)[], columns: number): number[] {
  const count = values.length;
  if (count <= 3 * columns) return Array.from({ length: count }, (_, i) => i);
  const picked = new Set<number>();
  for (let c = 0; c < columns; ++c) {
    const from = Math.floor((c * count) / columns);
    const to = Math.floor(((c + 1) * count) / columns);
    let low = -1;
    let high = -1;
    for (let i = from; i < to; ++i) {
      const v = values[i];
      // A gap has to stay a gap.
      if (v === null || v === undefined) picked.add(i);
      else {
        if (low < 0 || v < values[low]!) low = i;
        if (high < 0 || v > values[high]!) high = i;
      }
    }
    for (const i of [from, low, high]) if (i >= 0) picked.add(i);
  }
  picked.add(count - 1);
  return [...picked].sort((a, b) => a - b);
}
