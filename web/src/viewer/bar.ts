// SPDX-License-Identifier: MIT
/** The colours that are shown now, with what their key needs: scale, bands, names of materials. */
import { computed } from "@preact/signals";

import { report } from "../state";
import { chooseColourMap, tabulateCategories, tabulateColours } from "./colours";
import { writeTitle } from "./format";
import { bandColours, findShare, makeLevels, type Level, type Scale } from "./scale";
import type { Bar, Key } from "./scaleBar";
import { bands, colourMap } from "./settings";
import { materialField, scale, shown } from "./shown";

/** Ends of the bands, in SI, at round values of the field's unit; empty where colours run. */
export const bandLevels = computed<Level[]>(() => {
  const now = shown.value;
  if (!now || !bands.value || now.field.name === materialField) return [];
  return makeLevels(toUnit(scale.value, now.field.unit.si), bands.value);
});

function toUnit(some: Scale, si: number): Scale {
  return { ...some, low: some.low / si, high: some.high / si };
}

/** 256 colours as red, green, blue, 255. */
export const colourTable = computed<Uint8Array>(() => {
  const now = shown.value;
  if (now?.field.name === materialField) return tabulateCategories();
  const table = tabulateColours(colourMap.value ?? chooseColourMap(now?.field));
  if (!now || !bandLevels.value.length) return table;
  const inUnit = toUnit(scale.value, now.field.unit.si);
  return bandColours(table, bandLevels.value.map((level) => findShare(level.value, inUnit)));
});

/** The scalar bar, or the key of the materials. */
export const bar = computed<Bar | Key | null>(() => {
  const now = shown.value;
  if (!now) return null;
  const colours = colourTable.value;
  if (now.field.name === materialField) {
    const items = report.value.model.materials.map((m) => ({ place: m.index & 255, text: m.name }));
    return { title: "Material", colours, items };
  }
  const { unit, title, values } = now.field;
  const inUnit = toUnit(scale.value, unit.si);
  const levels = bandLevels.value.length ? bandLevels.value : null;
  const [low, high] = values.range ?? [scale.value.low, scale.value.high];
  return {
    title: writeTitle(title, unit),
    colours,
    scale: inUnit,
    levels,
    below: low < scale.value.low * (scale.value.low > 0 ? 0.999 : 1.001),
    above: high > scale.value.high,
  };
});
