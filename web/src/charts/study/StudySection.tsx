// SPDX-License-Identifier: MIT
/** A study: its table, any of its results over a varied key, and the displacement curves of all variants. */
import { useState } from "preact/hooks";

import { ChartTable, type Column } from "../../page/DataTable";
import { TornadoBars } from "../../sampling/TornadoChart";
import { CsvButton } from "../base/Legend";
import { formatNumber, titleWithUnit } from "../base/numbers";
import { listSectionsOf, SectionFigure } from "../sections/SectionCharts";
import { StudyCurves, StudyPlot } from "./StudyPlot";
import { StudyExtrapolation } from "./StudyExtrapolation";
import { StudyMotion } from "./StudyMotion";
import { StudyPictures } from "./StudyPictures";
import { findBars, findNumeric, makeStudyColumns, shownStudy, takeOrdered, type Study } from "./studyData";
import { orderValues } from "../base/rows";

function OrderTable({ study }: { study: Study }) {
  const rows = study.rows.filter((r) => r.motion);
  const monitors = [...new Set(rows.flatMap((r) => r.motion!.monitors.map((m) => m.name)))];
  if (rows.length === 0 || monitors.length === 0) return null;
  const onset = (row: (typeof rows)[number], name: string) =>
    row.motion!.monitors.find((m) => m.name === name)?.onset ?? null;
  return (
    <figure aria-label="Order of movement" class="chart-figure">
      <div class="chart-head">
        <h4>Order of movement</h4>
        <CsvButton
          part="study-onsets"
          what="onsets"
          columns={() => [
            { name: "variant", values: rows.map((r) => r.name) },
            ...monitors.map((name) => ({ name, unit: "s", values: rows.map((r) => onset(r, name)) })),
            { name: "pattern", values: rows.map((r) => r.motion!.pattern) },
          ]}
        />
      </div>
      <ChartTable
        label="When the monitored points began to move"
        rows={rows}
        columns={[
          ["Variant", (r) => r.name, "name"],
          ...monitors.map((name): Column<(typeof rows)[number]> => [
            `${name} [s]`,
            (r) => {
              const time = onset(r, name);
              return time === null ? <span class="chart-missing">at rest</span> : formatNumber(time, 3);
            },
            "number",
          ]),
          ["In words", (r) => r.motion!.sentence],
        ]}
      />
    </figure>
  );
}

export function StudySection() {
  const study = shownStudy.value;
  if (!study) return null;
  const sections = [...new Set(study.rows.flatMap((r) => (r.sections ?? []).map((s) => s.name)))];
  const failed = study.rows.filter((r) => r.status !== "finished").length;
  return (
    <section class="chart-section" aria-labelledby="chart-study-title">
      <div class="chart-head">
        <h3 id="chart-study-title">Variants of the study</h3>
        <CsvButton part="study" columns={() => makeStudyColumns(study)} />
      </div>
      <p>
        {study.rows.length} variants of {study.vary.map((v) => v.key).join(", ")}
        {study.mode && ` (${study.mode.replaceAll("_", " ")})`}
        {failed > 0 && `; ${failed} without a result`}.
      </p>
      <OrderTable study={study} />
      <StudyTable study={study} />
      <StudyExtrapolation study={study} />
      <StudyTornado study={study} />
      <StudyPlot study={study} />
      {study.rows.some((r) => r.curve) && <StudyCurves study={study} />}
      {study.rows.some((r) => r.paths) && <StudyMotion study={study} />}
      <StudyPictures study={study} />
      {sections.map((name) => (
        <SectionFigure key={name} runs={listSectionsOf(study, name)} />
      ))}
    </section>
  );
}

/** Tornado of the keys by their effect on the factor; other results are in the plot. */
function StudyTornado({ study }: { study: Study }) {
  const result = findNumeric(study)[0];
  const found = study.mode === "one_at_a_time" && result ? findBars(study, result) : { bars: [], base: null };
  if (!result || found.bars.length < 2) return null;
  const { bars, base } = found;
  return (
    <TornadoBars
      class="chart-figure"
      bars={bars.map((b) => ({ ...b, title: `${b.title}: ${b.low} to ${b.high}`, note: "" }))}
      base={base}
      titles={{
        chart: `Sensitivities of ${result.title}: one key changed at a time`,
        low: "smallest value",
        high: "largest value",
        axis: titleWithUnit(result.title, result.unit),
        note: base === null ? "" : `The line is the case as it is, ${formatNumber(base, 4)}.`,
      }}
      part="sensitivities"
      columns={() => [
        { name: "key", values: bars.map((b) => b.key) },
        { name: "smallest value", values: bars.map((b) => b.low) },
        { name: result.title, unit: result.unit || "-", values: bars.map((b) => b.low_factor) },
        { name: "largest value", values: bars.map((b) => b.high) },
        { name: result.title, unit: result.unit || "-", values: bars.map((b) => b.high_factor) },
      ]}
    />
  );
}

/** Columns of the study's files that every row of the table already has. */
const repeated = new Set(["variant", "result"]);

function StudyTable({ study }: { study: Study }) {
  const [sort, setSort] = useState<{ by: number | null; down: boolean }>({ by: null, down: false });
  const order =
    sort.by === null ? [...study.rows.keys()] : orderValues(takeOrdered(study.columns[sort.by]!), sort.down);
  const columns = study.columns.map((c, i) => ({ c, i })).filter(({ c }) => !repeated.has(c.name));
  const varied = study.vary.map((v) => v.key);
  const isNumeric = study.columns.map((c) => c.values.some((v) => v !== null));
  // Reasons and warnings in full; the table has only their number.
  const notes = study.rows.flatMap((r) => [r.reason, ...r.warnings].filter(Boolean).map((t) => `${r.name}: ${t}`));
  const press = (i: number) => setSort({ by: i, down: sort.by === i ? !sort.down : false });
  return (
    <>
      <div class="chart-scroll" tabIndex={0} role="group" aria-label="Table of variants">
        <table class="chart-table">
          <thead>
            <tr>
              <th scope="col">Variant</th>
              {columns.map(({ c, i }) => (
                <th
                  key={c.name}
                  scope="col"
                  class={isNumeric[i] ? "number chart-wrap" : undefined}
                  aria-sort={sort.by === i ? (sort.down ? "descending" : "ascending") : "none"}
                >
                  <button type="button" onClick={() => press(i)}>
                    {titleWithUnit(c.title, c.unit)}{" "}
                    <span aria-hidden="true" class="chart-missing">
                      {sort.by === i ? (sort.down ? "▼" : "▲") : "↕"}
                    </span>
                  </button>
                </th>
              ))}
              <th scope="col">Status</th>
            </tr>
          </thead>
          <tbody>
            {order.map((row) => {
              const r = study.rows[row]!;
              return (
                <tr key={row}>
                  <th scope="row">{r.name}</th>
                  {columns.map(({ c, i }) => (
                    <td key={c.name} class={isNumeric[i] ? "number" : undefined}>
                      {c.shown[row] ?
                        c.shown[row]
                      : <span class="chart-missing" title={r.reason || "this variant has no such result"}>
                          {varied.includes(c.name) ? "as in the case" : "none"}
                        </span>
                      }
                    </td>
                  ))}
                  <td>
                    {r.status}
                    {r.reason && <div class="chart-bad chart-reason">{r.reason}</div>}
                    {r.warnings.length > 0 && (
                      <div class="chart-missing">
                        {r.warnings.length === 1 ? "1 warning" : `${r.warnings.length} warnings`}
                      </div>
                    )}
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
      {notes.length > 0 && (
        <ul class="chart-note">
          {notes.map((n) => (
            <li key={n}>{n}</li>
          ))}
        </ul>
      )}
    </>
  );
}
