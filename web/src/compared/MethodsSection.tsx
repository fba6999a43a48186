// SPDX-License-Identifier: MIT
/** All methods side by side: factors by criterion with computing times, surfaces of other methods, their reading, and partial factors. */
import { CsvButton } from "../charts/base/Legend";
import { formatNumber } from "../charts/base/numbers";
import type { DesignStatement, MethodComparison, MethodRow } from "../contract";
import { ChartTable, Scroller, SymbolText } from "../page/DataTable";
import { getMethodTitle } from "../page/FactorTable";
import { formatDifference, formatDuration, formatFactor, formatInterval, formatSentence } from "../page/format";
import { report } from "../state";
import { FactorMark, type FactorScale, makeFactorScale } from "./FactorMark";
import { findMethods, listRows } from "./methodTable";

function PartialFactors({ partial }: { partial: DesignStatement }) {
  return (
    <figure class="chart-figure" aria-label="Partial factors">
      <h4>Partial factors{partial.set && `: ${partial.set}`}</h4>
      <p>{formatSentence(partial.text)}</p>
      <Scroller class="chart-scroll" label="Partial factors">
        <table class="chart-table compared-narrow">
          <tbody>
            {partial.values.map((v) => (
              <tr key={v.key}>
                <th scope="row">
                  <SymbolText text={v.symbol} /> {v.title}
                </th>
                <td class="number">{formatNumber(v.value, 4)}</td>
              </tr>
            ))}
            {partial.over_design !== null && (
              <tr>
                <th scope="row">Over-design factor</th>
                <td class={`number ${partial.over_design < 1 ? "chart-bad" : "chart-good"}`}>
                  {formatFactor(partial.over_design)}
                </td>
              </tr>
            )}
          </tbody>
        </table>
      </Scroller>
      {partial.materials.length > 0 && (
        <ChartTable
          label="Design values"
          class="compared-narrow"
          rows={partial.materials}
          columns={[
            ["Soil", (m) => m.material, "name"],
            [
              "Quantity",
              (m) => (
                <>
                  {m.quantity}
                  {m.symbol && " "}
                  {m.symbol && <SymbolText text={m.symbol} />}
                  {m.unit && ` [${m.unit === "deg" ? "°" : m.unit}]`}
                </>
              ),
            ],
            ["Characteristic", (m) => formatNumber(m.characteristic, 4), "number"],
            ["Design", (m) => formatNumber(m.design, 4), "number"],
          ]}
        />
      )}
      {partial.notes.map((text) => (
        <p key={text} class="chart-note">
          {formatSentence(text)}
        </p>
      ))}
    </figure>
  );
}

/** Others are compared with the governing surface of LEM, else with the first factor there is. */
function chooseReference(rows: MethodRow[]): MethodRow | undefined {
  const found = rows.filter((row) => row.factor !== null);
  return found.find((row) => row.method === "lem" && row.surface === report.value.methods_read?.governing) ?? found[0];
}

interface RowsProps {
  rows: MethodRow[];
  reference: MethodRow | undefined;
  compare: (row: MethodRow) => number | null;
  scale: FactorScale | null;
  label: string;
}

function RowTable({ rows, reference, compare, scale, label }: RowsProps) {
  return (
    <ChartTable
      label={label}
      class="compared-factors"
      rows={rows}
      columns={[
        [
          "Method",
          (row) => (
            <>
              {/* The titles of the other methods begin with the method. */}
              {row.method === "lem" && <span class="chart-missing">{getMethodTitle("lem")}: </span>}
              {row.title}
            </>
          ),
          "name",
        ],
        ["Criterion", (row) => row.criterion],
        ["F", (row) => <strong>{formatFactor(row.factor, row.method === "bounds" ? "–" : "none")}</strong>, "number"],
        ["Range", formatInterval, "number"],
        scale && ["Mark", (row) => <FactorMark scale={scale} row={row} />],
        reference && [
          `against ${reference.title}`,
          (row) => {
            const difference = compare(row);
            return row === reference ? "=" : difference === null ? "–" : formatDifference(difference);
          },
          "wrap",
        ],
        ["Time", (row) => (row.seconds === null ? "–" : formatDuration(row.seconds)), "number"],
        ["Note", (row) => row.note || "–"],
      ]}
    />
  );
}

function FactorRows({ rows, unjudged }: { rows: MethodRow[]; unjudged?: string }) {
  const reference = chooseReference(rows);
  const compare = (row: MethodRow) =>
    row.factor === null || !reference?.factor || row === reference ? null : row.factor / reference.factor - 1;
  const columns = () => [
    { name: "method", values: rows.map((r) => getMethodTitle(r.method)) },
    { name: "title", values: rows.map((r) => r.title) },
    { name: "criterion", values: rows.map((r) => r.criterion) },
    { name: "factor of safety", unit: "-", values: rows.map((r) => r.factor) },
    { name: "lower", unit: "-", values: rows.map((r) => r.lower) },
    { name: "upper", unit: "-", values: rows.map((r) => r.upper) },
    { name: "relative difference to the reference", unit: "-", values: rows.map(compare) },
    { name: "computing time", unit: "s", values: rows.map((r) => r.seconds) },
    { name: "note", values: rows.map((r) => r.note) },
  ];
  // A surface from another method is not a result of LEM.
  const isGiven = (row: MethodRow) => row.method === "lem" && row.source !== "critical" && row.source !== "noncircular";
  const given = rows.some((row) => row.method === "lem" && !isGiven(row)) ? rows.filter(isGiven) : [];
  const found = rows.filter((row) => !given.includes(row));
  const scale = makeFactorScale(rows, !unjudged);
  const shared = { reference, compare, scale };
  return (
    <>
      <div class="chart-head">
        <h3 id="chart-compared-title">Factors of safety by method</h3>
        <CsvButton part="methods" columns={columns} />
      </div>
      <RowTable {...shared} rows={found} label="Factors of safety by method and criterion" />
      {scale?.proven.lem && (
        <p class="chart-note">
          Behind each mark: the interval that limit analysis proves (ψ = φ). A bar is the interval of the method itself
          {scale.judges ? "; a hollow mark is ruled out." : `. It rules no factor out: ${unjudged}.`}
        </p>
      )}
      {given.length > 0 && (
        <details class="compared-more">
          <summary>{given.length} more on given surfaces, and on those of other methods</summary>
          <RowTable {...shared} rows={given} label="Factors of safety on given surfaces" />
        </details>
      )}
    </>
  );
}

function Handed({ methods: { table, handed } }: { methods: MethodComparison }) {
  // The table has them with LEM among the methods.
  const inTable = table.some((row) => row.source === "handed");
  if (handed.length === 0 || inTable) return null;
  return (
    <figure class="chart-figure" aria-label="Surfaces evaluated by LEM">
      <h4>LEM on the slip surfaces of the other methods</h4>
      <ul class="compared-list">
        {handed.map((h) => (
          <li key={`${h.from} ${h.to}`}>
            {h.title}:{" "}
            {h.factor === null ? <span class="chart-bad">refused</span> : <strong>F = {formatFactor(h.factor)}</strong>}
            {h.refusal && <span class="chart-missing"> ({h.refusal})</span>}
          </li>
        ))}
      </ul>
    </figure>
  );
}

export function MethodsSection() {
  const methods = findMethods(report.value);
  if (!methods) return null;
  const { reading } = report.value.methods_read!;
  const { partial_factors: partial } = methods;
  return (
    <section class="chart-section" aria-labelledby="chart-compared-title">
      <FactorRows rows={listRows(methods)} unjudged={methods.unjudged} />
      {reading.length > 0 && (
        <figure class="chart-figure" aria-label="How to read the differences">
          <h4>How to read the differences</h4>
          <dl class="compared-reading">
            {reading.map(({ topic, sentences }) => (
              <div key={topic}>
                <dt>{topic}</dt>
                <dd>
                  {sentences.map((text) => (
                    <p key={text}>{formatSentence(text)}</p>
                  ))}
                </dd>
              </div>
            ))}
          </dl>
        </figure>
      )}
      <Handed methods={methods} />
      {partial && <PartialFactors partial={partial} />}
    </section>
  );
}
