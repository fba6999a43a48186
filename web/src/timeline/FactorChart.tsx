// SPDX-License-Identifier: MIT
/** Factor of safety over time, with the rain of the case above it and the levels of its water below. */
import * as Plot from "@observablehq/plot";
import { useEffect, useState } from "preact/hooks";
import { signal } from "@preact/signals";

import { describeAxis, layOut, makeAxis } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { styleOf } from "../charts/base/styles";
import { formatFactor } from "../page/format";
import { report } from "../state";
import { findRain, type LevelLine, listLevels, listRain, type RainBar, type ShownTimeline } from "./chosen";

interface Props {
  timeline: ShownTimeline;
  chosen: number;
  onChoose: (moment: number) => void;
}

const makeTimeAxis = ({ duration, unit, start }: ShownTimeline, width: number) => ({
  domain: [0, duration / unit.si],
  label: `Time [${unit.name}${start ? ` since ${start}` : ""}]`,
  ticks: Math.max(4, width / 90),
});

export function FactorChart({ timeline, chosen, onChoose }: Props) {
  const [at] = useState(() => signal(0));
  const { unit, target, failure } = timeline;
  const points = timeline.factors.map((f, i) => ({ ...f, i, t: f.time / unit.si })).filter((p) => p.factor !== null);
  const stops = points.map((p) => p.t);
  useEffect(() => {
    at.value = timeline.factors[chosen]!.time / unit.si;
  }, [chosen]);
  const rain = listRain(report.value.water?.conditions ?? [], timeline.duration).map((bar) => ({
    ...bar,
    from: bar.from / unit.si,
    to: bar.to / unit.si,
  }));
  const elements = timeline.elements.flatMap((e) => e.runs.map((r) => ({ t: e.time / unit.si, factor: r.factor })));
  const factors = [...points.map((p) => p.factor!), ...elements.map((e) => e.factor)];
  const [low, high] = [Math.min(target, ...factors), Math.max(target, ...factors)];
  const margin = 0.06 * Math.max(high - low, 0.02);
  const most = Math.max(0, ...rain.map((bar) => bar.rate));
  // Rain hangs from the upper edge, over a quarter of the picture.
  const top = high + margin + (most > 0 ? 0.35 * (high - low + 2 * margin) : 0);
  const place = (rate: number) => top - (rate / most) * 0.3 * (top - low);
  const depth = (bar: RainBar) => place(bar.rate);
  const rainUnit = findRain(report.value.water?.conditions ?? [])?.unit.name ?? "";
  const rates = most > 0 ? [0, most / 2, most] : [];
  const writeRate = describeAxis(0, most, 2).format;
  const levels = listLevels(report.value.water?.conditions ?? [], timeline.duration);
  const { colour } = styleOf(0);
  const draw = (width: number) =>
    layOut({
      height: Math.max(260, Math.min(360, width * 0.45)),
      margins: [24, most > 0 ? 52 : 20, 46, 56],
      x: makeTimeAxis(timeline, width),
      y: { domain: [low - margin, top], label: "Factor of safety", ticks: 5 },
      marks: [
        Plot.axisY({ ticks: 5, label: "Factor of safety", labelArrow: "none" }),
        most > 0
          ? Plot.axisY(rates.map(place), {
              anchor: "right",
              tickFormat: (_, i) => writeRate(rates[i]!),
              label: `Rain [${rainUnit}]`,
              labelArrow: "none",
            })
          : null,
        Plot.rect(rain, { x1: "from", x2: "to", y1: depth, y2: top, fill: "var(--water, #2f7fb8)", fillOpacity: 0.45 }),
        failure
          ? Plot.rect([failure], {
              x1: failure.earliest / unit.si,
              x2: (failure.latest ?? timeline.duration) / unit.si,
              y1: low - margin,
              y2: high + margin,
              fill: "#c2185b",
              fillOpacity: 0.14,
            })
          : null,
        failure ? Plot.ruleX([failure.to / unit.si], { stroke: "#c2185b", y1: low - margin, y2: high + margin }) : null,
        Plot.ruleY([target], { stroke: "#c2185b", strokeDasharray: "4 3" }),
        Plot.line(points, { x: "t", y: "factor", stroke: colour, strokeWidth: 1.8 }),
        Plot.dot(points, { x: "t", y: "factor", r: 3, fill: colour }),
        Plot.dot(elements, { x: "t", y: "factor", r: 5, symbol: "diamond", stroke: styleOf(1).colour, strokeWidth: 2 }),
      ],
    });
  return (
    <figure class="chart-figure" aria-label="Factor of safety over time">
      <Chart
        label="Factor of safety over time"
        draw={draw}
        depends={[timeline]}
        stops={stops}
        hint="Point at a time to read it; a click shows its section below."
        ruler={() => at.value}
        onPick={(stop) => onChoose(points[stop]!.i)}
        read={(i) => {
          const p = points[i]!;
          return {
            text: `${p.title}: F = ${formatFactor(p.factor)}, ${p.surface.title}, ${p.source}`,
            marks: [{ value: p.factor!, at: p.t, colour }],
          };
        }}
      />
      <p class="chart-note">
        The factor was found at every dot. Dashed: {formatFactor(target)}, below which the slope fails.
        {failure &&
          " The line is the first time below it; the band holds the time of failure with what searches scatter."}
        {elements.length > 0 && " Diamonds: FEM."}
        {most > 0 && " Bars from above: rain, with its axis at the right."}
      </p>
      {levels.map((line) => (
        <LevelChart key={line.on} line={line} timeline={timeline} />
      ))}
    </figure>
  );
}

/** The level of the water on a side, on the times of the factor above it. */
function LevelChart({ line, timeline }: { line: LevelLine; timeline: ShownTimeline }) {
  const { unit } = timeline;
  const points = line.points.map(([t, level]) => [t / unit.si, level] as [number, number]);
  const levels = points.map(([, level]) => level);
  const [low, high] = [Math.min(...levels), Math.max(...levels)];
  const pad = 0.1 * (high - low);
  const draw = (width: number) =>
    layOut({
      height: 130,
      margins: [22, 20, 42, 56],
      x: makeTimeAxis(timeline, width),
      y: makeAxis({ title: `Level at ${line.on}`, unit: line.unit, domain: [low - pad, high + pad], count: 3 }),
      marks: [Plot.line(points, { stroke: "var(--water, #2f7fb8)", strokeWidth: 1.8 })],
    });
  return (
    <Chart
      quiet
      label={`Level at ${line.on} over time`}
      draw={draw}
      depends={[timeline]}
      stops={points.map(([t]) => t)}
      read={(i) => ({
        text: `${points[i]![0]} ${unit.name}: ${levels[i]} ${line.unit}`,
        marks: [{ value: levels[i]!, at: points[i]![0], colour: "var(--water, #2f7fb8)" }],
      })}
    />
  );
}
