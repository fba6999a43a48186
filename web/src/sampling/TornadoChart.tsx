// SPDX-License-Identifier: MIT
/** How far each number alone moves a result, the longest bar first: one deviation down and up, or the values of a study. */
import * as Plot from "@observablehq/plot";

import { layOut } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import type { CsvColumn } from "../charts/base/rows";
import { CsvButton, Legend } from "../charts/base/Legend";
import { formatNumber } from "../charts/base/numbers";
import type { Sampling } from "../contract";
import { showName, showValue } from "./probability";

const low = { colour: "var(--series-2)", dash: "", symbol: "circle" } as const;
const high = { colour: "var(--series-1)", dash: "", symbol: "circle" } as const;

interface TornadoBar {
  title: string;
  low_factor: number;
  high_factor: number;
  /** Behind the reading; may be empty. */
  note: string;
}

interface TornadoProps {
  bars: TornadoBar[];
  /** Result without changes; null: unknown. */
  base: number | null;
  titles: { chart: string; low: string; high: string; axis: string; note: string };
  part: string;
  columns: () => CsvColumn[];
  class?: string;
}

/** Bars from the result without a change to those of both ends, the longest first. */
export function TornadoBars({ bars, base, titles, part, columns, class: name }: TornadoProps) {
  const factors = bars.flatMap((b) => [b.low_factor, b.high_factor]);
  const middle = base ?? factors.reduce((a, b) => a + b, 0) / factors.length;
  const ends = [Math.min(middle, ...factors), Math.max(middle, ...factors)] as const;
  const pad = 0.12 * (ends[1] - ends[0]) || 0.02;
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
    return layOut({
      height: bars.length * 52 + 66,
      margins: [14, 18, 46, 14],
      x: { domain: [ends[0] - pad, ends[1] + pad], label: titles.axis, ticks: width < 400 ? 4 : 6 },
      y: { domain: [bars.length - 0.4, -0.75], axis: null },
      grid: "none",
      marks: [
        Plot.gridX({ ticks: 6, stroke: "var(--line)", strokeOpacity: 1 }),
        bar("low_factor", low.colour),
        bar("high_factor", high.colour),
        Plot.ruleX(base === null ? [] : [base], { stroke: "var(--ink)" }),
        Plot.text(bars, {
          frameAnchor: "left",
          y: (_, k) => k - 0.5,
          text: "title",
          textAnchor: "start",
          stroke: "var(--ground)",
          strokeWidth: 3,
          fill: "var(--ink)",
        }),
      ],
    });
  };
  return (
    <figure class={name} aria-label={titles.chart}>
      <div class="chart-head">
        <h4>{titles.chart}</h4>
        <CsvButton part={part} columns={columns} />
      </div>
      <Legend
        items={[
          { id: "low", title: titles.low, style: low },
          { id: "high", title: titles.high, style: high },
        ]}
      />
      <Chart
        along="y"
        label={titles.chart}
        draw={draw}
        depends={[bars]}
        stops={bars.map((_, k) => k)}
        hint="Point at a bar to read it."
        read={(k) => {
          const { title, low_factor, high_factor, note } = bars[k]!;
          return {
            text: `${title}: ${formatNumber(low_factor, 4)} to ${formatNumber(high_factor, 4)}${note}`,
            marks: [],
          };
        }}
      />
      {titles.note && <p class="chart-note">{titles.note}</p>}
    </figure>
  );
}

export function TornadoChart({ sampling }: { sampling: Sampling }) {
  const found = (sampling.tornado ?? []).filter((b) => b.low_factor !== null && b.high_factor !== null);
  if (found.length === 0) return null;
  const base = sampling.first_order?.mean_factor ?? null;
  const rank = (key: string) => sampling.ranks?.find((r) => r.key === key)?.coefficient ?? null;
  const bars = found.map((b) => ({
    title: `${showName(b.name)}: ${showValue(b.low_value, b.unit)} to ${showValue(b.high_value, b.unit)}`,
    low_factor: b.low_factor!,
    high_factor: b.high_factor!,
    note: rank(b.key) === null ? "" : `, rank correlation ${formatNumber(rank(b.key), 2)}`,
  }));
  return (
    <TornadoBars
      bars={bars}
      base={base}
      titles={{
        chart: "Sensitivities: one number changed by one deviation",
        low: "one deviation less",
        high: "one deviation more",
        axis: "Factor of safety",
        note: base === null ? "" : `The line is the factor with all numbers at their means, ${formatNumber(base, 4)}.`,
      }}
      part="sensitivities"
      columns={() => [
        { name: "number", values: found.map((b) => b.name) },
        { name: "unit", values: found.map((b) => b.unit) },
        { name: "one deviation less", values: found.map((b) => b.low_value) },
        { name: "factor", unit: "-", values: found.map((b) => b.low_factor) },
        { name: "one deviation more", values: found.map((b) => b.high_value) },
        { name: "factor", unit: "-", values: found.map((b) => b.high_factor) },
        { name: "rank correlation with the factor", unit: "-", values: found.map((b) => rank(b.key)) },
      ]}
    />
  );
}
