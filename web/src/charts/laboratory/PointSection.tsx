// SPDX-License-Identifier: MIT
/** Element tests: diagrams of each kind of apparatus, with one legend, and what came out in a table. */
import * as Plot from "@observablehq/plot";
import { useMemo } from "preact/hooks";

import type { PointGroup, PointTest, PointTests } from "../../contract";
import { DataTable, SymbolText } from "../../page/DataTable";
import { report } from "../../state";
import { Chart } from "../base/Chart";
import { CsvButton, Legend, useSwitches } from "../base/Legend";
import { formatNumber, formatQuantity } from "../base/numbers";
import {
  capitalise, findSpan, layOutDiagram, makeLines, makePointCsv, makeStops, type PointLine, readLines,
} from "./diagram";

function Diagram(props: {
  group: PointGroup;
  panel: PointGroup["panels"][number];
  lines: PointLine[];
  shown: PointLine[];
}) {
  const { group, panel, lines, shown } = props;
  const first = lines[0]!;
  const x = first.columns.get(panel.x)!;
  const y = first.columns.get(panel.y)!;
  const ends = findSpan(lines, panel.x, panel.log_x);
  const stops = makeStops(...ends, panel.log_x);
  const draw = () =>
    layOutDiagram(
      { ...x, ends },
      { ...y, ends: findSpan(lines, panel.y) },
      { height: 260, inset: 4, logX: panel.log_x },
      shown.map((line) => {
        const ys = line.columns.get(panel.y)!.values;
        return Plot.line(
          line.columns.get(panel.x)!.values.map((v, i) => [v, ys[i] ?? null]),
          { stroke: line.style.colour, strokeDasharray: line.style.dash, strokeWidth: 1.7, clip: true },
        );
      }),
    );
  const title = `${y.title} over ${x.title}`;
  return (
    <Chart
      label={`${group.title}: ${title}`}
      draw={draw}
      depends={[group, shown]}
      stops={stops}
      printWidth={320}
      hint={`${capitalise(title)}.`}
      read={(i) => {
        const here = readLines(shown, panel.x, panel.y, stops[i]!);
        const few = here.slice(0, 4).map(({ line, value }) => `${line.test.name} ${formatQuantity(value, y.unit)}`);
        const rest = here.length > few.length ? `, and ${here.length - few.length} more` : "";
        return {
          text: `${capitalise(x.title)} ${formatQuantity(stops[i], x.unit, 3)}: ${few.join(", ")}${rest}`,
          marks: here.map(({ line, value }) => ({ value, colour: line.style.colour })),
        };
      }}
    />
  );
}

function Group({ tests, group }: { tests: PointTests; group: PointGroup }) {
  const [hidden, toggle] = useSwitches();
  const lines = useMemo(() => makeLines(tests, report.value.point_columns ?? [], group), [tests, group]);
  const shown = lines.filter((line) => !hidden.has(line.test.name));
  return (
    <figure class="chart-figure" aria-label={group.title}>
      <div class="chart-head">
        <h4>{group.title}</h4>
        <CsvButton part={`point_${group.id}`} what="curves" columns={() => makePointCsv(lines)} />
      </div>
      <Legend
        hidden={hidden}
        onToggle={toggle}
        items={lines.map((line) => ({ id: line.test.name, title: line.test.name, style: line.style }))}
      />
      <div class="chart-grid">
        {group.panels.map((panel) => (
          <Diagram key={`${panel.x}-${panel.y}`} group={group} panel={panel} lines={lines} shown={shown} />
        ))}
      </div>
    </figure>
  );
}

function ResultTable({ tests }: { tests: PointTest[] }) {
  const { stress } = report.value.units;
  return (
    <DataTable
      caption="What came out"
      class="point-table"
      rows={tests}
      columns={[
        ["Test", (test) => test.name, "name"],
        [
          "Path",
          (test) => (
            <>
              {capitalise(test.kind)} of {test.material}
              {test.set && `, ${test.set}`}; {test.path}.
              {test.stopped && <strong> Ended early: {test.stopped}.</strong>}
            </>
          ),
        ],
        [`Peak q [${stress.name}]`, (test) => formatNumber(test.peak_q / stress.si), "number"],
        ["at strain [%]", (test) => formatNumber(test.peak_q_strain * 100, 3), "number"],
        [`End q [${stress.name}]`, ({ end }) => formatNumber((end.q ?? 0) / stress.si), "number"],
        [`End p′ [${stress.name}]`, ({ end }) => formatNumber((end.p ?? 0) / stress.si), "number"],
        [
          <>
            End <SymbolText text="ε_v" /> [%]
          </>,
          ({ end }) => formatNumber((end.volumetric_strain ?? 0) * 100, 3),
          "number",
        ],
        ["End e [-]", ({ end }) => formatNumber(end.void_ratio ?? 0), "number"],
      ]}
    />
  );
}

export function PointSection() {
  const tests = report.value.point_tests;
  if (!tests) return null;
  return (
    <section class="chart-section" aria-labelledby="chart-point-title">
      <h3 id="chart-point-title">Element tests</h3>
      <p class="chart-note">
        One point of soil each. Stresses are effective, compression and contraction are positive; q is negative where
        the axial stress is the smaller.
      </p>
      {tests.groups.map((group) => (
        <Group key={group.id} tests={tests} group={group} />
      ))}
      <ResultTable tests={tests.tests} />
    </section>
  );
}
