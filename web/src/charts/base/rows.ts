// SPDX-License-Identifier: MIT
/** Rows of a table: the nearest to an abscissa, those that a chart of some hundred pixels needs, their order; as CSV (RFC 4180), and files saved. */
export interface CsvColumn {
  name: string;
  /** "-" for plain numbers; left out for words. */
  unit?: string;
  values: readonly (number | string | null)[];
}

function quote(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

function writeCell(value: number | string | null | undefined): string {
  if (value === null || value === undefined) return "";
  // String() is the shortest text that reads back to the same double.
  if (typeof value === "number") return Number.isFinite(value) ? String(value) : "";
  return quote(value);
}

/** All columns side by side, lines ended by CR LF; a shorter column ends in empty cells. */
export function writeCsv(columns: readonly CsvColumn[]): string {
  const rows = Math.max(0, ...columns.map((c) => c.values.length));
  const lines = [columns.map((c) => quote(c.unit === undefined ? c.name : `${c.name} [${c.unit || "-"}]`)).join(",")];
  for (let i = 0; i < rows; ++i) lines.push(columns.map((c) => writeCell(c.values[i])).join(","));
  return lines.join("\r\n") + "\r\n";
}

/** "Dry slope, rev. B" and "curve" → "dry-slope-rev-b-curve.csv". */
export function makeFileName(title: string, part: string): string {
  const clean = (text: string) =>
    text
      .normalize("NFKD")
      .replace(/[\u0300-\u036f]/g, "")
      .toLowerCase()
      .replace(/[^a-z0-9.]+/g, "-")
      .replace(/^[-.]+|[-.]+$/g, "");
  return [clean(title).slice(0, 60), clean(part)].filter(Boolean).join("-") + ".csv";
}

export function saveFile(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  // The browser has taken the data by then; without this the blob would stay for the life of the page.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Index of the number of ascending `sorted` nearest to `x`, the lower of two equally near; -1 when there is none. */
export function findNearest(sorted: ArrayLike<number>, x: number): number {
  let low = 0;
  let high = sorted.length - 1;
  if (high < 0 || Number.isNaN(x)) return -1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (sorted[middle]! < x) low = middle;
    else high = middle;
  }
  return Math.abs(sorted[high]! - x) < Math.abs(sorted[low]! - x) ? high : low;
}

/** Index of the frame whose `key` is nearest to `x`; frames without one are passed over; -1 when none has one. */
export function findNearestFrame<T>(frames: readonly T[], key: (frame: T) => number | null, x: number): number {
  let best = -1;
  let distance = Infinity;
  frames.forEach((frame, i) => {
    const k = key(frame);
    if (k !== null && Math.abs(k - x) < distance) {
      best = i;
      distance = Math.abs(k - x);
    }
  });
  return best;
}

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

/** Row numbers in the order of a column; rows without a value come last in both directions. */
export function orderValues(values: readonly (number | string | null)[], down: boolean): number[] {
  const sign = down ? -1 : 1;
  return Array.from(values.keys()).sort((a, b) => {
    const [x, y] = [values[a] ?? null, values[b] ?? null];
    if (x === null || y === null) return Number(x === null) - Number(y === null) || a - b;
    const difference =
      typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y), "en", { numeric: true });
    return sign * difference || a - b;
  });
}
