// SPDX-License-Identifier: MIT
/** Supports that the selected surface crosses: where, with which force, and what limits it. */
import { formatNumber } from "../charts/base/numbers";
import { CsvButton } from "../charts/base/Legend";
import type { SupportForce } from "../contract";
import { ChartTable } from "../page/DataTable";
import { formatCoordinate } from "../page/format";
import { report } from "../state";
import { nameSurface, type SlicedSurface } from "./sliceData";

const limits: Record<SupportForce["limit"], string> = {
  tension: "tensile strength",
  pull_out: "pull-out",
  stripping: "stripping",
  prestress: "prestress",
  lateral: "lateral resistance",
  shear: "shear strength",
  embedment: "embedment: the pile moves through the stable soil",
  rotation: "embedment: the pile rotates",
  one_hinge: "plastic moment: one hinge",
  two_hinges: "plastic moment: two hinges",
};

const kilo = (force: number | null) => (force === null ? "–" : formatNumber(force / 1e3, 4));

/** Rows of supports that have no force on a surface, each once. */
export function listIdle(bars: { support: string; row: number }[], supports: { support: string; row: number | null }[]): string[] {
  const name = (bar: { support: string; row: number | null }) => `${bar.support} ${bar.row}`;
  const held = new Set(supports.map(name));
  return [...new Set(bars.map(name))].filter((bar) => !held.has(bar));
}

function IdleNote({ idle }: { idle: string[] }) {
  if (idle.length === 0) return null;
  return (
    <p class="chart-note">
      Without force: {idle.join(", ")}. The surface does not cross them, they would drive the mass, or they meet an open
      tension crack.
    </p>
  );
}

export function SupportTable({ surface }: { surface: SlicedSurface }) {
  const { supports } = surface;
  if (!supports) return null;
  const idle = listIdle(report.value.model.bars, supports);
  if (supports.length === 0)
    return (
      <figure class="chart-figure" aria-label="Supports">
        <h4>No support holds {nameSurface(surface)}</h4>
        <IdleNote idle={idle} />
      </figure>
    );
  const { length } = report.value.units;
  const fails = supports.some((s) => s.required !== undefined);
  const column = (name: string, unit: string | undefined, read: (s: SupportForce) => number | string | null) => ({
    name,
    unit,
    values: supports.map(read),
  });
  return (
    <figure class="chart-figure" aria-label="Supports">
      <div class="chart-head">
        <h4>Supports across {nameSurface(surface)}</h4>
        <CsvButton
          part={`supports-${surface.method}`}
          columns={() => [
            column("support", undefined, (s) => s.support),
            column("row", undefined, (s) => s.row),
            column("x", "m", (s) => s.crossing[0] ?? null),
            column("y", "m", (s) => s.crossing[1] ?? null),
            column("force", "N/m", (s) => s.force),
            column("resistance", "N/m", (s) => s.resistance),
            column("required", "N/m", (s) => s.required ?? null),
            column("tension", "N/m", (s) => s.tension),
            column("pull_out", "N/m", (s) => s.pull_out),
            column("stripping", "N/m", (s) => s.stripping),
            column("limit", undefined, (s) => s.limit),
          ]}
        />
      </div>
      <ChartTable
        label="Forces of supports"
        rows={supports}
        columns={[
          ["Support", (s) => `${s.support} ${s.row}`, "name"],
          ["Sense", (s) => (s.is_active ? "active" : "passive"), "name"],
          [`Crossing [${length.name}]`, (s) => `(${s.crossing.map((x) => formatCoordinate(x ?? 0)).join(", ")})`, "name"],
          ["Force [kN/m]", (s) => kilo(s.force), "number"],
          ["Resistance [kN/m]", (s) => kilo(s.resistance), "number"],
          ["Tension [kN/m]", (s) => kilo(s.tension), "number"],
          ["Pull-out [kN/m]", (s) => kilo(s.pull_out), "number"],
          ["Stripping [kN/m]", (s) => kilo(s.stripping), "number"],
          ["Governed by", (s) => limits[s.limit], "name"],
        ]}
      />
      <p class="chart-note">
        Per metre of slope. F divides the resistance of passive supports, and not that of active ones, which are loads.
        {fails && " At F below 1 equilibrium would require more than the resistance (column required of the CSV file)."}
      </p>
      <IdleNote idle={idle} />
    </figure>
  );
}
