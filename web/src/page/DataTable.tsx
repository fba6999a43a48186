// SPDX-License-Identifier: MIT
/** Tables from their columns; a wide one scrolls inside its own box where the screen is narrow. */
import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

interface Props {
  class: string;
  /** Name of the scrolled content, for screen readers. */
  label: string;
  children: ComponentChildren;
}

export function Scroller({ class: name, label, children }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const [scrolls, setScrolls] = useState(false);
  useEffect(() => {
    const element = box.current;
    if (!element) return;
    const observer = new ResizeObserver(() => setScrolls(element.scrollWidth > element.clientWidth + 1));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return (
    <div ref={box} class={name} role="group" aria-label={label} tabIndex={scrolls ? 0 : undefined}>
      {children}
    </div>
  );
}

/**
 * Words on a column: "name" for the names of the rows, "number" for numbers, which are aligned to the right, "wrap" for
 * numbers under a head in several lines; others are classes of its cells.
 */
type Kind = "name" | "number" | "wrap" | "prose" | "name number" | "number muted" | "surface-remarks" | "value";

/** Head of a column and its cells; without a value where the table lacks the column. */
export type Column<Row> =
  | [head: ComponentChildren, cell: (row: Row, i: number) => ComponentChildren, kind?: Kind]
  | false
  | null
  | undefined;

interface TableProps<Row> {
  class?: string;
  columns: Column<NoInfer<Row>>[];
  rows: readonly Row[];
  rowClass?: (row: NoInfer<Row>, i: number) => string | undefined | false;
  /** Rows below the others. */
  children?: ComponentChildren;
}

const headClass = (kind = "") =>
  kind === "wrap" ? "number chart-wrap" : kind.includes("number") ? "number" : undefined;
const cellClass = (kind = "") => kind.replace("name", "").replace("wrap", "number").trim() || undefined;

export function TableHead<Row>({ columns }: { columns: Column<Row>[] }) {
  return (
    <thead>
      <tr>
        {columns.map(
          (column, i) =>
            column && (
              <th key={i} scope="col" class={headClass(column[2])}>
                {column[0]}
              </th>
            ),
        )}
      </tr>
    </thead>
  );
}

export function TableRows<Row>({ columns, rows, rowClass }: TableProps<Row>) {
  return (
    <>
      {rows.map((row, i) => (
        <tr key={i} class={rowClass?.(row, i) || undefined}>
          {columns.map((column, k) => {
            if (!column) return null;
            const [, cell, kind] = column;
            if (!kind?.startsWith("name")) return <td key={k} class={cellClass(kind)}>{cell(row, i)}</td>;
            return <th key={k} scope="row" class={cellClass(kind)}>{cell(row, i)}</th>;
          })}
        </tr>
      ))}
    </>
  );
}

function Table<Row>(props: TableProps<Row>) {
  return (
    <>
      <TableHead columns={props.columns} />
      <tbody>
        <TableRows {...props} />
        {props.children}
      </tbody>
    </>
  );
}

/** A table with a caption; `quiet`: for screen readers only, where the heading above has the same text. */
export function CaptionedTable(props: {
  caption: string;
  quiet?: boolean;
  class?: string;
  children: ComponentChildren;
}) {
  return (
    <Scroller class="table-box" label={props.caption}>
      <table class={props.class}>
        <caption class={props.quiet ? "unseen" : undefined}>{props.caption}</caption>
        {props.children}
      </table>
    </Scroller>
  );
}

export function DataTable<Row>(props: TableProps<Row> & { caption: string; quiet?: boolean }) {
  return (
    <CaptionedTable caption={props.caption} quiet={props.quiet} class={props.class}>
      <Table {...props} />
    </CaptionedTable>
  );
}

/** A table among charts, with its heading above it. */
export function ChartTable<Row>(props: TableProps<Row> & { label: string }) {
  return (
    <Scroller class="chart-scroll" label={props.label}>
      <table class={props.class ? `chart-table ${props.class}` : "chart-table"}>
        <Table {...props} />
      </table>
    </Scroller>
  );
}

/** Names and values in two columns. */
export function Facts({ caption, rows }: { caption: string; rows: [string, ComponentChildren][] }) {
  return (
    <CaptionedTable caption={caption} quiet class="facts-table">
      <tbody>
        <TableRows columns={[["", ([name]) => name, "name"], ["", ([, value]) => value]]} rows={rows} />
      </tbody>
    </CaptionedTable>
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
