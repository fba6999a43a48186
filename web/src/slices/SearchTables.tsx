// SPDX-License-Identifier: MIT
/** How the search went: what was tried and refused, limits that were hit, and separate local minima. */
import { formatNumber, formatQuantity } from "../charts/base/numbers";
import type { SliceResult, SliceSearch, SlipSurface } from "../contract";
import { formatCoordinate, formatSentence } from "../page/format";
import { ChartTable, type Column } from "../page/DataTable";
import { report } from "../state";
import { listLimits, nameReason, titleMethod, type SlicedSurface } from "./sliceData";

const kinds: Record<SliceSearch["kind"], string> = {
  entry_exit: "Circles through points of entry and exit on the ground, several depths each",
  grid: "Circles about a grid of centres, several radii each",
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

export function SearchSummary({ lem: { search, slices, seconds } }: { lem: SliceResult }) {
  if (!search) return null;
  const rate = search.circles_per_second ? `, ${formatNumber(search.circles_per_second, 2)} circles per second` : "";
  return (
    <>
      <p>
        {kinds[search.kind]}
        {describeRanges(search)}. {formatNumber(search.tried, 6)} tried with {slices} slices in{" "}
        {formatQuantity(seconds, "s", 3)}
        {rate}.
      </p>
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

export function RefusedTable({ lem: { search } }: { lem: SliceResult }) {
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

export function Minima({ lem, selected, lit, light }: MinimaProps) {
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
