// SPDX-License-Identifier: MIT
/** How often a sampled result falls into each class, with the limit and fitted distributions. */
import * as Plot from "@observablehq/plot";
import { useMemo } from "preact/hooks";

import { layOut } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { CsvButton, Legend } from "../charts/base/Legend";
import { formatNumber, titleWithUnit } from "../charts/base/numbers";
import type { SampledValues } from "../contract";
import { findDensity, formatShare } from "./probability";

interface Props {
  values: SampledValues;
  title: string;
  unit: string;
  /** Samples below this limit fail. */
  limit: number | null;
  probability: number | null;
  part: string;
}

const fits = [
  { kind: "normal", title: "normal distribution", style: { colour: "var(--series-3)", dash: "", symbol: "circle" } },
  {
    kind: "lognormal",
    title: "lognormal distribution",
    style: { colour: "var(--series-4)", dash: "7 3", symbol: "circle" },
  },
] as const;

export function HistogramChart({ values, title, unit, limit, probability, part }: Props) {
  const { edges, counts } = values.histogram;
  const { mean, deviation } = values;
  const total = counts.reduce((a, b) => a + b, 0) || 1;
  const classes = useMemo(
    () => counts.map((count, i) => ({ from: edges[i]!, to: edges[i + 1]!, count, share: count / total })),
    [values],
  );
  const middles = classes.map((c) => (c.from + c.to) / 2);
  const fitted = limit !== null && mean !== null && deviation !== null && deviation > 0;
  const width = classes.length ? classes[0]!.to - classes[0]!.from : 1;
  const curves = fitted
    ? fits.map((fit) => ({
        ...fit,
        line: Array.from({ length: 121 }, (_, i) => {
          const x = edges[0]! + ((edges.at(-1)! - edges[0]!) * i) / 120;
          return [x, 100 * width * findDensity(fit.kind, mean, deviation, x)];
        }),
      }))
    : [];
  const low = Math.min(edges[0]!, limit ?? Infinity);
  const high = Math.max(edges.at(-1)!, limit ?? -Infinity);
  const draw = (size: number) =>
    layOut({
      height: Math.max(260, Math.min(330, size * 0.6)),
      margins: [limit === null ? 30 : 46, 18, 46, 52],
      x: { domain: [low, high], label: titleWithUnit(title, unit), ticks: 6, inset: 6 },
      y: { label: "Share of the samples [%]", ticks: 5 },
      marks: [
        Plot.rectY(classes, {
          x1: "from",
          x2: "to",
          y: (c: (typeof classes)[number]) => 100 * c.share,
          insetLeft: 0.5,
          insetRight: 0.5,
          fill: (c: (typeof classes)[number]) =>
            limit !== null && c.to <= limit + 1e-9 ? "var(--bad)" : "var(--series-1)",
          fillOpacity: 0.65,
        }),
        curves.map((c) =>
          Plot.line(c.line, { stroke: c.style.colour, strokeWidth: 1.8, strokeDasharray: c.style.dash }),
        ),
        limit === null ? null : Plot.ruleX([limit], { stroke: "var(--ink)", strokeWidth: 1.5 }),
        limit === null || probability === null
          ? null
          : Plot.text([limit], {
              x: limit,
              frameAnchor: "top",
              lineAnchor: "bottom",
              dy: -5,
              text: () => `P(F < ${limit}) = ${formatShare(probability)}`,
              textAnchor:
                limit < low + 0.3 * (high - low) ? "start" : limit > low + 0.7 * (high - low) ? "end" : "middle",
              fontWeight: 600,
            }),
      ],
    });
  return (
    <figure aria-label={`Distribution: ${title}`}>
      <div class="chart-head">
        <h4>{title}</h4>
        <CsvButton
          part={part}
          columns={() => [
            { name: "from", unit: unit || "-", values: classes.map((c) => c.from) },
            { name: "to", unit: unit || "-", values: classes.map((c) => c.to) },
            { name: "samples", unit: "-", values: classes.map((c) => c.count) },
          ]}
        />
      </div>
      {curves.length > 0 && (
        <Legend items={curves.map((c) => ({ id: c.kind, title: c.title, style: { ...c.style } }))} />
      )}
      <Chart
        label={`Histogram: ${title}`}
        draw={draw}
        depends={[values, limit]}
        stops={middles}
        hint="Point at a class to read it."
        read={(i) => {
          const c = classes[i]!;
          const range = `${formatNumber(c.from, 4)} to ${formatNumber(c.to, 4)}${unit && ` ${unit}`}`;
          return {
            text: `${range}: ${formatNumber(c.count, 7)} samples, ${formatShare(c.share)}`,
            marks: [{ value: 100 * c.share, at: middles[i]!, colour: "var(--series-1)" }],
          };
        }}
      />
      <p class="chart-note">
        Mean {formatNumber(mean, 4)}, deviation {formatNumber(deviation, 3)}, skewness{" "}
        {formatNumber(values.skewness, 2)}; {formatNumber(values.smallest, 4)} to {formatNumber(values.largest, 4)}
        {values.none > 0 && `; ${formatNumber(values.none, 7)} samples without a value`}
        {values.quantiles.length > 0 &&
          `. Quantiles: ${values.quantiles.map((q) => `${formatNumber(100 * q.share, 3)} % ${formatNumber(q.value, 4)}`).join(", ")}`}
        .
      </p>
    </figure>
  );
}
