// SPDX-License-Identifier: MIT
/** A field along a vertical section: the user places the section and chooses field and times. */
import * as Plot from "@observablehq/plot";
import { useEffect, useMemo, useState } from "preact/hooks";

import type { InputTable, Sequence, SequenceField } from "../../contract";
import { formatCoordinate } from "../../page/format";
import { findSetting } from "../../page/methods/settings";
import { fieldName, frameIndex, load, loadPlaces, report, sequenceIndex } from "../../state";
import { Chart } from "../base/Chart";
import { CsvButton, Select, Symbol } from "../base/Legend";
import { layOut, makeAxis } from "../base/axes";
import type { CsvColumn } from "../base/rows";
import { formatQuantity, titleWithUnit } from "../base/numbers";
import { type SeriesStyle, styleOf } from "../base/styles";
import { type Bin, findLayer, makeProfile, takeFrame } from "./profileData";

interface ProfileLine {
  frame: number;
  title: string;
  style: SeriesStyle;
  bins: Bin[];
}

interface ProfileProps {
  lines: ProfileLine[];
  field: SequenceField;
  /** Axis that points up. */
  vertical: number;
  onRemove: (frame: number) => void;
}

function ProfileChart({ lines, field, vertical, onRemove }: ProfileProps) {
  const { bounds, mesh } = report.value.model;
  const length = report.value.units.length;
  const unit = field.unit;
  const letter = "xyz"[vertical]!;
  const bottom = bounds[0][vertical]!;
  const layers = [...new Set(lines.flatMap((l) => l.bins.map((b) => b.layer)))].sort((a, b) => a - b);
  const heights = layers.map((k) => (bottom + (k + 0.5) * findLayer(mesh.mean_size)) / length.si);

  const bins = lines.flatMap((l) => l.bins);
  const highest = Math.max(...bins.map((b) => b.height), bottom + mesh.mean_size) + mesh.mean_size / 2;
  // Zero is on the axis: how large a value is shows only beside it.
  const low = Math.min(0, ...bins.map((b) => b.mean / unit.si)) * 1.05;
  const high = Math.max(0, ...bins.map((b) => b.mean / unit.si)) * 1.05 || (low < 0 ? 0 : 1);
  const draw = (width: number) =>
    layOut({
      height: Math.max(280, Math.min(420, width * 0.6)),
      margins: [28, 24, 46, 52],
      x: makeAxis({ title: field.title, unit: unit.name, domain: [low, high], count: 6 }),
      y: makeAxis({
        title: `Height ${letter}`,
        unit: length.name,
        domain: [bottom / length.si, highest / length.si],
        count: 6,
      }),
      grid: "x",
      marks: [
        Plot.ruleX([0], { stroke: "var(--muted)" }),
        lines.flatMap((l) => {
          const points = l.bins.map((b) => [b.mean / unit.si, b.height / length.si]);
          return [
            Plot.line(points, { stroke: l.style.colour, strokeWidth: 1.5, strokeDasharray: l.style.dash }),
            Plot.dot(points, { stroke: l.style.colour, symbol: l.style.symbol, r: 3.2, fill: "var(--ground)" }),
          ];
        }),
        Plot.ruleY([bottom / length.si], { stroke: "var(--muted)" }),
      ],
    });

  return (
    <>
      <ul class="chart-legend" aria-label="Times that are drawn">
        {lines.map((l) => (
          <li key={l.frame} class="chart-entry">
            <svg class="chart-swatch" width="34" height="12" viewBox="0 0 34 12" aria-hidden="true">
              <path d="M1 6H33" stroke={l.style.colour} stroke-width="1.6" stroke-dasharray={l.style.dash} />
              <Symbol style={l.style} x={17} y={6} />
            </svg>
            {l.title}
            <button
              type="button"
              class="chart-remove"
              aria-label={`Remove ${l.title}`}
              onClick={() => onRemove(l.frame)}
            >
              ×
            </button>
          </li>
        ))}
      </ul>
      <Chart
        along="y"
        label={`${field.title} over height`}
        draw={draw}
        depends={[lines, field]}
        stops={heights}
        hint="Point at a height to read it."
        read={(i) => {
          const hits = lines.map((l) => ({ line: l, bin: l.bins.find((b) => b.layer === layers[i]) }));
          const formatHere = (bin?: Bin) => formatQuantity(bin && bin.mean / unit.si, unit.name);
          const values = hits.map(({ line, bin }) => `${line.title}: ${formatHere(bin)}`);
          return {
            text: `${letter} = ${formatCoordinate(heights[i]! * length.si)} ${length.name}; ${values.join("; ")}`,
            marks: hits.flatMap(({ line, bin }) =>
              bin ? [{ value: bin.mean / unit.si, at: bin.height / length.si, colour: line.style.colour }] : [],
            ),
          };
        }}
      />
    </>
  );
}

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
                <span class="unseen">{letter(d)} of the section</span>
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
