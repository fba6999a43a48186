// SPDX-License-Identifier: MIT
/** A model in space: from where it is seen, and the planes between which its points are shown. */
import { report } from "../state";
import { formatCoordinate } from "../page/format";
import { cut } from "./settings";
import { shown } from "./shown";
import type { Stage } from "./stage";

/** Angles [rad] about the vertical and above the horizon. */
const views: [string, number, number][] = [
  ["Oblique", -0.4, 0.3],
  ["Front", 0, 0],
  ["Side", Math.PI / 2, 0],
  ["Top", 0, Math.PI / 2],
];

function setCut(axis: number, pair: [number, number]): void {
  cut.value = cut.value.map((old, k) => (k === axis ? pair : old));
}

/** Two ends along an axis; they cannot pass each other. */
function AxisCut(props: { axis: number; name: string }) {
  const { axis, name } = props;
  const { length } = report.value.units;
  const [low, high] = shown.value?.box ?? [[0, 0, 0], [1, 1, 1]];
  const pair = cut.value[axis]!;
  const write = (share: number) => formatCoordinate(low[axis]! + share * (high[axis]! - low[axis]!));
  const set = (end: 0 | 1, share: number) => {
    const next: [number, number] = [...pair];
    next[end] = share;
    if (next[0] > next[1]) next[1 - end] = share;
    setCut(axis, next);
  };
  return (
    <div class="viewer-cut">
      <b>{name}</b>
      {([0, 1] as const).map((end) => (
        <input
          key={end}
          type="range"
          min="0"
          max="1"
          step="0.01"
          aria-label={`Show points ${end ? "up to" : "from"} this ${name}`}
          aria-valuetext={`${write(pair[end])} ${length.name}`}
          value={pair[end]}
          onInput={(event) => set(end, event.currentTarget.valueAsNumber)}
        />
      ))}
      <output>
        {write(pair[0])} to {write(pair[1])} {length.name}
      </output>
      <button type="button" aria-label={`Cut ${name} in the middle`} onClick={() => setCut(axis, [0, 0.5])}>
        Half
      </button>
    </div>
  );
}

export function CutMenu(props: { stage: Stage | null }) {
  if (report.value.model.dimension !== 3) return null;
  return (
    <details class="viewer-menu">
      <summary>View and cut</summary>
      <div>
        <div class="viewer-views">
          {views.map(([name, azimuth, elevation]) => (
            <button key={name} type="button" onClick={() => props.stage?.look(azimuth, elevation)}>
              {name}
            </button>
          ))}
        </div>
        {["x", "y", "z"].map((name, axis) => (
          <AxisCut key={name} axis={axis} name={name} />
        ))}
        <button type="button" onClick={() => (cut.value = [[0, 1], [0, 1], [0, 1]])}>
          Show all
        </button>
      </div>
    </details>
  );
}
