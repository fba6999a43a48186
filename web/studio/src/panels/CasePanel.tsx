// SPDX-License-Identifier: MIT
/** Forms of the blocks of the case, generated from the schema; those that are given come first. */
import { findNode, type Path } from "../document/tree";
import type { JsonSchema } from "../engine/engine";
import { TableForm } from "../forms/TableForm";
import { schema } from "../session";
import * as state from "../state";

interface Block {
  path: Path;
  schema: JsonSchema;
}

const elsewhere = new Set(["materials", "regions", "surcharge", "support", "geometry"]);
const usual = ["project", "analysis", "lem", "initial", "earthquake", "fem", "bounds", "output"];

/** Tables of the first level, and tables in them that are given. */
function listBlocks(root: JsonSchema): Block[] {
  const tables = Object.entries(root.properties ?? {}).filter(([key, part]) => part.properties && !elsewhere.has(key));
  const rank = (key: string) => (usual.includes(key) ? usual.indexOf(key) : usual.length);
  return tables
    .toSorted(([a], [b]) => rank(a) - rank(b))
    .flatMap(([key, part]) => [
      { path: [key], schema: part },
      ...Object.entries(part.properties ?? {})
        .filter(([, inner]) => inner.properties)
        .map(([name, inner]) => ({ path: [key, name], schema: inner })),
    ]);
}

function BlockPart({ path, schema: table }: Block) {
  const given = findNode(state.tree.value, path) !== null;
  const name = path.join(".");
  const faults = state.messages.value.filter(({ key, severity }) => key.startsWith(name) && severity === "error").length;
  const meaning = (table.description ?? "").replace(/^(.+?\.)(?: .*)?$/s, "$1");
  return (
    <details class={given ? "block given" : "block"} open={faults > 0}>
      <summary>
        <b>[{name}]</b> <span class="muted">{meaning}</span>
        {faults > 0 && <span class="bad"> · {faults} {faults === 1 ? "error" : "errors"}</span>}
      </summary>
      <TableForm path={path} schema={table} />
    </details>
  );
}

const titleSchema: JsonSchema = { properties: { title: { type: "string", description: "Title of the case in reports and plots." } } };

export function CasePanel() {
  const root = schema.value;
  if (!root) return <p class="muted">The forms are loaded with the engine.</p>;
  const blocks = listBlocks(root);
  const isGiven = ({ path }: Block) => findNode(state.tree.value, path) !== null;
  const isUsual = ({ path }: Block) => path.length === 1 && usual.includes(String(path[0]));
  const first = blocks.filter((block) => isGiven(block) || isUsual(block));
  const others = blocks.filter((block) => !first.includes(block));
  return (
    <>
      <h2>Case</h2>
      <TableForm path={[]} schema={titleSchema} always={["title"]} />
      {first.map((block) => (
        <BlockPart key={block.path.join(".")} {...block} />
      ))}
      <h3>Further blocks</h3>
      {others.map((block) => (
        <BlockPart key={block.path.join(".")} {...block} />
      ))}
    </>
  );
}
