// SPDX-License-Identifier: MIT
/** A small curve beside a run: axes with a few numbers, a line, a band, marks. */
import { makeTicks } from "../../../src/viewer/scale";
import type { Point } from "../geometry/plane";
import type { Curve } from "./liveRun";

const [width, height] = [330, 150];
const [left, right, top, bottom] = [46, 10, 8, 34];

function findRange(values: number[]): [number, number] {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const margin = high > low ? 0.06 * (high - low) : Math.max(Math.abs(low) * 0.05, 0.05);
  return [low - margin, high + margin];
}

export function Plot({ curve }: { curve: Curve }) {
  const { title, line, marks, band } = curve;
  const all: Point[] = [...line, ...marks.map(({ at }) => at), ...(band ? [...band.lower, ...band.upper] : [])];
  if (!all.length) return null;
  const x = findRange(all.map((p) => p[0]));
  const y = findRange(all.map((p) => p[1]));
  const place = ([px, py]: Point): Point => [
    left + ((px - x[0]) / (x[1] - x[0])) * (width - left - right),
    height - bottom - ((py - y[0]) / (y[1] - y[0])) * (height - top - bottom),
  ];
  const join = (points: readonly Point[]) => points.map((p) => place(p).map((v) => v.toFixed(1)).join(" ")).join("L");
  const outline = band && [...band.lower, ...band.upper.toReversed()];
  return (
    <figure class="live-plot">
      <figcaption>{title}</figcaption>
      <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-label={`${title}: ${curve.y} over ${curve.x}, ${all.length} values`}>
        <path class="axis" d={`M${left} ${top}V${height - bottom}H${width - right}`} />
        {makeTicks(x[0], x[1], 5).map(({ value, text }) => {
          const [px] = place([value, y[0]]);
          return (
            <text key={value} class="middle" x={px} y={height - bottom + 14}>
              {text}
            </text>
          );
        })}
        {makeTicks(y[0], y[1], 4).map(({ value, text }) => {
          const [, py] = place([x[0], value]);
          return (
            <g key={value}>
              <path class="tick" d={`M${left} ${py}H${width - right}`} />
              <text class="end" x={left - 5} y={py + 4}>
                {text}
              </text>
            </g>
          );
        })}
        <text class="middle" x={(left + width - right) / 2} y={height - 4}>
          {curve.x}
        </text>
        <text class="end name" x={width - right} y={top + 9}>
          {curve.y}
        </text>
        {outline && outline.length > 2 && <path class="band" d={`M${join(outline)}Z`} />}
        {band && [band.lower, band.upper].map((ends, i) => <path key={i} class="curve" d={`M${join(ends)}`} />)}
        {line.length > 1 && <path class="curve" d={`M${join(line)}`} />}
        {marks.map(({ at, holds, label }, i) => {
          const [cx, cy] = place(at);
          return (
            <circle key={i} class={holds === null ? "mark" : holds ? "mark holds" : "mark fails"} cx={cx} cy={cy} r="3.2">
              <title>{label}</title>
            </circle>
          );
        })}
      </svg>
    </figure>
  );
}
