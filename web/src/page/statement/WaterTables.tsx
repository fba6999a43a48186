// SPDX-License-Identifier: MIT
/** Pore water in numbers: conditions, start, steady seepage, and where the water of the stages went. */
import { findUsedWater } from "../../drawing/standingWater";
import { report } from "../../state";
import { DataTable, Facts, SymbolText, numbers } from "../DataTable";
import { SeasonTable } from "./SeasonTable";
import { formatCoordinate, formatNumber, formatPlace, formatQuantity, formatSentence, formatUnit } from "../format";
import type { HydraulicCondition, Seepage, Water, WaterBudget, WaterState } from "../../contract";

/** Rows of a series that are written out; more are seen in its chart. */
const mostRows = 8;

function writeSeries({ series }: HydraulicCondition): string {
  if (!series) return "–";
  const value = (i: number) => formatQuantity(series.values[i], { name: series.unit.name, si: 1 });
  if (series.values.length === 1) return value(0);
  if (series.values.length > mostRows) return `${series.values.length} rows over time, drawn under “Soil water”`;
  return series.values.map((_, i) => `${value(i)} at ${formatNumber(series.time[i])}\u00a0s`).join(", ");
}

function Properties({ water }: { water: Water }) {
  return (
    <DataTable caption="Water" head={["Property", "Symbol", ...numbers("Value")]}>
      {water.properties.map((property) => (
        <tr key={property.key}>
          <th scope="row">{property.title}</th>
          <td>
            <SymbolText text={property.symbol} />
          </td>
          <td class="number">
            {formatNumber(property.value)} {formatUnit(property.unit)}
          </td>
        </tr>
      ))}
    </DataTable>
  );
}

function Conditions({ conditions }: { conditions: HydraulicCondition[] }) {
  if (conditions.length === 0)
    return <p>No hydraulic conditions: water may leave free surfaces at zero pressure, and none enters.</p>;
  return (
    <DataTable caption="Hydraulic conditions" head={["Where", "Condition", "Value", "Meaning"]}>
      {conditions.map((condition, i) => (
        <tr key={i}>
          <th scope="row">{condition.on}</th>
          <td>{condition.title}</td>
          <td>{writeSeries(condition)}</td>
          <td class="prose">{formatSentence(condition.text)}</td>
        </tr>
      ))}
    </DataTable>
  );
}

/** "error 4 × 10⁻⁹ of the water in the model". */
export function describeClosure(error: number): string {
  const size = Math.abs(error);
  return size < 1e-12 ? "error: round-off" : `error ${formatNumber(size, 1)} of the water in the model`;
}

function SeepageTable({ seepage, dimension }: { seepage: Seepage; dimension: 2 | 3 }) {
  const { units } = report.value;
  const rate = units.flow;
  const flow = (value: number) => formatNumber(value / rate.si);
  const height = (x: number[]) => `${formatCoordinate(x[1]!)}\u00a0${units.length.name}`;
  const runoff = seepage.discharges.reduce((sum, d) => sum + d.runoff, 0);
  const hasRunoff = seepage.discharges.some((d) => d.runoff !== 0);
  const closes = Math.abs(seepage.balance_error) <= 1e-9 * Math.max(seepage.inflow, seepage.outflow);
  const rows: [string, string][] = [
    ["Through the ground", formatQuantity(seepage.outflow, rate)],
    [
      "Balance",
      closes ? "error below 10⁻⁹ of the flow" : `error ${formatQuantity(seepage.balance_error, rate)}`,
    ],
    ["Solution", `${formatNumber(seepage.iterations)} iterations on the mesh of the calculation`],
    [
      "Largest suction",
      `${formatQuantity(seepage.largest_suction, units.stress)} at ${formatPlace(seepage.largest_suction_at)}`,
    ],
    ...seepage.exits.map((exit): [string, string] => [
      `Water leaves ${exit.name}`,
      dimension === 2
        ? `from ${formatPlace(exit.lowest)} up to the exit point ${formatPlace(exit.highest)}`
        : `between the heights ${height(exit.lowest)} and ${height(exit.highest)}`,
    ]),
  ];
  return (
    <>
      <DataTable
        caption={`Steady seepage ${report.value.result.season ? "before the season" : "at the start"}, ${rate.name}`}
        head={["Boundary", ...numbers("In", "Out", hasRunoff && "Runs off")]}
      >
        {seepage.discharges.map((d) => (
          <tr key={d.name}>
            <th scope="row">{d.name}</th>
            <td class="number">{flow(d.inflow)}</td>
            <td class="number">{flow(d.outflow)}</td>
            {hasRunoff && <td class="number">{flow(d.runoff)}</td>}
          </tr>
        ))}
        <tr class="main">
          <th scope="row">Together</th>
          <td class="number">{flow(seepage.inflow)}</td>
          <td class="number">{flow(seepage.outflow)}</td>
          {hasRunoff && <td class="number">{flow(runoff)}</td>}
        </tr>
      </DataTable>
      <Facts caption="The steady seepage" rows={rows} />
    </>
  );
}

/** Flow through each side at the end of the season, as opposed to the steady seepage before it. */
function Transient({ state }: { state: WaterState }) {
  const rate = report.value.units.flow;
  const flow = (value: number) => formatNumber(value / rate.si);
  return (
    <>
      <DataTable
        caption={`Transient seepage at the end of the season, ${rate.name}`}
        head={["Boundary", ...numbers("In", "Out")]}
      >
        {state.discharges.map((d) => (
          <tr key={d.name}>
            <th scope="row">{d.name}</th>
            <td class="number">{flow(d.inflow)}</td>
            <td class="number">{flow(d.outflow)}</td>
          </tr>
        ))}
        <tr class="main">
          <th scope="row">Together</th>
          <td class="number">{flow(state.inflow)}</td>
          <td class="number">{flow(state.outflow)}</td>
        </tr>
      </DataTable>
      <Facts
        caption="The transient seepage at its end"
        rows={[
          ["Growth of the stored water", formatQuantity(state.storage_rate, rate)],
          ...state.exits.map((exit): [string, string] => [
            `Water leaves ${exit.name}`,
            `from ${formatPlace(exit.lowest)} up to the exit point ${formatPlace(exit.highest)}`,
          ]),
        ]}
      />
    </>
  );
}

/** Amounts of water below the rounding of a balance of this size count as zero. */
function dropNoise(mass: number, budget: WaterBudget): number {
  return Math.abs(mass) < 1e-13 * Math.max(budget.initial, budget.stored) ? 0 : mass;
}

function Budget({ budget }: { budget: WaterBudget }) {
  const { units } = report.value;
  const unit = units.volume;
  const volume = (mass: number) => formatNumber(dropNoise(mass, budget) / budget.density / unit.si);
  const rains = budget.surfaces.some((s) => s.supplied !== 0 || s.runoff !== 0);
  // Surfaces without a condition are named only where water passed.
  const surfaces = budget.surfaces.filter((s, i) => i > 0 || dropNoise(s.entered, budget) || dropNoise(s.left, budget));
  const change = budget.stored - budget.initial;
  const rows: [string, string][] = [
    ["Stored at the start", `${volume(budget.initial)} ${unit.name}`],
    [
      "Stored at the end",
      `${volume(budget.stored)} ${unit.name}, ${change < 0 ? "less" : "more"} by ${volume(Math.abs(change))}`,
    ],
    ["Closure", `the balance ${describeClosure(budget.error)}`],
    ["Largest pore pressure", `${formatQuantity(budget.largest_pressure, units.stress)} at the end`],
    [
      "Largest suction",
      budget.largest_suction > 0 ? `${formatQuantity(budget.largest_suction, units.stress)} at the end` : "none",
    ],
  ];
  if (budget.transpired !== undefined)
    rows.push(["Transpired by plants", `${volume(budget.transpired)} ${unit.name}`]);
  if (budget.left_grid !== 0)
    rows.push(["Left with soil that left the grid", `${volume(budget.left_grid)} ${unit.name}`]);
  if (dropNoise(budget.pressed_in, budget) !== 0)
    rows.push(["Pressed into pores at frozen geometry", `${volume(budget.pressed_in)} ${unit.name}`]);
  if (dropNoise(budget.lost_between, budget) !== 0)
    rows.push(["Lost between elements", `${volume(budget.lost_between)} ${unit.name}`]);
  return (
    <>
      <DataTable
        caption={`Water budget of the stages, ${unit.name}`}
        head={["Boundary", "Condition", ...numbers("Came in", "Left", rains && "Rained", rains && "Ran off")]}
      >
        {surfaces.map((s, i) => (
          <tr key={i}>
            <th scope="row">{s.name}</th>
            <td>{s.condition.replaceAll("_", " ")}</td>
            <td class="number">{volume(s.entered)}</td>
            <td class="number">{volume(s.left)}</td>
            {rains && (
              <>
                <td class="number">{s.supplied ? volume(s.supplied) : "–"}</td>
                <td class="number">{s.supplied ? volume(s.runoff) : "–"}</td>
              </>
            )}
          </tr>
        ))}
        <tr class="main">
          <th scope="row" colSpan={2}>
            Together
          </th>
          <td class="number">{volume(budget.entered)}</td>
          <td class="number">{volume(budget.left)}</td>
          {rains && (
            <>
              <td class="number">{volume(budget.surfaces.reduce((sum, s) => sum + s.supplied, 0))}</td>
              <td class="number">{volume(budget.runoff)}</td>
            </>
          )}
        </tr>
      </DataTable>
      <Facts caption="The water budget" rows={rows} />
    </>
  );
}

/** Water before the run: laws, initial state and conditions. */
export function WaterTables({ water }: { water: Water }) {
  return (
    <>
      <p>{formatSentence(water.state)}</p>
      <Conditions conditions={water.conditions} />
      <Properties water={water} />
    </>
  );
}

/** Results on the water: seepage and budget. */
export function WaterResults() {
  const { model, result } = report.value;
  const { water, seepage, season } = result;
  const last = findUsedWater();
  if (!seepage && !season && !water)
    return <p>The results hold no water budget: the run has not ended.</p>;
  return (
    <>
      {seepage && <SeepageTable seepage={seepage} dimension={model.dimension} />}
      {season && <SeasonTable season={season} />}
      {last?.flow === "transient" && <Transient state={last} />}
      {water && <Budget budget={water} />}
    </>
  );
}
