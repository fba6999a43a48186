// SPDX-License-Identifier: MIT
/** A part of the report: a section with an address, a heading, and buttons beside it. */
import type { ComponentChildren } from "preact";

interface Props {
  id: string;
  title: string;
  /** One sentence under the heading: what is seen here. */
  lead?: ComponentChildren;
  /** Starts on a new page when printed. */
  newPage?: boolean;
  /** Holds a chart section, which is a landmark with a name of its own; its heading would repeat it. */
  chart?: boolean;
  /** Buttons beside the heading; not printed. */
  tools?: ComponentChildren;
  children: ComponentChildren;
}

export function Part({ id, title, lead, newPage, chart, tools, children }: Props) {
  const names = ["part", newPage && "new-page", chart && "chart-part"].filter(Boolean).join(" ");
  return (
    <section id={id} class={names} aria-labelledby={chart ? undefined : `${id}-heading`} tabIndex={-1}>
      <div class="part-head">
        <h2 id={`${id}-heading`}>{title}</h2>
        {tools && <div class="tools no-print">{tools}</div>}
      </div>
      {lead && <p class="lead">{lead}</p>}
      {children}
    </section>
  );
}
