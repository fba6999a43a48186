// SPDX-License-Identifier: MIT
/** Tables as CSV (RFC 4180): header `name [unit]`, numbers with all their digits, empty where there is no value; and files saved. */
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
