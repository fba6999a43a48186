// SPDX-License-Identifier: MIT
/** Element tests as lines, and the diagrams that they share with calibrations: margins, axes, grid. */
import * as Plot from "@observablehq/plot";

import type { Column, PointGroup, PointTest, PointTests } from "../../contract";
import { describeAxis, findLogTicks, findStep, formatLogTick, layOut, makeAxis } from "../base/axes";
import type { CsvColumn } from "../base/rows";
import { titleWithUnit } from "../base/numbers";
import { dashOf, type SeriesStyle, styleOf } from "../base/styles";

export interface PointLine {
  test: PointTest;
  style: SeriesStyle;
  columns: Map<string, Column>;
}

export function makeLines({ tests }: PointTests, columns: Column[][], group: PointGroup): PointLine[] {
  const coded = group.dash.some((dash) => dash > 0);
  return group.tests.map((number, i) => {
    const test = tests[number]!;
    const style = styleOf(group.colour[i]!);
    return {
      test,
      style: coded ? { ...style, dash: dashOf(group.dash[i]!) } : style,
      columns: new Map(columns[number]!.map((column) => [column.name, column])),
    };
  });
}

/** Smallest and largest value of a column over all lines, as an axis shows them; never the same. */
export function findSpan(lines: readonly PointLine[], name: string, log = false): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (const line of lines)
    for (const v of line.columns.get(name)?.values ?? [])
      if (v !== null && (!log || v > 0)) {
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
  if (!(low <= high)) return log ? [1, 10] : [0, 1];
  // A quantity that is zero throughout, or nearly one number, still needs an axis.
  if (high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high), 1e-9)) {
    const room = Math.max(0.05 * Math.abs(high), 0.01);
    return log ? [low / 1.1, high * 1.1] : [low - room, high + room];
  }
  // An axis that nearly begins at zero begins there.
  return [!log && low > 0 && low < 0.5 * high ? 0 : low, high];
}

/** Ticks of a logarithmic axis, which has even steps where it is shorter than one power of ten. */
export function listTicks(low: number, high: number): number[] {
  if (high >= 5 * low) return findLogTicks([low, high], 6);
  const step = findStep(low, high, 5);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, i) => (first + i) * step);
}

/** Stops of the crosshair, evenly spaced over the axis. */
export function makeStops(low: number, high: number, log: boolean, count = 200): number[] {
  return Array.from({ length: count + 1 }, (_, i) =>
    log ? low * (high / low) ** (i / count) : low + ((high - low) * i) / count,
  );
}

/** Values of the lines at an abscissa, where they first reach it. */
export function readLines(
  lines: readonly PointLine[],
  xName: string,
  yName: string,
  at: number,
): { line: PointLine; value: number }[] {
  return lines.flatMap((line) => {
    const x = line.columns.get(xName)!.values;
    const y = line.columns.get(yName)!.values;
    for (let i = 1; i < x.length; ++i) {
      const [a, b] = [x[i - 1]!, x[i]!];
      if (Math.min(a, b) > at || Math.max(a, b) < at) continue;
      const fraction = a === b ? 1 : (at - a) / (b - a);
      return [{ line, value: y[i - 1]! + fraction * (y[i]! - y[i - 1]!) }];
    }
    return [];
  });
}

/** All curves below each other, the first column naming the test. */
export function makePointCsv(lines: readonly PointLine[]): CsvColumn[] {
  const first = lines[0];
  if (!first) return [];
  const names = lines.flatMap((line) => [...line.columns.values()][0]!.values.map(() => line.test.name));
  return [
    { name: "test", values: names },
    ...[...first.columns.values()].map((column) => ({
      name: column.name,
      unit: column.unit,
      values: lines.flatMap((line) => line.columns.get(column.name)!.values),
    })),
  ];
}

export function capitalise(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

interface Axis {
  title: string;
  unit: string;
  /** Smallest and largest value. */
  ends: [number, number];
}

interface Look {
  height: number;
  /** Room between the frame and what is drawn [px]. */
  inset: number;
  logX: boolean;
}

export function layOutDiagram(
  x: Axis,
  y: Axis,
  { height, inset, logX }: Look,
  marks: Plot.Markish[],
): Plot.PlotOptions {
  const domain: [number, number] = logX ? [x.ends[0] / 1.1, x.ends[1] * 1.1] : x.ends;
  const along = describeAxis(...x.ends, 6);
  return layOut({
    height,
    margins: [26, 14, 44, 62],
    x: {
      type: logX ? "log" : "linear",
      domain,
      label: titleWithUnit(capitalise(x.title), x.unit),
      inset,
      ticks: logX ? listTicks(...domain) : 6,
      tickFormat: logX ? formatLogTick : along.format,
    },
    y: makeAxis({ title: capitalise(y.title), unit: y.unit, domain: y.ends, inset }),
    marks: [y.ends[0] < 0 && y.ends[1] > 0 ? Plot.ruleY([0], { stroke: "var(--muted)" }) : [], marks],
  });
}
