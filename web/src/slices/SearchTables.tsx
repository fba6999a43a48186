// SPDX-License-Identifier: MIT
/** How the search went: what was tried and refused, limits that were hit, and separate local minima. */
import { formatNumber, formatQuantity } from "../charts/base/numbers";
import type { LocalMinimum, SlicedSurface, Slices, SliceSearch } from "../contract";
import { formatCoordinate, formatSentence } from "../page/format";
import { ChartTable, numbers, wrapped } from "../page/DataTable";
import { report } from "../state";
import { nameReason, titleMethod } from "./sliceData";

const kinds: Record<SliceSearch["kind"], string> = {
  entry_exit: "Circles through points of entry and exit on the ground, several depths each",
  grid: "Circles about a grid of centres, several radii each",
};

function describeRanges(search: SliceSearch): string {
  const { length } = report.value.units;
  const formatPlace = formatCoordinate;
  const parts = [];
  if (search.exit) parts.push(`exit from x = ${formatPlace(search.exit[0]!)} to ${formatPlace(search.exit[1]!)} ${length.name}`);
  if (search.entry) parts.push(`entry from x = ${formatPlace(search.entry[0]!)} to ${formatPlace(search.entry[1]!)} ${length.name}`);
  if (search.grid?.length === 2)
    parts.push(
      `centres from (${search.grid[0]!.map(formatPlace).join(", ")}) to (${search.grid[1]!.map(formatPlace).join(", ")}) ${length.name}`,
    );
  return parts.length ? `: ${parts.join("; ")}` : "";
}

export function SearchSummary({ slices }: { slices: Slices }) {
  const { search } = slices;
  if (!search) return null;
  const rate = search.circles_per_second ? `, ${formatNumber(search.circles_per_second, 2)} circles per second` : "";
  return (
    <>
      <p>
        {kinds[search.kind]}
        {describeRanges(search)}. {formatNumber(search.tried, 6)} tried with {slices.slice_count} slices in{" "}
        {formatQuantity(slices.seconds, "s", 3)}
        {rate}.
      </p>
      {search.limit_hits.length > 0 && (
        <ul class="slice-hits">
          {search.limit_hits.map((text) => (
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

export function RefusedTable({ slices }: { slices: Slices }) {
  const { search } = slices;
  const reasons = [...new Set((search?.refused ?? []).flatMap((r) => r.reasons.map((x) => x.reason)))];
  if (!search || reasons.length === 0) return null;
  return (
    <figure class="chart-figure" aria-label="Refused surfaces">
      <h4>Refused, of {formatNumber(search.tried, 6)} surfaces</h4>
      <ChartTable
        label="Refused surfaces by method and reason"
        head={["Method", ...wrapped(...reasons.map(nameReason)), ...numbers("All")]}
      >
        {search.refused.map((row) => {
          const count = (reason: string) => row.reasons.find((r) => r.reason === reason)?.count ?? 0;
          return (
            <tr key={row.method}>
              <th scope="row">{titleMethod(slices, row.method)}</th>
              {reasons.map((reason) => (
                <td key={reason} class="number">
                  {formatNumber(count(reason), 6)}
                </td>
              ))}
              <td class="number">
                {formatNumber(
                  row.reasons.reduce((sum, r) => sum + r.count, 0),
                  6,
                )}
              </td>
            </tr>
          );
        })}
      </ChartTable>
    </figure>
  );
}

interface MinimaProps {
  slices: Slices;
  selected: SlicedSurface;
  lit: LocalMinimum | null;
  light: (minimum: LocalMinimum | null) => void;
}

export function Minima({ slices, selected, lit, light }: MinimaProps) {
  const minima = slices.minima.filter((m) => m.method === selected.method);
  if (minima.length === 0) return null;
  const { length } = report.value.units;
  const formatPlace = formatCoordinate;
  return (
    <figure class="chart-figure" aria-label="Local minima">
      <h4>Local minima, {titleMethod(slices, selected.method)}</h4>
      <ol class="slice-minima">
        {minima.map((m, i) => (
          <li key={i}>
            <button type="button" aria-pressed={lit === m} onClick={() => light(lit === m ? null : m)}>
              <strong>F = {m.factor.toFixed(3)}</strong>
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
