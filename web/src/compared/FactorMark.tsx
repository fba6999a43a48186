// SPDX-License-Identifier: MIT
/** A factor as a mark on the common scale of a table: behind it the interval of limit analysis, and its own
 * interval as a bar. */
import type { Factor, Method } from "../contract";

/** [lower, upper] */
export type Interval = [number, number];

/** Marks of a row of the methods, or of a factor of the answer. */
export interface Marked {
  method: Method;
  /** Word of the method, flow rule or criterion: "spencer", "associated". */
  name: string;
  factor: number | null;
  lower: number | null;
  upper: number | null;
  /** True for a state of the slope without limit analysis: a later time. */
  isElsewhere?: boolean;
  main?: boolean;
}

export const markFactor = ({ method, by, name, value, lower, upper, main }: Factor): Marked => ({
  method,
  name: by,
  factor: value,
  lower,
  upper,
  main,
  isElsewhere: name.startsWith("timeline."),
});

export interface FactorScale {
  /** Intervals of limit analysis for the soil of limit equilibrium and for that of the other methods, whose tension may
   * differ; null where nothing is proven. */
  proven: { lem: Interval | null; others: Interval | null };
  /** False where limit analysis and the other methods do not have the same soil, as below the heads of supports. */
  judges: boolean;
  low: number;
  high: number;
}

/** Factors further than this from the middle are drawn at the border of the scale. */
const widest = 0.3;
const height = 18;
/** Share of the width [%] that a mark at the border keeps free. */
const border = 4;

const readInterval = ({ lower, upper }: Marked): Interval | null =>
  lower !== null && upper !== null ? [lower, upper] : null;

/** The interval of limit analysis that a factor is drawn on. */
export const findProven = ({ proven }: FactorScale, row: Marked): Interval | null =>
  row.isElsewhere ? null : row.method === "lem" ? proven.lem : proven.others;

/** A scale that holds the intervals of limit analysis, the factors near them, and 1 where it is near; null without any. */
export function makeFactorScale(rows: Marked[], judges = true): FactorScale | null {
  const find = (method: string) =>
    rows.filter((row) => row.method === method).reduce<Interval | null>((best, row) => best ?? readInterval(row), null);
  // The rows of limit equilibrium carry the interval of its referee.
  const [referee, bounds] = [find("lem"), find("bounds")];
  const proven = { lem: referee ?? bounds, others: bounds ?? referee };
  const factors = rows.flatMap((row) => (row.factor === null ? [] : [row.factor])).sort((a, b) => a - b);
  const middle = proven.lem ? (proven.lem[0] + proven.lem[1]) / 2 : factors[Math.floor(factors.length / 2)];
  if (middle === undefined) return null;
  const values = [1, ...factors, ...rows.flatMap((row) => readInterval(row) ?? [])].filter(
    (value) => Math.abs(value / middle - 1) < widest,
  );
  const [least, most] = [Math.min(middle, ...values), Math.max(middle, ...values)];
  const margin = Math.max(0.05 * (most - least), 0.005 * middle);
  return { proven, judges, low: least - margin, high: most + margin };
}

/** Place on the scale [% of its width]; `inside`: the value lies on the scale. */
export function placeFactor({ low, high }: FactorScale, value: number): { at: number; inside: boolean } {
  const at = (100 * (value - low)) / (high - low);
  return { at: Math.min(100 - border, Math.max(border, at)), inside: value >= low && value <= high };
}

function Band({ scale, interval, name }: { scale: FactorScale; interval: Interval; name: string }) {
  const [from, to] = interval.map((value) => placeFactor(scale, value).at) as Interval;
  const thick = name === "factor-proven" ? height : 5;
  return (
    <rect class={name} x={`${from}%`} y={(height - thick) / 2} width={`${Math.max(1.2, to - from)}%`} height={thick} />
  );
}

/** True where limit analysis rules a factor out. It holds for ψ = φ alone, so that factors of soil that flows
 * otherwise are never ruled out. */
export function isRuledOut(scale: FactorScale, row: Marked): boolean {
  const proven = findProven(scale, row);
  if (!scale.judges || !proven || row.factor === null || (row.method !== "lem" && row.name !== "associated")) return false;
  const [low, high] = (row.method !== "lem" && readInterval(row)) || [row.factor, row.factor];
  return high < proven[0] || low > proven[1];
}

/** The numbers are in the columns beside it, so that it is hidden from assistive technology. */
export function FactorMark({ scale, row }: { scale: FactorScale; row: Marked }) {
  const proven = findProven(scale, row);
  const own = row.method === "lem" ? null : readInterval(row);
  const place = row.factor === null ? null : placeFactor(scale, row.factor);
  const one = placeFactor(scale, 1);
  const look = isRuledOut(scale, row) ? "factor-outside" : row.main ? "factor-held main" : "factor-held";
  return (
    <svg class="factor-mark" width="100%" height={height} aria-hidden="true">
      {proven && <Band scale={scale} interval={proven} name="factor-proven" />}
      {one.inside && <line class="factor-one" x1={`${one.at}%`} x2={`${one.at}%`} y1="0" y2={height} />}
      {own && <Band scale={scale} interval={own} name="factor-own" />}
      {place && (
        <svg x={`${place.at}%`} y={height / 2} overflow="visible">
          {place.inside ? (
            <circle class={look} r="3.5" />
          ) : (
            <path class="factor-outside" d={place.at > 50 ? "M-3-4l6 4l-6 4z" : "M3-4l-6 4l6 4z"} />
          )}
        </svg>
      )}
    </svg>
  );
}
