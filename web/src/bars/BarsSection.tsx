// SPDX-License-Identifier: MIT
/** Supports in FEM and MPM: the axial force along each bar, moment and shear force of piles and walls, and what limits them. */
import * as Plot from "@observablehq/plot";

import { layOut, makeAxis } from "../charts/base/axes";
import { Chart } from "../charts/base/Chart";
import { CsvButton, Legend, useSwitches } from "../charts/base/Legend";
import { formatNumber, formatQuantity } from "../charts/base/numbers";
import { styleOf } from "../charts/base/styles";
import { ChartTable, type Column } from "../page/DataTable";
import { report } from "../state";
import { type BarRow, type BarTable, listBarTables } from "./barData";

interface BarPoint {
  bar: number;
  name: string;
  /** In the unit of lengths. */
  place: number;
  /** In the unit of the quantity. */
  value: number;
}

/** A quantity along bars. */
interface Quantity {
  id: string;
  title: string;
  unit: string;
  /** In files. */
  si: string;
  /** SI over the unit. */
  scale: number;
  /** When it acts, if not as the axial force. */
  state?: string;
  place: (row: BarRow) => (number | null)[];
  get: (row: BarRow) => (number | null)[];
}

const place = (row: BarRow) => row.place;
const whole = "at full strength of the soil";
const ofForce = { unit: "kN/m", si: "N/m", scale: 1e3, place };
const ofMoment = { unit: "kN·m/m", si: "N.m/m", scale: 1e3, place };
const axialForce: Quantity = { ...ofForce, id: "force", title: "Axial force", get: (r) => r.force };
const ofBeams: Quantity[] = [
  { ...ofMoment, id: "moment", title: "Bending moment", get: (r) => r.moments },
  { ...ofForce, id: "shear", title: "Shear force", get: (r) => r.shears },
  { ...ofMoment, id: "moment-at-start", title: "Bending moment", state: whole, get: (r) => r.startMoments },
  { ...ofForce, id: "shear-at-start", title: "Shear force", state: whole, get: (r) => r.startShears },
  {
    id: "deflection",
    title: "Deflection",
    unit: "mm",
    si: "m",
    scale: 1e-3,
    state: whole,
    place: (r) => r.deflection.place,
    get: (r) => r.deflection.value,
  },
];

const kilo = (force: number | null) => (force === null ? "–" : formatNumber(force / 1e3, 4));
const share = (used: number | null) => (used === null ? "–" : `${(100 * used).toFixed(0)} %`);

function listPoints(rows: BarRow[], quantity: Quantity, unit: number): BarPoint[] {
  return rows.flatMap((row, bar) =>
    quantity
      .get(row)
      .map((value, i) => ({
        bar,
        name: row.name,
        place: (quantity.place(row)[i] ?? 0) / unit,
        value: (value ?? 0) / quantity.scale,
      })),
  );
}

function BarFigure({ table, quantity = axialForce }: { table: BarTable; quantity?: Quantity }) {
  const { length } = report.value.units;
  const [hidden, toggle] = useSwitches();
  const { rows } = table;
  const points = listPoints(rows, quantity, length.si).filter(({ name }) => !hidden.has(name));
  const isAxial = quantity === axialForce;
  const headColumns: Column<BarRow>[] = rows.some((r) => r.onWall)
    ? [["Head on", (r) => r.onWall ?? "soil", "name"]]
    : [];
  const state = quantity.state ?? table.state;
  const draw = (width: number) =>
    layOut({
      height: Math.max(260, Math.min(340, width * 0.45)),
      margins: [28, 20, 46, 62],
      x: { label: `Distance from the head [${length.name}]`, ticks: Math.max(4, width / 90) },
      y: makeAxis({
        title: quantity.title,
        unit: quantity.unit,
        domain: [
          Math.min(0, 1.05 * Math.min(...points.map((p) => p.value))),
          1.05 * Math.max(1e-9, ...points.map((p) => p.value)),
        ],
        log: false,
      }),
      marks: rows.map((_, bar) => {
        const { colour, dash } = styleOf(bar);
        const own = points.filter((p) => p.bar === bar);
        return Plot.line(own, { x: "place", y: "value", stroke: colour, strokeWidth: 1.6, strokeDasharray: dash });
      }),
    });
  return (
    <figure class="chart-figure" aria-label={`${quantity.title} of supports ${state}, ${table.title}`}>
      <div class="chart-head">
        <h4>
          {table.title}: {quantity.title.toLowerCase()} {state}
        </h4>
        <CsvButton
          part={`supports-${table.id}${isAxial ? "" : `-${quantity.id}`}`}
          columns={() => [
            { name: "support", values: rows.flatMap((r) => quantity.get(r).map(() => r.name)) },
            { name: "place", unit: "m", values: rows.flatMap((r) => quantity.get(r).map((_, i) => quantity.place(r)[i] ?? null)) },
            { name: quantity.id, unit: quantity.si, values: rows.flatMap((r) => quantity.get(r)) },
          ]}
        />
      </div>
      <Legend
        hidden={hidden}
        onToggle={rows.length > 1 ? toggle : undefined}
        items={rows.map(({ name }, bar) => ({ id: name, title: name, style: styleOf(bar) }))}
      />
      <Chart
        label={`${quantity.title} along the supports ${state} by ${table.title}`}
        draw={draw}
        depends={[hidden, table]}
        stops={points.map((p) => p.place)}
        hint="Point at a line to read it."
        read={(i) => {
          const p = points[i]!;
          return {
            text: `${p.name}, ${formatQuantity(p.place, length.name, 3)} from its head: ${formatQuantity(p.value, quantity.unit, 3)}`,
            marks: [{ value: p.value, at: p.place, colour: styleOf(p.bar).colour }],
          };
        }}
      />
      {isAxial ? (
        <ChartTable
          label={`Forces of supports by ${table.title}`}
          rows={rows}
          columns={[
            ["Support", (r) => r.name, "name"],
            ["Largest force [kN/m]", (r) => kilo(r.largest), "number"],
            ["Head [kN/m]", (r) => kilo(r.plate), "number"],
            ["Tension", (r) => share(r.tension), "number"],
            ["Pull-out", (r) => share(r.pullOut), "number"],
            ["Stripping", (r) => share(r.stripping), "number"],
            ["Limit reached", (r) => r.limit, "name"],
            ...headColumns,
          ]}
        />
      ) : quantity.id === "moment" ? (
        <ChartTable
          label={`Moments of supports by ${table.title}`}
          rows={rows.filter((r) => r.moments.length > 0)}
          columns={[
            ["Support", (r) => r.name, "name"],
            ["Largest moment [kN·m/m]", (r) => kilo(r.moment), "number"],
            ["Over M_p", (r) => share(r.bending), "number"],
            ["Shear force over strength", (r) => share(r.shear), "number"],
            ["Limit reached", (r) => r.limit, "name"],
          ]}
        />
      ) : null}
    </figure>
  );
}

export function BarsSection() {
  return (
    <>
      {listBarTables(report.value).map((table) => (
        <>
          <BarFigure key={table.id} table={table} />
          {table.rows.some((r) => r.moments.length > 0) &&
            ofBeams
              .filter((quantity) => table.rows.some((r) => quantity.get(r).length > 0))
              .map((quantity) => <BarFigure key={quantity.id} table={table} quantity={quantity} />)}
        </>
      ))}
      <p class="chart-note">
        Per metre of slope, tension positive. Percentages: the largest force over the tensile strength; the bond behind
        it; bond and head in front of it. Deflection: across the wall, towards the left of the way from head to toe. The
        weight acts on the finished slope at once, so that it is no forecast of the movement during construction.
      </p>
    </>
  );
}
