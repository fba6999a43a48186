// SPDX-License-Identifier: MIT
/** The lines of a profile: value across, height upwards; the crosshair runs along the height. */
import * as Plot from "@observablehq/plot";

import type { SequenceField } from "../../contract";
import { formatCoordinate } from "../../page/format";
import { report } from "../../state";
import { layOut, makeAxis } from "../base/axes";
import { Chart } from "../base/Chart";
import { Symbol } from "../base/Legend";
import { formatQuantity } from "../base/numbers";
import { type Bin, findLayer } from "./profileData";
import type { SeriesStyle } from "../base/styles";

export interface ProfileLine {
  frame: number;
  title: string;
  style: SeriesStyle;
  bins: Bin[];
}

interface ProfileProps {
  lines: ProfileLine[];
  field: SequenceField;
  /** Axis that points up. */
  vertical: number;
  onRemove: (frame: number) => void;
}

export function ProfileChart({ lines, field, vertical, onRemove }: ProfileProps) {
  const { bounds, mesh } = report.value.model;
  const length = report.value.units.length;
  const unit = field.unit;
  const letter = "xyz"[vertical]!;
  const bottom = bounds[0][vertical]!;
  const layers = [...new Set(lines.flatMap((l) => l.bins.map((b) => b.layer)))].sort((a, b) => a - b);
  const heights = layers.map((k) => (bottom + (k + 0.5) * findLayer(mesh.mean_size)) / length.si);

  const bins = lines.flatMap((l) => l.bins);
  const highest = Math.max(...bins.map((b) => b.height), bottom + mesh.mean_size) + mesh.mean_size / 2;
  // Zero is on the axis: how large a value is shows only beside it.
  const low = Math.min(0, ...bins.map((b) => b.mean / unit.si)) * 1.05;
  const high = Math.max(0, ...bins.map((b) => b.mean / unit.si)) * 1.05 || (low < 0 ? 0 : 1);
  const draw = (width: number) =>
    layOut({
      height: Math.max(280, Math.min(420, width * 0.6)),
      margins: [28, 24, 46, 52],
      x: makeAxis({ title: field.title, unit: unit.name, domain: [low, high], count: 6 }),
      y: makeAxis({
        title: `Height ${letter}`,
        unit: length.name,
        domain: [bottom / length.si, highest / length.si],
        count: 6,
      }),
      grid: "x",
      marks: [
        Plot.ruleX([0], { stroke: "var(--muted)" }),
        lines.flatMap((l) => {
          const points = l.bins.map((b) => [b.mean / unit.si, b.height / length.si]);
          return [
            Plot.line(points, { stroke: l.style.colour, strokeWidth: 1.5, strokeDasharray: l.style.dash }),
            Plot.dot(points, { stroke: l.style.colour, symbol: l.style.symbol, r: 3.2, fill: "var(--ground)" }),
          ];
        }),
        Plot.ruleY([bottom / length.si], { stroke: "var(--muted)" }),
      ],
    });

  return (
    <>
      <ul class="chart-legend" aria-label="Times that are drawn">
        {lines.map((l) => (
          <li key={l.frame} class="chart-entry">
            <svg class="chart-swatch" width="34" height="12" viewBox="0 0 34 12" aria-hidden="true">
              <path d="M1 6H33" stroke={l.style.colour} stroke-width="1.6" stroke-dasharray={l.style.dash} />
              <Symbol style={l.style} x={17} y={6} />
            </svg>
            {l.title}
            <button
              type="button"
              class="chart-remove"
              aria-label={`Remove ${l.title}`}
              onClick={() => onRemove(l.frame)}
            >
              ×
            </button>
          </li>
        ))}
      </ul>
      <Chart
        along="y"
        label={`${field.title} over height`}
        draw={draw}
        depends={[lines, field]}
        stops={heights}
        hint="Point at a height to read it."
        read={(i) => {
          const hits = lines.map((l) => ({ line: l, bin: l.bins.find((b) => b.layer === layers[i]) }));
          const formatHere = (bin?: Bin) => formatQuantity(bin && bin.mean / unit.si, unit.name);
          const values = hits.map(({ line, bin }) => `${line.title}: ${formatHere(bin)}`);
          return {
            text: `${letter} = ${formatCoordinate(heights[i]! * length.si)} ${length.name}; ${values.join("; ")}`,
            marks: hits.flatMap(({ line, bin }) =>
              bin ? [{ value: bin.mean / unit.si, at: bin.height / length.si, colour: line.style.colour }] : [],
            ),
          };
        }}
      />
    </>
  );
}
