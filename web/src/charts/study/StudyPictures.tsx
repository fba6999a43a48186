// SPDX-License-Identifier: MIT
/** Pictures of the variants of a study side by side: one row for each, one column for each time, one scale for all. */
import { useEffect, useMemo, useRef, useState } from "preact/hooks";

import type { Sequence, SequenceField } from "../../contract";
import { load, loadPlaces, report } from "../../state";
import { Camera } from "../../viewer/camera";
import { findCells } from "../../viewer/cells";
import { chooseColourMap, tabulateColours, writeColour } from "../../viewer/colours";
import { measureExtent } from "../../viewer/extent";
import { makeScale, makeTicks } from "../../viewer/scale";
import { type Body, makePlainPainter } from "../../viewer/painter";
import { takeFrame } from "../../viewer/shown";
import { distributeVolume } from "../../viewer/sizes";
import { joinScales, listPictures, nameRow, type PictureRow, type Study, type StudyRow } from "./studyData";
import { formatQuantity, titleWithUnit } from "../base/numbers";
import { nameTime } from "../sections/SectionCharts";
import { Select } from "../base/Legend";

interface PictureProps {
  row: PictureRow;
  frame: number;
  field: SequenceField;
  limits: [number, number];
  label: string;
}

/** All pictures show the box of the model. */
function makeCamera(width: number): Camera {
  const [low, high] = report.value.model.bounds;
  const camera = new Camera();
  camera.width = width;
  camera.height = Math.max(60, Math.round((width * (high[1]! - low[1]!)) / (high[0]! - low[0]!)));
  camera.fit([low[0]!, low[1]!, 0], [high[0]!, high[1]!, 0]);
  return camera;
}

async function describe(props: PictureProps): Promise<Body> {
  const { row, frame, field, limits } = props;
  const { sequence } = row;
  const [low, high] = report.value.model.bounds;
  const stored = sequence.fields.find((f) => f.name === "volume");
  const [positions, values, volumes] = await Promise.all([
    loadPlaces(sequence.positions),
    load(field.values),
    stored ? load(stored.values) : null,
  ]);
  const count = sequence.point_count;
  const { spacing } = measureExtent(positions, sequence);
  const sizes = distributeVolume(volumes && takeFrame(volumes, frame, count), count, spacing, 2);
  const here = takeFrame(positions, frame, count, 2);
  const cells = findCells(here, sizes, [low[0]!, low[1]!, high[0]!]);
  return {
    dimension: 2,
    count,
    origin: [low[0]!, low[1]!, 0],
    positions: here,
    values: takeFrame(values, frame, count),
    radii: cells.radii,
    cover: { reach: cells.reach, triangles: cells.cover, outlines: cells.outlines },
    scale: makeScale(...limits),
    colours: tabulateColours(chooseColourMap(field)),
    slices: [0],
    extent: Math.hypot(high[0]! - low[0]!, high[1]! - low[1]!),
    walls: [low[0]!, low[1]!, high[0]!],
    showPoints: true,
    edges: null,
    edgeColour: "",
  };
}

/** Drawn with two pixels for each of the screen, so that paper gets as many as it can show. */
function Picture(props: PictureProps) {
  const host = useRef<HTMLDivElement>(null);
  const painter = useMemo(makePlainPainter, []);
  const [trouble, setTrouble] = useState("");
  useEffect(() => {
    let current = true;
    let body: Body | null = null;
    const draw = () => {
      const width = host.current?.clientWidth ?? 0;
      if (!body || !width) return;
      const camera = makeCamera(width);
      painter.resize(camera.width, camera.height, 2);
      painter.draw(body, camera);
    };
    host.current!.replaceChildren(painter.canvas);
    describe(props).then(
      (found) => {
        body = found;
        if (current) draw();
      },
      (error: Error) => current && setTrouble(error.message),
    );
    const observer = new ResizeObserver(draw);
    observer.observe(host.current!);
    return () => {
      current = false;
      observer.disconnect();
    };
  }, [props.row, props.frame, props.field, ...props.limits]);
  return <div ref={host} class="picture" role="img" aria-label={trouble || props.label} />;
}

function ColourBar({ field, limits }: { field: SequenceField; limits: [number, number] }) {
  const table = tabulateColours(chooseColourMap(field));
  const [low, high] = limits.map((v) => v / field.unit.si) as [number, number];
  const stops = Array.from({ length: 17 }, (_, i) => writeColour(table, Math.round((255 * i) / 16)));
  return (
    <div class="picture-bar">
      <span>{titleWithUnit(field.title, field.unit.name)}</span>
      <span class="picture-scale">
        <span class="picture-colours" style={{ background: `linear-gradient(to right, ${stops.join(", ")})` }} />
        {makeTicks(low, high, 4).map((t) => (
          <span key={t.text} class="picture-tick" style={{ left: `${(100 * (t.value - low)) / (high - low)}%` }}>
            {t.text}
          </span>
        ))}
      </span>
    </div>
  );
}

function pickField(sequence: Sequence, name: string): SequenceField | undefined {
  return sequence.fields.find((f) => f.name === name);
}

export function StudyPictures({ study }: { study: Study }) {
  const rows = useMemo(() => listPictures(study, report.value.sequences), [study]);
  const [name, setName] = useState("deviatoric_strain");
  if (rows.length === 0 || report.value.model.dimension !== 2) return null;
  const first = rows[0]!.sequence;
  const field = pickField(first, name) ?? first.fields[0];
  if (!field) return null;
  const limits = joinScales(rows.flatMap((r) => pickField(r.sequence, field.name) ?? []));
  const longest = Math.max(...rows.flatMap((r) => r.clock));
  const columns = Math.max(...rows.map((r) => r.pictures.length));
  const title = (row: StudyRow) => nameRow(study, study.rows.indexOf(row));
  return (
    <figure aria-label="Pictures of the variants" class="chart-figure">
      <div class="chart-head">
        <h4>The variants side by side</h4>
      </div>
      <div class="chart-bar">
        <Select label="Field" value={field.name} options={first.fields.map((f) => [f.name, titleWithUnit(f.title, f.unit.name)])} onChange={setName} />
        <ColourBar field={field} limits={limits} />
      </div>
      <div class="picture-table" style={{ "--picture-columns": columns }}>
        {rows.map((r) => {
          const own = pickField(r.sequence, field.name);
          return (
            <div key={r.sequence.id} class="picture-row">
              <h5>{title(r.row)}</h5>
              <div class="picture-frames">
                {r.pictures.map((frame) => {
                  const time = nameTime(r.clock[frame]!, longest);
                  const label = `${field.title}, ${title(r.row)}, ${time}`;
                  return (
                    <div key={frame} class="picture-cell">
                      {own && <Picture row={r} frame={frame} field={own} limits={limits} label={label} />}
                      <span class="picture-time">{time}</span>
                    </div>
                  );
                })}
              </div>
            </div>
          );
        })}
      </div>
      <p class="chart-note">
        One scale for all pictures: {formatQuantity(limits[0] / field.unit.si, field.unit.name, 3)} to{" "}
        {formatQuantity(limits[1] / field.unit.si, field.unit.name, 3)}. Grey: no value.
      </p>
    </figure>
  );
}
