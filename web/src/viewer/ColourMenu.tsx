// SPDX-License-Identifier: MIT
/** How values become colours: the map, its ends, bands, the logarithm. */
import { Choice } from "./Choice";
import { chooseColourMap, colourMapTitles, type ColourMapName } from "./colours";
import { writeUnit } from "./format";
import { bands, colourMap, handLimits, limitMode, logarithmic, type LimitMode } from "./settings";
import { canBeLogarithmic, field, materialField, scale } from "./shown";

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

export function ColourMenu() {
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
