// SPDX-License-Identifier: MIT
/** Decoding of packed arrays against arrays packed by hand, byte by byte. */
import { deflateSync } from "node:zlib";
import { describe, expect, it } from "vitest";

import type { PackedArray, PackedPlaces } from "../src/contract";
import { readIntegers, readPlaces, readValues } from "../src/data";

/** The text that the page holds for these bytes. */
const pack = (bytes: number[]) => Buffer.from(deflateSync(Uint8Array.from(bytes))).toString("base64");
const of = (bytes: number[]) => () => pack(bytes);

const base = { id: "a", delta: false, planes: false } as const;

describe("readIntegers", () => {
  it("reads little endian numbers of every width", async () => {
    const u8: PackedArray = { ...base, type: "u8", shape: [3] };
    expect([...(await readIntegers(u8, of([0, 7, 255])))]).toEqual([0, 7, 255]);
    const u16: PackedArray = { ...base, type: "u16", shape: [2] };
    expect([...(await readIntegers(u16, of([0x02, 0x01, 0xff, 0xff])))]).toEqual([0x0102, 0xffff]);
    const u32: PackedArray = { ...base, type: "u32", shape: [2] };
    expect([...(await readIntegers(u32, of([4, 3, 2, 1, 255, 255, 255, 255])))]).toEqual([0x01020304, 4294967295]);
    // -1.5 = sign 1, exponent 127, fraction 0.5: 0xbfc00000; 0.1f is the nearest float.
    const f32: PackedArray = { ...base, type: "f32", shape: [2] };
    const floats = await readIntegers(f32, of([0, 0, 0xc0, 0xbf, 0xcd, 0xcc, 0xcc, 0x3d]));
    expect([...floats]).toEqual([-1.5, Math.fround(0.1)]);
  });

  it("joins byte planes: all lowest bytes stand first", async () => {
    const u16: PackedArray = { ...base, type: "u16", shape: [3], planes: true };
    expect([...(await readIntegers(u16, of([0x01, 0x02, 0xff, 0x00, 0x01, 0xfe])))]).toEqual([1, 0x0102, 0xfeff]);
    const u32: PackedArray = { ...base, type: "u32", shape: [2], planes: true };
    expect([...(await readIntegers(u32, of([4, 8, 3, 7, 2, 6, 1, 5])))]).toEqual([0x01020304, 0x05060708]);
  });

  it("sums up differences along the first axis only, and wraps around the type's range", async () => {
    // Rows (1, 250), (3, 5), (2, 5): 250 → 5 is +11 modulo 256, 3 → 2 is +255.
    const u8: PackedArray = { ...base, type: "u8", shape: [3, 2], delta: true };
    expect([...(await readIntegers(u8, of([1, 250, 2, 11, 255, 0])))]).toEqual([1, 250, 3, 5, 2, 5]);
    // 5 → 65535 → 0, planes and differences together: differences are 5, 65530 = 0xfffa, 1.
    const u16: PackedArray = { ...base, type: "u16", shape: [3], delta: true, planes: true };
    expect([...(await readIntegers(u16, of([5, 0xfa, 1, 0, 0xff, 0])))]).toEqual([5, 65535, 0]);
    // A row of several axes: [2][2][2].
    const cube: PackedArray = { ...base, type: "u8", shape: [2, 2, 2], delta: true };
    expect([...(await readIntegers(cube, of([1, 2, 3, 4, 1, 1, 1, 1])))]).toEqual([1, 2, 3, 4, 2, 3, 4, 5]);
  });

  it("leaves a single row alone, and reads an array without numbers", async () => {
    const one: PackedArray = { ...base, type: "u8", shape: [1, 3], delta: true };
    expect([...(await readIntegers(one, of([9, 1, 1])))]).toEqual([9, 1, 1]);
    const none: PackedArray = { ...base, type: "u16", shape: [0, 2], delta: true, planes: true };
    expect(await readIntegers(none, of([]))).toHaveLength(0);
  });

  it("names the array with too few or too many numbers", async () => {
    const array: PackedArray = { ...base, type: "u8", shape: [2, 2] };
    await expect(readIntegers(array, of([1, 2, 3]))).rejects.toThrow("array 'a' has 3 numbers, not 4");
    await expect(readIntegers(array, of([1, 2, 3, 4, 5]))).rejects.toThrow("array 'a' has 5 numbers, not 4");
  });

  it("fails on a damaged stream, never with wrong numbers", async () => {
    const array: PackedArray = { ...base, type: "u8", shape: [400] };
    const whole = pack(Array.from({ length: 400 }, (_, i) => (i * i * 7) % 251));
    await expect(readIntegers(array, () => whole.slice(0, whole.length / 2))).rejects.toThrow();
    await expect(readIntegers(array, () => "AAAA" + whole.slice(4))).rejects.toThrow();
  });
});

describe("readValues", () => {
  it("maps 0 and 65534 to the ends of the range, the rest evenly, and 65535 to NaN", async () => {
    const array: PackedArray = { ...base, type: "u16", shape: [4], range: [-3, 5] };
    // 32767 is half of 65534: the middle of the range.
    const values = await readValues(array, of([0x00, 0x00, 0xfe, 0xff, 0xff, 0x7f, 0xff, 0xff]));
    expect([...values]).toEqual([-3, 5, 1, Number.NaN]);
  });

  it("keeps 'no value' through differences: a point that is lost and comes back", async () => {
    const array: PackedArray = { ...base, type: "u16", shape: [3, 1], delta: true, range: [0, 65534] };
    // 7 → 65535 → 9: differences 7, 65528 = 0xfff8, 10.
    expect([...(await readValues(array, of([7, 0, 0xf8, 0xff, 10, 0])))]).toEqual([7, Number.NaN, 9]);
  });

  it("gives numbers without a range as they are", async () => {
    const array: PackedArray = { ...base, type: "u16", shape: [1] };
    expect([...(await readValues(array, of([0xff, 0xff])))]).toEqual([65535]);
  });
});

describe("readPlaces", () => {
  const easting = 500_000.25;
  const northing = 4_000_000.5;

  it("gives each component its own origin and step, and keeps the digits of a map", async () => {
    const places: PackedPlaces = {
      ...base, type: "u16", shape: [2, 1, 2], delta: true, origin: [easting, northing], step: [0.001, 0.0005],
    };
    // Rows (3, 7) and (65535, 9): the differences are 65532 = 0xfffc and 2.
    const read = await readPlaces(places, of([3, 0, 7, 0, 0xfc, 0xff, 2, 0]));
    expect(read[0]).toBeCloseTo(easting + 0.003, 9);
    expect(read[1]).toBeCloseTo(northing + 0.0035, 9);
    expect(read[2]).toBeNaN();
    expect(read[3]).toBeCloseTo(northing + 0.0045, 9);
  });

  it("adds floats to the origin in double precision", async () => {
    const places: PackedPlaces = { ...base, type: "f32", shape: [1, 2], origin: [easting, northing], step: [1, 1] };
    // -1.5 and 0.1f, as above: a float of 4,000,000.6 would be off by 0.1.
    const read = await readPlaces(places, of([0, 0, 0xc0, 0xbf, 0xcd, 0xcc, 0xcc, 0x3d]));
    expect([...read]).toEqual([easting - 1.5, northing + Math.fround(0.1)]);
  });
});
