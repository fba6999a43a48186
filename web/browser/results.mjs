// SPDX-License-Identifier: MIT
// Reads the results folder and the packed arrays of the page without any code of the page.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { inflateSync } from "node:zlib";

/** summary.json of the folder, or null (a study has none). */
export function readSummary(folder) {
  const path = join(folder, "summary.json");
  return existsSync(path) ? JSON.parse(readFileSync(path, "utf8")) : null;
}

/** A CSV as rows of cells; a number becomes a number. */
export function readCsv(text) {
  const cell = (t) => (t.trim() !== "" && Number.isFinite(Number(t)) ? Number(t) : t.replace(/^"(.*)"$/, "$1"));
  return text.trim().split(/\r?\n/).map((line) => line.split(",").map(cell));
}

const widths = { u8: 1, u16: 2, u32: 4 };

/** Decodes one row (frame) of a packed u8, u16 or u32 array of the page; NaN for "no value". */
export async function readFrame(page, array, frame) {
  const text = await page.evaluate((id) => document.getElementById(id)?.textContent ?? "", array.id);
  const bytes = inflateSync(Buffer.from(text, "base64"));
  const width = widths[array.type];
  const count = bytes.length / width;
  const row = count / array.shape[0];
  const read = (i) => {
    let number = 0;
    for (let k = width - 1; k >= 0; --k) number = number * 256 + bytes[array.planes ? k * count + i : i * width + k];
    return number;
  };
  const values = Array.from({ length: row }, () => 0);
  for (let f = array.delta ? 0 : frame; f <= frame; ++f)
    for (let i = 0; i < row; ++i) values[i] = (values[i] + read(f * row + i)) % 256 ** width;
  if (array.origin)
    return values.map((q, i) => {
      const component = i % array.origin.length;
      return q === 65535 ? Number.NaN : array.origin[component] + array.step[component] * q;
    });
  if (!array.range) return values;
  const [min, max] = array.range;
  return values.map((q) => (q === 65535 ? Number.NaN : min + (q * (max - min)) / 65534));
}

/** Numbers in a text of the page: real minus signs, spaces between digits and powers of ten are read too. */
export function findNumbers(text) {
  const plain = text.replace(/\u2212/g, "-").replace(/(\d)[\u202f\u2009\u00a0](?=\d{3}(?!\d))/g, "$1");
  const lower = (character) => "-0123456789"["⁻⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(character)];
  const powers = plain.replace(/\s*[×·]\s*10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/g, (_, power) => `e${[...power].map(lower).join("")}`);
  return [...powers.matchAll(/-?\d+(?:\.\d+)?(?:e[+-]?\d+)?/gi)].map((match) => Number(match[0]));
}

/** Returns whether a text shows `value` to `digits` significant digits, or better. */
export function showsNumber(text, value, digits) {
  return findNumbers(text).some((n) => Math.abs(n - value) <= Math.abs(value) * 0.5 * 10 ** (1 - digits) + 1e-12);
}
