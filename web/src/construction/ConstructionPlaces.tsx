// SPDX-License-Identifier: MIT
/** Places of the stages of construction: monitors with measurements and stress paths, section lines, forces of supports, MPM from a stage. */
import * as Plot from "@observablehq/plot";

import { layOut, makeAxis } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { Legend } from "../charts/base/Legend";
import { styleOf } from "../charts/base/styles";
import type { Unit } from "../contract";
import type { Construction, ConstructionMonitor, ConstructionSupport, Release } from "../contract/results";
import { ChartTable } from "../page/DataTable";
import { formatNumber, formatQuantity } from "../page/format";
import { report } from "../state";
import { listAlongSupports } from "./construction";
import { type Curve, Curves } from "./Curves";

interface TimeProps {
  construction: Construction;
  time: Unit;
  times: number[];
  ends: number[];
  isWet: boolean;
}

/** The distance beyond the toe where MPM ended, unless its two meshes leave it open. */
const formatRunout = ({ error, undetermined, toe_distance }: Release, unit: Unit) =>
  error ? "–" : undetermined?.includes("toe_distance") ? "not determined" : formatQuantity(toe_distance, unit, 3);

type Measured = { time: number[]; value: number[]; rms?: number | null } | null | undefined;

const makeCurve = (title: string, values: (number | null)[], sign: number, measured: Measured): Curve => ({
  title,
  values: values.map((v) => (v === null ? null : sign * v)),
  ...(measured ? { measured: { at: measured.time, values: measured.value } } : {}),
});

/** Effective stress path of each monitor: q over p′. */
function StressPaths({ monitors, unit }: { monitors: ConstructionMonitor[]; unit: Unit }) {
  const paths = monitors.map(({ name, mean, deviator }, k) => ({
    name,
    style: styleOf(k),
    points: mean.flatMap((p, i) => {
      const q = deviator[i];
      return p === null || q === null || q === undefined || !Number.isFinite(p) || !Number.isFinite(q)
        ? []
        : [{ p: p / unit.si, q: q / unit.si }];
    }),
  }));
  const all = paths.flatMap(({ points }) => points);
  if (all.length === 0) return null;
  const right = 1.05 * Math.max(...all.map(({ p }) => p), 1e-9);
  const top = 1.1 * Math.max(...all.map(({ q }) => q), 1e-9);
  const first = paths[0]!.points;
  const draw = (width: number) =>
    layOut({
      height: 240,
      margins: [22, 20, 46, 62],
      x: { domain: [0, right], label: `Effective mean stress p′ [${unit.name}]`, ticks: Math.max(4, width / 90) },
      y: makeAxis({ title: "Deviatoric stress q", unit: unit.name, domain: [0, top], count: 4 }),
      marks: paths.flatMap(({ points, style }) => [
        Plot.line(points, { x: "p", y: "q", stroke: style.colour, strokeWidth: 1.8, curve: "linear" }),
        Plot.dot(points.slice(0, 1), { x: "p", y: "q", stroke: style.colour, fill: "white", r: 4 }),
        Plot.dot(points.slice(-1), { x: "p", y: "q", fill: style.colour, r: 4 }),
      ]),
    });
  return (
    <>
      {paths.length > 1 && <Legend items={paths.map(({ name, style }) => ({ id: name, title: name, style }))} />}
      <Chart
        quiet
        label="Effective stress paths of the monitors"
        draw={draw}
        depends={[monitors]}
        stops={first.map(({ p }) => p)}
        read={(i) => ({
          text: `${paths[0]!.name}: p′ = ${formatNumber(first[i]!.p)} ${unit.name}, q = ${formatNumber(first[i]!.q)} ${unit.name}`,
          marks: [{ value: first[i]!.q, at: first[i]!.p, colour: paths[0]!.style.colour }],
        })}
      />
      <p class="chart-note">Stress paths begin at the open dots and end at the full ones.</p>
    </>
  );
}

/** Settlement, lateral displacement and pore pressure of the monitors in time, with what was measured. */
export function MonitorsInTime({ construction: { monitors }, time, times, ends, isWet }: TimeProps) {
  const { units } = report.value;
  if (monitors.length === 0) return null;
  const shared = { along: "Time", at: times, atUnit: time, marks: ends };
  const rms = (measured: Measured, unit: Unit) => (measured ? formatQuantity(measured.rms, unit, 3) : "–");
  const isMeasured = monitors.some((m) => m.measured_settlement ?? m.measured_lateral ?? m.measured_pressure);
  return (
    <>
      <Curves
        {...shared}
        title="Settlement of monitors"
        unit={units.displacement}
        downwards
        curves={monitors.map((m) => makeCurve(m.name, m.displacement_y, -1, m.measured_settlement))}
      />
      {monitors.some((m) => m.measured_lateral) && (
        <Curves
          {...shared}
          title="Horizontal displacement of monitors"
          unit={units.displacement}
          curves={monitors.map((m) => makeCurve(m.name, m.displacement_x, 1, m.measured_lateral))}
        />
      )}
      {isWet && (
        <Curves
          {...shared}
          title="Pore pressure of monitors"
          unit={units.stress}
          curves={monitors.map((m) => makeCurve(m.name, m.pressure, 1, m.measured_pressure))}
        />
      )}
      <StressPaths monitors={monitors} unit={units.stress} />
      {isMeasured && (
        <ChartTable
          label="Differences from the measurements, root mean square"
          rows={monitors}
          columns={[
            ["Monitor", (m) => m.name, "name"],
            ["Settlement", (m) => rms(m.measured_settlement, units.displacement), "number"],
            ["Horizontal displacement", (m) => rms(m.measured_lateral, units.displacement), "number"],
            ["Pore pressure", (m) => rms(m.measured_pressure, units.stress), "number"],
          ]}
        />
      )}
    </>
  );
}

const ofMoment: Unit = { si: 1e3, name: "kN·m/m" };

/** Values along section lines at the ends of the stages. */
export function LinesOfStages({ construction: { lines }, isWet }: { construction: Construction; isWet: boolean }) {
  const { units } = report.value;
  return (
    <>
      {lines.map(({ name, distance, profiles }) => {
        const shared = { along: `Distance along '${name}'`, at: distance, atUnit: units.length };
        return (
          <div key={name}>
            <Curves
              {...shared}
              title="Settlement"
              unit={units.displacement}
              downwards
              curves={profiles.map((p) => makeCurve(p.stage, p.displacement_y, -1, null))}
            />
            <Curves
              {...shared}
              title="Horizontal displacement"
              unit={units.displacement}
              curves={profiles.map((p) => makeCurve(p.stage, p.displacement_x, 1, null))}
            />
            {isWet && (
              <Curves
                {...shared}
                title="Excess pore pressure"
                unit={units.stress}
                curves={profiles.map((p) => makeCurve(p.stage, p.excess, 1, null))}
              />
            )}
          </div>
        );
      })}
    </>
  );
}

/** Moment, shear force and deflection of walls and axial force of bars along each support, a curve for each stage. */
function AlongSupports({ construction }: { construction: Construction }) {
  const { units } = report.value;
  const quantities = [
    { title: "Bending moment", unit: ofMoment, find: (s: ConstructionSupport) => ({ place: s.place, value: s.moment }) },
    { title: "Shear force", unit: units.line_force, find: (s: ConstructionSupport) => ({ place: s.place, value: s.shear }) },
    {
      title: "Deflection",
      unit: units.displacement,
      find: (s: ConstructionSupport) => ({ place: s.deflection_place ?? [], value: s.deflection ?? [] }),
    },
    { title: "Axial force", unit: units.line_force, find: (s: ConstructionSupport) => ({ place: s.place, value: s.moment.length > 0 ? [] : s.force }) },
  ];
  return (
    <>
      {quantities.flatMap(({ title, unit, find }) =>
        listAlongSupports(construction, find).map(({ name, at, curves }) => (
          <Curves
            key={`${title} ${name}`}
            title={`${title} of '${name}'`}
            unit={unit}
            along={`Distance from the head of '${name}'`}
            at={at}
            atUnit={units.length}
            curves={curves}
          />
        )),
      )}
    </>
  );
}

/** Forces of the supports at the ends of the stages, and MPM from them. */
export function SupportsOfStages({ construction }: { construction: Construction }) {
  const { units } = report.value;
  const { stages } = construction;
  const forces = stages.flatMap(({ name, supports }) => supports.map((s) => ({ stage: name, ...s })));
  const released = stages.flatMap(({ name, release }) => (release ? [{ stage: name, release }] : []));
  return (
    <>
      <AlongSupports construction={construction} />
      {forces.length > 0 && (
        <ChartTable
          label="Forces of supports at the ends of the stages"
          rows={forces}
          columns={[
            ["Stage", (s) => s.stage, "name"],
            ["Support", (s) => (s.row && forces.some((other) => other.support === s.support && other.row !== s.row) ? `${s.support}, row ${s.row}` : s.support)],
            ["Axial force", (s) => formatQuantity(s.largest_force, units.line_force, 3), "number"],
            ["Head", (s) => formatQuantity(s.head_force, units.line_force, 3), "number"],
            forces.some((s) => s.moment.length > 0) && [
              "Moment",
              (s) => (s.moment.length > 0 ? formatQuantity(s.largest_moment, ofMoment, 3) : "–"),
              "number",
            ],
            forces.some((s) => s.shear.length > 0) && [
              "Shear force",
              (s) => (s.shear.length > 0 ? formatQuantity(s.largest_shear, units.line_force, 3) : "–"),
              "number",
            ],
            forces.some((s) => s.largest_deflection !== undefined) && [
              "Deflection",
              (s) => (s.largest_deflection !== undefined ? formatQuantity(s.largest_deflection, units.displacement, 3) : "–"),
              "number",
            ],
            forces.some((s) => s.struts) && [
              "Struts",
              (s) => (s.struts ? s.struts.map((n) => formatQuantity(n, units.line_force, 3)).join(", ") : "–"),
              "number",
            ],
          ]}
        />
      )}
      {released.length > 0 && (
        <ChartTable
          label="MPM from the ends of stages"
          rows={released}
          columns={[
            ["Stage", (s) => s.stage, "name"],
            ["Largest displacement", (s) => (s.release.error ? "–" : formatQuantity(s.release.largest_displacement, units.length, 3)), "number"],
            ["Runout beyond the toe", (s) => formatRunout(s.release, units.length), "number"],
            ["Results", (s) => s.release.error ?? s.release.folder],
          ]}
        />
      )}
    </>
  );
}
