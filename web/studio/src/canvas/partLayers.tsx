// SPDX-License-Identifier: MIT
/** Conditions, ranges of the search, levels and circles on the canvas: lines in metres, symbols of constant size. */
import type { Part } from "../document/parts";
import { isInside, listSegments, type Point } from "../geometry/plane";
import * as state from "../state";
import { toScreen, view } from "./camera";
import { findGround, findWidth } from "./hit";

const isChosen = ({ id }: Part) => state.selection.value.kind === "part" && state.selection.value.id === id;
const name = (part: Part, more = "") => `part ${part.kind} ${more}${isChosen(part) ? " chosen" : ""}`;

/** Circles, levels and sides of blocks, whose coordinates are metres. */
export function PartLines() {
  return (
    <g>
      {state.parts.value.map((part) => {
        const { circle, levels, x } = part;
        if (circle) {
          const [[cx, cy], r] = [circle.centre, circle.radius.value];
          return <path key={part.id} class={name(part)} d={`M${cx - r} ${cy}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`} />;
        }
        if (!levels.length) return null;
        const [low, high] = findWidth(part);
        const level = levels[0]!.value;
        const lines = levels.map(({ value }) => `M${low} ${value}H${high}`).join("");
        const sides = x.length === 2 ? x.map(({ value }) => `M${value} ${level}V${part.kind === "heave" ? (findGround(value) ?? level) : level - 0.15 * Math.abs(high - low)}`).join("") : "";
        return <path key={part.id} class={name(part)} d={lines + sides} />;
      })}
    </g>
  );
}

/** Places along a line [px] every `spacing` pixels, with the direction along it and the one away from the soil. */
function listPlaces(line: readonly Point[], spacing: number): { at: Point; along: Point; outward: Point }[] {
  const scale = view.value.scale;
  const regions = state.regions.value;
  return listSegments(line, false).flatMap(([a, b]) => {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length === 0) return [];
    const [tx, ty] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    const reach = 4 / scale;
    const middle: Point = [(a[0] + b[0]) / 2 - ty * reach, (a[1] + b[1]) / 2 + tx * reach];
    // The left of the line is soil: the outside is to its right.
    const side = regions.some(({ points }) => isInside(middle, points)) ? -1 : 1;
    const count = Math.max(1, Math.min(80, Math.round((length * scale) / spacing)));
    return Array.from({ length: count }, (_, i) => {
      const t = (i + 0.5) / count;
      return {
        at: toScreen([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]),
        along: [tx, -ty] as const,
        // y of the screen points down.
        outward: [-side * ty, -side * tx] as const,
      };
    });
  });
}

const move = ([x, y]: Point, [dx, dy]: Point, by: number): Point => [x + by * dx, y + by * dy];
const write = ([x, y]: Point) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** An arrow from one pixel to another. */
function drawArrow(from: Point, to: Point): string {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  const d: Point = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const n: Point = [-d[1], d[0]];
  const back = move(to, d, -5);
  return `M${write(from)}L${write(to)}M${write(move(back, n, 3))}L${write(to)}L${write(move(back, n, -3))}`;
}

const ring = (at: Point, r: number) => `M${write([at[0] - r, at[1]])}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;

type Place = ReturnType<typeof listPlaces>[number];
/** Symbols by kind and word; the first one of a kind serves words that have none. */
const symbols: Record<string, (place: Place, part: Part) => string> = {
  "boundary full": ({ at, along, outward }) => `M${write(at)}L${write(move(move(at, outward, 8), along, -6))}`,
  "boundary normal": ({ at, outward }) => ring(move(at, outward, 4.5), 3.2),
  "boundary plane": ({ at, along, outward }) => `${ring(move(at, outward, 4.5), 3.2)}M${write(move(move(at, outward, 9), along, -5))}L${write(move(move(at, outward, 9), along, 5))}`,
  "boundary friction": ({ at, along, outward }) => `M${write(move(at, along, -5))}L${write(move(at, outward, 7))}L${write(move(at, along, 5))}`,
  "boundary velocity": ({ at, outward }) => drawArrow(move(at, outward, 18), move(at, outward, 3)),
  traction: ({ at, outward }, { direction }) => {
    const length = direction ? Math.hypot(...direction) : 0;
    const d: Point = direction && length > 0 ? [direction[0] / length, -direction[1] / length] : [-outward[0], -outward[1]];
    return drawArrow(move(at, d, -22), move(at, d, -2));
  },
  "hydraulic total_head": ({ at, along, outward }) => `M${write(move(move(at, outward, 10), along, -4))}L${write(move(move(at, outward, 10), along, 4))}L${write(move(at, outward, 3))}Z`,
  "hydraulic pressure": ({ at, outward }) => ring(move(at, outward, 6), 3.5),
  "hydraulic seepage_face": ({ at, outward }) => drawArrow(move(at, outward, 2), move(at, outward, 12)),
  "hydraulic rain": ({ at }) => drawArrow([at[0] + 4, at[1] - 18], [at[0], at[1] - 3]),
  "hydraulic flux": ({ at, outward }) => drawArrow(move(at, outward, 16), move(at, outward, 2)),
  "hydraulic no_flow": ({ at, along, outward }) => `M${write(move(move(at, outward, 4), along, -5))}L${write(move(move(at, outward, 4), along, 5))}`,
  roots: ({ at, along, outward }) => `M${write(at)}L${write(move(at, outward, -10))}M${write(move(at, outward, -4))}L${write(move(move(at, outward, -9), along, 4))}`,
};

function Condition({ part }: { part: Part }) {
  if (part.line.length < 2) return null;
  const symbol = symbols[`${part.kind} ${part.word}`] ?? symbols[part.kind] ?? symbols[`${part.kind} full`]!;
  return <path class={name(part, "symbol")} d={listPlaces(part.line, part.kind === "traction" ? 30 : 22).map((place) => symbol(place, part)).join("")} />;
}

/** A band over the ground with marks at its ends. */
function GroundRange({ part }: { part: Part }) {
  const [from, to] = [part.x[0]!.value, part.x[1]!.value];
  const corners = state.regions.value.flatMap(({ points }) => points.map(([x]) => x)).filter((x) => x > from && x < to);
  const places = [from, ...[...new Set(corners)].sort((a, b) => a - b), to];
  const line = places.flatMap((x) => {
    const top = findGround(x);
    return top === null ? [] : [toScreen([x, top])];
  });
  if (line.length < 2) return null;
  const [first, last] = [line[0]!, line.at(-1)!];
  const d = `M${line.map(([x, y]) => write([x, y - 6])).join("L")}`;
  const ends = [first, last].map(([x, y]) => `M${write([x, y - 13])}v14`).join("");
  const middle = line[Math.floor((line.length - 1) / 2)]!;
  const next = line[Math.floor((line.length - 1) / 2) + 1] ?? middle;
  return (
    <g class={name(part)}>
      <path class="band" d={d} />
      <path d={ends} />
      <text x={(middle[0] + next[0]) / 2} y={(middle[1] + next[1]) / 2 + 13}>
        {part.kind}
      </text>
    </g>
  );
}

/** Symbols along conditions, bands of entries and exits, names of levels. */
export function PartMarks() {
  return (
    <g class="parts-layer">
      {state.parts.value.map((part) => {
        if (part.kind === "entry" || part.kind === "exit") return <GroundRange key={part.id} part={part} />;
        if (part.levels.length) {
          const [px, py] = toScreen([findWidth(part)[0], part.levels[0]!.value]);
          return (
            <g key={part.id} class={name(part)}>
              <text class="at-start" x={Math.max(px, 46) + 6} y={py - 9}>
                {part.title}
              </text>
            </g>
          );
        }
        return <Condition key={part.id} part={part} />;
      })}
    </g>
  );
}
