// SPDX-License-Identifier: MIT
/** A probability over something, with the band of its confidence interval. */
import * as Plot from "@observablehq/plot";
import { useState } from "preact/hooks";

import { layOut, makeAxis } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { AxisChoice, type AxisKind, CsvButton } from "../charts/base/Legend";
import { formatNumber } from "../charts/base/numbers";
import { formatShare } from "./probability";

interface Props {
  title: string;
  /** Title of the abscissa. */
  axis: string;
  axisUnit: string;
  /** Title of the ordinate. */
  probability: string;
  /** [x, probability, lower, upper]. */
  points: number[][];
  part: string;
  note: string;
}

export function BandChart({ title, axis, axisUnit, probability, points, part, note }: Props) {
  const [scale, setScale] = useState<AxisKind>("linear");
  const positive = points.flatMap((p) => [p[1]!, p[2]!]).filter((v) => v > 0);
  const log = scale === "log" && positive.length > 0;
  const lowest = log ? 100 * Math.min(...positive) : 0;
  const largest = Math.max(1e-9, ...points.map((p) => 100 * p[3]!));
  const seen = points.filter((p) => !log || p[1]! > 0);
  const label = `${probability} [%]`;
  const draw = (width: number) =>
    layOut({
      height: Math.max(260, Math.min(330, width * 0.6)),
      margins: [28, 18, 46, 58],
      x: { label: axisUnit ? `${axis} [${axisUnit}]` : axis, ticks: width < 420 ? 4 : 6 },
      y: log
        ? { ...makeAxis({ title: label, domain: [lowest, largest], log }) }
        : { domain: [0, largest], label, ticks: 5 },
      grid: "none",
      marks: [
        Plot.gridY({ ticks: 5, stroke: "var(--line)", strokeOpacity: 1 }),
        Plot.areaY(seen, {
          x: (p) => p[0],
          y1: (p) => Math.max(lowest, 100 * p[2]),
          y2: (p) => 100 * p[3],
          fill: "var(--series-1)",
          fillOpacity: 0.18,
        }),
        Plot.line(seen, { x: (p) => p[0], y: (p) => 100 * p[1], stroke: "var(--series-1)", strokeWidth: 1.8 }),
      ],
    });
  return (
    <figure aria-label={title}>
      <div class="chart-head">
        <h4>{title}</h4>
        <span class="chart-tools">
          <AxisChoice label="Axis of the probability" value={scale} onChange={setScale} />
          <CsvButton
            part={part}
            columns={() => [
              { name: axis.toLowerCase(), unit: axisUnit || "-", values: points.map((p) => p[0]!) },
              { name: "probability", unit: "-", values: points.map((p) => p[1]!) },
              { name: "lower", unit: "-", values: points.map((p) => p[2]!) },
              { name: "upper", unit: "-", values: points.map((p) => p[3]!) },
            ]}
          />
        </span>
      </div>
      <Chart
        label={title}
        draw={draw}
        depends={[points, scale]}
        stops={seen.map((p) => p[0]!)}
        hint="Point at the curve to read it."
        read={(i) => {
          const [x, p, lower, upper] = seen[i]!;
          return {
            text: `${axis} ${formatNumber(x, 4)}${axisUnit && ` ${axisUnit}`}: ${formatShare(p!)} (${formatShare(lower!)} to ${formatShare(upper!)})`,
            marks: [{ value: 100 * p!, at: x!, colour: "var(--series-1)" }],
          };
        }}
      />
      <p class="chart-note">{note}</p>
    </figure>
  );
}
