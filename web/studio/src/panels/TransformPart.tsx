// SPDX-License-Identifier: MIT
/** Copy, move, mirror, turn, scale and offset of the selected shapes, and which shapes are selected besides. */
import { useSignal } from "@preact/signals";

import type { Chain } from "../document/chains";
import { EditFault } from "../document/edits";
import { copyChain, mapChains, mirrorAt, offsetChain, type PlaneMap, scaleAbout, shiftBy, turnAbout } from "../document/transform";
import { readTree } from "../document/tree";
import { pointsOf } from "../document/vertices";
import { findExtent, type Point } from "../geometry/plane";
import * as state from "../state";
import { fromShownLength, length } from "../units";
import { writeShown } from "./PointTable";

type Operation = "shift" | "mirrorX" | "mirrorY" | "turn" | "scale" | "offset";

interface Input {
  key: string;
  label: string;
  /** A length in the unit of display. */
  isLength: boolean;
}

const inputs: Record<Operation, { title: string; fields: Input[] }> = {
  shift: { title: "Move", fields: [{ key: "dx", label: "Δx", isLength: true }, { key: "dy", label: "Δy", isLength: true }] },
  mirrorX: { title: "Mirror at a vertical line", fields: [{ key: "x", label: "x of the line", isLength: true }] },
  mirrorY: { title: "Mirror at a horizontal line", fields: [{ key: "y", label: "y of the line", isLength: true }] },
  turn: {
    title: "Turn",
    fields: [{ key: "angle", label: "Angle [°], anticlockwise", isLength: false }, { key: "x", label: "about x", isLength: true }, { key: "y", label: "about y", isLength: true }],
  },
  scale: {
    title: "Scale",
    fields: [{ key: "factor", label: "Factor", isLength: false }, { key: "x", label: "about x", isLength: true }, { key: "y", label: "about y", isLength: true }],
  },
  offset: { title: "Parallel (offset)", fields: [{ key: "shift", label: "Distance: up or outwards positive", isLength: true }] },
};

function makeMap(operation: Operation, values: Record<string, number>): PlaneMap {
  const { dx = 0, dy = 0, x = 0, y = 0, angle = 0, factor = 1 } = values;
  if (operation === "mirrorX") return mirrorAt([x, 0], [x, 1]);
  if (operation === "mirrorY") return mirrorAt([0, y], [1, y]);
  if (operation === "turn") return turnAbout([x, y], angle);
  if (operation === "scale") return scaleAbout([x, y], factor);
  return shiftBy(dx, dy);
}

/** Applies an edit to shapes one after another, each found again in the text that the one before has left. */
function applyToAll(chains: readonly Chain[], edit: (text: string, chain: Chain) => string): string {
  return chains.reduce((text, chain) => edit(text, chain), state.tree.value.text);
}

function parse(text: string) {
  const { tree } = readTree(text);
  if (!tree) throw new EditFault("The text is not TOML.");
  return tree;
}

export function TransformPart({ chain }: { chain: Chain }) {
  const operation = useSignal<Operation>("shift");
  const copies = useSignal(true);
  const typed = useSignal<Record<string, string>>({});
  const shapes = state.selectedChains.value;
  const { low, high } = findExtent(shapes.flatMap(pointsOf)) ?? { low: [0, 0] as Point, high: [0, 0] as Point };
  const suggested: Record<string, string> = {
    dx: "0",
    dy: "0",
    x: writeShown(operation.value === "mirrorX" ? high[0] : (low[0] + high[0]) / 2),
    y: writeShown(operation.value === "mirrorY" ? high[1] : (low[1] + high[1]) / 2),
    angle: "0",
    factor: "1",
    shift: "-1",
  };
  const { title, fields } = inputs[operation.value];
  const isParallel = operation.value === "offset";
  const read = (): Record<string, number> => {
    const values: Record<string, number> = {};
    for (const { key, label, isLength } of fields) {
      const text = (typed.value[key] ?? suggested[key]!).replace("−", "-");
      const value = Number(text);
      if (text.trim() === "" || Number.isNaN(value)) throw new EditFault(`${label}: “${text}” is not a number.`);
      values[key] = isLength ? fromShownLength(value) : value;
    }
    return values;
  };
  const apply = () => {
    const what = shapes.length > 1 ? `${shapes.length} shapes` : chain.name;
    const copying = copies.value || isParallel;
    state.attempt(`${copying ? (isParallel ? "Offset" : "Copy") : title.split(" ")[0]} ${what}`, () => {
      const values = read();
      if (isParallel) return applyToAll(shapes, (text, shape) => offsetChain(parse(text), shape, values.shift!));
      const map = makeMap(operation.value, values);
      if (copies.value) return applyToAll(shapes, (text, shape) => copyChain(parse(text), shape, map));
      return mapChains(state.tree.value, state.chains.value, shapes, map);
    });
  };
  return (
    <details class="transform">
      <summary>Copy, mirror, turn, offset</summary>
      <form
        onSubmit={(e) => {
          e.preventDefault();
          apply();
        }}
      >
        <label class="plain-field">
          Operation
          <select value={operation.value} onChange={(e) => (operation.value = e.currentTarget.value as Operation)}>
            {(Object.keys(inputs) as Operation[]).map((key) => (
              <option key={key} value={key}>
                {inputs[key].title}
              </option>
            ))}
          </select>
        </label>
        <div class="pair">
          {fields.map(({ key, label, isLength }) => (
            <label key={key} class="plain-field">
              {label}
              {isLength && ` [${length.value.name}]`}
              <input
                value={typed.value[key] ?? suggested[key]}
                inputMode="decimal"
                autocomplete="off"
                onInput={(e) => (typed.value = { ...typed.value, [key]: e.currentTarget.value })}
              />
            </label>
          ))}
        </div>
        {!isParallel && (
          <label class="check">
            <input type="checkbox" checked={copies.value} onChange={(e) => (copies.value = e.currentTarget.checked)} /> Keep the original and change a copy
          </label>
        )}
        <p class="tools">
          <button type="submit">{title}</button>
        </p>
      </form>
      <details>
        <summary>Together with other shapes{shapes.length > 1 ? `: ${shapes.length - 1}` : ""}</summary>
        <p class="field-note">Shift and a click on the canvas add to the selection as well.</p>
        {state.chains.value
          .filter(({ id, kind }) => id !== chain.id && kind !== "box")
          .map(({ id, name }) => (
            <label key={id} class="check">
              <input type="checkbox" checked={state.also.value.includes(id)} onChange={() => state.selectChain(id, true)} /> {name}
            </label>
          ))}
      </details>
    </details>
  );
}
