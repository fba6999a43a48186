/** What is shown and how: sequence, field, colours, limits, layers, the view in space, the picture. */
import { fieldName, report, sequence, sequenceIndex } from "../state";
import { colourMapTitles, type ColourMapName } from "./colours";
import { writeTitle, writeUnit } from "./format";
import { showSequence } from "./play";
import {
  colourMap, cut, handLimits, inSpace, layers, layerTitles, limitMode, type LayerName, type LimitMode,
} from "./settings";
import { field, limits } from "./shown";

interface ChoiceProps {
  label: string;
  value: string;
  choose: (value: string) => void;
  /** Values with their titles. */
  items: [string, string][];
}

function Choice(props: ChoiceProps) {
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
  if (mode === "hand") handLimits.value = limits.value;
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

function hasLayer(name: LayerName): boolean {
  const { model } = report.value;
  if (name === "water") return model.water.length > 0;
  if (name === "mesh") return model.mesh.cells !== undefined;
  const hasStrain = sequence.value?.fields.some((f) => f.name === "deviatoric_strain") ?? false;
  if (name === "ridge") return model.dimension === 2 && hasStrain;
  if (name === "slip") return model.dimension === 2;
  if (name === "boundaries") return model.boundaries.some((b) => b.lines.length > 0);
  if (name === "monitors") return model.monitors.length > 0;
  return true;
}

function Layers() {
  return (
    <details class="viewer-menu">
      <summary>Layers</summary>
      <div>
        {(Object.keys(layerTitles) as LayerName[]).filter(hasLayer).map((name) => (
          <label key={name}>
            <input
              type="checkbox"
              checked={layers.value[name]}
              onChange={(event) => (layers.value = { ...layers.value, [name]: event.currentTarget.checked })}
            />
            {layerTitles[name]}
          </label>
        ))}
      </div>
    </details>
  );
}

/** Shows only the points between two planes along each axis. */
function Cut() {
  if (report.value.model.dimension !== 3) return null;
  const set = (axis: number, end: 0 | 1, share: number) => {
    const next = cut.value.map((pair) => [...pair] as [number, number]);
    next[axis]![end] = share;
    if (next[axis]![0] > next[axis]![1]) next[axis]![1 - end] = share;
    cut.value = next;
  };
  return (
    <details class="viewer-menu">
      <summary>Cut</summary>
      <div>
        {["x", "y", "z"].map((name, axis) => (
          <div key={name} class="viewer-cut">
            <span>{name}</span>
            {([0, 1] as const).map((end) => (
              <input
                key={end}
                type="range"
                min="0"
                max="1"
                step="0.01"
                aria-label={`Show points ${end ? "up to" : "from"} this ${name}`}
                value={cut.value[axis]![end]}
                onInput={(event) => set(axis, end, event.currentTarget.valueAsNumber)}
              />
            ))}
          </div>
        ))}
        <button type="button" onClick={() => (cut.value = [[0, 1], [0, 1], [0, 1]])}>
          Show all
        </button>
      </div>
    </details>
  );
}

export function Toolbar(props: { save: () => void }) {
  const { sequences, model } = report.value;
  const automatic = field.value?.diverging ? "blueRed" : "viridis";
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
        choose={(value) => {
          if (limitMode.value === "hand") limitMode.value = "all";
          fieldName.value = value;
        }}
        items={(sequence.value?.fields ?? []).map((f) => [f.name, writeTitle(f.title, f.unit)])}
      />
      <Choice
        label="Colours"
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
      <span class="viewer-tools">
        <Layers />
        <Cut />
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
