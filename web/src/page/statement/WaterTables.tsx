// SPDX-License-Identifier: MIT
/** Pore water in numbers: conditions, start, steady seepage, the weather before the run, and where the water of the stages went. */
import type { Discharge, HydraulicCondition, Season, Seepage, SeepageExit, Water, WaterBudget } from "../../contract";
import { findUsedWater } from "../../drawing/standingWater";
import { report } from "../../state";
import { DataTable, Facts, SymbolText } from "../DataTable";
import { formatCoordinate, formatNumber, formatPlace, formatQuantity, formatSentence, formatUnit } from "../format";

/** Rows of a series that are written out; more are seen in its chart. */
const mostRows = 8;

function writeSeries({ series }: HydraulicCondition): string {
  if (!series) return "–";
  const value = (i: number) => formatQuantity(series.values[i], { name: series.unit.name, si: 1 });
  if (series.values.length === 1) return value(0);
  if (series.values.length > mostRows) return `${series.values.length} rows over time, drawn under “Soil water”`;
  return series.values.map((_, i) => `${value(i)} at ${formatNumber(series.time[i])}\u00a0s`).join(", ");
}

/** "error 4 × 10⁻⁹ of the water in the model". */
export function describeClosure(error: number): string {
  const size = Math.abs(error);
  return size < 1e-12 ? "error: round-off" : `error ${formatNumber(size, 1)} of the water in the model`;
}

/** What passes each side; `runoff` where some ran off. */
function Discharges(props: { caption: string; of: { discharges: Discharge[]; inflow: number; outflow: number }; runoff?: boolean }) {
  const { discharges, inflow, outflow } = props.of;
  const rate = report.value.units.flow;
  const flow = (value: number) => formatNumber(value / rate.si);
  const runoff = discharges.reduce((sum, d) => sum + d.runoff, 0);
  const all = { name: "Together", inflow, outflow, runoff };
  return (
    <DataTable
      caption={`${props.caption}, ${rate.name}`}
      rows={[...discharges, all]}
      rowClass={(d) => d === all && "main"}
      columns={[
        ["Boundary", (d) => d.name, "name"],
        ["In", (d) => flow(d.inflow), "number"],
        ["Out", (d) => flow(d.outflow), "number"],
        props.runoff && ["Runs off", (d) => flow(d.runoff), "number"],
      ]}
    />
  );
}

const writeExit = ({ lowest, highest }: SeepageExit) =>
  `from ${formatPlace(lowest)} up to the exit point ${formatPlace(highest)}`;

function SeepageTable({ seepage, dimension }: { seepage: Seepage; dimension: 2 | 3 }) {
  const { length, flow, stress } = report.value.units;
  const height = (x: number[]) => `${formatCoordinate(x[1]!)}\u00a0${length.name}`;
  const closes = Math.abs(seepage.balance_error) <= 1e-9 * Math.max(seepage.inflow, seepage.outflow);
  const rows: [string, string][] = [
    ["Through the ground", formatQuantity(seepage.outflow, flow)],
    ["Balance", closes ? "error below 10⁻⁹ of the flow" : `error ${formatQuantity(seepage.balance_error, flow)}`],
    ["Solution", `${formatNumber(seepage.iterations)} iterations on the mesh of the calculation`],
    [
      "Largest suction",
      `${formatQuantity(seepage.largest_suction, stress)} at ${formatPlace(seepage.largest_suction_at)}`,
    ],
    ...seepage.exits.map((exit): [string, string] => [
      `Water leaves ${exit.name}`,
      dimension === 2 ? writeExit(exit) : `between the heights ${height(exit.lowest)} and ${height(exit.highest)}`,
    ]),
  ];
  const caption = `Steady seepage ${report.value.result.season ? "before the season" : "at the start"}`;
  return (
    <>
      <Discharges caption={caption} of={seepage} runoff={seepage.discharges.some((d) => d.runoff !== 0)} />
      <Facts caption="The steady seepage" rows={rows} />
    </>
  );
}

/** The weather before the run: where its water went, and how dry the soil became. */
function SeasonTable({ season }: { season: Season }) {
  const { units } = report.value;
  const volume = (value: number) => formatQuantity(value, units.volume);
  const length = (value: number) => formatNumber(value / units.length.si);
  const suction = (value: number) => formatNumber(value / units.stress.si);
  const growth = season.growth < 0 ? "less" : "more";
  const rows: [string, string][] = [
    ["Weather before the run", `${formatNumber(season.duration / 86400)} days, in soil at rest`],
    ["Came in", volume(season.inflow)],
    ["Ran off", volume(season.runoff)],
    ["Left through the ground and the sides", volume(season.outflow)],
    ["Transpired", `${volume(season.transpired)} of ${volume(season.potential)} that the plants asked for`],
    ["Stored at its end", `${volume(Math.abs(season.growth))} ${growth} than at its start`],
    ["Balance", `closes to ${formatNumber(Math.abs(season.error), 1)} of the greatest of these`],
  ];
  return (
    <>
      <Facts caption="The weather before the run" rows={rows} />
      <DataTable
        caption={`Suction under the ground, ${units.stress.name}; negative is pressure`}
        rows={season.layers}
        columns={[
          [
            `Depth, ${units.length.name}`,
            ({ depth }, i) => `${length(season.layers[i - 1]?.depth ?? 0)}–${length(depth)}`,
            "name",
          ],
          ["Mean, start", (layer) => suction(layer.initial), "number"],
          ["Mean, end", (layer) => suction(layer.mean), "number"],
          ["Least", (layer) => suction(layer.least), "number"],
          ["Greatest", (layer) => suction(layer.greatest), "number"],
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
  const { volume: unit, stress } = report.value.units;
  const volume = (mass: number) => formatNumber(dropNoise(mass, budget) / budget.density / unit.si);
  const rains = budget.surfaces.some((s) => s.supplied !== 0 || s.runoff !== 0);
  // Surfaces without a condition are named only where water passed.
  const surfaces = budget.surfaces.filter((s, i) => i > 0 || dropNoise(s.entered, budget) || dropNoise(s.left, budget));
  const change = budget.stored - budget.initial;
  const amount = (mass: number) => `${volume(mass)} ${unit.name}`;
  const hasSuction = budget.largest_suction > 0;
  const rows: [string, string | false][] = [
    ["Stored at the start", amount(budget.initial)],
    ["Stored at the end", `${amount(budget.stored)}, ${change < 0 ? "less" : "more"} by ${volume(Math.abs(change))}`],
    ["Closure", `the balance ${describeClosure(budget.error)}`],
    ["Largest pore pressure", `${formatQuantity(budget.largest_pressure, stress)} at the end`],
    ["Largest suction", hasSuction ? `${formatQuantity(budget.largest_suction, stress)} at the end` : "none"],
    ["Transpired by plants", budget.transpired !== undefined && amount(budget.transpired)],
    ["Left with soil that left the grid", budget.left_grid !== 0 && amount(budget.left_grid)],
    [
      "Pressed into pores at frozen geometry",
      dropNoise(budget.pressed_in, budget) !== 0 && amount(budget.pressed_in),
    ],
    ["Lost between elements", dropNoise(budget.lost_between, budget) !== 0 && amount(budget.lost_between)],
  ];
  return (
    <>
      <DataTable
        caption={`Water budget of the stages, ${unit.name}`}
        rows={surfaces}
        columns={[
          ["Boundary", (s) => s.name, "name"],
          ["Condition", (s) => s.condition.replaceAll("_", " ")],
          ["Came in", (s) => volume(s.entered), "number"],
          ["Left", (s) => volume(s.left), "number"],
          rains && ["Rained", (s) => (s.supplied ? volume(s.supplied) : "–"), "number"],
          rains && ["Ran off", (s) => (s.supplied ? volume(s.runoff) : "–"), "number"],
        ]}
      >
        <tr class="main">
          <th scope="row" colSpan={2}>
            Together
          </th>
          <td class="number">{volume(budget.entered)}</td>
          <td class="number">{volume(budget.left)}</td>
          {rains && <td class="number">{volume(budget.surfaces.reduce((sum, s) => sum + s.supplied, 0))}</td>}
          {rains && <td class="number">{volume(budget.runoff)}</td>}
        </tr>
      </DataTable>
      <Facts caption="The water budget" rows={rows.filter(([, value]) => value)} />
    </>
  );
}

/** Water before the run: laws, initial state and conditions. */
export function WaterTables({ water }: { water: Water }) {
  return (
    <>
      <p>{formatSentence(water.state)}</p>
      {water.conditions.length === 0 ? (
        <p>No hydraulic conditions: water may leave free surfaces at zero pressure, and none enters.</p>
      ) : (
        <DataTable
          caption="Hydraulic conditions"
          rows={water.conditions}
          columns={[
            ["Where", (condition) => condition.on, "name"],
            ["Condition", (condition) => condition.title],
            ["Value", writeSeries],
            ["Meaning", (condition) => formatSentence(condition.text), "prose"],
          ]}
        />
      )}
      <DataTable
        caption="Water"
        rows={water.properties}
        columns={[
          ["Property", (property) => property.title, "name"],
          ["Symbol", (property) => <SymbolText text={property.symbol} />],
          ["Value", ({ value, unit }) => `${formatNumber(value)} ${formatUnit(unit)}`, "number"],
        ]}
      />
    </>
  );
}

/** Results on the water: seepage and budget. */
export function WaterResults() {
  const { model, result, units } = report.value;
  const { water, seepage, season } = result;
  const last = findUsedWater();
  if (!seepage && !season && !water)
    return <p>The results hold no water budget: the run has not ended.</p>;
  return (
    <>
      {seepage && <SeepageTable seepage={seepage} dimension={model.dimension} />}
      {season && <SeasonTable season={season} />}
      {/* Flow through each side at the end of the season, as opposed to the steady seepage before it. */}
      {last?.flow === "transient" && (
        <>
          <Discharges caption="Transient seepage at the end of the season" of={last} />
          <Facts
            caption="The transient seepage at its end"
            rows={[
              ["Growth of the stored water", formatQuantity(last.storage_rate, units.flow)],
              ...last.exits.map((exit): [string, string] => [`Water leaves ${exit.name}`, writeExit(exit)]),
            ]}
          />
        </>
      )}
      {water && <Budget budget={water} />}
    </>
  );
}
