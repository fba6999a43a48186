// SPDX-License-Identifier: MIT
/** The factor of a row as a mark on a scale that all rows share: behind it what limit analysis proves, and its own
 * interval as a bar. */
import type { MethodRow } from "../contract";

/** [lower, upper] */
export type Interval = [number, number];

export interface FactorScale {
  /** Intervals of limit analysis for the soil of limit equilibrium and for that of the other methods, whose tension may
   * differ; null where nothing is proven. */
  proven: { lem: Interval | null; others: Interval | null };
  low: number;
  high: number;
}

/** Factors further than this from the middle are drawn at the border of the scale. */
const widest = 0.3;
const width = 120;
const height = 18;

const readInterval = (row: MethodRow): Interval | null =>
  row.lower !== null && row.upper !== null ? [row.lower, row.upper] : null;

/** The proven interval that the factor of a row is drawn on. */
export const findProven = ({ proven }: FactorScale, row: MethodRow): Interval | null =>
  row.method === "lem" ? proven.lem : proven.others;

/** A scale that holds the proven intervals and the factors near them; null without any. */
export function makeFactorScale(rows: MethodRow[]): FactorScale | null {
  const find = (method: string) =>
    rows.filter((row) => row.method === method).reduce<Interval | null>((best, row) => best ?? readInterval(row), null);
  // The rows of limit equilibrium carry the interval of its referee.
  const [referee, bounds] = [find("lem"), find("bounds")];
  const proven = { lem: referee ?? bounds, others: bounds ?? referee };
  const factors = rows.flatMap((row) => (row.factor === null ? [] : [row.factor])).sort((a, b) => a - b);
  const middle = proven.lem ? (proven.lem[0] + proven.lem[1]) / 2 : factors[Math.floor(factors.length / 2)];
  if (middle === undefined) return null;
  const values = [...factors, ...rows.flatMap((row) => readInterval(row) ?? [])].filter(
    (value) => Math.abs(value / middle - 1) < widest,
  );
  const [least, most] = [Math.min(middle, ...values), Math.max(middle, ...values)];
  const margin = Math.max(0.05 * (most - least), 0.005 * middle);
  return { proven, low: least - margin, high: most + margin };
}

/** Place on the scale [px]; `inside`: the value lies on the scale. */
export function placeFactor({ low, high }: FactorScale, value: number): { x: number; inside: boolean } {
  const x = (width * (value - low)) / (high - low);
  return { x: Math.min(width - 4, Math.max(4, x)), inside: value >= low && value <= high };
}

function Band({ scale, interval, name }: { scale: FactorScale; interval: Interval; name: string }) {
  const [from, to] = interval.map((value) => placeFactor(scale, value).x) as Interval;
  const thick = name === "factor-proven" ? height : 5;
  return <rect class={name} x={from} y={(height - thick) / 2} width={Math.max(1.5, to - from)} height={thick} />;
}

/** True where the proven interval rules a factor out. It holds for ψ = φ alone, so that factors of soil that flows
 * otherwise are never ruled out. */
export function isRuledOut(scale: FactorScale, row: MethodRow): boolean {
  const proven = findProven(scale, row);
  if (!proven || row.factor === null || (row.method !== "lem" && row.name !== "associated")) return false;
  const [low, high] = (row.method !== "lem" && readInterval(row)) || [row.factor, row.factor];
  return high < proven[0] || low > proven[1];
}

/** The numbers stand in the columns beside it, so that it is hidden from assistive technology. */
export function FactorMark({ scale, row }: { scale: FactorScale; row: MethodRow }) {
  const proven = findProven(scale, row);
  const own = row.method === "lem" ? null : readInterval(row);
  const place = row.factor === null ? null : placeFactor(scale, row.factor);
  const y = height / 2;
  return (
    <svg class="factor-mark" width={width} height={height} viewBox={`0 0 ${width} ${height}`} aria-hidden="true">
      {proven && <Band scale={scale} interval={proven} name="factor-proven" />}
      {own && <Band scale={scale} interval={own} name="factor-own" />}
      {place?.inside && (
        <circle class={isRuledOut(scale, row) ? "factor-outside" : "factor-held"} cx={place.x} cy={y} r="3.5" />
      )}
      {place && !place.inside && (
        <path
          class="factor-outside"
          d={place.x > y ? `M${place.x - 3} ${y - 4}l6 4l-6 4z` : `M${place.x + 3} ${y - 4}l-6 4l6 4z`}
        />
      )}
    </svg>
  );
}
