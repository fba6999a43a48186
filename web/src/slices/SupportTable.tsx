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
};

const kilo = (force: number | null) => (force === null ? "–" : formatNumber(force / 1e3, 4));

export function SupportTable({ surface }: { surface: SlicedSurface }) {
  const { supports } = surface;
  if (!supports || supports.length === 0) return null;
  const { length } = report.value.units;
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
      </p>
    </figure>
  );
}
