// SPDX-License-Identifier: MIT
/** The materials: characteristic and design values, and values at failure. */
import type { MaterialRow, SoilWater } from "../../contract";
import { report } from "../../state";
import { CaptionedTable, SymbolText, TableHead, TableRows, type Column } from "../DataTable";
import { formatFactor, formatNumber, formatSentence, formatUnit } from "../format";

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
