// SPDX-License-Identifier: MIT
/** Layers of the section in metres: regions, water, loads, supports, slip surface. Zoom and pan change the transform alone. */
import { findRoom } from "../../../src/drawing/ground";
import { tabulateCategories, writeColour } from "../../../src/viewer/colours";
import { background, writeMatrix } from "../background/background";
import { pointsOf } from "../document/vertices";
import { findExtent, findTop, type Point } from "../geometry/plane";
import * as state from "../state";
import { stress } from "../units";
import { toScreen, transform, view } from "./camera";
import { findGround } from "./hit";
import { PartLines, PartMarks } from "./partLayers";

/** Colour of a soil: by its place in the file, as in the report. */
export function findSoilColour(soil: string): string {
  return writeColour(tabulateCategories(), state.soils.value.indexOf(soil));
}

const draw = (points: readonly Point[], closed = false): string =>
  points.length ? `M${points.map(([x, y]) => `${x} ${y}`).join("L")}${closed ? "Z" : ""}` : "";

const isChosen = (id: string) => state.selectedChains.value.some((chain) => chain.id === id);

function Regions() {
  return (
    <g class="regions">
      {state.regions.value.map(({ id, soil, points }) => (
        <path
          key={id}
          d={draw(points, true)}
          class={isChosen(id) ? "region chosen" : "region"}
          style={{ fill: findSoilColour(soil) }}
        />
      ))}
    </g>
  );
}

/** Lines of the text, drawn by their kind. */
function Lines() {
  return (
    <g>
      {state.chains.value
        .filter(({ kind, single }) => kind !== "region" && kind !== "support" && !single)
        .map((chain) => {
          const chosen = isChosen(chain.id) ? " chosen" : "";
          const [low, high] = pointsOf(chain);
          if (chain.corners) {
            const corners: Point[] = low && high ? [low, [high[0], low[1]], high, [low[0], high[1]]] : [];
            return <path key={chain.id} class={`line ${chain.kind}${chosen}`} d={draw(corners, true)} />;
          }
          const points = pointsOf(chain);
          return (
            <g key={chain.id}>
              {isWater(chain.kind) && <path class={`line ${chain.kind} level`} d={draw(levelEnds(points))} />}
              <path class={`line ${chain.kind}${chosen}`} d={draw(points, chain.closed)} />
            </g>
          );
        })}
    </g>
  );
}

const isWater = (kind: string) => kind === "water" || kind === "drawdown" || kind === "piezometric";

/** A place on a line a quarter of the way along x, where slip surfaces are rare. */
function findMark(line: readonly Point[]): Point {
  const [first, last] = [line[0] ?? [0, 0], line.at(-1) ?? [0, 0]];
  const x = first[0] + 0.22 * (last[0] - first[0]);
  const y = findTop(x, line.slice(1).map((p, i) => [line[i]!, p] as const));
  return [x, y ?? first[1]];
}

/** A water table is level beyond its ends, up to the ends of the section. */
function levelEnds(points: readonly Point[]): Point[] {
  const x = state.regions.value.flatMap((region) => region.points.map((p) => p[0]));
  const [first, last] = [points[0], points.at(-1)];
  if (!first || !last || !x.length) return [];
  return [[Math.min(first[0], ...x), first[1]], ...points, [Math.max(last[0], ...x), last[1]]];
}

/** Standing water, as the engine finds it above the ground. */
function Ponds() {
  return (
    <g>
      {(state.section.value?.ponds ?? []).map((pond, i) => (
        <path key={i} class="pond" d={draw(pond, true)} />
      ))}
    </g>
  );
}

function Supports() {
  return (
    <g>
      {(state.section.value?.supports ?? []).map(({ head, end }, i) => (
        <path key={i} class="line bar" d={draw([head, end])} />
      ))}
    </g>
  );
}

/** The ground from left to right: that of the engine, or during a drag the tops of the regions at their corners. */
function listGround(): Point[] {
  if (!state.live.value) return state.section.value?.ground ?? [];
  const places = new Set(state.regions.value.flatMap(({ points }) => points.map(([x]) => x)));
  return [...places].sort((a, b) => a - b).map((x): Point => [x, findGround(x) ?? 0]);
}

/** The critical surface of the last search, and the mass above it. */
function Slip() {
  const found = state.solved.value;
  if (!found?.surface.length) return null;
  const stale = state.isSolving.value ? " stale" : "";
  const [first, last] = [found.surface[0]!, found.surface.at(-1)!];
  const [low, high] = first[0] < last[0] ? [first, last] : [last, first];
  const inner = listGround().filter(([x]) => x > low[0] && x < high[0]);
  // A tension crack: the surface begins below the ground.
  const [left, right] = [low, high].map(([x, y]): Point => [x, Math.max(y, findGround(x) ?? y)]);
  const ground: Point[] = [left!, ...inner, right!];
  const above = first[0] < last[0] ? ground.toReversed() : ground;
  return (
    <g>
      <path class="mass" d={draw([...found.surface, ...above], true)} />
      <path class="slip-edge" d={draw(found.surface)} />
      <path class={`slip${stale}`} d={draw(found.surface)} />
    </g>
  );
}

/** The picture behind the section. */
function Picture() {
  const found = background.value;
  if (!found?.shown) return null;
  const { data, width, height, opacity } = found;
  return <image class="picture" href={data} width={width} height={height} opacity={opacity} transform={writeMatrix(found)} preserveAspectRatio="none" />;
}

/** Everything whose coordinates are metres; widths of lines are pixels. */
export function WorldLayers() {
  return (
    <g transform={transform.value} class="world">
      <Picture />
      <Regions />
      <Ponds />
      <Slip />
      <Lines />
      <PartLines />
      <Supports />
    </g>
  );
}

type Shown = (typeof state.regions.value)[number];

const rooms = new Map<string, ReturnType<typeof findRoom>>();

/** The place for a name; regions inside of it are avoided. Places are kept by the shapes that they depend on. */
function findNamePlace(region: Shown, later: readonly Shown[]): ReturnType<typeof findRoom> {
  const extent = findExtent(region.points)!;
  const [width, height] = [extent.high[0] - extent.low[0], extent.high[1] - extent.low[1]];
  if (width * view.value.scale < 24 || height * view.value.scale < 18) return null;
  const inside = later.filter(({ points }) => points.some(([x, y]) => x > extent.low[0] && x < extent.high[0] && y > extent.low[1] && y < extent.high[1]));
  const key = JSON.stringify([region.points, ...inside.map(({ points }) => points)]);
  const known = rooms.get(key);
  if (known !== undefined) return known;
  if (rooms.size > 2000) rooms.clear();
  const found = findRoom(region.points, inside.map(({ points }) => points));
  rooms.set(key, found);
  return found;
}

/** Names of soils where there is room, marks of water tables, arrows of loads: of constant size. */
export function Labels() {
  const regions = state.regions.value;
  const { scale } = view.value;
  return (
    <g class="labels">
      {regions.map((region, i) => {
        const { id, name, soil } = region;
        const room = findNamePlace(region, regions.slice(i + 1));
        const text = soil && soil !== name ? `${name} · ${soil}` : name;
        const fitting = [text, name].find((t) => room && 6.6 * t.length <= 2.6 * room.radius * scale && room.radius * scale > 9);
        if (!room || !fitting) return null;
        const [x, y] = toScreen(room.at);
        return (
          <text key={id} x={x} y={y}>
            {fitting}
          </text>
        );
      })}
      {state.chains.value
        .filter(({ kind }) => isWater(kind))
        .map((chain) => {
          const [x, y] = toScreen(findMark(levelEnds(pointsOf(chain))));
          return <path key={chain.id} class="water-mark" d={`M${x - 6} ${y - 11}h12l-6 10zM${x - 4} ${y + 4}h8M${x - 2} ${y + 7}h4`} />;
        })}
      {state.chains.value
        .filter(({ kind }) => kind === "monitor" || kind === "centre")
        .map((chain) => {
          const [x, y] = toScreen(pointsOf(chain)[0]!);
          return <path key={chain.id} class="monitor-mark" d={`M${x - 5} ${y}h10M${x} ${y - 5}v10`} />;
        })}
      <PartMarks />
      <Loads />
    </g>
  );
}

/** Arrows on the ground, 22 px long. */
function Loads() {
  const now = state.selection.value;
  return (
    <>
      {state.loads.value.map(({ x, values }, index) => {
        const [first, last] = [x[0]!.value, x.at(-1)!.value];
        const count = Math.max(2, Math.min(24, Math.round(((last - first) * view.value.scale) / 22) + 1));
        const places = Array.from({ length: count }, (_, i) => first + (i / (count - 1)) * (last - first));
        const tops = places.flatMap((at) => {
          const top = findGround(at);
          return top === null ? [] : [toScreen([at, top])];
        });
        if (!tops.length) return null;
        const arrows = tops.map(([px, py]) => `M${px} ${py - 24}V${py - 3}M${px - 3} ${py - 8}L${px} ${py - 2}L${px + 3} ${py - 8}`).join("");
        const rail = `M${tops.map(([px, py]) => `${px} ${py - 24}`).join("L")}`;
        const [tx, ty] = tops[Math.floor(tops.length / 2)]!;
        const shown = [...new Set(values.map((value) => (Number.isNaN(value) ? "?" : String(Number((value / stress.value.size).toPrecision(4))))))].join(" – ");
        return (
          <g key={index} class={now.kind === "load" && now.index === index ? "load chosen" : "load"}>
            <path d={arrows + rail} />
            <text x={tx} y={ty - 32}>
              {shown} {stress.value.name}
            </text>
          </g>
        );
      })}
    </>
  );
}
