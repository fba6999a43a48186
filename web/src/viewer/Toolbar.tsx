// SPDX-License-Identifier: MIT
/** Selects sequence and field; settings that are needed less often are in menus: colours, layers, view and cut in space. */
import { findUsedWater } from "../drawing/standingWater";
import { formatCoordinate } from "../page/format";
import { fieldName, report, sequence, sequenceIndex } from "../state";
import { findComponents } from "./arrows";
import { chooseColourMap, type ColourMapName, colourMapTitles } from "./colours";
import { writeTitle, writeUnit } from "./scale";
import {
  arrowQuantity, type ArrowQuantity, arrowTitles, bands, chosenSurfaces, colourMap, cut, handLimits, inSpace,
  type LayerName, layers, layerTitles, limitMode, type LimitMode, listOtherSurfaces, logarithmic,
} from "./settings";
import { showSequence } from "./play";
import { canBeLogarithmic, field, fields, materialField, scale, shown } from "./shown";
import type { Stage } from "./stage";

interface ChoiceProps {
  label: string;
  value: string;
  choose: (value: string) => void;
  /** Values with their titles. */
  items: [string, string][];
}

export function Choice(props: ChoiceProps) {
  const { label, value, choose } = props;
  return (
    <label class="viewer-choice">
      <span>{label}</span>
      <select aria-label={label} value={value} onChange={(event) => choose(event.currentTarget.value)}>
        {props.items.map(([item, title]) => (
          <option key={item} value={item} selected={item === value}>
            {title}
          </option>
        ))}
      </select>
    </label>
  );
}

function chooseLimits(mode: LimitMode): void {
  if (mode === "hand") handLimits.value = [scale.value.low, scale.value.high];
  limitMode.value = mode;
}

/** The two ends of the colour scale, in the unit of the field. */
function HandLimits() {
  const unit = field.value?.unit;
  if (limitMode.value !== "hand" || !unit) return null;
  const set = (end: 0 | 1, text: string) => {
    const value = Number(text) * unit.si;
    if (text.trim() === "" || !Number.isFinite(value)) return;
    handLimits.value = end ? [handLimits.value[0], value] : [value, handLimits.value[1]];
  };
  return (
    <span class="viewer-limits">
      {([0, 1] as const).map((end) => (
        <input
          key={end}
          type="number"
          step="any"
          aria-label={`${end ? "Upper" : "Lower"} limit of the colours ${writeUnit(unit)}`}
          value={Number((handLimits.value[end] / unit.si).toPrecision(4))}
          onChange={(event) => set(end, event.currentTarget.value)}
        />
      ))}
      <span>{writeUnit(unit)}</span>
    </span>
  );
}

function ColourMenu() {
  const automatic = chooseColourMap(field.value);
  const named = field.value?.name === materialField;
  return (
    <details class="viewer-menu">
      <summary>Colours</summary>
      <div class="viewer-form">
        {named && <span>Materials have fixed colours.</span>}
        <Choice
          label="Colour map"
          value={colourMap.value ?? automatic}
          choose={(value) => (colourMap.value = value === automatic ? null : (value as ColourMapName))}
          items={Object.entries(colourMapTitles)}
        />
        <Choice
          label="Limits"
          value={limitMode.value}
          choose={(value) => chooseLimits(value as LimitMode)}
          items={[["all", "All frames"], ["frame", "This frame"], ["hand", "By hand"]]}
        />
        <HandLimits />
        <Choice
          label="Bands"
          value={String(bands.value)}
          choose={(value) => (bands.value = Number(value))}
          items={[["0", "None: colours run"], ["6", "About 6"], ["10", "About 10"], ["16", "About 16"]]}
        />
        <label>
          <input
            type="checkbox"
            checked={logarithmic.value && canBeLogarithmic.value}
            disabled={!canBeLogarithmic.value}
            onChange={(event) => (logarithmic.value = event.currentTarget.checked)}
          />
          Logarithmic
        </label>
      </div>
    </details>
  );
}

/** Angles [rad] about the vertical and above the horizon. */
const views: [string, number, number][] = [
  ["Oblique", -0.4, 0.3],
  ["Front", 0, 0],
  ["Side", Math.PI / 2, 0],
  ["Top", 0, Math.PI / 2],
];

function setCut(axis: number, pair: [number, number]): void {
  cut.value = cut.value.map((old, k) => (k === axis ? pair : old));
}

/** Two ends along an axis; they cannot pass each other. */
function AxisCut(props: { axis: number; name: string }) {
  const { axis, name } = props;
  const { length } = report.value.units;
  const [low, high] = shown.value?.box ?? [[0, 0, 0], [1, 1, 1]];
  const pair = cut.value[axis]!;
  const write = (share: number) => formatCoordinate(low[axis]! + share * (high[axis]! - low[axis]!));
  const set = (end: 0 | 1, share: number) => {
    const next: [number, number] = [...pair];
    next[end] = share;
    if (next[0] > next[1]) next[1 - end] = share;
    setCut(axis, next);
  };
  return (
    <div class="viewer-cut">
      <b>{name}</b>
      {([0, 1] as const).map((end) => (
        <input
          key={end}
          type="range"
          min="0"
          max="1"
          step="0.01"
          aria-label={`Show points ${end ? "up to" : "from"} this ${name}`}
          aria-valuetext={`${write(pair[end])} ${length.name}`}
          value={pair[end]}
          onInput={(event) => set(end, event.currentTarget.valueAsNumber)}
        />
      ))}
      <output>
        {write(pair[0])} to {write(pair[1])} {length.name}
      </output>
      <button type="button" aria-label={`Cut ${name} in the middle`} onClick={() => setCut(axis, [0, 0.5])}>
        Half
      </button>
    </div>
  );
}

function CutMenu(props: { stage: Stage | null }) {
  if (report.value.model.dimension !== 3) return null;
  return (
    <details class="viewer-menu">
      <summary>View and cut</summary>
      <div>
        <div class="viewer-views">
          {views.map(([name, azimuth, elevation]) => (
            <button key={name} type="button" onClick={() => props.stage?.look(azimuth, elevation)}>
              {name}
            </button>
          ))}
        </div>
        {["x", "y", "z"].map((name, axis) => (
          <AxisCut key={name} axis={axis} name={name} />
        ))}
        <button type="button" onClick={() => (cut.value = [[0, 1], [0, 1], [0, 1]])}>
          Show all
        </button>
      </div>
    </details>
  );
}

function hasLayer(name: LayerName): boolean {
  const { model } = report.value;
  if (name === "water") return findUsedWater() !== undefined || (model.dimension === 2 && hasPressure());
  // Without a water table of each frame, the initial one is the water table.
  if (name === "startWater") return (findUsedWater()?.water_table.length ?? 0) > 0 && hasPressure();
  if (name === "hydraulics") return report.value.water?.conditions.some((c) => c.lines.length > 0) ?? false;
  if (name === "mesh") return model.mesh.cells !== undefined;
  const hasStrain = sequence.value?.fields.some((f) => f.name === "deviatoric_strain") ?? false;
  if (name === "ridge") return model.dimension === 2 && hasStrain;
  if (name === "otherSurfaces") return model.dimension === 2 && listOtherSurfaces().length > 0;
  if (name === "soils") return model.dimension === 2 && model.polygons.some((p) => p.material);
  if (name === "slip" || name === "present") return model.dimension === 2;
  if (name === "boundaries") return model.boundaries.some((b) => b.lines.length > 0);
  if (name === "monitors") return model.monitors.length > 0;
  return true;
}

const hasPressure = () => sequence.value?.fields.some((f) => f.name === "pore_pressure") ?? false;

/** Names of the layers in this model. */
function writeName(name: LayerName): string {
  if (report.value.model.dimension === 2) return layerTitles[name];
  return name === "mesh" ? "Surface of the background mesh" : name === "rulers" ? "Axes and box" : layerTitles[name];
}

function LayerMenu() {
  const { dimension } = report.value.model;
  const quantities = (Object.keys(arrowTitles) as ArrowQuantity[]).filter(
    (name) => findComponents(sequence.value?.fields ?? [], name, dimension).length > 0,
  );
  return (
    <details class="viewer-menu">
      <summary>Layers</summary>
      <div class="viewer-form">
        {(Object.keys(layerTitles) as LayerName[]).filter(hasLayer).map((name) => (
          <label key={name}>
            <input
              type="checkbox"
              checked={layers.value[name]}
              onChange={(event) => (layers.value = { ...layers.value, [name]: event.currentTarget.checked })}
            />
            {writeName(name)}
          </label>
        ))}
        {layers.value.otherSurfaces && hasLayer("otherSurfaces") && (
          <fieldset class="viewer-surfaces">
            <legend>Surfaces</legend>
            {listOtherSurfaces().map((surface) => (
              <label key={surface.name}>
                <input
                  type="checkbox"
                  checked={surface.shown}
                  onChange={(event) =>
                    (chosenSurfaces.value = { ...chosenSurfaces.value, [surface.name]: event.currentTarget.checked })
                  }
                />
                {surface.text}
              </label>
            ))}
          </fieldset>
        )}
        {quantities.length > 0 && (
          <Choice
            label="Arrows"
            value={arrowQuantity.value}
            choose={(value) => (arrowQuantity.value = value as ArrowQuantity)}
            items={(["none", ...quantities] as const).map((name): [string, string] => [name, arrowTitles[name]])}
          />
        )}
      </div>
    </details>
  );
}

function chooseField(name: string): void {
  if (limitMode.value === "hand") limitMode.value = "all";
  fieldName.value = name;
}

export function Toolbar(props: { stage: Stage | null; save: () => void }) {
  const { sequences, model } = report.value;
  return (
    <div class="viewer-toolbar">
      <Choice
        label="Sequence"
        value={String(sequenceIndex.value)}
        choose={(value) => showSequence(Number(value))}
        items={sequences.map((s, i) => [String(i), s.title])}
      />
      <Choice
        label="Field"
        value={field.value?.name ?? ""}
        choose={chooseField}
        items={fields.value.map((f) => [f.name, writeTitle(f.title, f.unit)])}
      />
      <span class="viewer-tools">
        <ColourMenu />
        <LayerMenu />
        <CutMenu stage={props.stage} />
        {model.dimension === 2 && (
          <button type="button" aria-pressed={inSpace.value} onClick={() => (inSpace.value = !inSpace.value)}>
            3D
          </button>
        )}
        <button type="button" aria-label="Save picture" title="Save picture" onClick={props.save}>
          Save
        </button>
      </span>
    </div>
  );
}
