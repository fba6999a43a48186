// SPDX-License-Identifier: MIT
/** What is selected: name, soil and points of a region or line, coordinates of a vertex, keys of a load or support. Without a selection: the parts of the section. */
import { findSoilColour } from "../canvas/layers";
import { moveSelectedTo } from "../canvas/moving";
import type { Chain } from "../document/chains";
import { applyEdits, setValue } from "../document/edits";
import { renameRegion, setSoil } from "../document/operations";
import { splitLine } from "../document/transform";
import { type Corner, pointsOf } from "../document/vertices";
import { findSchema } from "../forms/schema";
import { TableForm } from "../forms/TableForm";
import { TextInput } from "../forms/TextInput";
import { readCoordinates } from "../geometry/coordinates";
import { computeArea } from "../geometry/plane";
import { schema } from "../session";
import * as state from "../state";
import { length } from "../units";
import { BackgroundPart } from "./BackgroundPart";
import { AddCondition, DeleteButton, LineConditions, PartPanel } from "./PartPanel";
import { PointTable, writeShown } from "./PointTable";
import { tab } from "./tabs";
import { TransformPart } from "./TransformPart";

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

const drawn: readonly string[] = ["points", "bottom", "at", "first", "heads", "water_table", "name", "x", "corners", "centre", "box"];

function ChainPanel({ chain }: { chain: Chain }) {
  const named = ["region", "line", "surface", "exclude", "monitor", "layer", "through", "throughBox", "window", "windowBox", "section", "centre"].includes(chain.kind);
  const table = findSchema(schema.value, chain.owner);
  const hasForm = table && ["surface", "support", "drawdown", "layer", "centre", "centres"].includes(chain.kind);
  return (
    <>
      <h2>
        {kinds[chain.kind]} {named ? `“${chain.name}”` : chain.kind === "support" ? `“${chain.name}”` : ""}
      </h2>
      {named && <NameField chain={chain} />}
      {chain.kind === "region" && <SoilChoice region={chain.name} soil={chain.soil} />}
      {chain.closed && <p class="muted">Area {writeArea(Math.abs(computeArea(pointsOf(chain))))}</p>}
      {chain.kind === "line" && <LineConditions name={chain.name} />}
      <PointTable chain={chain} />
      {hasForm && <TableForm path={chain.owner} schema={table} without={chain.kind === "support" ? ["first", "heads"] : drawn} />}
      <TransformPart chain={chain} />
      <DeleteButton what={state.selectedChains.value.length > 1 ? `${state.selectedChains.value.length} shapes` : named ? chain.name : kinds[chain.kind].toLowerCase()} />
    </>
  );
}

const writeArea = (area: number) => `${(area / length.value.size ** 2).toFixed(2)} ${length.value.name}²`;

function VertexPanel() {
  const vertex = state.selectedVertex.value!;
  const sharing = vertex.corners.map(({ chain }) => state.chains.value[chain]!);
  const set = (typed: string) => {
    const { point, fault } = readCoordinates(typed, vertex.at, length.value.size);
    if (point) moveSelectedTo(point);
    else state.notice.value = { text: fault, bad: true };
  };
  return (
    <>
      <h2>Vertex</h2>
      <label class="plain-field">
        Place: x,y or @dx,dy or length&lt;angle
        <TextInput value={`${writeShown(vertex.at[0])}, ${writeShown(vertex.at[1])}`} commit={set} />
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
      <SplitButtons sharing={sharing} corners={vertex.corners} />
      <DeleteButton what="vertex" />
    </>
  );
}

/** Named lines that have the vertex between their ends can be split there. */
function SplitButtons({ sharing, corners }: { sharing: readonly Chain[]; corners: readonly Corner[] }) {
  const inner = corners.filter(({ index }, i) => ["line", "section", "through"].includes(sharing[i]!.kind) && index > 0 && index < sharing[i]!.points.length - 1);
  if (!inner.length) return null;
  return (
    <p class="tools">
      {inner.map(({ chain: c, index }) => {
        const chain = state.chains.value[c]!;
        return (
          <button key={chain.id} type="button" onClick={() => void state.attempt(`Split ${chain.name}`, () => splitLine(state.tree.value, chain, index))}>
            Split {chain.name} here
          </button>
        );
      })}
    </p>
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

/** Parts of the search and conditions, and what can be added to sides and lines. */
function PartList() {
  const parts = state.parts.value;
  return (
    <>
      <h3>Conditions and search</h3>
      <ul class="parts">
        {parts.map((part) => (
          <li key={part.id}>
            <button type="button" onClick={() => (state.selection.value = { kind: "part", id: part.id })}>
              {part.title}
            </button>
            {part.word && <span class="muted"> {part.word.replaceAll("_", " ")}</span>}
          </li>
        ))}
      </ul>
      <AddCondition />
    </>
  );
}

function Overview() {
  const chains = state.chains.value.filter(({ kind }) => kind !== "box" && kind !== "centre");
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
        <p>A survey, a drawing or a GeoStudio file dropped on the page is imported.</p>
        <BackgroundPart />
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
      <PartList />
      <BackgroundPart />
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
  const part = state.selectedPart.value;
  if (part) return <PartPanel key={part.id} part={part} />;
  const chain = state.selectedChain.value;
  return chain ? <ChainPanel key={chain.id} chain={chain} /> : <Overview />;
}
