// SPDX-License-Identifier: MIT
/** Common parts of the diagrams of element tests and of calibrations: margins, axes, grid. */
import * as Plot from "@observablehq/plot";

import { describeAxis, formatLogTick, layOut, makeAxis } from "../base/axes";
import { titleWithUnit } from "../base/numbers";
import { listTicks } from "./pointData";

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
