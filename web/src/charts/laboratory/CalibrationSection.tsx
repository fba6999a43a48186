// SPDX-License-Identifier: MIT
/** A calibration: the fitted parameters with their errors and correlations, and measured points over fitted curves. */
import * as Plot from "@observablehq/plot";
import { useMemo } from "preact/hooks";

import type { Calibration, CalibratedParameter } from "../../contract";
import { type Column, DataTable } from "../../page/DataTable";
import { report } from "../../state";
import { type CurveGroup, findRange, groupCurves, makeCurveCsv, makeParameterCsv, shortenKey } from "./calibrationData";
import { Chart } from "../base/Chart";
import { CsvButton, Legend, useSwitches } from "../base/Legend";
import { formatNumber, formatQuantity, titleWithUnit } from "../base/numbers";
import { capitalise, layOutDiagram } from "./diagram";

function Diagram({ group }: { group: CurveGroup }) {
  const [hidden, toggle] = useSwitches();
  const shown = group.lines.filter(({ curve }) => !hidden.has(curve.test));
  const { x, y } = group.lines[0]!.curve;
  const stops = useMemo(
    () => [...new Set(group.lines.flatMap(({ curve }) => curve.at))].sort((a, b) => a - b),
    [group],
  );
  const title = `${y.title} over ${x.title}`;
  const draw = () =>
    layOutDiagram(
      { ...x, ends: findRange(group.lines, 0) },
      { ...y, ends: findRange(group.lines, 1) },
      { height: 300, inset: 6, logX: group.logX },
      shown.flatMap(({ curve, style }) => [
        Plot.line(curve.line_before, { stroke: style.colour, strokeWidth: 1, strokeOpacity: 0.35, clip: true }),
        Plot.line(curve.line, { stroke: style.colour, strokeWidth: 1.7, strokeDasharray: style.dash, clip: true }),
        Plot.dot(
          curve.at.map((v, i) => [v, curve.measured[i]!] as [number, number]),
          { stroke: style.colour, fill: "var(--ground)", symbol: style.symbol, r: 3.6, strokeWidth: 1.6 },
        ),
      ]),
    );
  return (
    <figure class="chart-figure" aria-label={title}>
      <div class="chart-head">
        <h4>{capitalise(title)}</h4>
        <CsvButton part={`calibration_${group.id}`} what="points" columns={() => makeCurveCsv(group.lines)} />
      </div>
      <Legend
        markers
        hidden={hidden}
        onToggle={toggle}
        items={group.lines.map(({ curve, style }) => ({
          id: curve.test,
          title: curve.weight > 0 ? curve.test : `${curve.test} (not fitted)`,
          style,
        }))}
      />
      <Chart
        label={`Measured and fitted ${title}`}
        draw={draw}
        depends={[group, hidden]}
        stops={stops}
        printWidth={520}
        hint="Symbols: measured. Lines: fitted; faint: with the parameters at the start."
        read={(i) => {
          const here = shown.flatMap(({ curve, style }) => {
            const k = curve.at.indexOf(stops[i]!);
            return k < 0 ? [] : [{ curve, style, k }];
          });
          const parts = here
            .slice(0, 3)
            .map(
              ({ curve, k }) =>
                `${curve.test} measured ${formatQuantity(curve.measured[k], y.unit)}, ` +
                `fitted ${formatNumber(curve.fitted[k])}`,
            );
          const rest = here.length > parts.length ? `, and ${here.length - parts.length} more` : "";
          return {
            text: `${capitalise(x.title)} ${formatQuantity(stops[i], x.unit, 3)}: ${parts.join("; ")}${rest}`,
            marks: here.map(({ curve, style, k }) => ({ value: curve.measured[k]!, colour: style.colour })),
          };
        }}
      />
    </figure>
  );
}

function describeError(p: CalibratedParameter): string {
  if (p.error === null) return "–";
  const fraction = p.value === 0 ? "" : ` (${formatNumber((100 * p.error) / Math.abs(p.value), 2)} %)`;
  return `± ${formatNumber(p.error, 3)}${fraction}`;
}

function ParameterTable({ calibration }: { calibration: Calibration }) {
  const { parameters, correlation } = calibration;
  return (
    <DataTable
      caption="Fitted parameters"
      class="point-table"
      rows={parameters}
      columns={[
        ["Parameter", (p, i) => `${i + 1} ${titleWithUnit(shortenKey(p.key), p.unit)}`, "name"],
        [
          "Fitted",
          (p) => (
            <>
              {formatNumber(p.value, 5)}
              {p.limit !== "no" && <strong> at its limit</strong>}
            </>
          ),
          "number",
        ],
        ["Standard error", describeError, "number"],
        ["Start", (p) => formatNumber(p.start), "number"],
        ["Range", (p) => `${formatNumber(p.low)} to ${formatNumber(p.high)}`, "number"],
        ...parameters.map(
          (_, j): Column<CalibratedParameter> => [
            `Corr. with ${j + 1}`,
            (__, i) => {
              const c = i === j ? null : (correlation[i]?.[j] ?? null);
              const text = c === null ? "–" : c.toFixed(2).replace("-", "−");
              return c !== null && Math.abs(c) > 0.95 ? <strong>{text}</strong> : text;
            },
            "number",
          ],
        ),
      ]}
    />
  );
}

function ResidualTable({ calibration }: { calibration: Calibration }) {
  return (
    <DataTable
      caption="Differences, calculated minus measured"
      class="point-table"
      rows={calibration.curves}
      columns={[
        ["Test or monitor", (c) => c.test, "name"],
        [
          "Curve",
          (c) => (
            <>
              {titleWithUnit(c.y.title, c.y.unit)} over {c.x.title}
              {c.missing > 1e-6 && <strong>; {formatNumber(100 * c.missing, 2)} % not reached</strong>}
            </>
          ),
        ],
        ["Points", (c) => c.at.length, "number"],
        ["Root mean square", (c) => formatNumber(c.rms, 3), "number"],
        ["At the start", (c) => formatNumber(c.rms_before, 3), "number"],
        ["Mean", (c) => formatNumber(c.mean, 3), "number"],
        ["Largest", (c) => `${formatNumber(c.largest, 3)} at ${formatQuantity(c.largest_at, c.x.unit, 3)}`, "number"],
        ["Stated error", (c) => formatNumber(c.deviation, 3), "number"],
        ["Weight", (c) => formatNumber(c.weight, 3), "number"],
      ]}
    />
  );
}

export function CalibrationSection() {
  const { calibration } = report.value;
  const groups = useMemo(() => groupCurves(calibration?.curves ?? []), [calibration]);
  if (!calibration) return null;
  const { starts, best } = calibration;
  const converged = starts.filter((start) => start.converged).length;
  return (
    <section class="chart-section" aria-labelledby="chart-calibration-title">
      <div class="chart-head">
        <h3 id="chart-calibration-title">Calibration</h3>
        <CsvButton part="calibration" what="parameters" columns={() => makeParameterCsv(calibration)} />
      </div>
      <p class="chart-note">
        {starts.length === 1
          ? `One search by least squares between the bounds, which ${converged ? "converged" : "did not converge"},`
          : `${starts.length} searches by least squares between the bounds, ${converged} of which converged; number ${best + 1} came nearest,`}{" "}
        after {starts[best]!.iterations} iterations ({calibration.evaluations} sets of parameters,{" "}
        {calibration.tests} tests in all). The {calibration.values} measured values lie{" "}
        {formatNumber(calibration.scatter, 3)} times their stated errors from the fitted curves; the standard errors are
        scaled with that, and take the errors of all values as independent of each other.
      </p>
      <ParameterTable calibration={calibration} />
      {groups.map((group) => (
        <Diagram key={group.id} group={group} />
      ))}
      <ResidualTable calibration={calibration} />
    </section>
  );
}
