// SPDX-License-Identifier: MIT
/** Methods of slices: the critical surfaces, every trial, the map of centres, the slices of the selected surface. */
import { useState } from "preact/hooks";

import type { SlipSurface } from "../contract";
import { formatSentence } from "../page/format";
import { report } from "../state";
import { MapFigure } from "./MapFigure";
import { Minima, RefusedTable, SearchSummary } from "./SearchTables";
import { hasSlices, slicedSurfaces, type SlicedSurface } from "./sliceData";
import { SliceTable } from "./SliceTable";
import { SurfaceTable } from "./SurfaceTable";
import { TrialFigure } from "./TrialFigure";
import "./slices.css";

/** The surface that governs is shown first, else the first that has slices. */
function chooseFirst(surfaces: SlicedSurface[]): SlicedSurface | undefined {
  const whole = surfaces.filter((s) => s.factor !== null && hasSlices(s));
  return whole.find((s) => s.governs) ?? whole[0] ?? surfaces[0];
}

export function SlicesSection() {
  const { result, slices } = report.value;
  const { lem } = result;
  const [chosen, select] = useState<SlicedSurface | undefined>(undefined);
  const [lit, light] = useState<SlipSurface | null>(null);
  const selected = chosen ?? chooseFirst(slicedSurfaces.value);
  if (!lem || !slices) return null;
  const hasMap = slices.maps.length > 0 || slices.trials !== undefined;
  return (
    <section class="chart-section" aria-labelledby="chart-slices-title">
      <h3 id="chart-slices-title">Limit equilibrium (LEM)</h3>
      {lem.error && (
        <p>
          <span class="chart-bad">No answer:</span> {formatSentence(lem.error)}
        </p>
      )}
      <SearchSummary lem={lem} />
      {selected ? (
        <>
          <SurfaceTable selected={selected} select={(s) => (select(s), light(null))} />
          <div class={hasMap ? "slice-pair" : undefined}>
            <div>
              <TrialFigure slices={slices} selected={selected} lit={lit} />
              <Minima lem={lem} selected={selected} lit={lit} light={light} />
            </div>
            {hasMap && <MapFigure slices={slices} selected={selected} />}
          </div>
          <SliceTable surface={selected} />
        </>
      ) : (
        !lem.error && <p>No surface has a factor.</p>
      )}
      <RefusedTable lem={lem} />
    </section>
  );
}
