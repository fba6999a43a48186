// SPDX-License-Identifier: MIT
/** The background picture: chosen, shown, placed by the coordinates of two of its points. */
import { useSignal } from "@preact/signals";

import { background, marks, placeByPoints, takePicture } from "../background/background";
import { selectTool } from "../canvas/drawing";
import { readCoordinates } from "../geometry/coordinates";
import type { Point } from "../geometry/plane";
import * as state from "../state";
import { length } from "../units";
import { writeShown } from "./PointTable";

function PlaceForm({ points }: { points: readonly [Point, Point] }) {
  const shown = points.map(([x, y]) => `${writeShown(x)}, ${writeShown(y)}`);
  const typed = useSignal<[string, string]>(["", ""]);
  const fault = useSignal("");
  const apply = () => {
    const read = typed.value.map((text) => readCoordinates(text, null, length.value.size));
    const wrong = read.find((one) => one.fault);
    const placed = wrong ? null : placeByPoints(background.value!, points, [read[0]!.point!, read[1]!.point!]);
    fault.value = wrong?.fault ?? (placed ? "" : "The two points must differ.");
    if (!placed) return;
    background.value = { ...background.value!, ...placed };
    marks.value = null;
    ++state.opened.value;
  };
  return (
    <form
      onSubmit={(e) => {
        e.preventDefault();
        apply();
      }}
    >
      {[0, 1].map((i) => (
        <label key={i} class="plain-field">
          Coordinates of the {i === 0 ? "first" : "second"} point, x,y [{length.value.name}]
          <input
            id={`picture-point-${i + 1}`}
            placeholder={`now ${shown[i]}`}
            autocomplete="off"
            value={typed.value[i]}
            onInput={(e) => {
              const next: [string, string] = [...typed.value];
              next[i] = e.currentTarget.value;
              typed.value = next;
            }}
          />
        </label>
      ))}
      {fault.value && (
        <p class="bad" role="alert">
          {fault.value}
        </p>
      )}
      <p class="tools">
        <button type="submit">Place the picture</button>
        <button type="button" onClick={() => (marks.value = null)}>
          Cancel
        </button>
      </p>
    </form>
  );
}

export function BackgroundPart() {
  const found = background.value;
  return (
    <details class="background" open={marks.value !== null || undefined}>
      <summary>Background picture{found ? `: ${found.name}` : ""}</summary>
      {found && (
        <>
          <label class="check">
            <input type="checkbox" checked={found.shown} onChange={(e) => (background.value = { ...found, shown: e.currentTarget.checked })} /> Show it
          </label>
          <label class="plain-field">
            Opacity
            <input type="range" min="0.1" max="1" step="0.05" value={found.opacity} onInput={(e) => (background.value = { ...found, opacity: Number(e.currentTarget.value) })} />
          </label>
          {marks.value ? (
            <PlaceForm points={marks.value} />
          ) : (
            <p class="tools">
              <button type="button" onClick={() => selectTool("picture")}>
                Place it by two points
              </button>
              <button type="button" onClick={() => (background.value = null)}>
                Remove it
              </button>
            </p>
          )}
        </>
      )}
      <label class="plain-field">
        {found ? "Another picture" : "Picture or scan (PNG, JPEG, WebP); it can also be dropped on the page"}
        <input
          id="background-file"
          type="file"
          accept="image/png,image/jpeg,image/webp,image/gif,image/bmp"
          onChange={(e) => {
            const chosen = e.currentTarget.files?.[0];
            if (chosen) void takePicture(chosen);
          }}
        />
      </label>
    </details>
  );
}
