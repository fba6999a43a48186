// SPDX-License-Identifier: MIT
/** Puts together what the painter draws: points, colours, mesh. */
import { report } from "../state";
import { colourTable } from "./bar";
import { meshEdges } from "./meshEdges";
import type { Body } from "./painter";
import { inSpace, layers } from "./settings";
import { frame, scale, shown, takeFrame, takePositions } from "./shown";
import { cells, radii } from "./sizes";
import type { Theme } from "./theme";

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
