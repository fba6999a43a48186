// SPDX-License-Identifier: MIT
/** The slip surfaces of all methods over one section, for a run without material points: on the strains of the finite
 * elements where there are any, else on the soils. */
import { useMemo } from "preact/hooks";

import { useSwitches } from "../charts/base/useSwitches";
import { drawOutlines, drawSoils, drawSurcharges, drawWater } from "../drawing/ground";
import { GroundKeys, LineSwatch } from "../drawing/Keys";
import { findSoilBox } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { chooseLook, drawSurface } from "../drawing/surfaceLines";
import { paintField } from "../elements/fieldPainter";
import { useFields } from "../elements/useFields";
import { report } from "../state";
import { tabulateColours } from "../viewer/colours";
import { makeScale } from "../viewer/scale";
import type { Bar } from "../viewer/scaleBar";
import { listSurfaces, type NamedSurface } from "./surfaces";
import "./compared.css";

export function Overview() {
  const { finite_elements: elements } = report.value;
  const run = elements?.runs.find((r) => r.fields);
  const fields = useFields(elements, run);
  const surfaces = useMemo(listSurfaces, []);
  const [hidden, toggle] = useSwitches(() => surfaces.filter((s) => !s.first).map((s) => s.name));
  const limits = run?.fields?.strain_scale ?? [0, 1];
  const colours = tabulateColours("viridis");
  const scale = makeScale(limits[0]!, limits[1]!);
  const bar = useMemo<Bar | null>(
    () => fields && { title: "Shear strain", colours, scale, levels: null, below: false, above: true },
    [fields],
  );
  const shown = surfaces.filter((s) => !hidden.has(s.name));
  const list = (some: NamedSurface[]) =>
    some.map((s) => {
      const { colour, dash } = chooseLook(s.look);
      return (
        <li key={s.name} class={hidden.has(s.name) ? "off" : undefined}>
          <button type="button" aria-pressed={!hidden.has(s.name)} onClick={() => toggle(s.name)}>
            <span class="overview-swatch">
              <LineSwatch colour={colour} dash={dash.join(" ")} />
            </span>
            {s.text}
          </button>
        </li>
      );
    });
  return (
    <div class="chart-section overview">
      <SectionCanvas
        label={`Section with ${shown.map((s) => s.text).join("; ") || "no slip surface"}`}
        file="slip_surfaces"
        box={findSoilBox()}
        bar={bar}
        tallest={430}
        draw={(pen) => {
          if (fields) paintField(pen, fields.mesh, fields.mesh.nodes, fields.strain, colours, scale);
          else drawSoils(pen);
          drawOutlines(pen);
          drawWater(pen);
          drawSurcharges(pen);
        }}
        depends={[fields]}
        drawOver={(pen) => {
          for (const s of [...shown].reverse())
            drawSurface(pen.context, s.points.map(pen.place), chooseLook(s.look), 2.4);
        }}
        dependsOver={[hidden]}
      />
      <ul class="drawing-keys" aria-label="Legend">
        {!fields && <GroundKeys />}
        {list(surfaces.filter((s) => s.first))}
      </ul>
      {surfaces.some((s) => !s.first) && (
        <details class="overview-more no-print">
          <summary>{surfaces.filter((s) => !s.first).length} more surfaces</summary>
          <ul class="drawing-keys" aria-label="More surfaces">
            {list(surfaces.filter((s) => !s.first))}
          </ul>
        </details>
      )}
      {fields && run && (
        <p class="chart-note">Colours: shear strain of the finite elements at failure ({run.title}).</p>
      )}
    </div>
  );
}
