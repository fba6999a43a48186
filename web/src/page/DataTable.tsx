// SPDX-License-Identifier: MIT
/** A table with a caption that scrolls inside its own box where the screen is narrow. */
import type { ComponentChildren } from "preact";

import { Scroller } from "./Scroller";

/** Head of a column: its name, or that of a column of numbers; false where the table lacks the column. */
type Cell = string | false | { number: ComponentChildren; class: string };

/** Heads of columns of numbers, which are aligned to the right; empty for others. */
export function numbers(...names: ComponentChildren[]): Cell[] {
  return names.map((name) => (name ? { number: name, class: "number" } : false));
}

/** The same, in several lines where that makes the column narrower. */
export function wrapped(...names: ComponentChildren[]): Cell[] {
  return names.map((name) => (name ? { number: name, class: "number chart-wrap" } : false));
}

export function TableHead({ cells }: { cells: Cell[] }) {
  return (
    <thead>
      <tr>
        {cells
          .filter((cell) => cell !== false)
          .map((cell, i) => (
            <th key={i} scope="col" class={typeof cell === "string" ? undefined : cell.class}>
              {typeof cell === "string" ? cell : cell.number}
            </th>
          ))}
      </tr>
    </thead>
  );
}

interface Props {
  caption: string;
  /** The caption is for screen readers only: the heading above has the same text. */
  quiet?: boolean;
  class?: string;
  /** Above rows; a table without it has a body of its own. */
  head?: Cell[];
  children: ComponentChildren;
}

export function DataTable({ caption, quiet, class: name, head, children }: Props) {
  return (
    <Scroller class="table-box" label={caption}>
      <table class={name}>
        <caption class={quiet ? "unseen" : undefined}>{caption}</caption>
        {head && <TableHead cells={head} />}
        {head ? <tbody>{children}</tbody> : children}
      </table>
    </Scroller>
  );
}

/** A table among charts, with its heading above it. */
export function ChartTable(props: { label: string; class?: string; head: Cell[]; children: ComponentChildren }) {
  return (
    <Scroller class="chart-scroll" label={props.label}>
      <table class={props.class ? `chart-table ${props.class}` : "chart-table"}>
        <TableHead cells={props.head} />
        <tbody>{props.children}</tbody>
      </table>
    </Scroller>
  );
}

/** Names and values in two columns. */
export function Facts({ caption, rows }: { caption: string; rows: [string, ComponentChildren][] }) {
  return (
    <DataTable caption={caption} quiet class="facts-table">
      <tbody>
        {rows.map(([name, value]) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            <td>{value}</td>
          </tr>
        ))}
      </tbody>
    </DataTable>
  );
}

/** "σ_t" with its index below the line. */
export function SymbolText({ text }: { text: string }) {
  const [base, index] = text.split("_");
  return (
    <i class="symbol">
      {base}
      {index && <sub>{index}</sub>}
    </i>
  );
}
