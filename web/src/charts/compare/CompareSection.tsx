// SPDX-License-Identifier: MIT
/** Computed beside published: the numbers, whether they agree within the tolerance, and by how much. */
import * as Plot from "@observablehq/plot";

import type { Comparison, Report } from "../../contract";
import { ChartTable } from "../../page/DataTable";
import { report } from "../../state";
import { Chart } from "../base/Chart";
import { CsvButton } from "../base/Legend";
import { layOut } from "../base/axes";
import { formatNumber, isPlain, titleWithUnit } from "../base/numbers";

interface Difference {
  /** computed − published [SI]. */
  absolute: number | null;
  /** Over the published value's magnitude; null for a published zero. */
  relative: number | null;
  /** Over the tolerance: within ±1 passes. Without a tolerance, 0 where both are equal, else infinite. */
  overTolerance: number | null;
}

/** Of the run and of its element tests; a report of tests alone has theirs as its own. */
export const listComparisons = ({ kind, result, point_tests: tests }: Report): Comparison[] => [
  ...result.comparisons,
  ...(kind === "tests" ? [] : (tests?.comparisons ?? [])),
];

function isMissing(comparison: Pick<Comparison, "computed">): boolean {
  return comparison.computed === null;
}

export function measureDifference(c: Pick<Comparison, "computed" | "published" | "tolerance">): Difference {
  if (c.computed === null) return { absolute: null, relative: null, overTolerance: null };
  const absolute = c.computed - c.published;
  const relative = c.published === 0 ? null : absolute / Math.abs(c.published);
  const overTolerance = absolute === 0 ? 0 : c.tolerance > 0 ? absolute / c.tolerance : Math.sign(absolute) * Infinity;
  return { absolute, relative, overTolerance };
}

/** Differences beyond this many tolerances are drawn at the edge, as arrows. */
const edge = 3;
const good = "var(--good)";
const bad = "var(--bad)";

function describeCount(all: readonly Comparison[]): string {
  const passed = all.filter((c) => c.passes).length;
  if (all.length === 1) return passed ? "The one comparison passes." : "The one comparison fails.";
  if (passed === all.length) return `All ${all.length} comparisons pass.`;
  if (passed === 0) return `None of the ${all.length} comparisons passes.`;
  const missed = all.length - passed;
  return `${passed} of ${all.length} comparisons pass, ${missed} ${missed === 1 ? "misses" : "miss"}.`;
}

/** The tolerance as the case states it, with the unit of the quantity when it is a bare number. */
function nameTolerance({ tolerance_text: text, unit }: Comparison): string {
  return isPlain(unit.name) || /[%a-z]/i.test(text) ? text : `${text} ${unit.name}`;
}

function Verdict({ comparison }: { comparison: Comparison }) {
  if (isMissing(comparison)) return <span class="chart-bad">✗ no result</span>;
  return comparison.passes ? <span class="chart-good">✓ passes</span> : <span class="chart-bad">✗ misses</span>;
}

/** "+0.02 (+1.5 %)". */
function writeDifference(c: Comparison): string {
  const { absolute, relative } = measureDifference(c);
  const signed = (v: number, unit = "") => `${v > 0 ? "+" : ""}${formatNumber(v, 3)}${unit}`;
  if (absolute === null) return "–";
  return signed(absolute / c.unit.si) + (relative === null ? "" : ` (${signed(100 * relative, " %")})`);
}

export function CompareSection() {
  const all = listComparisons(report.value);
  if (all.length === 0) return null;
  return (
    <section class="chart-section" aria-labelledby="chart-compare-title">
      <div class="chart-head">
        <h3 id="chart-compare-title">Computed beside published</h3>
        <CsvButton part="comparisons" columns={() => makeColumns(all)} />
      </div>
      <p>{describeCount(all)}</p>
      <ChartTable
        label="Table of comparisons"
        rows={all}
        columns={[
          ["Quantity", (c) => titleWithUnit(c.title, c.unit.name), "name"],
          ["Verdict", (c) => <Verdict comparison={c} />],
          ["Computed", (c) => formatNumber(c.computed === null ? null : c.computed / c.unit.si), "number"],
          ["Published", (c) => formatNumber(c.published / c.unit.si), "number"],
          ["Difference", writeDifference, "number"],
          ["Tolerance", (c) => `± ${nameTolerance(c)}`, "number"],
          [
            "Source",
            (c) => (
              <>
                {c.source}
                {c.note && <div class="chart-missing">{c.note}</div>}
              </>
            ),
          ],
        ]}
      />
      <DifferenceChart all={all} />
    </section>
  );
}

function makeColumns(all: readonly Comparison[]) {
  const d = all.map(measureDifference);
  return [
    { name: "quantity", values: all.map((c) => c.title) },
    { name: "unit", values: all.map((c) => c.unit.name) },
    { name: "computed", values: all.map((c) => (c.computed === null ? null : c.computed / c.unit.si)) },
    { name: "published", values: all.map((c) => c.published / c.unit.si) },
    { name: "difference", values: all.map((c, i) => (d[i]!.absolute === null ? null : d[i]!.absolute! / c.unit.si)) },
    { name: "relative difference", unit: "-", values: d.map((v) => v.relative) },
    { name: "tolerance", values: all.map((c) => c.tolerance / c.unit.si) },
    { name: "verdict", values: all.map((c) => (isMissing(c) ? "no result" : c.passes ? "passes" : "misses")) },
    { name: "source", values: all.map((c) => c.source) },
  ];
}

/** One dot per comparison over the band of its tolerance. */
function DifferenceChart({ all }: { all: Comparison[] }) {
  const rows = all.map((c, i) => ({ c, i, over: measureDifference(c).overTolerance })).filter((r) => r.over !== null);
  if (rows.length === 0) return null;
  // When all are near, the axis ends not far outside of the band.
  const reach = rows.every((r) => Math.abs(r.over!) < 1.4) ? 1.5 : edge;
  const shown = (over: number) => Math.max(-edge, Math.min(edge, over));
  const draw = (width: number): Plot.PlotOptions => {
    const wide = width >= 560;
    const longest = Math.max(...rows.map((r) => r.c.title.length));
    return layOut({
      height: rows.length * (wide ? 28 : 44) + 56,
      margins: [8, 20, 46, wide ? Math.min(longest * 6.6 + 16, width * 0.45) : 12],
      x: {
        domain: [-reach - 0.15, reach + 0.15],
        label: "(computed − published) / tolerance",
        ticks: [-3, -2, -1, 0, 1, 2, 3].filter((t) => Math.abs(t) <= reach),
        tickFormat: (v: number) => formatNumber(v),
      },
      y: { domain: [rows.length - 0.5, -0.5], axis: null },
      grid: "none",
      marks: [
        Plot.rect([0], { x1: -1, x2: 1, y1: -0.5, y2: rows.length - 0.5, fill: good, fillOpacity: 0.14 }),
        Plot.ruleX([0], { stroke: "var(--muted)" }),
        Plot.ruleY(
          rows.map((_, k) => k),
          { stroke: "var(--line)" },
        ),
        Plot.link(rows, {
          x1: 0,
          x2: (r) => shown(r.over!),
          y1: (_, k) => k,
          y2: (_, k) => k,
          stroke: (r) => (r.c.passes ? good : bad),
          strokeWidth: 2,
        }),
        Plot.dot(rows, {
          x: (r) => shown(r.over!),
          y: (_, k) => k,
          r: 5,
          symbol: (r: (typeof rows)[number]) => (r.c.passes ? "circle" : "times"),
          fill: (r) => (r.c.passes ? good : "none"),
          stroke: (r) => (r.c.passes ? good : bad),
          strokeWidth: 2,
        }),
        Plot.text(
          rows.filter((r) => Math.abs(r.over!) > edge),
          {
            x: (r) => shown(r.over!),
            y: (r) => rows.indexOf(r),
            text: (r) => `${r.over! < 0 ? "◂ " : ""}${formatNumber(r.over, 3)}${r.over! > 0 ? " ▸" : ""}`,
            dy: -11,
            dx: 4,
            textAnchor: "middle",
            fill: bad,
          },
        ),
        Plot.text(rows, {
          frameAnchor: "left",
          y: (_, k) => k,
          text: (r) => r.c.title,
          dx: wide ? -8 : 2,
          dy: wide ? 0 : -13,
          textAnchor: wide ? "end" : "start",
        }),
      ],
    });
  };
  return (
    <Chart
      along="y"
      label="Differences over tolerances"
      draw={draw}
      depends={[all]}
      stops={rows.map((_, k) => k)}
      read={(k) => {
        const { c, over } = rows[k]!;
        const verdict = c.passes ? "passes" : "misses";
        return { text: `${c.title}: difference ${formatNumber(over, 3)} tolerances, ${verdict}`, marks: [] };
      }}
      hint="The band is the tolerance: a dot inside passes."
    />
  );
}
