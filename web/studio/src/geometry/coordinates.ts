// SPDX-License-Identifier: MIT
/** Typed coordinates: `x,y`, `@dx,dy` and `length<angle` from the last point. */
import type { Point } from "./plane";

export type Typed = { point: Point; fault: null } | { point: null; fault: string };

const number = String.raw`[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?`;
const pair = new RegExp(`^(@?)\\s*(${number})\\s*[,;\\s]\\s*(${number})$`);
const polar = new RegExp(`^@?\\s*(${number})\\s*<\\s*(${number})\\s*°?$`);

const fail = (fault: string): Typed => ({ point: null, fault });
const trim = (value: number) => Number(value.toFixed(9)) + 0;

/**
 * Reads a point; relative ones need the last point. Angles [deg] are measured from the horizontal, upwards positive. Typed
 * lengths have the size `unit` [m].
 */
export function readCoordinates(text: string, last: Point | null, unit = 1): Typed {
  const clean = text.trim().replaceAll("−", "-");
  const polarParts = polar.exec(clean);
  const parts = pair.exec(clean);
  if (!parts && !polarParts) return fail(`“${clean}” is not a point. Write x,y or @dx,dy or length<angle, with decimal points.`);
  const relative = polarParts !== null || parts![1] === "@";
  if (relative && !last) return fail("The first point needs absolute coordinates: x,y.");
  if (polarParts) {
    const [length, angle] = [Number(polarParts[1]) * unit, (Number(polarParts[2]) * Math.PI) / 180];
    return { point: [trim(last![0] + length * Math.cos(angle)), trim(last![1] + length * Math.sin(angle))], fault: null };
  }
  const [x, y] = [Number(parts![2]) * unit, Number(parts![3]) * unit];
  return { point: relative ? [trim(last![0] + x), trim(last![1] + y)] : unit === 1 ? [x, y] : [trim(x), trim(y)], fault: null };
}

/** Points pasted from a spreadsheet: one a row, two columns with tabs, commas, semicolons or blanks between them. */
export function readPastedPoints(text: string, unit = 1): Point[] | null {
  const rows = text.trim().split(/\r?\n/).map((row) => row.trim()).filter(Boolean);
  const points = rows.map((row) => {
    // A comma is decimal where tabs or semicolons separate the columns.
    const clean = /[\t;]/.test(row) ? row.replaceAll(",", ".").replace(/[\t;]+/, " ") : row;
    return readCoordinates(clean, null, unit).point;
  });
  // A header is left out.
  const body = points[0] ? points : points.slice(1);
  return body.length > 0 && body.every((point) => point) ? (body as Point[]) : null;
}
