// SPDX-License-Identifier: MIT
/** Limit analysis: the interval, the fields that prove both ends, and how the meshes closed it. */
import { useMemo, useState } from "preact/hooks";

import { Choice } from "../charts/base/Legend";
import { formatNumber, formatQuantity } from "../charts/base/numbers";
import type { BoundsDrawn, BoundsResult } from "../contract";
import { drawBars, drawOutlines, drawSoilNames, drawSoils, drawSurcharges } from "../drawing/ground";
import { GroundKeys, LineKey, useOpacity } from "../drawing/Keys";
import { findSoilBox, paintTriangles } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { drawSurface } from "../drawing/surfaceLines";
import { bandLook } from "../elements/ElementsFigure";
import { ChartTable } from "../page/DataTable";
import { formatFactor, formatSentence, roundDown, roundUp } from "../page/format";
import { report } from "../state";
import { tabulateColours } from "../viewer/colours";
import { makeScale } from "../viewer/scale";
import { drawArrows, drawCrosses, useBounds } from "./fields";

type Field = "holds" | "moves";

const titles: Record<Field, string> = { holds: "stresses that hold", moves: "mechanism" };

/** All but the most sheared triangles: a few small ones have by far the largest rate. */
function findLimit(values: Float32Array): number {
  const sorted = Float32Array.from(values).sort();
  return sorted[Math.floor(0.97 * (sorted.length - 1))] || 1;
}

function Figure({ bounds, drawn }: { bounds: BoundsResult; drawn: BoundsDrawn }) {
  const fields = useBounds(drawn);
  const options = (["moves", "holds"] as const).filter((field) => drawn[field]);
  const [chosen, choose] = useState<Field>("moves");
  const field = options.includes(chosen) ? chosen : options[0];
  const { opacity, slider } = useOpacity();
  const colours = tabulateColours("viridis");
  const scale = useMemo(
    () => makeScale(0, field === "moves" && fields?.moves ? findLimit(fields.moves.shear_rate) : 1),
    [field, fields],
  );
  if (!field) return null;
  const holds = field === "holds";
  const factor = holds ? roundDown(bounds.lower) : roundUp(bounds.upper);
  const title = holds ? "Strength used" : "Shear strain rate";
  return (
    <figure class="chart-figure" aria-label="Fields that prove the bounds">
      <h4>
        {holds ? "Stresses in equilibrium" : "Velocities of a mechanism"} at F = {formatFactor(factor)}
      </h4>
      <div class="chart-bar">
        {options.length > 1 && (
          <Choice
            label="Field"
            value={field}
            options={options.map((value) => ({ value, title: titles[value] }))}
            onChange={choose}
          />
        )}
        {slider}
      </div>
      <SectionCanvas
        label={`${titles[field]}, F = ${formatFactor(factor)}`}
        file={`proven_bounds_${field}`}
        box={findSoilBox()}
        bar={{ title, colours, scale, levels: null, below: false, above: !holds }}
        draw={(pen) => {
          drawSoils(pen);
          if (holds && fields?.holds)
            paintTriangles(pen, fields.holds.mesh, fields.holds.utilisation, colours, scale, opacity);
          if (!holds && fields?.moves)
            paintTriangles(pen, fields.moves.mesh, fields.moves.shear_rate, colours, scale, opacity);
          drawOutlines(pen);
          drawSurcharges(pen);
          drawBars(pen);
        }}
        depends={[fields, field, opacity]}
        drawOver={(pen) => {
          if (holds && fields?.holds) drawCrosses(pen, fields.holds.middles, fields.holds.stress);
          if (!holds && fields?.moves) drawArrows(pen, fields.moves.nodes, fields.moves.velocity);
          drawSoilNames(pen);
          if (!holds)
            for (const { points } of bounds.sides ?? []) drawSurface(pen.context, points.map(pen.place), bandLook, 2.4);
        }}
        dependsOver={[fields, field]}
      />
      <ul class="drawing-keys" aria-label="Legend">
        <GroundKeys />
        {holds ? (
          <li>Crosses: principal effective stresses, red in tension</li>
        ) : (
          <li>Arrows: velocities; their size has no meaning</li>
        )}
        {!holds && (bounds.sides ?? []).length > 0 && (
          <LineKey colour={bandLook.colour} width={2.4}>
            Axis of the largest shear strain rate
          </LineKey>
        )}
      </ul>
    </figure>
  );
}

function Meshes({ bounds }: { bounds: BoundsResult }) {
  return (
    <ChartTable
      label="Meshes of limit analysis"
      class="bounds-meshes"
      rows={bounds.meshes}
      columns={[
        ["Triangles", (mesh) => formatNumber(mesh.triangles, 6), "number"],
        ["Lower bound", (mesh) => formatFactor(roundDown(mesh.lower)), "number"],
        ["Upper bound", (mesh) => formatFactor(roundUp(mesh.upper)), "number"],
        ["Programs", (mesh) => mesh.programs, "number"],
        ["Iterations", (mesh) => mesh.iterations, "number"],
        ["Seconds", (mesh) => formatNumber(mesh.seconds, 3), "number"],
      ]}
    />
  );
}

/** The interval of limit analysis in one sentence. */
function describeInterval({ no_lower, no_upper, is_davis, takes_tension, ...bounds }: BoundsResult): string {
  const [lower, upper] = [roundDown(bounds.lower), roundUp(bounds.upper)];
  const soil =
    (is_davis ? "for soil with the strength of Davis, which is an estimate for ψ < φ" : "for ψ = φ") +
    (takes_tension ? ", and the tensile strength as given" : "");
  if (lower !== null && upper !== null)
    return (
      `The factor of safety lies between ${formatFactor(lower)} and ${formatFactor(upper)}, ` +
      `${formatNumber((200 * (upper - lower)) / (upper + lower), 2)} % of the middle, ${soil}.`
    );
  if (lower !== null) return `The factor of safety is at least ${formatFactor(lower)} ${soil}. There is no upper bound: ${no_upper}.`;
  if (upper !== null) return `The factor of safety is at most ${formatFactor(upper)} ${soil}. There is no lower bound: ${no_lower}.`;
  return `No bound was found: ${no_lower}; ${no_upper}.`;
}

export function BoundsSection() {
  const { result, proven_bounds: drawn } = report.value;
  const { bounds } = result;
  if (!bounds) return null;
  return (
    <section class="chart-section" aria-labelledby="chart-bounds-title">
      <h3 id="chart-bounds-title">Limit analysis</h3>
      {bounds.error ? (
        <p>
          <span class="chart-bad">No answer:</span> {formatSentence(bounds.error)}
        </p>
      ) : (
        <p>
          {describeInterval(bounds)} {formatQuantity(bounds.seconds ?? 0, "s", 3)}.
        </p>
      )}
      {drawn && <Figure bounds={bounds} drawn={drawn} />}
      {bounds.meshes.length > 0 && <Meshes bounds={bounds} />}
    </section>
  );
}
