// SPDX-License-Identifier: MIT
/** The run that is shown, over the section: material points by their displacement, slip surfaces with their names. */
import { toScreen, transform } from "../canvas/camera";
import type { Point } from "../geometry/plane";
import type { RunFrame } from "./liveRun";
import { shown } from "./shown";

const classes = 6;

/** Points in classes of equal steps of displacement, each one path of dots. */
export function groupPoints({ x, y, displacement }: RunFrame): { path: string; level: number }[] {
  const largest = Math.max(...displacement, 1e-9);
  const paths = Array.from({ length: classes }, () => "");
  x.forEach((px, i) => {
    const level = Math.min(classes - 1, Math.floor(((displacement[i] ?? 0) / largest) * classes));
    paths[level] += `M${px} ${y[i]}h0`;
  });
  return paths.map((path, level) => ({ path, level })).filter(({ path }) => path !== "");
}

const draw = (points: readonly Point[]) => `M${points.map(([x, y]) => `${x} ${y}`).join("L")}`;

export function RunLayer() {
  const run = shown.value;
  if (!run) return null;
  return (
    <g class="run-layer">
      <g transform={transform.value} class="world">
        {run.frame && groupPoints(run.frame).map(({ path, level }) => <path key={level} class={`points level-${level}`} d={path} />)}
        {run.surfaces.map(({ name, method, points }) => (
          <path key={name} class={`run-surface ${method}`} d={draw(points)} />
        ))}
      </g>
      <g class="labels">
        {run.surfaces.map(({ name, method, points }, i) => {
          const [x, y] = toScreen(points[Math.floor((points.length * (i + 1)) / (run.surfaces.length + 1))]!);
          return (
            <text key={name} class={`run-name ${method}`} x={x} y={y + 14}>
              {name}
            </text>
          );
        })}
      </g>
    </g>
  );
}
