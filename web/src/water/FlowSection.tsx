// SPDX-License-Identifier: MIT
/** The method "seepage": discharges, exit gradients, and the safety against uplift and heave, at every time. */
import type { ExitGradient, FlowState, Heave, SectionFlow } from "../contract";
import { type Column, ChartTable } from "../page/DataTable";
import { formatDuration, formatFactor, formatNumber, formatPlace, formatQuantity } from "../page/format";
import { report } from "../state";

/** A row with the state that it belongs to. */
type Row<Found> = { state: FlowState; found: Found };

const listRows = <Found,>(states: FlowState[], list: (state: FlowState) => Found[]): Row<Found>[] =>
  states.flatMap((state) => list(state).map((found) => ({ state, found })));

export function FlowSection() {
  const { flow } = report.value.result;
  if (!flow) return null;
  const { states } = flow;
  const rate = report.value.units.flow;
  const inTime = states.length > 1;
  const time = <Found,>(): Column<Row<Found>> =>
    inTime && ["Time", ({ state }) => formatDuration(state.time), "number"];
  const sections = listRows<SectionFlow>(states, (state) => state.sections);
  const exits = listRows<ExitGradient>(states, (state) => state.exits);
  const heaves = listRows<Heave>(states, (state) => state.heaves);
  const uplifts = listRows(states, (state) => (state.uplift ? [state.uplift] : []));
  const { stress } = report.value.units;
  return (
    <div class="chart-section">
      <ChartTable
        label="Flow through the soil"
        rows={states}
        columns={[
          inTime && ["Time", (state) => formatDuration(state.time), "number"],
          ["In", (state) => formatQuantity(state.inflow, rate), "number"],
          ["Out", (state) => formatQuantity(state.outflow, rate), "number"],
        ]}
      />
      {sections.length > 0 && (
        <ChartTable
          label="Discharge through the sections"
          rows={sections}
          columns={[
            ["Section", ({ found }) => found.name, "name"],
            time<SectionFlow>(),
            ["Discharge", ({ found }) => formatQuantity(found.discharge, rate), "number"],
          ]}
        />
      )}
      {exits.length > 0 && (
        <ChartTable
          label="Exit gradients"
          rows={exits}
          rowClass={({ found }) => found.factor !== undefined && found.factor < 1 && "main"}
          columns={[
            ["Boundary", ({ found }) => found.name, "name"],
            time<ExitGradient>(),
            [
              "Exit gradient",
              ({ found }) => formatNumber(found.gradient, 3) + (found.grows ? ", depends on the mesh" : ""),
              "number",
            ],
            ["At", ({ found }) => formatPlace(found.at)],
            ["Critical", ({ found }) => formatNumber(found.critical, 3), "number"],
            ["Factor against boiling", ({ found }) => formatFactor(found.factor), "number"],
          ]}
        />
      )}
      {uplifts.length > 0 && (
        <ChartTable
          label="Uplift of less permeable layers"
          rows={uplifts}
          columns={[
            ["Layer", ({ found }) => found.layer, "name"],
            time<NonNullable<FlowState["uplift"]>>(),
            ["Weight of the soil", ({ found }) => formatQuantity(found.weight, stress), "number"],
            ["Pressure below it", ({ found }) => formatQuantity(found.pressure, stress), "number"],
            ["At", ({ found }) => formatPlace(found.at)],
            ["Factor against uplift", ({ found }) => formatFactor(found.factor), "number"],
          ]}
        />
      )}
      {heaves.length > 0 && (
        <ChartTable
          label="Heave of blocks"
          rows={heaves}
          columns={[
            ["Block", ({ found }) => found.name, "name"],
            time<Heave>(),
            ["Buoyant weight", ({ found }) => `${formatNumber(found.weight / 1e3)} kN/m`, "number"],
            ["Excess force", ({ found }) => `${formatNumber(found.force / 1e3)} kN/m`, "number"],
            ["Factor against heave", ({ found }) => formatFactor(found.factor), "number"],
          ]}
        />
      )}
      <p class="chart-note">
        Boiling: critical gradient γ′/γ_w over the exit gradient, where the ground is nearly level. Uplift: weight of the
        soil over the pore pressure below a layer that is less permeable by a factor of ten, both without standing water.
        Heave: buoyant weight over the force of the excess pore pressure at the base of the block (Terzaghi). Discharges
        are positive to the right of a section.
      </p>
    </div>
  );
}
