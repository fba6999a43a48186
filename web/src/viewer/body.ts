// SPDX-License-Identifier: MIT
/** Puts together what the painter draws: points, mesh, colours, and what their key needs. */
import { computed } from "@preact/signals";

import { report } from "../state";
import { chooseColourMap, tabulateCategories, tabulateColours } from "./colours";
import { bandColours, findShare, type Level, makeLevels, type Scale, writeTitle } from "./scale";
import { meshEdges } from "./meshEdges";
import type { Body } from "./painter";
import type { Bar, Key } from "./scaleBar";
import { bands, colourMap, inSpace, layers } from "./settings";
import { frame, materialField, scale, shown, takeFrame, takePositions } from "./shown";
import { cells, radii } from "./sizes";
import type { Theme } from "./theme";

/** Ends of the bands, in SI, at round values of the field's unit; empty where colours run. */
const bandLevels = computed<Level[]>(() => {
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

/** Slices that a section is repeated in when it is turned in space. */
const slabSlices = 6;

/** Front and back of what is shown along z [m]. */
export function findDepth(): [number, number] {
  const { box, spacing } = shown.value!;
  if (report.value.model.dimension === 3) return [box[0][2], box[1][2]];
  return [inSpace.value ? -(slabSlices - 1) * spacing : 0, 0];
}

/** The body as it is shown now. */
export function describeBody(theme: Theme): Body {
  const now = shown.value!;
  const { dimension, bounds } = report.value.model;
  const [low, high] = now.box;
  const count = now.sequence.point_count;
  const flat = inSpace.value ? null : cells.value;
  return {
    dimension,
    count,
    origin: low,
    positions: takePositions(now, frame.value),
    values: takeFrame(now.values, frame.value, count),
    radii: radii.value,
    cover: flat && { reach: flat.reach, triangles: flat.cover, outlines: flat.outlines },
    scale: scale.value,
    colours: colourTable.value,
    slices: inSpace.value && dimension === 2 ? Array.from({ length: slabSlices }, (_, i) => -i * now.spacing) : [0],
    extent: Math.hypot(...high.map((h, k) => h - low[k]!)) + 10 * now.spacing,
    walls: [bounds[0][0]!, bounds[0][1]!, bounds[1][0]!],
    showPoints: layers.value.points,
    edges: layers.value.mesh ? meshEdges.value : null,
    edgeColour: layers.value.points && !inSpace.value ? "#20262e" : theme.muted,
  };
}
