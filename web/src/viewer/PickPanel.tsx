// SPDX-License-Identifier: MIT
/** The values at the picked point, and how the shown field went there over the frames. */
import { useEffect, useState } from "preact/hooks";

import type { SequenceField } from "../contract";
import { readValues } from "../data";
import { fieldName, load, pickedPoint, report } from "../state";
import { formatCoordinate } from "../page/format";
import { writeNumber, writeUnit } from "./format";
import { saveFile } from "../charts/base/saveFile";
import { writePointCsv } from "./pointCsv";
import { PointHistory } from "./PointHistory";
import { frame, shown, type Shown } from "./shown";
import type { Stage } from "./stage";

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
