// SPDX-License-Identifier: MIT
/** Colour maps for colour-blind readers, and the tables that the drawing looks colours up in. */
import { findShare, type Scale } from "./scale";

/**
 * 25 colours at equal distances, six digits each: viridis, cividis and inferno of matplotlib, RdBu of ColorBrewer
 * without its dark ends.
 */
const stops = {
  viridis:
    "440154471063481f70472d7b4439834046883b528b365d8d31688e2c728e287c8e24868e21918c" +
    "1f9a8a20a48628ae8035b77948c16e5ec96275d05490d743addc30c8e020e5e419fde725",
  cividis:
    "00224e002a5f0031701a386f2a3f6d38476c434e6c4d556c575d6d61656f6a6c717374757d7c78" +
    "868379918b789b9476a59c74b0a571bcae6cc6b667d2c060dec958e9d34ef6dd3ffee838",
  inferno:
    "000004050417110a30210c4a320a5e450a6957106e67166e781c6d8a226a9a2865ab2f5ebc3754" +
    "ca404ad84c3ee45a31ed6925f57b17f98e09fca108fbb61af9cb35f4df53f2f27dfcffa4",
  blueRed:
    "1b5a9c266caf327cb73e8cbf529dc86eaed28ac0dba2cde3b8d8e9cfe4efddebf2eaf1f5f7f6f6" +
    "f9eee7fbe4d6fdd9c4f9c6acf6b394f19e7de6866adc6e57d05548c43b3cb72230a21328",
} as const;

export type ColourMapName = keyof typeof stops | "redBlue";

export const colourMapTitles: Record<ColourMapName, string> = {
  viridis: "Viridis",
  cividis: "Cividis",
  inferno: "Inferno",
  blueRed: "Blue–white–red",
  redBlue: "Red–white–blue",
};

const tables = new Map<ColourMapName, Uint8Array>();

/** The map of a field that the reader has chosen none for. Blue is where water presses, and red where it pulls. */
export function chooseColourMap(field: { name: string; diverging: boolean } | null | undefined): ColourMapName {
  if (!field?.diverging) return "viridis";
  return field.name === "pore_pressure" ? "redBlue" : "blueRed";
}

/** 256 colours as red, green, blue, 255. */
export function tabulateColours(name: ColourMapName): Uint8Array {
  let table = tables.get(name);
  if (table) return table;
  table = new Uint8Array(256 * 4).fill(255);
  if (name === "redBlue") {
    // The other way round: blue is where water is under pressure.
    const from = tabulateColours("blueRed");
    for (let i = 0; i < 256; ++i) table.set(from.subarray(4 * (255 - i), 4 * (256 - i)), 4 * i);
    tables.set(name, table);
    return table;
  }
  const map = stops[name];
  const channel = (stop: number, c: number) => parseInt(map.slice(6 * stop + 2 * c, 6 * stop + 2 * c + 2), 16);
  for (let i = 0; i < 256; ++i) {
    const at = (i / 255) * 24;
    const first = Math.min(23, Math.floor(at));
    for (let c = 0; c < 3; ++c) {
      table[4 * i + c] = Math.round(channel(first, c) * (first + 1 - at) + channel(first + 1, c) * (at - first));
    }
  }
  tables.set(name, table);
  return table;
}

/** Soils: of the colours of Okabe and Ito those that are no water, and brown and violet. */
const categories = ["e69f00", "999999", "009e73", "d55e00", "f0e442", "cc79a7", "7a4a24", "6b4c9a"];

let categoryTable: Uint8Array | null = null;

/** A table in which category n has place n; the eight colours repeat. */
export function tabulateCategories(): Uint8Array {
  if (categoryTable) return categoryTable;
  categoryTable = new Uint8Array(256 * 4).fill(255);
  for (let i = 0; i < 256; ++i) {
    const colour = parseInt(categories[i % categories.length]!, 16);
    categoryTable.set([colour >> 16, (colour >> 8) & 255, colour & 255], 4 * i);
  }
  return categoryTable;
}

/** Place of a value in the table, 0 to 255; -1 for no value. */
export function findColour(value: number, scale: Scale): number {
  const fraction = findShare(value, scale);
  return Number.isNaN(fraction) ? -1 : Math.min(255, Math.floor(fraction * 255 + 0.5));
}

/** Colour of a place in the table as CSS. */
export function writeColour(table: Uint8Array, place: number): string {
  if (place < 0) return "#9a9a9a";
  return `rgb(${table[4 * place]},${table[4 * place + 1]},${table[4 * place + 2]})`;
}
