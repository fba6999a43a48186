// SPDX-License-Identifier: MIT
/** Factors of safety over the size that the study extrapolates, and where their lines meet size zero. */
import * as Plot from "@observablehq/plot";

import { ChartTable } from "../../page/DataTable";
import { formatFactor } from "../../page/format";
import { layOut } from "../base/axes";
import { Chart } from "../base/Chart";
import { CsvButton, Legend } from "../base/Legend";
import { formatNumber, titleWithUnit } from "../base/numbers";
import { styleOf } from "../base/styles";
import type { Study } from "./studyData";

export function StudyExtrapolation({ study }: { study: Study }) {
  const { extrapolation } = study;
  if (!extrapolation || extrapolation.factors.length === 0) return null;
  const { key, unit, factors } = extrapolation;
  const title = (f: (typeof factors)[number]) => [f.criterion, f.variant].filter(Boolean).join("; ");
  const points = factors
    .flatMap((f, k) => [
      { k, x: 0, y: f.linear, name: title(f), extrapolated: true },
      ...f.sizes.map((x, i) => ({ k, x, y: f.factors[i]!, name: title(f), extrapolated: false })),
    ])
    .sort((a, b) => a.x - b.x);
  const largest = Math.max(...points.map((p) => p.x));
  const sum = (values: number[]) => values.reduce((a, b) => a + b, 0);
  const draw = (width: number) =>
    layOut({
      height: Math.max(280, Math.min(380, width * 0.5)),
      margins: [28, 20, 46, 58],
      x: { domain: [0, largest * 1.05], label: titleWithUnit(key, unit), ticks: width < 420 ? 4 : 7, inset: 8 },
      y: { label: "Factor of safety", ticks: 6, inset: 10, zero: false },
      marks: factors.map((f, k) => {
        const { colour, dash, symbol } = styleOf(k);
        // The least squares line passes through the mean of the sizes and of the factors.
        const [x, y] = [sum(f.sizes) / f.sizes.length, sum(f.factors) / f.sizes.length];
        const end = f.linear + (x > 0 ? (largest * (y - f.linear)) / x : 0);
        const marks = f.sizes.map((size, i) => [size, f.factors[i]!]);
        return [
          Plot.line(
            [
              [0, f.linear],
              [largest, end],
            ],
            { stroke: colour, strokeWidth: 1.4, strokeDasharray: dash || "5 3" },
          ),
          Plot.dot(marks, { stroke: colour, strokeWidth: 1.6, fill: "var(--ground)", symbol, r: 4.2 }),
          Plot.dot([[0, f.linear]], { stroke: colour, fill: colour, symbol, r: 4.6 }),
        ];
      }),
    });
  return (
    <figure aria-label={`Factors extrapolated to ${key} = 0`} class="chart-figure">
      <div class="chart-head">
        <h4>Extrapolated to {key} = 0</h4>
        <CsvButton
          part="study-extrapolation"
          what="extrapolation"
          columns={() => [
            { name: "factor", values: points.map((p) => p.name) },
            { name: key, unit: unit || "-", values: points.map((p) => p.x) },
            { name: "factor of safety", unit: "-", values: points.map((p) => p.y) },
          ]}
        />
      </div>
      <Legend markers items={factors.map((f, k) => ({ id: title(f), title: title(f), style: styleOf(k) }))} />
      <Chart
        label={`Factors of safety over ${key}`}
        draw={draw}
        depends={[extrapolation]}
        stops={[...new Set(points.map((p) => p.x))]}
        hint="Point at a size to read it; filled marks are extrapolated."
        read={(i) => {
          const x = [...new Set(points.map((p) => p.x))][i]!;
          const here = points.filter((p) => p.x === x);
          return {
            text: here.map((p) => `${p.name}: ${formatFactor(p.y)}`).join("; "),
            marks: here.map((p) => ({ value: p.y, at: x, colour: styleOf(p.k).colour })),
          };
        }}
      />
      <ChartTable
        label="Extrapolated factors of safety"
        rows={factors}
        columns={[
          ["Factor", title, "name"],
          ["Sizes", (f) => f.sizes.length, "number"],
          ["Coarsest", (f) => formatFactor(f.factors[0]), "number"],
          ["Finest", (f) => formatFactor(f.factors.at(-1)), "number"],
          ["At zero, line through all", (f) => <strong>{formatFactor(f.linear)}</strong>, "wrap"],
          ["±", (f) => formatFactor(f.standard_error), "number"],
          ["Line through the finest two", (f) => formatFactor(f.finest_pair), "wrap"],
          ["Order p", (f) => formatNumber(f.order, 3), "number"],
          ["with p", (f) => formatFactor(f.by_order), "number"],
        ]}
      />
      <p class="chart-note">
        ± is the standard error from the scatter of the meshes about the line. The order p is the exponent of the size
        that fits best, where there are four sizes.
      </p>
    </figure>
  );
}
