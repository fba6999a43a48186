// SPDX-License-Identifier: MIT
/** How far each number alone moves the factor, one deviation down and up: the longest bar first. */
import * as Plot from "@observablehq/plot";

import { centred } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { CsvButton, Legend } from "../charts/base/Legend";
import { formatNumber } from "../charts/base/numbers";
import type { Sampling } from "../contract";
import { showName, showValue } from "./names";

const low = { colour: "var(--series-2)", dash: "", symbol: "circle" } as const;
const high = { colour: "var(--series-1)", dash: "", symbol: "circle" } as const;

export function TornadoChart({ sampling }: { sampling: Sampling }) {
  const bars = (sampling.tornado ?? []).filter((b) => b.low_factor !== null && b.high_factor !== null);
  if (bars.length === 0) return null;
  const factors = bars.flatMap((b) => [b.low_factor!, b.high_factor!]);
  const atMeans = sampling.first_order?.mean_factor ?? null;
  const middle = atMeans ?? factors.reduce((a, b) => a + b, 0) / factors.length;
  const ends = [Math.min(middle, ...factors), Math.max(middle, ...factors)] as const;
  const pad = 0.12 * (ends[1] - ends[0]) || 0.02;
  const rank = (key: string) => sampling.ranks?.find((r) => r.key === key)?.coefficient ?? null;
  const draw = (width: number): Plot.PlotOptions => {
    const bar = (side: "low_factor" | "high_factor", colour: string) =>
      Plot.rect(bars, {
        x1: middle,
        x2: side,
        y1: (_, k) => k - 0.3,
        y2: (_, k) => k + 0.3,
        fill: colour,
        fillOpacity: 0.8,
      });
    return {
      height: bars.length * 52 + 66,
      marginLeft: 14,
      marginRight: 18,
      marginTop: 14,
      marginBottom: 46,
      x: { domain: [ends[0] - pad, ends[1] + pad], label: "Factor of safety", ...centred, ticks: width < 400 ? 4 : 6 },
      y: { domain: [bars.length - 0.4, -0.75], axis: null },
      marks: [
        Plot.gridX({ ticks: 6, stroke: "var(--line)", strokeOpacity: 1 }),
        bar("low_factor", low.colour),
        bar("high_factor", high.colour),
        Plot.ruleX(atMeans === null ? [] : [atMeans], { stroke: "var(--ink)" }),
        Plot.text(bars, {
          frameAnchor: "left",
          y: (_, k) => k - 0.5,
          text: (b) => `${showName(b.name)}: ${showValue(b.low_value, b.unit)} to ${showValue(b.high_value, b.unit)}`,
          textAnchor: "start",
          stroke: "var(--ground)",
          strokeWidth: 3,
          fill: "var(--ink)",
        }),
      ],
      color: { type: "identity" },
    };
  };
  return (
    <figure aria-label="Sensitivities">
      <div class="chart-head">
        <h4>Sensitivities: one number changed by one deviation</h4>
        <CsvButton
          part="sensitivities"
          columns={() => [
            { name: "number", values: bars.map((b) => b.name) },
            { name: "unit", values: bars.map((b) => b.unit) },
            { name: "one deviation less", values: bars.map((b) => b.low_value) },
            { name: "factor", unit: "-", values: bars.map((b) => b.low_factor) },
            { name: "one deviation more", values: bars.map((b) => b.high_value) },
            { name: "factor", unit: "-", values: bars.map((b) => b.high_factor) },
            { name: "rank correlation with the factor", unit: "-", values: bars.map((b) => rank(b.key)) },
          ]}
        />
      </div>
      <Legend
        items={[
          { id: "low", title: "one deviation less", style: low },
          { id: "high", title: "one deviation more", style: high },
        ]}
      />
      <Chart
        along="y"
        label="Sensitivities of the factor of safety"
        draw={draw}
        depends={[sampling]}
        stops={bars.map((_, k) => k)}
        showReading
        hint="Point at a bar to read it."
        read={(k) => {
          const b = bars[k]!;
          const correlation = rank(b.key);
          return {
            text:
              `${showName(b.name)}: F = ${formatNumber(b.low_factor, 4)} to ${formatNumber(b.high_factor, 4)}` +
              (correlation === null ? "" : `, rank correlation ${formatNumber(correlation, 2)}`),
            marks: [],
          };
        }}
      />
      {atMeans !== null && (
        <p class="chart-note">The line is the factor with all numbers at their means, {formatNumber(atMeans, 4)}.</p>
      )}
    </figure>
  );
}
