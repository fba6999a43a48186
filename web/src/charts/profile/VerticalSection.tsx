// SPDX-License-Identifier: MIT
/** A field along a vertical section: the user places the section and chooses field and times. */
import { useEffect, useMemo, useState } from "preact/hooks";

import type { InputTable, Sequence } from "../../contract";
import { findSetting } from "../../page/methods/settings";
import { formatCoordinate } from "../../page/format";
import { fieldName, frameIndex, load, loadPlaces, report, sequenceIndex } from "../../state";
import type { CsvColumn } from "../base/csv";
import { CsvButton } from "../base/Legend";
import { formatQuantity, titleWithUnit } from "../base/numbers";
import { ProfileChart, type ProfileLine } from "./ProfileChart";
import { type Bin, findLayer, makeProfile, takeFrame } from "./profileData";
import { styleOf } from "../base/styles";
import { Select } from "../base/Select";

/** More lines than this cannot be distinguished. */
const mostTimes = 6;

/** The axis along which gravity points: y, unless it is tilted further. */
function findVertical(input: InputTable): number {
  const direction = findSetting(input, "gravity.direction");
  if (!Array.isArray(direction)) return 1;
  const sizes = direction.map((d) => Math.abs(Number(d)));
  return Math.max(0, sizes.indexOf(Math.max(...sizes)));
}

/** First, middle and last frame, and the one that the viewer shows. */
function chooseFrames(sequence: Sequence, current: number): number[] {
  const last = sequence.frames.length - 1;
  return [...new Set([0, Math.round(last / 2), last, Math.min(current, last)])].sort((a, b) => a - b);
}

export function VerticalSection() {
  const [index, setIndex] = useState(() => {
    const shown = sequenceIndex.peek();
    const usable = (s?: Sequence) => !!s && s.frames.length > 0 && s.fields.length > 0;
    return usable(report.value.sequences[shown]) ? shown : report.value.sequences.findIndex(usable);
  });
  const sequence = report.value.sequences[index]!;
  const [name, setName] = useState(fieldName.peek());
  const field = sequence.fields.find((f) => f.name === name) ?? sequence.fields[0]!;
  const [times, setTimes] = useState(() => chooseFrames(sequence, frameIndex.peek()));
  const { bounds, mesh, dimension } = report.value.model;
  const vertical = findVertical(report.value.result.input);
  // Without a mesh its elements are not known.
  const band = mesh.mean_size || (bounds[1][0]! - bounds[0][0]!) / 50;
  const across = [0, 1, 2].filter((d) => d < dimension && d !== vertical);
  const [at, setAt] = useState<(number | null)[]>(() =>
    [0, 1, 2].slice(0, dimension).map((d) => (d === vertical ? null : (bounds[0][d]! + bounds[1][d]!) / 2)),
  );
  const length = report.value.units.length;
  const [data, setData] = useState<{ positions: Float64Array; values: Float32Array; of: string } | null>(null);
  const [trouble, setTrouble] = useState("");

  useEffect(() => {
    let current = true;
    Promise.all([loadPlaces(sequence.positions), load(field.values)]).then(
      ([positions, values]) => current && setData({ positions, values, of: field.values.id }),
      (error: Error) => current && setTrouble(error.message),
    );
    return () => {
      current = false;
    };
  }, [sequence, field]);

  const lines = useMemo(() => {
    if (!data || data.of !== field.values.id) return [];
    return times.map((frame, i): ProfileLine => {
      const positions = takeFrame(data.positions, sequence.positions.shape, frame);
      const section = { positions, dimension, vertical, at, half: band / 2 };
      const values = takeFrame(data.values, field.values.shape, frame);
      return {
        frame,
        title: sequence.frames[frame]!.label,
        style: styleOf(i),
        bins: makeProfile(section, values, bounds[0][vertical]!, findLayer(band)),
      };
    });
  }, [data, field, sequence, times, at]);

  const unit = field.unit;
  const letter = (d: number) => "xyz"[d]!;
  const formatHere = (metres: number) => formatQuantity(metres / length.si, length.name, 3);
  const place = across.map((d) => `${letter(d)} = ${formatCoordinate(at[d] ?? 0)} ${length.name}`).join(", ");

  const columns = (): CsvColumn[] => {
    const rows = lines.flatMap((l) => l.bins.map((bin) => ({ line: l, bin })));
    const take = (get: (b: Bin) => number) => rows.map((r) => get(r.bin));
    const frames = rows.map(({ line }) => sequence.frames[line.frame]!);
    return [
      sequence.axis === "factor" ?
        { name: "srf", unit: "-", values: frames.map((f) => f.factor) }
      : { name: "time", unit: "s", values: frames.map((f) => f.time) },
      { name: "height", unit: length.name, values: take((b) => b.height / length.si) },
      { name: field.name, unit: unit.name, values: take((b) => b.mean / unit.si) },
      { name: "smallest", unit: unit.name, values: take((b) => b.min / unit.si) },
      { name: "largest", unit: unit.name, values: take((b) => b.max / unit.si) },
      { name: "points", unit: "-", values: take((b) => b.count) },
    ];
  };

  const pickSequence = (i: number) => {
    setIndex(i);
    setTimes(chooseFrames(report.value.sequences[i]!, 0));
  };
  const toggleTime = (frame: number) =>
    setTimes(times.includes(frame) ? times.filter((t) => t !== frame) : [...times, frame].sort((a, b) => a - b));

  return (
    <div>
      <div class="chart-head">
        <h4>
          {field.title} along {place}
        </h4>
        <CsvButton part={`profile-${field.name}`} columns={columns} />
      </div>
      <div class="chart-bar">
        <Select label="Field" value={field.name} options={sequence.fields.map((f) => [f.name, titleWithUnit(f.title, f.unit.name)])} onChange={setName} />
        <Select
          label="Frames of"
          value={index}
          options={report.value.sequences.flatMap((s, i): [number, string][] =>
            s.frames.length > 0 && s.fields.length > 0 ? [[i, s.title]] : [],
          )}
          onChange={(value) => pickSequence(Number(value))}
        />
      </div>
      <div class="chart-bar">
        {across.map((d) => {
          const [min, max] = [bounds[0][d]! / length.si, bounds[1][d]! / length.si];
          const set = (v: number) => Number.isFinite(v) && setAt(at.map((a, k) => (k === d ? v * length.si : a)));
          const common = { min, max, step: "any", value: (at[d] ?? 0) / length.si };
          return (
            <span key={d} class="chart-bar">
              <label>
                {letter(d)}
                <input type="range" {...common} onInput={(e) => set(e.currentTarget.valueAsNumber)} />
              </label>
              <label>
                <span class="chart-unseen">{letter(d)} of the section</span>
                <input
                  type="number"
                  {...common}
                  value={Number(common.value.toFixed(3))}
                  onChange={(e) => set(e.currentTarget.valueAsNumber)}
                />
                {length.name}
              </label>
            </span>
          );
        })}
        <label>
          Add{" "}
          <select
            value=""
            disabled={times.length >= mostTimes}
            onChange={(e) => {
              if (e.currentTarget.value !== "") toggleTime(Number(e.currentTarget.value));
              e.currentTarget.value = "";
            }}
          >
            <option value="">{sequence.axis === "factor" ? "a factor…" : "a time…"}</option>
            {sequence.frames.map((f, i) => (times.includes(i) ? null : <option key={i} value={i}>{f.label}</option>))}
          </select>
        </label>
      </div>
      <ProfileChart lines={lines} field={field} vertical={vertical} onRemove={toggleTime} />
      <p class="chart-note">
        {trouble ||
          `Means of the points within ± ${formatHere(band / 2)} of ${place}${mesh.mean_size ? " (a band as wide as a mean element)" : ""}, ` +
            `in layers of ${formatHere(findLayer(band))}, where the points are in each frame.`}
        {!trouble && data && lines.every((l) => l.bins.length === 0) && " There are no points here."}
      </p>
    </div>
  );
}
