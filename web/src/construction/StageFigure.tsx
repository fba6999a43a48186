// SPDX-License-Identifier: MIT
/** The section at the end of a stage: what is placed and removed, supports, displacement or pore pressure, deformed mesh, plastic elements. */
import { useMemo, useState } from "preact/hooks";

import { Choice, useToggles } from "../charts/base/Legend";
import { formatNumber, titleWithUnit } from "../charts/base/numbers";
import type { PackedStageFields, StagesDrawn, Unit } from "../contract";
import type { Construction } from "../contract/results";
import { drawBars, drawOutlines, drawSoilNames, drawSoils, isInside } from "../drawing/ground";
import { GroundKeys, useOpacity } from "../drawing/Keys";
import { findSoilBox, paintTriangles, type Pen } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { chooseMagnification } from "../elements/ElementsFigure";
import { load, loadIntegers, loadPlaces, report, useLoaded } from "../state";
import { tabulateColours } from "../viewer/colours";
import { makeScale } from "../viewer/scale";

type Quantity = "none" | "displacement" | "pressure" | "excess";

interface StageFields {
  nodes: Float64Array;
  elements: Uint32Array;
  state: Float32Array;
  displacement: Float32Array;
  values: Partial<Record<Quantity, Float32Array>>;
}

async function loadStage(mesh: StagesDrawn, stage: PackedStageFields): Promise<StageFields> {
  const [nodes, elements] = await Promise.all([loadPlaces(mesh.nodes), loadIntegers(mesh.elements)]);
  const [state, displacement] = await Promise.all([load(stage.state), load(stage.displacement)]);
  const values: StageFields["values"] = {
    displacement: Float32Array.from({ length: nodes.length / 2 }, (_, i) => Math.hypot(displacement[2 * i]!, displacement[2 * i + 1]!)),
  };
  if (stage.pressure) values.pressure = await load(stage.pressure);
  if (stage.excess) values.excess = await load(stage.excess);
  return { nodes, elements: Uint32Array.from(elements), state, displacement, values };
}

/** Elements with this property, as corners of triangles. */
function select({ elements, state }: StageFields, has: (state: number) => boolean): Uint32Array {
  return elements.filter((_, i) => has(state[Math.floor(i / 3)]!));
}

/** Whether a place lies in an element without soil. */
function isAbsent(fields: StageFields, at: readonly number[]): boolean {
  const absent = select(fields, (s) => s === 0);
  const corner = (n: number) => [fields.nodes[2 * n]!, fields.nodes[2 * n + 1]!];
  for (let t = 0; t < absent.length; t += 3)
    if (isInside(at, [0, 1, 2].map((k) => corner(absent[t + k]!)))) return true;
  return false;
}

/** Outlines of triangles as one path. */
function trace({ context, place }: Pen, nodes: Float64Array, triangles: Uint32Array): void {
  context.beginPath();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; ++k) {
      const n = triangles[t + k]!;
      const at = place([nodes[2 * n]!, nodes[2 * n + 1]!]);
      if (k === 0) context.moveTo(...at);
      else context.lineTo(...at);
    }
    context.closePath();
  }
}

/** Covers soil that is not there. */
function erase(pen: Pen, nodes: Float64Array, triangles: Uint32Array): void {
  trace(pen, nodes, triangles);
  pen.context.fillStyle = pen.context.strokeStyle = pen.theme.ground;
  pen.context.lineWidth = 1.5;
  pen.context.fill();
  pen.context.stroke();
}

function drawTriangles(pen: Pen, nodes: Float64Array, triangles: Uint32Array): void {
  trace(pen, nodes, triangles);
  pen.context.globalAlpha = 0.35;
  pen.context.strokeStyle = pen.theme.ink;
  pen.context.lineWidth = 0.6;
  pen.context.stroke();
  pen.context.globalAlpha = 1;
}

function drawPlastic({ context, place, theme }: Pen, nodes: Float64Array, triangles: Uint32Array): void {
  context.fillStyle = theme.ink;
  for (let t = 0; t < triangles.length; t += 3) {
    const mean = [0, 1].map((d) => [0, 1, 2].reduce((sum, k) => sum + nodes[2 * triangles[t + k]! + d]!, 0) / 3);
    const [x, y] = place(mean);
    context.fillRect(x - 1.2, y - 1.2, 2.4, 2.4);
  }
}

const titles: Record<Quantity, string> = {
  none: "soils",
  displacement: "displacement",
  pressure: "pore pressure",
  excess: "excess pore pressure",
};

export function StageFigure({ construction, drawn }: { construction: Construction; drawn: StagesDrawn }) {
  const [chosen, choose] = useState(String(drawn.stages.length - 1));
  const [quantity, setQuantity] = useState<Quantity>("displacement");
  const [on, toggle] = useToggles({ mesh: false, deformed: false, plastic: false });
  const { opacity, slider } = useOpacity();
  const packed = drawn.stages[Number(chosen)]!;
  const fields = useLoaded(() => loadStage(drawn, packed), packed);
  const supports = construction.stages.find(({ name }) => name === packed.stage)?.supports ?? [];
  const box = findSoilBox();
  const { units } = report.value;
  const unit: Unit = quantity === "displacement" ? units.displacement : units.stress;
  const values = fields?.values[quantity];
  const soil = useMemo(() => (fields ? select(fields, (s) => s > 0) : null), [fields]);
  // Beside the soil that is there, so that removed ground does not set the scale.
  const [low, high] = useMemo(() => {
    if (!values || !soil) return [0, 1];
    let [least, most] = [0, 0];
    for (const n of soil) [least, most] = [Math.min(least, values[n]!), Math.max(most, values[n]!)];
    return [least, most > least ? most : least + 1];
  }, [values, soil]);
  const largest = useMemo(() => {
    if (!fields || !soil) return 0;
    return soil.reduce((most, n) => Math.max(most, fields.values.displacement![n]!), 0);
  }, [fields, soil]);
  const magnification = chooseMagnification(largest, box[1][1]! - box[0][1]!);
  const nodes = useMemo(
    () => fields && (on.deformed ? fields.nodes.map((x, i) => x + magnification * fields.displacement[i]!) : fields.nodes),
    [fields, on.deformed, magnification],
  );
  const colours = tabulateColours("viridis");
  const bar = useMemo(
    () =>
      values
        ? { title: titleWithUnit(titles[quantity][0]!.toUpperCase() + titles[quantity].slice(1), unit.name), colours, scale: makeScale(low / unit.si, high / unit.si), levels: null, below: false, above: false }
        : null,
    [values, low, high],
  );
  return (
    <figure class="chart-figure" aria-label={`Section at the end of stage '${packed.stage}'`}>
      <h4>Section at the end of stage '{packed.stage}'</h4>
      <div class="chart-bar">
        <Choice
          label="Stage"
          value={chosen}
          options={drawn.stages.map(({ stage }, i) => ({ value: String(i), title: stage }))}
          onChange={choose}
        />
        <Choice
          label="Field"
          value={quantity}
          options={(Object.keys(titles) as Quantity[])
            .filter((key) => key === "none" || key === "displacement" || packed[key])
            .map((value) => ({ value, title: titles[value] }))}
          onChange={setQuantity}
        />
        {quantity !== "none" && slider}
        {toggle("mesh", "Mesh")}
        {largest > 0 && toggle("deformed", `Deformed, ${formatNumber(magnification, 3)} times`)}
        {toggle("plastic", "Plastic elements")}
      </div>
      <SectionCanvas
        label={`Stage '${packed.stage}', ${titles[quantity]}`}
        file={`stage_${Number(chosen) + 1}_${quantity}`}
        box={box}
        bar={bar}
        draw={(pen) => {
          drawSoils(pen);
          drawOutlines(pen);
          if (!fields || !nodes || !soil) return;
          erase(pen, fields.nodes, select(fields, (s) => s === 0));
          if (values) paintTriangles(pen, { nodes, triangles: soil }, values, colours, makeScale(low, high), opacity);
          if (on.mesh || on.deformed) drawTriangles(pen, nodes, soil);
          drawBars(pen, ({ support, row }) => supports.some((s) => s.support === support && (s.row ?? row) === row));
        }}
        depends={[fields, quantity, nodes, on.mesh, opacity]}
        drawOver={(pen) => {
          if (fields && nodes && on.plastic) drawPlastic(pen, nodes, select(fields, (s) => s === 2));
          drawSoilNames(pen, (at) => (fields && isAbsent(fields, at) ? null : at));
        }}
        dependsOver={[on, fields]}
      />
      <ul class="drawing-keys" aria-label="Legend">
        <GroundKeys />
        {on.plastic && <li>▪ Most of the element has yielded</li>}
      </ul>
      <p class="chart-note">Displacements count from the start of the stages, or from a stage with <code>reset_displacement</code>.</p>
    </figure>
  );
}
