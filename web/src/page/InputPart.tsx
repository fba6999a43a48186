// SPDX-License-Identifier: MIT
/** The whole input as it was understood: what the case file gave, and every default. */
import { useMemo, useState } from "preact/hooks";

import { report } from "../state";
import { CopyButton, Lazy, Part } from "./Part";
import { CaptionedTable, type Column, TableHead, TableRows } from "./DataTable";
import { formatCount, formatUnit } from "./format";
import { formatInput, type InputBlock, type InputRow, listBlocks, writeToml } from "./inputRows";

const columns: Column<InputRow>[] = [
  ["Key", (row) => <code>{row.key}</code>, "name"],
  ["Value", (row) => formatInput(row.value), "value"],
  ["Unit", (row) => (row.value === null ? "" : formatUnit(row.unit))],
  ["From", ({ given }) => <span class={`mark ${given ? "given" : "default"}`}>{given ? "given" : "default"}</span>],
];

function Block({ block, open }: { block: InputBlock; open: boolean }) {
  const rows = block.groups.flatMap((group) => group.rows);
  const given = rows.filter((row) => row.given).length;
  return (
    <details class="input-block" open={open}>
      <summary>
        <code>{block.name}</code>
        <span class="note">
          {given} given, {formatCount(rows.length - given, "default")}
        </span>
      </summary>
      <CaptionedTable caption={`Input: ${block.name}`} quiet class="input-table">
        <TableHead columns={columns} />
        {block.groups.map((group) => (
          <tbody key={group.title}>
            {group.title && (
              <tr class="group">
                <th scope="rowgroup" colSpan={4}>
                  {group.title}
                </th>
              </tr>
            )}
            <TableRows columns={columns} rows={group.rows} rowClass={(row) => (row.given ? "given" : "default")} />
          </tbody>
        ))}
      </CaptionedTable>
    </details>
  );
}

/** Rows whose key, heading or value holds the text; blocks and groups without any are left out. */
function filterBlocks(blocks: InputBlock[], text: string, onlyGiven: boolean): InputBlock[] {
  const sought = text.trim().toLowerCase();
  const fits = (block: InputBlock, title: string, row: InputRow) =>
    (!onlyGiven || row.given) &&
    (!sought ||
      `${block.name}.${row.key} ${title} ${formatInput(row.value)} ${row.unit}`.toLowerCase().includes(sought));
  return blocks
    .map((block) => ({
      ...block,
      groups: block.groups
        .map((group) => ({ ...group, rows: group.rows.filter((row) => fits(block, group.title, row)) }))
        .filter((group) => group.rows.length > 0),
    }))
    .filter((block) => block.groups.length > 0);
}

function Echo() {
  const [text, setText] = useState("");
  const [onlyGiven, setOnlyGiven] = useState(false);
  const blocks = useMemo(() => listBlocks(report.value.result.input), [report.value]);
  const shown = filterBlocks(blocks, text, onlyGiven);
  const count = shown.flatMap((block) => block.groups).reduce((sum, group) => sum + group.rows.length, 0);
  const narrowed = text.trim() !== "" || onlyGiven;
  return (
    <>
      <form class="filter no-print" onSubmit={(event) => event.preventDefault()}>
        <label>
          Filter{" "}
          <input
            type="search"
            placeholder="damping, kPa, curve …"
            value={text}
            onInput={(event) => setText(event.currentTarget.value)}
          />
        </label>
        <label>
          <input type="checkbox" checked={onlyGiven} onChange={() => setOnlyGiven(!onlyGiven)} /> only what the case
          file gave
        </label>
        <span class="note" role="status">
          {formatCount(count, "value")}
        </span>
      </form>
      {shown.length === 0 && <p>No key, value or unit fits.</p>}
      <div class="input-blocks">
        {shown.map((block) => (
          <Block key={`${block.name} ${narrowed}`} block={block} open={narrowed} />
        ))}
      </div>
    </>
  );
}

/** An image, so that nothing in it can act on the page. */
function Picture() {
  const { input_picture: picture } = report.value;
  if (!picture) return null;
  return (
    <figure class="input-picture">
      <img
        alt="Section with its soils, water, loads, supports and search ranges"
        src={`data:image/svg+xml;charset=utf-8,${encodeURIComponent(picture)}`}
      />
    </figure>
  );
}

const lead =
  "Every value that the calculation used, also those that the case file did not name. " +
  "A copied case file gives the same calculation again.";

export function InputPart() {
  if (Object.keys(report.value.result.input).length === 0)
    return (
      <Part id="input" title="Input as it was understood" newPage>
        <p>Not known: the results hold no summary of the input.</p>
      </Part>
    );
  const tools = (
    <>
      <CopyButton label="Copy case file" text={() => writeToml(report.value.result.input, true)} />
      <CopyButton label="Copy with defaults" text={() => writeToml(report.value.result.input, false)} />
    </>
  );
  return (
    <Part id="input" title="Input as it was understood" lead={lead} tools={tools} newPage>
      <Picture />
      <Lazy height={500}>{() => <Echo />}</Lazy>
    </Part>
  );
}
