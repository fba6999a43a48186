// SPDX-License-Identifier: MIT
/** The materials: characteristic and design values, and values at failure. */
import { report } from "../../state";
import { DataTable, numbers, SymbolText, TableHead } from "../DataTable";
import { formatFactor, formatNumber, formatSentence, formatUnit } from "../format";
import type { SoilWater } from "../../contract";

/** The laws of the soil's water and their parameters, which no strength factor divides. */
function SoilWaterRows({ water, columns, spare }: { water: SoilWater; columns: number; spare: number }) {
  return (
    <>
      <tr>
        <th scope="row" colSpan={columns} class="prose">
          <span class="note">
            {[`Retention: ${water.retention}`, `Conductivity: ${water.conductivity}`, `Effective stress: ${water.chi}`]
              .map(formatSentence)
              .join(" ")}
          </span>
        </th>
      </tr>
      {water.parameters.map((parameter) => (
        <tr key={parameter.key}>
          <th scope="row">{parameter.title}</th>
          <td>
            <SymbolText text={parameter.symbol} />
          </td>
          <td>{formatUnit(parameter.unit) || "–"}</td>
          <td class="number">{formatNumber(parameter.value)}</td>
          {Array.from({ length: spare }, (_, i) => (
            <td key={i} class="number">
              –
            </td>
          ))}
        </tr>
      ))}
    </>
  );
}

export function MaterialTable() {
  const { kind, model, answer } = report.value;
  const properties = model.materials.flatMap((material) => material.properties);
  const hasDesign = properties.some((property) => property.design !== null);
  const hasFailure = properties.some((property) => property.at_failure !== null);
  const main = answer.factors.find((factor) => factor.main)?.value;
  const columns = 4 + (hasDesign ? 1 : 0) + (hasFailure ? 1 : 0);
  if (model.materials.length === 0) return <p>The results name no materials.</p>;
  return (
    <>
      <DataTable caption="Properties of the materials" quiet>
        <TableHead
          cells={[
            "Property",
            "Symbol",
            "Unit",
            ...numbers("Characteristic", hasDesign && "Design", hasFailure && "At failure"),
          ]}
        />
        {model.materials.map((material) => (
          <tbody key={material.name}>
            <tr class="group">
              <th scope="rowgroup" colSpan={columns}>
                {material.name}
                <span class="note">
                  {" "}
                  – {material.model}
                  {material.regions.length > 0 && `, in ${material.regions.join(", ")}`}
                </span>
              </th>
            </tr>
            {material.properties.map((property) => (
              <tr key={property.key}>
                <th scope="row">{property.title}</th>
                <td>{property.symbol && <SymbolText text={property.symbol} />}</td>
                <td>{formatUnit(property.unit) || "–"}</td>
                <td class="number">
                  {property.characteristic === null ? "none" : formatNumber(property.characteristic)}
                </td>
                {hasDesign && <td class="number">{formatNumber(property.design)}</td>}
                {hasFailure && <td class="number">{formatNumber(property.at_failure)}</td>}
              </tr>
            ))}
            {material.water && <SoilWaterRows water={material.water} columns={columns} spare={columns - 4} />}
          </tbody>
        ))}
      </DataTable>
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
