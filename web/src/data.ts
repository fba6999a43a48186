// SPDX-License-Identifier: MIT
/** Reads the document and its packed arrays from the page. */
import type { PackedArray, PackedPlaces, Report, ReportDocument, Results } from "./contract";

/** Packed array → text in base64. The page finds it in the document; a test reads it from a file. */
export type Source = (id: string) => string;

/** What `talus report DIR --data` writes. */
export interface ReportData {
  report: ReportDocument;
  results: Results;
  arrays: Record<string, string>;
}

let given: ReportData["arrays"] = {};

/** Takes a report that the page does not hold. Returns the ids of its arrays that differ from those before. */
export function takeArrays({ arrays }: ReportData): string[] {
  const before = given;
  given = arrays;
  return Object.keys(before).filter((id) => before[id] !== arrays[id]);
}

const fromPage: Source = (id) => {
  if (given[id] !== undefined) return given[id];
  const element = document.getElementById(id);
  if (!element) throw new Error(`the report holds no array '${id}'`);
  return element.textContent ?? "";
};

/** The report that the page holds, or null when nothing was filled in. */
export function readReport(): Report | null {
  const [report, results] = ["talus-report", "talus-results"].map((id) => document.getElementById(id)?.textContent);
  return report && results ? { ...JSON.parse(report), ...JSON.parse(results) } : null;
}

async function inflate(base64: string): Promise<Uint8Array> {
  // A plain loop: Uint8Array.from with a function takes twenty times as long for some megabytes.
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const widths = { u8: 1, u16: 2, u32: 4, f32: 4 } as const;

/** Joins the planes: byte k of number i is at k × count + i. */
function joinPlanes(bytes: Uint8Array, width: number): Uint8Array {
  const count = bytes.length / width;
  const joined = new Uint8Array(bytes.length);
  for (let k = 0; k < width; ++k) for (let i = 0; i < count; ++i) joined[i * width + k] = bytes[k * count + i]!;
  return joined;
}

/** The numbers as stored; rows are summed up where the array holds differences. */
export async function readIntegers(array: PackedArray, source: Source = fromPage) {
  const width = widths[array.type];
  let bytes = await inflate(source(array.id));
  if (bytes.length % width) throw new Error(`array '${array.id}' is damaged: it ends within a number`);
  if (array.planes && width > 1) bytes = joinPlanes(bytes, width);
  const numbers =
    array.type === "u8" ? bytes
    : array.type === "u16" ? new Uint16Array(bytes.buffer)
    : array.type === "u32" ? new Uint32Array(bytes.buffer)
    : new Float32Array(bytes.buffer);
  const count = array.shape.reduce((a, b) => a * b, 1);
  if (numbers.length !== count) throw new Error(`array '${array.id}' has ${numbers.length} numbers, not ${count}`);
  if (array.delta && array.shape[0]! > 1) {
    const row = count / array.shape[0]!;
    // A typed array wraps around by itself.
    for (let i = row; i < count; ++i) numbers[i] = numbers[i]! + numbers[i - row]!;
  }
  return numbers;
}

/** A packed array as values in SI; NaN where there is none. */
export async function readValues(array: PackedArray, source: Source = fromPage): Promise<Float32Array> {
  const numbers = await readIntegers(array, source);
  if (!array.range) return Float32Array.from(numbers);
  const [min, max] = array.range;
  const step = (max - min) / 65534;
  const values = new Float32Array(numbers.length);
  for (let i = 0; i < values.length; ++i) values[i] = numbers[i] === 65535 ? Number.NaN : min + numbers[i]! * step;
  return values;
}

/** Packed coordinates [m]; NaN where there is none. */
export async function readPlaces(array: PackedPlaces, source: Source = fromPage): Promise<Float64Array> {
  const numbers = await readIntegers(array, source);
  const { origin, step, type } = array;
  const width = origin.length;
  const places = new Float64Array(numbers.length);
  for (let i = 0; i < places.length; ++i) {
    const none = type === "u16" && numbers[i] === 65535;
    places[i] = none ? Number.NaN : origin[i % width]! + step[i % width]! * numbers[i]!;
  }
  return places;
}
