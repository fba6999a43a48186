// SPDX-License-Identifier: MIT
/** The model in numbers: geometry, mesh and water; the materials with characteristic and design values, and values at failure. */
import { type ComponentChildren, Fragment } from "preact";

import type { MaterialRow, SoilWater, Unit, Water } from "../../contract";
import { findUsedWater } from "../../drawing/standingWater";
import { report } from "../../state";
import { startWater } from "../../water/waterFields";
import { CaptionedTable, type Column, DataTable, Facts, SymbolText, TableHead, TableRows } from "../DataTable";
import {
  formatCoordinate, formatFactor, formatNumber, formatPlace, formatQuantity, formatSentence, formatUnit,
} from "../format";
import { selectsMethod } from "../methods/settings";

const second: Unit = { name: "s", si: 1 };

function describeWater(dimension: 2 | 3, count: number, wet: Water | undefined): string {
  if (wet) return formatSentence(wet.state);
  if (count === 0) return "Dry: no water table, no pore pressure";
  return count === 1 ? "One water table, below" : `${count} water ${dimension === 3 ? "surfaces" : "tables"}, below`;
}

/** A line that was calculated has a point in every element. */
const mostPoints = 12;

/** Coordinates in the unit of lengths, one after the other. */
function Points({ points }: { points: number[][] }) {
  return (
    <span class="points">
      {points.map((point, i) => (
        <Fragment key={i}>
          <span>({point.map(formatCoordinate).join(", ")})</span>{" "}
        </Fragment>
      ))}
    </span>
  );
}

/** Some of them where there are many, evenly chosen with both ends. */
function ThinPoints({ points }: { points: number[][] }) {
  if (points.length <= mostPoints) return <Points points={points} />;
  const step = (points.length - 1) / (mostPoints - 1);
  return (
    <>
      <Points points={Array.from({ length: mostPoints }, (_, i) => points[Math.round(i * step)]!)} />
      <span class="note">
        {" "}
        ({mostPoints} of {points.length} points)
      </span>
    </>
  );
}

export function GeometryTables() {
  const { result, model, units, water: wet } = report.value;
  const { input } = result;
  const { mesh, polygons } = model;
  const length = (x: number) => formatQuantity(x, units.length);
  const [low, high] = model.bounds;
  const soilSize = high.map((x, d) => length(x - (low[d] ?? 0))).join(" × ");
  // A killed run has no summary: its values are unknown, and not zero.
  const known = (value: number, text: string) => (value > 0 ? text : "not known");
  const hasPoints = selectsMethod(report.value, "mpm");
  const ofPoints: [string, ComponentChildren][] = [
    [
      "Mesh",
      (mesh.elements > 0
        ? `${formatNumber(mesh.elements)} linear ${model.dimension === 2 ? "triangles" : "tetrahedra"}, ` +
          `${formatNumber(mesh.nodes)} nodes, `
        : "") + `${known(mesh.points, formatNumber(mesh.points))} material points`,
    ],
    [
      "Element size",
      known(mesh.mean_size, `mean side ${length(mesh.mean_size)}, smallest altitude ${length(mesh.smallest_altitude)}`),
    ],
    ["Critical time step", known(mesh.critical_time_step, formatQuantity(mesh.critical_time_step, second))],
  ];
  const rows: [string, ComponentChildren][] = [
    ["Dimension", model.dimension === 2 ? "2D, plane strain; quantities per metre of thickness" : "3D"],
    ["Box", `${soilSize}, from ${formatPlace(low)} to ${formatPlace(high)}`],
    ["Slope height H", known(model.slope_height, length(model.slope_height))],
    ["Water", Object.keys(input).length > 0 ? describeWater(model.dimension, startWater.value.states.length, wet) : "not known"],
    ...(hasPoints ? ofPoints : []),
  ];
  const used = findUsedWater();
  return (
    <>
      <Facts caption={hasPoints ? "Geometry, water and mesh" : "Geometry and water"} rows={rows} />
      {polygons.length > 0 && (
        <DataTable
          caption={`Polygons, corners in ${units.length.name}`}
          rows={polygons}
          columns={[
            ["Polygon", (polygon) => polygon.name, "name"],
            ["Material", (polygon) => polygon.material || "–"],
            ["Corners", (polygon) => <Points points={polygon.points} />, "prose"],
          ]}
        />
      )}
      {used && used.water_table.length > 0 && (
        <DataTable
          caption={`${wet ? "Water table at the start" : "Water tables"}, points in ${units.length.name}`}
          rows={used.water_table}
          columns={[
            ["Water table", (_, i) => (used.water_table.length > 1 ? `${used.title}, line ${i + 1}` : used.title), "name"],
            ["Points", (points) => <ThinPoints points={points} />, "prose"],
          ]}
        />
      )}
    </>
  );
}

type Property = MaterialRow["properties"][number];

/** The laws of the soil's water and their parameters, which no strength factor divides. */
function SoilWaterRows({ water, columns }: { water: SoilWater; columns: Column<Property>[] }) {
  const rows = water.parameters.map((p): Property => ({ ...p, characteristic: p.value, design: null, at_failure: null }));
  return (
    <>
      <tr>
        <th scope="row" colSpan={columns.filter(Boolean).length} class="prose">
          <span class="note">
            {[`Retention: ${water.retention}`, `Conductivity: ${water.conductivity}`, `Effective stress: ${water.chi}`]
              .map(formatSentence)
              .join(" ")}
          </span>
        </th>
      </tr>
      <TableRows columns={columns} rows={rows} />
    </>
  );
}

export function MaterialTable() {
  const { kind, model, answer } = report.value;
  const properties = model.materials.flatMap((material) => material.properties);
  const hasDesign = properties.some((property) => property.design !== null);
  const hasFailure = properties.some((property) => property.at_failure !== null);
  const main = answer.factors.find((factor) => factor.main)?.value;
  const columns: Column<Property>[] = [
    ["Property", (p) => p.title, "name"],
    ["Symbol", (p) => p.symbol && <SymbolText text={p.symbol} />],
    ["Unit", (p) => formatUnit(p.unit) || "–"],
    ["Characteristic", (p) => (p.characteristic === null ? "none" : formatNumber(p.characteristic)), "number"],
    hasDesign && ["Design", (p) => formatNumber(p.design), "number"],
    hasFailure && ["At failure", (p) => formatNumber(p.at_failure), "number"],
  ];
  if (model.materials.length === 0) return <p>The results name no materials.</p>;
  return (
    <>
      <CaptionedTable caption="Properties of the materials" quiet>
        <TableHead columns={columns} />
        {model.materials.map((material) => (
          <tbody key={material.name}>
            <tr class="group">
              <th scope="rowgroup" colSpan={columns.filter(Boolean).length}>
                {material.name}
                <span class="note">
                  {" "}
                  – {material.model}
                  {material.regions.length > 0 && `, in ${material.regions.join(", ")}`}
                </span>
              </th>
            </tr>
            <TableRows columns={columns} rows={material.properties} />
            {material.water && <SoilWaterRows water={material.water} columns={columns} />}
          </tbody>
        ))}
      </CaptionedTable>
      <p class="note">
        Characteristic values are those of the {kind === "study" ? "first variant" : "case file"}.
        {hasDesign && " Design values are divided by the strength factor of the last stage."}
        {hasFailure &&
          (main
            ? ` At failure: c/F and arctan(tan φ/F) with F = ${formatFactor(main)}.`
            : " At failure: c/F and arctan(tan φ/F) at the factor of safety F.")}
        {" A dash: the value is not changed, or does not apply."}
      </p>
    </>
  );
}
