// SPDX-License-Identifier: MIT
// CSV of the charts: what a reader after RFC 4180 gets back is what was put in, to the last digit.
import { expect, test } from "vitest";

import { makeFileName, writeCsv } from "../../src/charts/base/csv";

/** A reader after the grammar of RFC 4180, independent of the writer. */
function readCsv(text: string): string[][] {
  const rows: string[][] = [[]];
  let cell = "";
  let quoted = false;
  for (let i = 0; i < text.length; ++i) {
    const c = text[i]!;
    if (quoted && c === '"' && text[i + 1] === '"') {
      cell += '"';
      ++i;
    } else if (c === '"') quoted = !quoted;
    else if (!quoted && c === ",") {
      rows[rows.length - 1]!.push(cell);
      cell = "";
    } else if (!quoted && c === "\r" && text[i + 1] === "\n") {
      rows[rows.length - 1]!.push(cell);
      rows.push([]);
      cell = "";
      ++i;
    } else cell += c;
  }
  expect(cell).toBe("");
  return rows.slice(0, -1);
}

test("every double comes back as itself", () => {
  const values = [0.1 + 0.2, 1 / 3, 3.575102018074865e-15, Number.MAX_VALUE, 5e-324, -1234567.891, 1e21];
  const rows = readCsv(writeCsv([{ name: "srf", unit: "-", values }]));
  expect(rows[0]).toEqual(["srf [-]"]);
  expect(rows.slice(1).map((r) => Number(r[0]))).toEqual(values);
});

test("commas, quotes and line breaks stay inside their cells", () => {
  const words = ['FoS, "frozen"', "two\r\nlines", "plain"];
  const rows = readCsv(writeCsv([{ name: "a,b", values: words }, { name: "h", unit: "m", values: [1, 2, 3] }]));
  expect(rows).toEqual([["a,b", "h [m]"], [words[0], "1"], [words[1], "2"], [words[2], "3"]]);
});

test("a missing value is an empty cell, never a zero or a word, and rows stay whole", () => {
  const rows = readCsv(writeCsv([
    { name: "t", unit: "s", values: [0, 1, 2] },
    { name: "u", unit: "mm", values: [null, Number.NaN] },
  ]));
  expect(rows.slice(1)).toEqual([["0", ""], ["1", ""], ["2", ""]]);
});

test("file names hold nothing that a file system minds", () => {
  const name = makeFileName('Böschung A/B: "Nord"', "history_runout_1.75");
  expect(name).toBe("boschung-a-b-nord-history-runout-1.75.csv");
  expect(makeFileName("..", "curve")).toBe("curve.csv");
});
