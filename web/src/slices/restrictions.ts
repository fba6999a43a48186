// SPDX-License-Identifier: MIT
/** What the case asked of the slip surfaces of a search: windows, areas, tangents, inclinations; as sentences, and drawn in the section. */
import { formatNumber } from "../charts/base/numbers";
import type { SearchRestrictions, SearchShape } from "../contract";
import type { Pen } from "../drawing/pen";
import { formatCoordinate } from "../page/format";
import { report } from "../state";
import { drawDot, type Pixel, strokeLine, writeEdged } from "../viewer/lines";

const formatPoint = (p: number[]) => `(${p.map(formatCoordinate).join(", ")})`;

const describeShape = ({ name, points, is_box }: SearchShape) =>
  `${name} ${is_box ? `from ${points.map(formatPoint).join(" to ")}` : points.map(formatPoint).join(", ")}`;

const listShapes = (shapes: SearchShape[]) => shapes.map(describeShape).join("; ");

const formatAngles = (range: number[]) =>
  `${range.map((angle) => formatNumber((angle * 180) / Math.PI, 4)).join("° to ")}°`;

/** One sentence for each restriction. */
export function listRestrictions(restrictions: SearchRestrictions): string[] {
  const { length, line_force: force } = report.value.units;
  const { block, tangent, excluded, through, impenetrable, slides_left, smallest_area, smallest_weight } = restrictions;
  const list = [];
  if (block)
    list.push(
      `${block.along ? `Along ${block.along}` : `Through windows: ${listShapes(block.windows)} ${length.name}`}; the upper end rises at ${formatAngles(block.active)}, the lower end at ${formatAngles(block.passive)}.`,
    );
  if (tangent?.levels)
    list.push(
      `Deepest point of circles at y = ${tangent.levels.map(formatCoordinate).join(" to ")} ${length.name}.`,
    );
  if (tangent?.layer) list.push(`Circles touch the ${tangent.is_top ? "top" : "bottom"} of ${tangent.layer}.`);
  if (excluded.length) list.push(`No surface enters ${listShapes(excluded)} ${length.name}.`);
  if (through.length) list.push(`Every surface passes ${listShapes(through)} ${length.name}.`);
  if (impenetrable.length) list.push(`Surfaces follow the top of ${impenetrable.join(", ")}.`);
  if (slides_left !== undefined) list.push(`Only masses that slide to the ${slides_left ? "left" : "right"}.`);
  if (smallest_area)
    list.push(`Area of the mass at least ${formatNumber(smallest_area / length.si ** 2, 4)} ${length.name}².`);
  if (smallest_weight)
    list.push(`Weight of the mass at least ${formatNumber(smallest_weight / force.si, 4)} ${force.name}.`);
  return list;
}

const corners = ({ points, is_box }: SearchShape): number[][] => {
  const [a, b] = points;
  return is_box && a && b ? [a, [b[0]!, a[1]!], b, [a[0]!, b[1]!], a] : points;
};

/** Draws windows (accent), excluded areas (dashed, filled) and the levels of tangents. */
export function drawRestrictions({ context, camera, place, theme }: Pen, restrictions: SearchRestrictions): void {
  const draw = (shape: SearchShape, isArea: boolean) => {
    const line = corners(isArea ? { ...shape, points: [...shape.points, shape.points[0]!] } : shape).map(place);
    if (isArea) {
      context.globalAlpha = 0.3;
      context.fillStyle = theme.muted;
      context.beginPath();
      for (const p of line) context.lineTo(...p);
      context.fill();
      context.globalAlpha = 1;
    }
    if (line.length === 1) drawDot(context, line[0]!, 4, { fill: theme.ground, colour: theme.accent, width: 1.8 });
    strokeLine(context, line, { colour: isArea ? theme.ink : theme.accent, width: 1.8, dash: isArea ? [3, 3] : [] });
    // In an area or a box, or above a point or a line, where factors do not cover the name.
    const isWide = isArea || shape.is_box;
    const middle = [0, 1].map((k) => line.slice(1).reduce((sum, p) => sum + p[k]!, 0) / (line.length - 1)) as Pixel;
    const highest = line.reduce((best, p) => (p[1] < best[1] ? p : best));
    const at: Pixel = isWide ? middle : [highest[0], highest[1] - 12];
    context.font = "600 11px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    writeEdged(context, shape.name, at, { colour: theme.ink, edge: theme.ground, width: 4 });
  };
  for (const shape of restrictions.excluded) draw(shape, true);
  for (const shape of [...(restrictions.block?.windows ?? []), ...restrictions.through]) draw(shape, false);
  for (const level of new Set(restrictions.tangent?.levels ?? [])) {
    const y = place([0, level])[1];
    const ends: Pixel[] = [
      [camera.margins.left, y],
      [camera.width - camera.margins.right, y],
    ];
    strokeLine(context, ends, { colour: theme.accent, width: 1, dash: [2, 4] });
  }
}
