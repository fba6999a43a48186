// SPDX-License-Identifier: MIT
/** The τ–σ diagram of each soil. */
import * as Plot from "@observablehq/plot";

import type { MaterialRow, SoilStrength } from "../../contract";
import { report } from "../../state";
import { Chart } from "../base/Chart";
import { CsvButton, Legend } from "../base/Legend";
import { layOut, makeAxis } from "../base/axes";
import { formatQuantity } from "../base/numbers";
import { styleOf } from "../base/styles";

const margins: [number, number, number, number] = [26, 14, 44, 58];

function StrengthChart({ material, strength }: { material: MaterialRow; strength: SoilStrength }) {
  const { stress: unit } = report.value.units;
  const toUnit = (values: readonly number[]) => values.map((v) => v / unit.si);
  const normal = toUnit(strength.normal);
  const lines = strength.lines.map((line) => ({ ...line, shear: toUnit(line.shear) }));
  const styles = lines.map((_, i) => styleOf(i));
  const highest = Math.max(...lines.flatMap((line) => line.shear), 1e-9);
  const draw = () =>
    layOut({
      height: 230,
      margins,
      x: makeAxis({ title: strength.stress, unit: unit.name, domain: [0, normal.at(-1) ?? 1], count: 6 }),
      y: makeAxis({ title: "Shear strength τ", unit: unit.name, domain: [0, 1.08 * highest] }),
      marks: lines.map((line, k) =>
        Plot.line(
          normal.map((s, i) => [s, line.shear[i] ?? Number.NaN]),
          { stroke: styles[k]!.colour, strokeDasharray: styles[k]!.dash, strokeWidth: 1.8, clip: true },
        ),
      ),
    });
  return (
    <figure class="chart-figure" aria-label={`Strength of ${material.name}`}>
      <div class="chart-head">
        <h4>{material.name}</h4>
        <CsvButton
          part={`strength_${material.name}`}
          what={`strength of ${material.name}`}
          columns={() => [
            { name: "stress", unit: unit.name, values: normal },
            ...lines.map((line) => ({ name: line.name || "strength", unit: unit.name, values: line.shear })),
          ]}
        />
      </div>
      <p class="chart-note">{material.model}.</p>
      <Chart
        label={`${material.name}: shear strength over stress`}
        draw={draw}
        depends={[strength]}
        stops={normal}
        printWidth={420}
        hint="Point at the envelope to read it."
        read={(i) => ({
          text: `σ' = ${formatQuantity(normal[i], unit.name)}: ${lines
            .map((line) => `${line.name ? `${line.name} ` : ""}${formatQuantity(line.shear[i], unit.name)}`)
            .join(", ")}`,
          marks: lines.map((line, k) => ({ value: line.shear[i]!, colour: styles[k]!.colour })),
        })}
      />
      {lines.length > 1 && (
        <Legend items={lines.map((line, k) => ({ id: line.name, title: line.name, style: styles[k]! }))} />
      )}
    </figure>
  );
}

export function StrengthSection() {
  const { materials } = report.value.model;
  return (
    <section class="chart-section" aria-labelledby="chart-strength-title">
      <h3 id="chart-strength-title">Strength of the soils</h3>
      <div class="chart-grid">
        {materials.map((m) => m.strength && <StrengthChart key={m.name} material={m} strength={m.strength} />)}
      </div>
    </section>
  );
}
