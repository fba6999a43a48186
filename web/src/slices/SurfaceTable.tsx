// SPDX-License-Identifier: MIT
/** The surfaces that have a factor: by method, with the results of the checks and the yield acceleration; one is selected. */
import { CsvButton } from "../charts/base/Legend";
import { formatNumber, titleWithUnit } from "../charts/base/numbers";
import { formatFactor } from "../page/format";
import { ChartTable } from "../page/DataTable";
import { report } from "../state";
import { nameReason, nameSurface, type SlicedSurface, slicedSurfaces } from "./sliceData";

interface Props {
  selected: SlicedSurface;
  select: (surface: SlicedSurface) => void;
}

const percent = (share: number) => `${formatNumber(100 * share, 2)} %`;

export function SurfaceTable({ selected, select }: Props) {
  const { length } = report.value.units;
  const surfaces = slicedSurfaces.value;
  const drawdown = report.value.slices?.drawdown;
  const has = {
    lambda: surfaces.some((s) => s.lambda !== null),
    correction: surfaces.some((s) => s.correction !== 1),
    before: surfaces.some((s) => s.drawdown),
    undrained: surfaces.some((s) => typeof s.drawdown?.undrained_factor === "number"),
    acceleration: surfaces.some((s) => s.yield_acceleration !== null),
  };
  const drawn = surfaces.map((s) => s.drawdown);
  const circles = surfaces.map((s) => s.circle);
  const columns = () => [
    { name: "surface", values: surfaces.map(nameSurface) },
    { name: "factor of safety", unit: "-", values: surfaces.map((s) => s.factor) },
    has.before && {
      name: "factor of safety before drawdown",
      unit: "-",
      values: drawn.map((d) => d?.factor_before ?? null),
    },
    has.undrained && {
      name: "factor of safety, second stage",
      unit: "-",
      values: drawn.map((d) => d?.undrained_factor ?? null),
    },
    { name: "lambda", unit: "-", values: surfaces.map((s) => s.lambda) },
    { name: "correction f0", unit: "-", values: surfaces.map((s) => s.correction) },
    { name: "yield acceleration", unit: "g", values: surfaces.map((s) => s.yield_acceleration) },
    { name: "area", unit: `${length.name}²`, values: surfaces.map((s) => s.area / length.si ** 2) },
    { name: "depth", unit: length.name, values: surfaces.map((s) => s.depth / length.si) },
    { name: "centre x", unit: length.name, values: circles.map((c) => (c ? c.centre[0]! / length.si : null)) },
    { name: "centre y", unit: length.name, values: circles.map((c) => (c ? c.centre[1]! / length.si : null)) },
    { name: "radius", unit: length.name, values: circles.map((c) => (c ? c.radius / length.si : null)) },
    { name: "smallest m_alpha", unit: "-", values: surfaces.map((s) => s.checks.smallest_m_alpha) },
    { name: "tensile share of the base", unit: "-", values: surfaces.map((s) => s.checks.tensile_share) },
    { name: "share of sides with thrust outside", unit: "-", values: surfaces.map((s) => s.checks.thrust_outside) },
    { name: "refused because", values: surfaces.map((s) => (s.factor === null ? nameReason(s.checks.refusal) : "")) },
  ];
  return (
    <figure class="chart-figure" aria-label="Critical surfaces">
      <div class="chart-head">
        <h4>Critical surfaces by method</h4>
        <CsvButton part="slip-surfaces" columns={columns} />
      </div>
      <ChartTable
        label="Critical surfaces by method"
        class="surface-table"
        rows={surfaces}
        rowClass={(s) => s === selected && "surface-selected"}
        columns={[
          [
            "Surface",
            (s) => (
              <button type="button" aria-pressed={s === selected} title="Show its slices" onClick={() => select(s)}>
                <span aria-hidden="true">{s === selected ? "●" : "○"}</span> {nameSurface(s)}
              </button>
            ),
            "name",
          ],
          ["F", (s) => formatFactor(s.factor, "none"), "number"],
          has.before && ["F before drawdown", (s) => formatFactor(s.drawdown?.factor_before, "none"), "number"],
          has.undrained && ["F, second stage", (s) => formatFactor(s.drawdown?.undrained_factor, "none"), "number"],
          has.lambda && ["λ", (s) => formatNumber(s.lambda, 3), "number"],
          has.correction && ["f₀", (s) => (s.correction === 1 ? "–" : formatNumber(s.correction, 4)), "number"],
          has.acceleration && [
            <span title="Horizontal acceleration with F = 1">
              k<sub>y</sub>
            </span>,
            (s) => formatNumber(s.yield_acceleration, 3),
            "number",
          ],
          [titleWithUnit("Area", `${length.name}²`), (s) => formatNumber(s.area / length.si ** 2, 4), "number"],
          [titleWithUnit("Depth", length.name), (s) => formatNumber(s.depth / length.si, 3), "number"],
          [
            <>
              Smallest m<sub>α</sub>
            </>,
            (s) => formatNumber(s.checks.smallest_m_alpha, 3),
            "wrap",
          ],
          ["Base in tension", (s) => percent(s.checks.tensile_share), "wrap"],
          ["Thrust outside", (s) => (s.lambda === null ? "–" : percent(s.checks.thrust_outside)), "wrap"],
          [
            "Remarks",
            (s) => (
              <>
                {s.factor === null && s.checks.refusal && (
                  <span class="chart-bad">refused: {nameReason(s.checks.refusal)}</span>
                )}
                {s.warnings.map((w) => (
                  <div key={w}>{w}</div>
                ))}
                {s.factor !== null && s.warnings.length === 0 && <span class="chart-missing">none</span>}
              </>
            ),
            "surface-remarks",
          ],
        ]}
      />
      {drawdown && (
        <p class="chart-note">
          F is the factor of safety after a rapid drawdown, by {drawdown}; the other factors are of the same
          surface.
        </p>
      )}
      {has.acceleration && (
        <p class="chart-note">
          k<sub>y</sub> is the horizontal acceleration, over that of gravity, with which the factor of this surface is
          1.
        </p>
      )}
    </figure>
  );
}
