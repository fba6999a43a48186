// SPDX-License-Identifier: MIT
/** Numbers as text, on axes, and in CSV. */
import { expect, test } from "vitest";

import { describeAxis, findLogTicks, findStep, formatLogTick } from "../../src/charts/base/axes";
import { makeFileName, writeCsv } from "../../src/charts/base/rows";
import { formatNumber, scaleUnit } from "../../src/charts/base/numbers";

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

/** Reads "−3.6×10⁻¹⁵" and "10⁻³" back. */
function readNumber(text: string): number {
  const raised = (t: string) => t.replace("⁻", "-").replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (c) => String("⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c)));
  const power = /^(?:(.*)×)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/.exec(text.replace("−", "-"));
  return power ? Number(`${power[1] ?? "1"}e${raised(power[2]!)}`) : Number(text.replace("−", "-"));
}

test("four digits are kept over the whole range", () => {
  for (const value of [1.5934724, 0.00123456, -392.1234, 12345.678, 999999.4, 5.23934e-16, -6.02214e23]) {
    const digits = Math.abs(value) >= 1e6 || Math.abs(value) < 1e-3 ? 3 : 4;
    expect(Math.abs(readNumber(formatNumber(value)) / value - 1)).toBeLessThan(0.51 * 10 ** (1 - digits));
  }
  expect(formatNumber(0)).toBe("0");
  expect(formatNumber(null)).toBe("–");
  expect(formatNumber(Number.NaN)).toBe("–");
});

test("all ticks of an axis have different texts that read back as their values", () => {
  const axes = [[0, 3400], [1.395, 1.495], [-0.002, 0.0004], [0, 2.7e-4], [-3e7, 5e6], [99.9, 100.1]] as const;
  for (const [low, high] of axes) {
    const { format, power } = describeAxis(low, high, 6);
    const step = findStep(low, high, 6);
    const scale = power ? readNumber(power) : 1;
    const ticks = [];
    for (let k = Math.ceil(low / step); k * step <= high; ++k) ticks.push(k * step);
    expect(ticks.length).toBeGreaterThanOrEqual(3);
    expect(ticks.length).toBeLessThanOrEqual(13);
    for (const t of ticks) expect(Math.abs(readNumber(format(t)) * scale - t)).toBeLessThan(1e-9 * (high - low));
    expect(new Set(ticks.map(format)).size).toBe(ticks.length);
  }
});

test("ticks of coordinates of a map have no power of ten, which would hide what tells them apart", () => {
  const { format, power } = describeAxis(6_329_708, 6_329_713, 5);
  expect(power).toBe("");
  expect([6_329_709, 6_329_710].map(format)).toEqual(["6329709", "6329710"]);
  expect(describeAxis(0, 6_329_713, 5).power).toBe("10⁶");
});

test("logarithmic ticks lie inside, are few, and are named rightly", () => {
  for (const [low, high] of [[3e-15, 0.5], [0.2, 5000], [2, 30], [0.9, 1.1e5], [0.4, 0.9]] as const) {
    const ticks = findLogTicks([low, high], 6);
    expect(ticks.length).toBeGreaterThanOrEqual(1);
    expect(ticks.length).toBeLessThanOrEqual(7);
    for (const t of ticks) {
      expect(t).toBeGreaterThanOrEqual(low * (1 - 1e-9));
      expect(t).toBeLessThanOrEqual(high * (1 + 1e-9));
      expect(readNumber(formatLogTick(t)) / t).toBeCloseTo(1, 9);
    }
  }
});

test("joules are shown in the unit that keeps numbers short, and only joules", () => {
  for (const largest of [3, 4e3, 7e6, 2e9]) {
    const { factor } = scaleUnit("J", largest);
    expect(largest * factor).toBeGreaterThanOrEqual(1);
    expect(largest * factor).toBeLessThan(1000);
  }
  expect(scaleUnit("kPa", 1e7)).toEqual({ unit: "kPa", factor: 1 });
});
