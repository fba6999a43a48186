// SPDX-License-Identifier: MIT
/** Curves over time or along a line, with the points that were measured. */
import * as Plot from "@observablehq/plot";

import { layOut, makeAxis } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { Legend } from "../charts/base/Legend";
import { styleOf } from "../charts/base/styles";
import type { Unit } from "../contract";
import { formatNumber } from "../page/format";

export interface Curve {
  title: string;
  values: (number | null)[];
  /** Measured points in SI, drawn as dots of its colour. */
  measured?: { at: number[]; values: number[] };
}

interface CurvesProps {
  title: string;
  unit: Unit;
  /** Title, places and unit of the abscissa, in SI. */
  along: string;
  at: number[];
  atUnit: Unit;
  curves: Curve[];
  /** Abscissae with a dashed line, in its unit. */
  marks?: number[];
  /** Ordinates grow downwards, as settlements do. */
  downwards?: boolean;
}

/** Finite numbers of a list that may have gaps. */
const isFiniteNumber = (v: number | null | undefined): v is number => typeof v === "number" && Number.isFinite(v);

export function Curves({ title, unit, along, at, atUnit, curves, marks = [], downwards = false }: CurvesProps) {
  const t = at.map((x) => x / atUnit.si);
  const shown = curves.map(({ title: name, values, measured }, k) => ({
    name,
    style: styleOf(k),
    points: values.flatMap((v, i) => (isFiniteNumber(v) ? [{ t: t[i]!, value: v / unit.si }] : [])),
    dots: measured ? measured.at.map((x, i) => ({ t: x / atUnit.si, value: measured.values[i]! / unit.si })) : [],
  }));
  const all = shown.flatMap(({ points, dots }) => [...points, ...dots].map(({ value }) => value));
  const [low, high] = [Math.min(0, ...all), Math.max(0, ...all)];
  const pad = 0.06 * Math.max(high - low, 1e-12);
  const domain: [number, number] = downwards ? [high + pad, low - pad] : [low - pad, high + pad];
  const hasDots = shown.some(({ dots }) => dots.length > 0);
  const draw = (width: number) =>
    layOut({
      height: 220,
      margins: [22, 20, 46, 62],
      x: { domain: [Math.min(0, ...t), Math.max(...t, 0)], label: `${along} [${atUnit.name}]`, ticks: Math.max(4, width / 90) },
      y: makeAxis({ title, unit: unit.name, domain, count: 4 }),
      marks: [
        Plot.ruleX(marks, { stroke: "var(--line)", strokeDasharray: "3 3" }),
        ...shown.map(({ points, style }) => Plot.line(points, { x: "t", y: "value", stroke: style.colour, strokeWidth: 1.8 })),
        ...shown.map(({ dots, style }) => Plot.dot(dots, { x: "t", y: "value", stroke: style.colour, fill: "var(--paper, white)", r: 3.5 })),
      ],
    });
  return (
    <>
      {(shown.length > 1 || hasDots) && (
        <Legend items={shown.map(({ name, style, dots }) => ({ id: name, title: dots.length > 0 ? `${name} (dots: measured)` : name, style }))} />
      )}
      <Chart
        quiet
        label={`${title}, ${along.toLowerCase()}`}
        draw={draw}
        depends={[at, curves]}
        stops={t}
        read={(i) => ({
          text: `${formatNumber(t[i])} ${atUnit.name}: ${shown
            .map(({ name, points }) => {
              const found = points.find((p) => p.t === t[i]);
              return `${name} ${found ? `${formatNumber(found.value)} ${unit.name}` : "–"}`;
            })
            .join(", ")}`,
          marks: shown.flatMap(({ points, style }) => {
            const found = points.find((p) => p.t === t[i]);
            return found ? [{ value: found.value, at: found.t, colour: style.colour }] : [];
          }),
        })}
      />
    </>
  );
}
