// SPDX-License-Identifier: MIT
/** The values at the picked point, how the shown field went there over the frames, and its history as a table. */
import * as Plot from "@observablehq/plot";
import { useEffect, useRef, useState } from "preact/hooks";

import { type CsvColumn, makeFileName, saveFile, writeCsv } from "../charts/base/rows";
import type { SequenceField } from "../contract";
import { readValues } from "../data";
import { formatCoordinate } from "../page/format";
import { fieldName, load, pickedPoint, report } from "../state";
import { writeNumber, writeTitle, writeUnit } from "./scale";
import { goTo } from "./play";
import { frame, type Shown, shown } from "./shown";
import type { Stage } from "./stage";

/** Frames, coordinates and all fields of a point, in the report's units. `series`: field → value per frame [SI]. */
function tabulatePoint(now: Shown, point: number, series: Map<string, ArrayLike<number>>): CsvColumn[] {
  const { sequence, positions } = now;
  const { model, units } = report.value;
  const { frames, point_count: count } = sequence;
  const round = (value: number) => Number(value.toPrecision(7));
  const columns: CsvColumn[] = [
    { name: "time", unit: "s", values: frames.map((f) => round(f.time - frames[0]!.time)) },
    { name: "strength reduction factor", values: frames.map((f) => f.factor) },
    { name: "frame", values: frames.map((f) => f.label) },
  ];
  for (let k = 0; k < model.dimension; ++k) {
    const at = (f: number) => positions[(f * count + point) * model.dimension + k]!;
    // A micrometre is finer than the page stores, and all digits of a map are kept.
    const values = frames.map((_, f) => Number((at(f) / units.length.si).toFixed(6)));
    columns.push({ name: "xyz"[k]!, unit: units.length.name, values });
  }
  for (const field of sequence.fields) {
    const values = Array.from(series.get(field.name) ?? [], (value) => round(value / field.unit.si));
    columns.push({ name: field.title, unit: field.unit.name, values });
  }
  return columns;
}

/** Name and content of the file. */
function writePointCsv(now: Shown, point: number, series: Map<string, ArrayLike<number>>): [string, Blob] {
  const name = makeFileName(report.value.title, `${now.sequence.id} point ${now.ids[point]}`);
  return [name, new Blob([writeCsv(tabulatePoint(now, point, series))], { type: "text/csv" })];
}

function PointHistory(props: { now: Shown; values: Float32Array | undefined }) {
  const host = useRef<HTMLDivElement>(null);
  const { now } = props;
  const { frames, axis } = now.sequence;
  // While another sequence is being decoded the values are still those of the one before.
  const values = props.values?.length === frames.length ? props.values : undefined;
  const index = frame.value;
  const start = frames[0]!.time;
  const along = (f: number) => (axis === "factor" ? (frames[f]!.factor ?? f) : frames[f]!.time - start);
  const axisTitle = axis === "factor" ? "Strength reduction factor" : "Time [s]";

  useEffect(() => {
    if (!values || !host.current) return;
    const { si } = now.field.unit;
    const rows = Array.from(values, (value, f) => ({ x: along(f), y: Number.isNaN(value) ? null : value / si }));
    const plot = Plot.plot({
      width: 360,
      height: 190,
      marginLeft: 52,
      marginBottom: 34,
      style: { background: "transparent", fontSize: "11px" },
      x: { label: axisTitle, labelArrow: "none", ticks: 5, nice: true },
      y: { label: writeTitle(now.field.title, now.field.unit), labelArrow: "none", ticks: 5, nice: true, grid: true },
      marks: [
        Plot.lineY(rows, { x: "x", y: "y", stroke: "var(--accent, #0b62a8)", strokeWidth: 1.8 }),
        Plot.ruleX([along(index)], { stroke: "currentColor", strokeOpacity: 0.35 }),
        Plot.dot(rows.slice(index, index + 1), { x: "x", y: "y", r: 4, fill: "var(--accent, #0b62a8)" }),
      ],
    });
    plot.setAttribute("aria-hidden", "true");
    const goToClicked = (event: Event) => {
      const wanted = plot.scale("x")!.invert!((event as PointerEvent).offsetX * (360 / plot.clientWidth)) as number;
      const distance = (f: number) => Math.abs(along(f) - wanted);
      goTo(frames.reduce((best, _, f) => (distance(f) < distance(best) ? f : best), 0));
    };
    plot.addEventListener("click", goToClicked);
    host.current.replaceChildren(plot);
  });

  if (!values || values.every(Number.isNaN)) return <div class="viewer-history" ref={host} />;
  let [smallest, largest] = [0, 0];
  values.forEach((value, f) => {
    if (value < values[smallest]!) smallest = f;
    if (value > values[largest]!) largest = f;
  });
  const link = (name: string, f: number) => (
    <button type="button" class="viewer-link" onClick={() => goTo(f)}>
      {name}: {writeNumber(values[f]! / now.field.unit.si)} at {frames[f]!.label}
    </button>
  );
  return (
    <figure class="viewer-history" aria-label={`${now.field.title} at the picked point over the frames`}>
      <div ref={host} />
      <figcaption>
        {link("Largest", largest)}
        {link("Smallest", smallest)}
      </figcaption>
    </figure>
  );
}

/** Number of fields that stay decoded; beyond it, each is read for the picked point and released. */
const keptNumbers = 3e7;

/** The picked point's values over the frames, per field; they come in one after the other. */
function useSeries(now: Shown, point: number): Map<string, Float32Array> {
  const [series, setSeries] = useState(new Map<string, Float32Array>());
  useEffect(() => {
    let stopped = false;
    const { sequence } = now;
    const [count, frames] = [sequence.point_count, sequence.frames.length];
    const found = new Map<string, Float32Array>();
    const take = (field: SequenceField, values: Float32Array) =>
      found.set(field.name, Float32Array.from({ length: frames }, (_, f) => values[f * count + point]!));
    if (now.values.length === count * frames) take(now.field, now.values);
    setSeries(new Map(found));
    (async () => {
      const keep = count * frames * sequence.fields.length < keptNumbers;
      for (const field of sequence.fields) {
        if (found.has(field.name)) continue;
        const values = await (keep ? load(field.values) : readValues(field.values));
        if (stopped) return;
        take(field, values);
        setSeries(new Map(found));
      }
    })().catch(() => {});
    return () => void (stopped = true);
  }, [now, point]);
  return series;
}

function Position(props: { now: Shown; point: number; stage: Stage }) {
  const { model, units } = report.value;
  const at = props.stage.locate(props.point).slice(0, model.dimension);
  const text = at.map((value, k) => `${"xyz"[k]} = ${formatCoordinate(value)} ${units.length.name}`);
  return <span>{text.join(", ")}</span>;
}

function MaterialName(props: { now: Shown; point: number }) {
  const [name, setName] = useState("");
  useEffect(() => {
    void load(props.now.sequence.materials).then((materials) => {
      const index = materials[props.point];
      setName(report.value.model.materials.find((m) => m.index === index)?.name ?? `material ${index}`);
    });
  }, [props.now, props.point]);
  return <span>{name}</span>;
}

/** Monitored points by name, and any point by its number: a way to a point without a mouse. */
function PointFinder(props: { stage: Stage }) {
  const pick = (id: number) => {
    const index = props.stage.findIndex(id);
    if (index !== undefined) pickedPoint.value = index;
  };
  return (
    <span class="viewer-finder">
      {report.value.model.monitors.map((m) => (
        <button type="button" key={m.id} onClick={() => pick(m.id)}>
          {m.name}
        </button>
      ))}
      <label>
        Point no.{" "}
        <input
          type="number"
          min="0"
          aria-label="Number of the point"
          onChange={(event) => pick(event.currentTarget.valueAsNumber)}
        />
      </label>
    </span>
  );
}

function Picked(props: { now: Shown; point: number; stage: Stage }) {
  const { now, point, stage } = props;
  const series = useSeries(now, point);
  return (
    <>
      <p class="viewer-picked">
        <b role="status">Point {now.ids[point]}</b>
        <MaterialName now={now} point={point} />
        <Position now={now} point={point} stage={stage} />
        <span>{now.sequence.frames[frame.value]?.label}</span>
        <button
          type="button"
          class="viewer-link"
          disabled={series.size < now.sequence.fields.length}
          onClick={() => {
            const [name, content] = writePointCsv(now, point, series);
            saveFile(content, name);
          }}
        >
          CSV of all frames
        </button>
      </p>
      <div class="viewer-values">
        <dl>
          {now.sequence.fields.map((field) => {
            const value = series.get(field.name)?.[frame.value];
            return (
              <div key={field.name} class={field.name === now.field.name ? "viewer-current" : undefined}>
                <dt>
                  <button
                    type="button"
                    class="viewer-link"
                    title={`Show ${field.title} in the section and over the frames`}
                    onClick={() => (fieldName.value = field.name)}
                  >
                    {field.title}
                  </button>
                </dt>
                <dd>
                  {value === undefined ? "…" : writeNumber(value / field.unit.si)}{" "}
                  <span>{writeUnit(field.unit)}</span>
                </dd>
              </div>
            );
          })}
        </dl>
        <PointHistory now={now} values={series.get(now.field.name)} />
      </div>
    </>
  );
}

export function PickPanel(props: { stage: Stage | null }) {
  const [now, point, stage] = [shown.value, pickedPoint.value, props.stage];
  if (!now || !stage) return null;
  const valid = point !== null && point < now.sequence.point_count;
  return (
    <div class="viewer-pick">
      <div class="viewer-pick-head">
        <span>{valid ? "Another point:" : "Click the section, or choose a point, to see its values:"}</span>
        <PointFinder stage={stage} />
        {valid && (
          <button type="button" onClick={() => (pickedPoint.value = null)}>
            Clear
          </button>
        )}
      </div>
      <section aria-label="Values at the picked point" hidden={!valid}>
        {valid && <Picked now={now} point={point} stage={stage} />}
      </section>
    </div>
  );
}
