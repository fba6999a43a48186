// SPDX-License-Identifier: MIT
/** Displacement over the strength reduction factor: the trials, the fitted lines, the factor of each criterion. */
import * as Plot from "@observablehq/plot";
import { useMemo, useState } from "preact/hooks";

import type { Branch, Criterion, CriterionKind, DisplacementCurve } from "../../contract";
import { formatFactor, roundDown, roundUp } from "../../page/format";
import { frameIndex, report, sequence, sequenceIndex } from "../../state";
import { layOut, makeAxis } from "../base/axes";
import { Chart } from "../base/Chart";
import {
  findRestLimits, judgeTrial, makeCurveColumns, placeFlags, sampleBranch, stateWords, type TrialState,
} from "./curveData";
import { AxisChoice, type AxisKind, CsvButton } from "../base/Legend";
import { findNearestFrame } from "../base/rows";
import { formatNumber, formatQuantity } from "../base/numbers";
import { styleOf } from "../base/styles";

const criterionTitles: Record<CriterionKind, string> = {
  bilinear: "bilinear lines",
  displacement: "displacement limit",
  jump: "jump",
  frozen: "frozen geometry",
};

/** The interval at frozen geometry is rounded outward, as in the answer. */
const roundInterval = (c: Criterion): Criterion =>
  c.name === "frozen" ? { ...c, lower: roundDown(c.lower), upper: roundUp(c.upper) } : c;

const margin = { left: 62, right: 18, bottom: 48 };
const ink = "var(--ink)";
const rowHeight = 18;
/** Width that a label of the flags takes per character [px]; a little more than the fonts need. */
const characterWidth = 6.9;
/** Width of the title of the displacement axis, which is on the frame's left corner [px]. */
const titleWidth = 165;

export function CurveSection() {
  const { curve } = report.value.result;
  if (!curve || curve.points.length === 0) return null;
  return (
    <section class="chart-section" aria-labelledby="chart-curve-title">
      <div class="chart-head">
        <h3 id="chart-curve-title">Displacement over strength reduction factor</h3>
        <CsvButton part="curve" columns={() => makeCurveColumns(curve)} />
      </div>
      <CurveChart curve={curve} />
    </section>
  );
}

function CurveChart({ curve }: { curve: DisplacementCurve }) {
  const [scale, setScale] = useState<AxisKind>("linear");
  const unit = report.value.units.displacement;
  const limits = useMemo(
    () => findRestLimits(report.value.result.input, report.value.model.slope_height),
    [report.value],
  );
  const log = scale === "log";
  const trials = useMemo(
    () =>
      curve.points
        .map((p) => ({ ...p, shown: p.displacement / unit.si, state: judgeTrial(p, limits) }))
        .sort((a, b) => a.srf - b.srf),
    [curve, limits, unit],
  );
  const visible = log ? trials.filter((t) => t.displacement > 0) : trials;
  const main = report.value.answer.factors.find((f) => f.main)?.by;
  const criteria = curve.criteria.map((c, i) => ({ ...roundInterval(c), style: styleOf(i), main: c.name === main }));
  const found = criteria.filter((c) => c.factor !== null);

  const draw = (width: number): Plot.PlotOptions => {
    const factors = [...trials.map((t) => t.srf), ...found.map((c) => c.factor!)];
    const low = Math.min(...factors);
    const high = Math.max(...factors);
    const pad = (high - low) * 0.03 || 0.1;
    const x: [number, number] = [low - pad, high + pad];
    const largest = Math.max(...visible.map((t) => t.shown), 0);
    const y: [number, number] = log
      ? [Math.min(...visible.map((t) => t.shown)) / 1.6, largest * 1.6]
      : [-largest * 0.015, largest * 1.05 || 1];
    const inside = width - margin.left - margin.right;
    const at = found.map((c) => margin.left + ((c.factor! - x[0]) / (x[1] - x[0])) * inside);
    const label = (c: (typeof found)[number]) =>
      width < 480 ? formatFactor(c.factor) : `${formatFactor(c.factor)} ${criterionTitles[c.name]}`;
    const flags = placeFlags(
      at,
      found.map((c) => label(c).length * characterWidth + 14),
      width - 2,
    );
    // The title of the axis has the row next to the frame when a label would be in it.
    const reach = found.map((c, i) => at[i]! - (flags.side === "left" ? label(c).length * characterWidth : 0));
    if (reach.some((end) => end < margin.left + titleWidth)) flags.rows = flags.rows.map((row) => row + 1);
    const rows = Math.max(0, ...flags.rows) + 1;
    const line = (branch: Branch) =>
      sampleBranch(branch, x[0], x[1], y[0] * unit.si, y[1] * unit.si).map(([f, u]) => [f, u / unit.si]);
    const axis = makeAxis({ title: "Largest displacement", unit: unit.name, domain: y, log, count: 6 });
    const meet = curve.bilinear?.factor ?? null;
    return layOut({
      height: Math.max(300, Math.min(440, width * 0.62)) + rows * rowHeight,
      margins: [10 + rows * rowHeight, margin.right, margin.bottom, margin.left],
      x: { domain: x, label: "Strength reduction factor SRF", ticks: width < 480 ? 5 : 8 },
      y: { ...axis, label: null },
      marks: [
        Plot.rect(
          found.filter((c) => c.lower !== null && c.upper !== null && c.upper > c.lower),
          { x1: "lower", x2: "upper", y1: y[0], y2: y[1], fill: (c) => c.style.colour, fillOpacity: 0.13 },
        ),
        ...found.flatMap((c, i) => [
          Plot.ruleX([c.factor], {
            stroke: c.style.colour,
            strokeWidth: c.main ? 2.2 : 1.4,
            strokeDasharray: c.style.dash,
            insetTop: -(flags.rows[i]! + 1) * rowHeight,
          }),
          Plot.text([c], {
            x: "factor",
            frameAnchor: "top",
            text: label,
            dx: flags.side === "right" ? 5 : -5,
            dy: -(flags.rows[i]! + 0.5) * rowHeight,
            textAnchor: flags.side === "right" ? "start" : "end",
            lineAnchor: "middle",
            fill: c.style.colour,
            fontWeight: c.main ? 700 : 400,
          }),
        ]),
        ...(curve.bilinear
          ? [curve.bilinear.first, curve.bilinear.second].map((b) =>
              Plot.line(line(b), { stroke: ink, strokeWidth: 1, strokeDasharray: "5 3", strokeOpacity: 0.75 }),
            )
          : []),
        Plot.line(visible, { x: "srf", y: "shown", stroke: "var(--muted)", strokeWidth: 1 }),
        ...(curve.bilinear && meet !== null
          ? [
              Plot.dot([[meet, (curve.bilinear.first.slope * meet + curve.bilinear.first.intercept) / unit.si]], {
                symbol: "diamond",
                r: 6,
                stroke: ink,
                fill: "var(--ground)",
                strokeWidth: 1.5,
                clip: true,
              }),
            ]
          : []),
        Plot.dot(visible, {
          x: "srf",
          y: "shown",
          r: 3.6,
          symbol: (t: (typeof visible)[number]) => (t.state === "failed" ? "times" : "circle"),
          stroke: ink,
          strokeWidth: 1.5,
          fill: (t) => (t.state === "rest" ? "var(--ink)" : "var(--ground)"),
        }),
        Plot.ruleX([x[0]], { stroke: "var(--muted)" }),
        Plot.text([axis.label], {
          frameAnchor: "top-left",
          dy: -12,
          dx: -margin.left + 4,
          textAnchor: "start",
          lineAnchor: "middle",
        }),
      ],
    });
  };

  const show = (stop: number) => {
    const index = report.value.sequences.findIndex((s) => s.kind === "curve");
    const frame = findNearestFrame(report.value.sequences[index]?.frames ?? [], (f) => f.factor, visible[stop]!.srf);
    if (index < 0 || frame < 0) return;
    sequenceIndex.value = index;
    frameIndex.value = frame;
  };
  const canShow = report.value.sequences.some((s) => s.kind === "curve");
  const omitted = trials.length - visible.length;

  return (
    <>
      <div class="chart-bar">
        <AxisChoice label="Axis of displacement" value={scale} onChange={setScale} />
      </div>
      <Chart
        label="Displacement over strength reduction factor, trials"
        draw={draw}
        depends={[curve, scale, limits]}
        stops={visible.map((t) => t.srf)}
        hint={canShow ? "Point at a trial to read it; click to see it in the viewer." : "Point at a trial to read it."}
        read={(i) => {
          const t = visible[i]!;
          const speedUnit = report.value.units.speed;
          const speed = formatQuantity(t.nodal_speed / speedUnit.si, speedUnit.name, 2);
          const state = `${stateWords[t.state]} (force ratio ${formatNumber(t.force_ratio, 2)}, nodal speed ${speed})`;
          return {
            text: `SRF ${formatNumber(t.srf, 5)}: ${formatQuantity(t.shown, unit.name)}, ${state}`,
            marks: [{ value: t.shown, colour: ink }],
          };
        }}
        onPick={canShow ? show : undefined}
        ruler={() => {
          const shown = sequence.value;
          return shown?.kind === "curve" ? (shown.frames[frameIndex.value]?.factor ?? null) : null;
        }}
      />
      <CurveLegend states={trials.map((t) => t.state)} bilinear={!!curve.bilinear} />
      {log && omitted > 0 && (
        <p class="chart-note">
          {omitted === 1 ? "One trial" : `${omitted} trials`} without displacement cannot stand on a logarithmic axis.
        </p>
      )}
      <ul class="chart-criteria">
        {criteria.map((c) => (
          <li key={c.name}>
            <svg class="chart-swatch" width="30" height="12" viewBox="0 0 30 12" aria-hidden="true">
              <rect x="0" y="0" width="30" height="12" fill={c.style.colour} opacity="0.16" />
              <path d="M1 6H29" stroke={c.style.colour} stroke-width="2" stroke-dasharray={c.style.dash} />
            </svg>
            <span>
              <strong>{criterionTitles[c.name]}</strong>{" "}
              {c.factor === null
                ? "found no factor"
                : `${formatFactor(c.factor)}, ${c.name === "frozen" ? "interval" : "bracket"} ${formatFactor(c.lower)} to ${formatFactor(c.upper)}`}
              {c.note && `: ${c.note}`}
              {c.main && " (the factor of safety of this report)"}
            </span>
          </li>
        ))}
      </ul>
    </>
  );
}

function CurveLegend({ states, bilinear }: { states: TrialState[]; bilinear: boolean }) {
  const dot = (fill: string) => (
    <svg class="chart-swatch" width="14" height="12" viewBox="0 0 14 12" aria-hidden="true">
      <circle cx="7" cy="6" r="4" fill={fill} stroke="var(--ink)" stroke-width="1.6" />
    </svg>
  );
  return (
    <ul class="chart-legend">
      <li class="chart-entry">
        {dot("var(--ink)")} trial, {stateWords.rest}
      </li>
      {states.includes("moving") && (
        <li class="chart-entry">
          {dot("var(--ground)")} trial, {stateWords.moving}
        </li>
      )}
      {states.includes("failed") && <li class="chart-entry">× trial, {stateWords.failed}</li>}
      {bilinear && (
        <li class="chart-entry">
          <svg class="chart-swatch" width="30" height="12" viewBox="0 0 30 12" aria-hidden="true">
            <line x1="1" y1="6" x2="29" y2="6" stroke="var(--ink)" stroke-dasharray="5 3" />
            <path d="M15 1L19 6L15 11L11 6Z" fill="var(--ground)" stroke="var(--ink)" stroke-width="1.5" />
          </svg>
          bilinear lines and where they meet
        </li>
      )}
    </ul>
  );
}
