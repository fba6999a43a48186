// SPDX-License-Identifier: MIT
/** Methods of slices: the critical surfaces, every trial, the map of centres, the slices of the selected surface, and how the search went. */
import { useState } from "preact/hooks";

import { formatNumber, formatQuantity } from "../charts/base/numbers";
import type { SliceResult, SliceSearch, SlipSurface } from "../contract";
import { ChartTable, type Column } from "../page/DataTable";
import { formatCoordinate, formatSentence } from "../page/format";
import { report } from "../state";
import { MapFigure } from "./MapFigure";
import { SliceTable } from "./SliceTable";
import { SupportTable } from "./SupportTable";
import { SurfaceTable } from "./SurfaceTable";
import { TrialFigure } from "./TrialFigure";
import { listRestrictions } from "./restrictions";
import { hasSlices, listLimits, nameReason, type SlicedSurface, slicedSurfaces, titleMethod } from "./sliceData";
import "./slices.css";

const kinds: Record<SliceSearch["kind"], string> = {
  entry_exit: "Circles through points of entry and exit on the ground, several depths each",
  grid: "Circles about a grid of centres, several radii each",
  block: "Polylines through windows or along a layer, with ranges of inclination of their ends",
};

function describeRanges({ ranges: { exit, entry, grid } }: SliceSearch): string {
  const { length } = report.value.units;
  const formatPlace = formatCoordinate;
  const parts = [];
  if (exit) parts.push(`exit from x = ${formatPlace(exit[0]!)} to ${formatPlace(exit[1]!)} ${length.name}`);
  if (entry) parts.push(`entry from x = ${formatPlace(entry[0]!)} to ${formatPlace(entry[1]!)} ${length.name}`);
  if (grid)
    parts.push(
      `centres from (${grid.from.map(formatPlace).join(", ")}) to (${grid.to.map(formatPlace).join(", ")}) ${length.name}`,
    );
  return parts.length ? `: ${parts.join("; ")}` : "";
}

function SearchSummary({ lem: { search, slices, seconds } }: { lem: SliceResult }) {
  if (!search) return null;
  const rate = search.circles_per_second ? `, ${formatNumber(search.circles_per_second, 2)} surfaces per second` : "";
  return (
    <>
      <p>
        {kinds[search.kind]}
        {describeRanges(search)}. {formatNumber(search.tried, 6)} tried with {slices} slices in{" "}
        {formatQuantity(seconds, "s", 3)}
        {rate}.
      </p>
      {search.restrictions && (
        <ul aria-label="Restrictions of the search">
          {listRestrictions(search.restrictions).map((text) => (
            <li key={text}>{text}</li>
          ))}
        </ul>
      )}
      {search.limits.length > 0 && (
        <ul class="slice-hits">
          {listLimits().map((text) => (
            <li key={text}>
              <strong>At a limit of the search: </strong>
              {formatSentence(text)}
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

function RefusedTable({ lem: { search } }: { lem: SliceResult }) {
  const refused = Object.entries(search?.refused ?? {});
  const reasons = [...new Set(refused.flatMap(([, counts]) => Object.keys(counts)))];
  if (!search || reasons.length === 0) return null;
  return (
    <figure class="chart-figure" aria-label="Refused surfaces">
      <h4>Refused, of {formatNumber(search.tried, 6)} surfaces</h4>
      <ChartTable
        label="Refused surfaces by method and reason"
        rows={refused}
        columns={[
          ["Method", ([method]) => titleMethod(method), "name"],
          ...reasons.map((reason): Column<(typeof refused)[number]> => [
            nameReason(reason),
            ([, counts]) => formatNumber(counts[reason] ?? 0, 6),
            "wrap",
          ]),
          ["All", ([, counts]) => formatNumber(Object.values(counts).reduce((sum, n) => sum + n, 0), 6), "number"],
        ]}
      />
    </figure>
  );
}

interface MinimaProps {
  lem: SliceResult;
  selected: SlicedSurface;
  lit: SlipSurface | null;
  light: (minimum: SlipSurface | null) => void;
}

function Minima({ lem, selected, lit, light }: MinimaProps) {
  const minima = lem.minima[selected.method] ?? [];
  if (minima.length === 0) return null;
  const { length } = report.value.units;
  const formatPlace = formatCoordinate;
  return (
    <figure class="chart-figure" aria-label="Local minima">
      <h4>Local minima, {titleMethod(selected.method)}</h4>
      <ol class="slice-minima">
        {minima.map((m, i) => (
          <li key={i}>
            <button type="button" aria-pressed={lit === m} onClick={() => light(lit === m ? null : m)}>
              <strong>F = {(m.factor ?? 0).toFixed(3)}</strong>
              {m.circle &&
                ` centre (${m.circle.centre.map(formatPlace).join(", ")}), radius ${formatNumber(m.circle.radius / length.si, 4)} ${length.name}`}
              {m.points.length > 1 &&
                `, from x = ${formatPlace(m.points[0]![0]!)} to ${formatPlace(m.points.at(-1)![0]!)} ${length.name}`}
            </button>
          </li>
        ))}
      </ol>
      <p class="chart-note no-print">Press one to see it in the section.</p>
    </figure>
  );
}

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
          <SupportTable surface={selected} />
          <SliceTable surface={selected} />
        </>
      ) : (
        !lem.error && <p>No surface has a factor.</p>
      )}
      <RefusedTable lem={lem} />
    </section>
  );
}
