// SPDX-License-Identifier: MIT
/** What lies over the section in pixels: grid, rulers, handles of vertices, what is being drawn, the snap marker, places of messages. */
import { computed, signal } from "@preact/signals";

import { makeTicks } from "../../../src/viewer/scale";
import { marks } from "../background/background";
import type { Snapped } from "../geometry/snap";
import type { Point } from "../geometry/plane";
import * as state from "../state";
import { length } from "../units";
import { ruler, size, toScreen, toWorld } from "./camera";

/** Where the next point would be, by the pointer. */
export const pointer = signal<Snapped | null>(null);
export const showGrid = signal(true);

export function Grid() {
  const { width, height } = size.value;
  if (!showGrid.value) return null;
  const step = state.gridStep.value;
  const [low, high] = [toWorld([0, height]), toWorld([width, 0])];
  const lines: { d: string; strong: boolean }[] = [];
  for (let i = Math.ceil(low[0] / step); i * step <= high[0]; ++i) {
    const x = toScreen([i * step, 0])[0].toFixed(1);
    lines.push({ d: `M${x} 0V${height}`, strong: i % 5 === 0 });
  }
  for (let i = Math.ceil(low[1] / step); i * step <= high[1]; ++i) {
    const y = toScreen([0, i * step])[1].toFixed(1);
    lines.push({ d: `M0 ${y}H${width}`, strong: i % 5 === 0 });
  }
  const join = (strong: boolean) => lines.filter((line) => line.strong === strong).map(({ d }) => d).join("");
  return (
    <g class="grid">
      <path d={join(false)} />
      <path class="strong" d={join(true)} />
    </g>
  );
}

export function Rulers() {
  const { width, height } = size.value;
  const base = height - ruler.bottom;
  const [low, high] = [toWorld([ruler.left, base]), toWorld([width, 0])];
  const { name, size: unit } = length.value;
  const across = makeTicks(low[0] / unit, high[0] / unit, Math.max(2, (width - ruler.left) / 90));
  const up = makeTicks(low[1] / unit, high[1] / unit, Math.max(2, base / 60));
  return (
    <g class="rulers">
      <rect x="0" y={base} width={width} height={ruler.bottom} />
      <rect x="0" y="0" width={ruler.left} height={height} />
      <path d={`M${ruler.left} 0V${base}H${width}`} />
      {across.map(({ value, text }) => {
        const x = toScreen([value * unit, 0])[0];
        if (x < ruler.left + 16 || x > width - 16) return null;
        return (
          <g key={value}>
            <path d={`M${x} ${base}v4`} />
            <text x={x} y={base + 16}>
              {text}
            </text>
          </g>
        );
      })}
      {up.map(({ value, text }) => {
        const y = toScreen([0, value * unit])[1];
        if (y > base - 8 || y < 10) return null;
        return (
          <g key={value}>
            <path d={`M${ruler.left} ${y}h-4`} />
            <text class="left" x={ruler.left - 7} y={y + 4}>
              {text}
            </text>
          </g>
        );
      })}
      <text class="left" x={ruler.left - 7} y={base + 16}>
        {name}
      </text>
    </g>
  );
}

/** Vertices of everything that can be moved; those of the box are left out. */
const shown = computed(() =>
  state.vertices.value.filter(({ corners }) => corners.some(({ chain }) => state.chains.value[chain]!.kind !== "box")),
);

export function Handles() {
  const now = state.selectedVertex.value;
  const chain = state.selectedChain.value;
  const c = chain ? state.chains.value.indexOf(chain) : -1;
  return (
    <g class="handles">
      {shown.value.map((vertex, i) => {
        const [x, y] = toScreen(vertex.at);
        const chosen = vertex === now;
        const among = vertex.corners.some((corner) => corner.chain === c);
        const half = chosen ? 5 : among ? 4 : 3;
        return (
          <rect
            key={i}
            class={chosen ? "handle chosen" : among ? "handle among" : "handle"}
            x={x - half}
            y={y - half}
            width={2 * half}
            height={2 * half}
          />
        );
      })}
    </g>
  );
}

const line = (points: readonly Point[]) => points.map((p) => toScreen(p).map((v) => v.toFixed(1)).join(" ")).join("L");

const rectangles: ReadonlySet<state.Tool> = new Set(["window", "centres", "heave"]);
const listCorners = ([x0, y0]: Point, [x1, y1]: Point): Point[] => [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];

/** The line that is being drawn, up to the pointer. */
export function Draft() {
  const points = state.draft.value;
  const at = pointer.value?.at;
  if (!points.length) return null;
  const [x, y] = toScreen(points[0]!);
  const closes = state.tool.value === "region" || state.tool.value === "exclude";
  return (
    <g class="draft">
      <path d={`M${line(at ? [...points, at] : points)}`} />
      {closes && points.length > 1 && at && <path class="closing" d={`M${line([at, points[0]!])}`} />}
      {rectangles.has(state.tool.value) && at && <path class="closing" d={`M${line(listCorners(points[0]!, at))}Z`} />}
      {state.tool.value === "circle" && at && <circle class="first" cx={x} cy={y} r={Math.hypot(toScreen(at)[0] - x, toScreen(at)[1] - y)} />}
      {points.map((p, i) => {
        const [px, py] = toScreen(p);
        return <circle key={i} cx={px} cy={py} r="3.5" />;
      })}
      {closes && points.length > 2 && <circle class="first" cx={x} cy={y} r="8" />}
    </g>
  );
}

/** The two points of the background picture whose coordinates are asked for. */
export function PictureMarks() {
  return (
    <g class="draft">
      {marks.value?.map((at, i) => {
        const [x, y] = toScreen(at);
        return (
          <g key={i}>
            <path d={`M${x - 8} ${y}h16M${x} ${y - 8}v16`} />
            <text class="mark-number" x={x + 7} y={y - 7}>
              {i + 1}
            </text>
          </g>
        );
      })}
    </g>
  );
}

/** A square at a vertex, a cross at a crossing, a triangle on a line, a plus on the grid. */
export function SnapMarker() {
  const snapped = pointer.value;
  if (!snapped || snapped.kind === "free") return null;
  const [x, y] = toScreen(snapped.at);
  const shapes: Record<string, string> = {
    vertex: `M${x - 7} ${y - 7}h14v14h-14z`,
    intersection: `M${x - 7} ${y - 7}l14 14M${x + 7} ${y - 7}l-14 14`,
    line: `M${x - 8} ${y + 6}h16l-8 -14z`,
    aligned: `M${x - 6} ${y - 3}h12M${x - 6} ${y + 3}h12`,
    grid: `M${x - 6} ${y}h12M${x} ${y - 6}v12`,
  };
  return <path class={`snap-marker ${snapped.kind}`} d={shapes[snapped.kind]} />;
}

/** Places of errors and warnings. */
export function MessageMarks() {
  return (
    <g class="message-marks">
      {state.messages.value
        .filter(({ place, severity }) => place && severity !== "note")
        .map(({ place, severity, text }, i) => {
          const [x, y] = toScreen(place!);
          return (
            <g key={i} class={severity}>
              <circle cx={x} cy={y} r="9" />
              <path d={`M${x} ${y - 4.5}v5.500M${x} ${y + 3}v1.600`} />
              <title>{text}</title>
            </g>
          );
        })}
    </g>
  );
}
