// SPDX-License-Identifier: MIT
/** What is selected: name, soil and points of a region or line, coordinates of a vertex, keys of a load or support. Without a selection: the parts of the section. */
import { findSoilColour } from "../canvas/layers";
import { deleteSelected, moveSelectedTo } from "../canvas/moving";
import type { Chain } from "../document/chains";
import { applyEdits, setValue, writeNumber } from "../document/edits";
import { renameRegion, setSoil } from "../document/operations";
import type { Path } from "../document/tree";
import { deleteVertex, insertVertex, moveVertices, pointsOf, replacePoints } from "../document/vertices";
import type { JsonSchema } from "../engine/engine";
import { TableForm } from "../forms/TableForm";
import { TextInput } from "../forms/TextInput";
import { readCoordinates, readPastedPoints } from "../geometry/coordinates";
import { computeArea } from "../geometry/plane";
import { schema } from "../session";
import * as state from "../state";
import { tab } from "./tabs";

const kinds: Record<Chain["kind"], string> = {
  region: "Region",
  line: "Line",
  ground: "Ground",
  layer: "Layer boundary",
  water: "Water table",
  piezometric: "Piezometric line",
  drawdown: "Water table after drawdown",
  surface: "Slip surface",
  exclude: "Excluded area",
  through: "Surfaces pass here",
  window: "Window of block search",
  monitor: "Monitor",
  support: "Support",
  section: "Line of discharge",
  windowBox: "Window of block search",
  throughBox: "Surfaces pass here",
  centres: "Centres of circles",
  centre: "Centre of slip circle",
  box: "Box",
};

/** The schema of a table at a path: names of materials and supports, and places in lists, are skipped. */
export function findSchema(root: JsonSchema | null, path: Path): JsonSchema | null {
  let at = root;
  for (const step of path) {
    if (!at) return null;
    if (typeof step === "number") at = at.items ?? null;
    else at = at.properties?.[step] ?? (typeof at.additionalProperties === "object" ? at.additionalProperties : null);
  }
  return at;
}

const write = (value: number) => writeNumber(Number(value.toFixed(6)));

/** A coordinate of a vertex; all that shares it moves. */
function PointRow({ chain, index }: { chain: Chain; index: number }) {
  const { x, y } = chain.points[index]!;
  const c = state.chains.value.indexOf(chain);
  const vertex = state.vertices.value.find(({ corners }) => corners.some((corner) => corner.chain === c && corner.index === index));
  if (!vertex) return null;
  const set = (which: 0 | 1, typed: string) => {
    const value = Number(typed.replace("−", "-"));
    if (typed.trim() === "" || Number.isNaN(value)) {
      state.notice.value = { text: `“${typed}” is not a coordinate.`, bad: true };
      return;
    }
    const to = which === 0 ? ([value, vertex.at[1]] as const) : ([vertex.at[0], value] as const);
    state.attempt("Move a vertex", () => moveVertices(state.tree.value, state.chains.value, [{ vertex, to }], state.vertices.value));
  };
  const add = () => {
    const points = pointsOf(chain);
    const next = points[(index + 1) % points.length]!;
    const at = [(vertex.at[0] + next[0]) / 2, (vertex.at[1] + next[1]) / 2] as const;
    state.attempt("Insert a vertex", () => insertVertex(state.tree.value, state.chains.value, at, c));
  };
  const isLast = !chain.closed && index === chain.points.length - 1;
  const name = `Point ${index + 1}`;
  return (
    <tr class={state.selectedVertex.value === vertex ? "chosen" : undefined}>
      <th scope="row">{index + 1}</th>
      <td>
        <TextInput aria-label={`${name}, x`} value={write(x.value)} commit={(typed) => set(0, typed)} />
      </td>
      <td>
        <TextInput aria-label={`${name}, y`} value={write(y.value)} commit={(typed) => set(1, typed)} />
      </td>
      <td class="row-tools">
        <button type="button" title="Insert a point after this one" aria-label={`Insert a point after ${index + 1}`} disabled={isLast || chain.single} onClick={add}>
          +
        </button>
        <button
          type="button"
          title="Delete this point"
          aria-label={`Delete point ${index + 1}`}
          onClick={() => state.attempt("Delete a vertex", () => deleteVertex(state.tree.value, state.chains.value, vertex))}
        >
          −
        </button>
      </td>
    </tr>
  );
}

function PointTable({ chain }: { chain: Chain }) {
  const paste = (event: ClipboardEvent) => {
    const points = readPastedPoints(event.clipboardData?.getData("text/plain") ?? "");
    // A single number goes into its cell.
    if (!points || points.length < 2) return;
    event.preventDefault();
    state.attempt(`Paste ${points.length} points`, () => applyEdits(state.tree.value.text, replacePoints(state.tree.value, chain, points)));
  };
  return (
    <table class="points" onPaste={paste}>
      <caption>Points. A table pasted from a spreadsheet replaces them.</caption>
      <thead>
        <tr>
          <th scope="col">
            <span class="unseen">Number</span>
          </th>
          <th scope="col">x [m]</th>
          <th scope="col">y [m]</th>
          <th scope="col">
            <span class="unseen">Change</span>
          </th>
        </tr>
      </thead>
      <tbody>
        {chain.points.map((_, index) => (
          <PointRow key={index} chain={chain} index={index} />
        ))}
      </tbody>
    </table>
  );
}

function SoilChoice({ region, soil }: { region: string; soil: string | null }) {
  const known = state.soils.value;
  return (
    <label class="plain-field">
      Soil
      <select value={soil ?? ""} onChange={(e) => void state.attempt(`Set the soil of ${region}`, () => setSoil(state.tree.value, region, e.currentTarget.value))}>
        {!soil && <option value="">none</option>}
        {soil && !known.includes(soil) && <option value={soil}>{soil} (not described yet)</option>}
        {known.map((name) => (
          <option key={name}>{name}</option>
        ))}
      </select>
    </label>
  );
}

function NameField({ chain }: { chain: Chain }) {
  const rename = (to: string) => {
    const tree = state.tree.value;
    state.attempt(`Rename ${chain.name}`, () =>
      chain.kind === "region" ? renameRegion(tree, chain.name, to.trim()) : applyEdits(tree.text, setValue(tree, [...chain.owner, "name"], JSON.stringify(to.trim()))),
    );
  };
  return (
    <label class="plain-field">
      Name
      <TextInput value={chain.name} commit={rename} />
    </label>
  );
}

const drawn: readonly string[] = ["points", "bottom", "at", "first", "heads", "water_table", "name", "x"];

function ChainPanel({ chain }: { chain: Chain }) {
  const named = ["region", "line", "surface", "exclude", "monitor", "layer"].includes(chain.kind);
  const table = findSchema(schema.value, chain.owner);
  const hasForm = table && ["surface", "support", "through", "window", "drawdown", "layer"].includes(chain.kind);
  return (
    <>
      <h2>
        {kinds[chain.kind]} {named ? `“${chain.name}”` : chain.kind === "support" ? `“${chain.name}”` : ""}
      </h2>
      {named && <NameField chain={chain} />}
      {chain.kind === "region" && <SoilChoice region={chain.name} soil={chain.soil} />}
      {chain.closed && <p class="muted">Area {Math.abs(computeArea(pointsOf(chain))).toFixed(2)} m²</p>}
      <PointTable chain={chain} />
      {hasForm && <TableForm path={chain.owner} schema={table} without={chain.kind === "support" ? ["first", "heads"] : drawn} />}
      <DeleteButton what={named ? chain.name : kinds[chain.kind].toLowerCase()} />
    </>
  );
}

function DeleteButton({ what }: { what: string }) {
  return (
    <p class="tools">
      <button type="button" onClick={deleteSelected}>
        Delete {what}
      </button>
    </p>
  );
}

function VertexPanel() {
  const vertex = state.selectedVertex.value!;
  const sharing = vertex.corners.map(({ chain }) => state.chains.value[chain]!);
  const set = (typed: string) => {
    const { point, fault } = readCoordinates(typed, vertex.at);
    if (point) moveSelectedTo(point);
    else state.notice.value = { text: fault, bad: true };
  };
  return (
    <>
      <h2>Vertex</h2>
      <label class="plain-field">
        Place: x,y or @dx,dy or length&lt;angle
        <TextInput value={`${write(vertex.at[0])}, ${write(vertex.at[1])}`} commit={set} />
      </label>
      <h3>Shared by</h3>
      <ul class="parts">
        {sharing.map((chain, i) => (
          <li key={i}>
            <button type="button" onClick={() => (state.selection.value = { kind: "chain", id: chain.id })}>
              {kinds[chain.kind]} {chain.name}
            </button>
          </li>
        ))}
      </ul>
      <DeleteButton what="vertex" />
    </>
  );
}

function LoadPanel({ index }: { index: number }) {
  const load = state.loads.value[index];
  const table = findSchema(schema.value, ["surcharge", index]);
  if (!load) return null;
  return (
    <>
      <h2>Surcharge “{load.name}”</h2>
      {table && <TableForm path={load.path} schema={table} always={["name", "x", "load"]} />}
      <DeleteButton what={load.name} />
    </>
  );
}

function Overview() {
  const chains = state.chains.value.filter(({ kind }) => kind !== "box");
  const built = state.regions.value.filter(({ id }) => id.startsWith("section."));
  if (!chains.length)
    return (
      <>
        <h2>Nothing is drawn yet</h2>
        <ol class="steps">
          <li>
            Choose <b>Draw a region</b> (R) and click its corners, or type them: <code>0,0</code> Enter, <code>44,0</code> Enter …; an empty Enter closes it.
          </li>
          <li>
            Describe its soil under <button type="button" class="link" onClick={() => (tab.value = "soils")}>Soils</button>.
          </li>
          <li>Drag its vertices: the factor of safety follows.</li>
        </ol>
      </>
    );
  return (
    <>
      <h2>{state.title.value || "Section"}</h2>
      <ul class="parts">
        {chains.map((chain) => (
          <li key={chain.id}>
            {chain.kind === "region" && <span class="swatch" style={{ background: findSoilColour(chain.soil ?? "") }} />}
            <button type="button" onClick={() => (state.selection.value = { kind: "chain", id: chain.id })}>
              {chain.kind === "region" ? chain.name : `${kinds[chain.kind]}${chain.name && chain.name !== kinds[chain.kind] ? ` ${chain.name}` : ""}`}
            </button>
            {chain.kind === "region" && <SoilOf soil={chain.soil} />}
          </li>
        ))}
        {state.loads.value.map((load, index) => (
          <li key={`load ${index}`}>
            <button type="button" onClick={() => (state.selection.value = { kind: "load", index })}>
              Surcharge {load.name}
            </button>
          </li>
        ))}
      </ul>
      {built.length > 0 && (
        <>
          <h3>Regions built from layers</h3>
          <ul class="parts">
            {built.map(({ id, name, soil }) => (
              <li key={id}>
                <span class="swatch" style={{ background: findSoilColour(soil) }} />
                {name} <SoilOf soil={soil} />
              </li>
            ))}
          </ul>
        </>
      )}
    </>
  );
}

const SoilOf = ({ soil }: { soil: string | null }) => <span class="muted"> {soil || "no soil"}</span>;

export function SelectionPanel() {
  const now = state.selection.value;
  if (now.kind === "vertex" && state.selectedVertex.value) return <VertexPanel />;
  if (now.kind === "load") return <LoadPanel index={now.index} />;
  const chain = state.selectedChain.value;
  return chain ? <ChainPanel key={chain.id} chain={chain} /> : <Overview />;
}
