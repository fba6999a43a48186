// SPDX-License-Identifier: MIT
/** FEM at failure: shear strain or displacement, optionally deformed, plastic elements, slip line. */
import { useMemo, useState } from "preact/hooks";

import { Choice, useToggles } from "../charts/base/Legend";
import { formatNumber, titleWithUnit } from "../charts/base/numbers";
import { clipToSoil, drawBars, drawOutlines, drawSoilNames, drawSoils, drawSurcharges } from "../drawing/ground";
import { GroundKeys, LineKey, useOpacity } from "../drawing/Keys";
import { findSoilBox } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { drawSurface, drawSurfaceLabels } from "../drawing/surfaceLines";
import { report } from "../state";
import { tabulateColours } from "../viewer/colours";
import { makeScale } from "../viewer/scale";
import type { Bar } from "../viewer/scaleBar";
import { listQuantities, quantityTitles, useWaterLayer } from "../water/useWaterLayer";
import type { WaterQuantity } from "../water/waterFields";
import { type Drawn, drawMesh, drawYielding, type FlowRun, moveNodes, paintField, useFields } from "./fields";

type Quantity = "strain" | "displacement" | "none" | WaterQuantity;

export const bandLook = { colour: "#c2185b", dash: [] };

/** 1, 2 or 5 times a power of ten, so that the largest displacement becomes about a twentieth of the height. */
export function chooseMagnification(largest: number, height: number): number {
  if (!(largest > 0) || !(height > 0)) return 1;
  const rough = (0.05 * height) / largest;
  const power = 10 ** Math.floor(Math.log10(rough));
  return Math.max(1, ([5, 2, 1].find((k) => k * power <= rough) ?? 1) * power);
}

/** A finished strength reduction at failure, or the last trial of one in progress. */
export type PicturedRun = Drawn & Pick<FlowRun, "title" | "slip_lines"> & { factor?: number; heading: string; note: string };

export function ElementsFigure({ run }: { run: PicturedRun }) {
  const fields = useFields(run);
  const [quantity, setQuantity] = useState<Quantity>("strain");
  const [on, toggle] = useToggles({ mesh: false, deformed: false, yields: false, slip: true });
  const ofSolid = quantity === "strain" || quantity === "displacement";
  const { opacity, slider } = useOpacity();
  const layer = useWaterLayer(ofSolid || quantity === "none" ? null : quantity);
  const { displacement: unit } = report.value.units;
  const box = findSoilBox();
  const lengths = useMemo(
    () =>
      fields &&
      Float32Array.from({ length: fields.displacement.length / 2 }, (_, i) =>
        Math.hypot(fields.displacement[2 * i]!, fields.displacement[2 * i + 1]!),
      ),
    [fields],
  );
  const largest = useMemo(() => (lengths ? lengths.reduce((a, b) => Math.max(a, b), 0) : 0), [lengths]);
  const magnification = chooseMagnification(largest, box[1][1]! - box[0][1]!);
  const nodes = useMemo(
    () => (fields ? moveNodes(fields.mesh, fields.displacement, on.deformed ? magnification : 0) : null),
    [fields, on.deformed, magnification],
  );
  const limits = run.fields?.strain_scale ?? [0, 1];
  const scale = useMemo(
    () => (quantity === "strain" ? makeScale(limits[0]!, limits[1]!) : makeScale(0, largest)),
    [quantity, largest, run],
  );
  const colours = tabulateColours("viridis");
  const bar = useMemo<Bar | null>(
    () =>
      !fields || !ofSolid
        ? null
        : quantity === "strain"
          ? { title: "Shear strain", colours, scale, levels: null, below: false, above: true }
          : {
              title: titleWithUnit("Displacement", unit.name),
              colours,
              scale: makeScale(0, largest / unit.si),
              levels: null,
              below: false,
              above: false,
            },
    [fields, quantity, scale],
  );
  const values = quantity === "displacement" ? lengths : fields?.strain;
  return (
    <figure class="chart-figure" aria-label={run.heading}>
      <h4>{run.heading}</h4>
      <div class="chart-bar">
        <Choice
          label="Field"
          value={quantity}
          options={[
            { value: "strain", title: "shear strain" },
            { value: "displacement", title: "displacement" },
            { value: "none", title: "soils" },
            ...listQuantities().map((value) => ({ value, title: quantityTitles[value] })),
          ]}
          onChange={setQuantity}
        />
        {layer.controls}
        {quantity !== "none" && slider}
        {toggle("mesh", "Mesh")}
        {largest > 0 && toggle("deformed", `Deformed, ${formatNumber(magnification, 3)} times`)}
        {toggle("yields", "Plastic elements")}
        {run.slip_lines.length > 0 && toggle("slip", run.slip_lines.length > 1 ? "Slip surfaces" : "Slip surface")}
      </div>
      <SectionCanvas
        label={`FEM, ${quantity === "strain" ? "shear strain" : ofSolid || quantity === "none" ? quantity : quantityTitles[quantity]}, ${run.heading}`}
        file={`finite_elements_${quantity}`}
        box={box}
        bar={ofSolid ? bar : layer.bar}
        draw={(pen) => {
          drawSoils(pen);
          if (fields && nodes && values && ofSolid)
            paintField(pen, fields.mesh, nodes, values, colours, scale, opacity);
          clipToSoil(pen, () => layer.paint(pen, opacity));
          if (fields && nodes && (on.mesh || on.deformed)) drawMesh(pen, fields.mesh, nodes);
          drawOutlines(pen);
          layer.drawOver(pen);
          drawSurcharges(pen);
          drawBars(pen);
        }}
        depends={[fields, quantity, nodes, on.mesh, ...layer.depends, opacity]}
        drawOver={(pen) => {
          if (fields && nodes && on.yields) drawYielding(pen, fields.mesh, nodes, fields.yields);
          drawSoilNames(pen);
          if (!on.slip) return;
          const lines = run.slip_lines.map((line) => line.map(pen.place));
          for (const line of lines) drawSurface(pen.context, line, bandLook, 2.4);
          const text = run.factor?.toFixed(3) ?? "";
          const labels = lines.slice(0, 1).map((line) => ({ line, text, colour: bandLook.colour }));
          drawSurfaceLabels(pen.context, labels);
        }}
        dependsOver={[on, run, fields]}
      />
      <ul class="drawing-keys" aria-label="Legend">
        <GroundKeys />
        {on.slip && run.slip_lines.length > 0 && (
          <LineKey colour={bandLook.colour} width={2.4}>
            {run.slip_lines.length > 1 ? "Slip surfaces of both sides" : "Slip surface"}: axis of the largest shear strain
          </LineKey>
        )}
        {on.yields && <li>× Plastic in the last step</li>}
      </ul>
      {layer.note && <p class="chart-note">{layer.note}</p>}
      <p class="chart-note">
        {run.note}
      </p>
    </figure>
  );
}
