// SPDX-License-Identifier: MIT
/** The slip surfaces of all methods over one section, for a run without MPM: on the strains of FEM where there
 * are any, else on the soils. */
import { useMemo, useState } from "preact/hooks";

import { Choice, useSwitches } from "../charts/base/Legend";
import { clipToSoil, drawBars, drawCrack, drawOutlines, drawSoilNames, drawSoils, drawSurcharges } from "../drawing/ground";
import { GroundKeys, LineSwatch, useOpacity } from "../drawing/Keys";
import { findSoilBox } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { chooseLook, drawSurface, drawSurfaceLabels } from "../drawing/surfaceLines";
import { drawnReduction, flowRuns, paintField, useFields } from "../elements/fields";
import { report } from "../state";
import { formatCount } from "../page/format";
import { tabulateColours } from "../viewer/colours";
import { makeScale } from "../viewer/scale";
import type { Bar } from "../viewer/scaleBar";
import { listQuantities, quantityTitles, useWaterLayer } from "../water/useWaterLayer";
import type { WaterQuantity } from "../water/waterFields";
import { listSurfaces, type NamedSurface } from "./methodTable";
import "./compared.css";

type Shown = "strain" | "soils" | WaterQuantity;

export function Overview() {
  const run = drawnReduction.value ?? flowRuns.value.find((r) => r.fields);
  const fields = useFields(run);
  const surfaces = useMemo(listSurfaces, [report.value]);
  const [hidden, toggle] = useSwitches(() => surfaces.filter((s) => !s.first).map((s) => s.name));
  const [chosen, choose] = useState<Shown | null>(null);
  const shows: Shown = chosen ?? (fields ? "strain" : "soils");
  const options: Shown[] = [...(fields ? ["strain" as const] : []), "soils", ...listQuantities()];
  const { opacity, slider } = useOpacity();
  const layer = useWaterLayer(shows === "strain" || shows === "soils" ? null : shows);
  const limits = run?.fields?.strain_scale ?? [0, 1];
  const colours = tabulateColours("viridis");
  const scale = makeScale(limits[0]!, limits[1]!);
  const strainBar = useMemo<Bar | null>(
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
  const bar = shows === "strain" ? strainBar : layer.bar;
  return (
    <div class="chart-section overview">
      <div class="chart-bar no-print">
        {options.length > 1 && (
          <Choice
            label="Colours of the section"
            value={shows}
            options={options.map((value) => ({
              value,
              title: value === "strain" ? "shear strain" : value === "soils" ? "soils" : quantityTitles[value],
            }))}
            onChange={choose}
          />
        )}
        {layer.controls}
        {shows !== "soils" && slider}
      </div>
      <SectionCanvas
        label={`Section with ${shown.map((s) => s.text).join("; ") || "no slip surface"}`}
        file="slip_surfaces"
        box={findSoilBox()}
        bar={bar}
        tallest={430}
        draw={(pen) => {
          drawSoils(pen);
          if (fields && shows === "strain")
            paintField(pen, fields.mesh, fields.mesh.nodes, fields.strain, colours, scale, opacity);
          clipToSoil(pen, () => layer.paint(pen, opacity));
          drawOutlines(pen);
          layer.drawOver(pen);
          drawSurcharges(pen);
          drawBars(pen);
        }}
        depends={[fields, shows, ...layer.depends, opacity]}
        drawOver={(pen) => {
          const names = drawSoilNames(pen);
          for (const s of [...shown].reverse()) {
            if (s.method === "lem") drawCrack(pen, s.points);
            drawSurface(pen.context, s.points.map(pen.place), chooseLook(s.look), 2.4);
          }
          drawSurfaceLabels(
            pen.context,
            shown.flatMap((s) =>
              s.factor === null
                ? []
                : [{ line: s.points.map(pen.place), text: s.factor.toFixed(3), colour: chooseLook(s.look).colour }],
            ),
            names,
          );
        }}
        dependsOver={[hidden, surfaces]}
      />
      <ul class="drawing-keys" aria-label="Legend">
        <GroundKeys />
        {list(surfaces.filter((s) => s.first))}
      </ul>
      {surfaces.some((s) => !s.first) && (
        <details class="overview-more no-print">
          <summary>{formatCount(surfaces.filter((s) => !s.first).length, "more surface", "more surfaces")}</summary>
          <ul class="drawing-keys" aria-label="More surfaces">
            {list(surfaces.filter((s) => !s.first))}
          </ul>
        </details>
      )}
      {layer.note && <p class="chart-note">{layer.note}</p>}
      {fields && run && shows === "strain" && (
        <p class="chart-note">
          Colours: shear strain of FEM {drawnReduction.value ? "in the last trial" : "at failure"} ({run.title}).
        </p>
      )}
    </div>
  );
}
