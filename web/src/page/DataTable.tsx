/** A table with a caption that scrolls inside its own box where the screen is narrow. */
import type { ComponentChildren } from "preact";

import { Scroller } from "./Scroller";

interface Props {
  caption: string;
  /** The caption is read aloud only: the heading above says the same. */
  quiet?: boolean;
  class?: string;
  children: ComponentChildren;
}

export function DataTable({ caption, quiet, class: name, children }: Props) {
  return (
    <Scroller class="table-box" label={caption}>
      <table class={name}>
        <caption class={quiet ? "unseen" : undefined}>{caption}</caption>
        {children}
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
