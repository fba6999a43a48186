// SPDX-License-Identifier: MIT
/** Frames of the charts, and what a reader sets beside them. */
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";

interface Props {
  title: ComponentChildren;
  /** Beside the heading: buttons. */
  tools?: ComponentChildren;
  children: ComponentChildren;
}

/** The charts of one part of the page; `id`: word of its heading. */
export function ChartSection({ id, title, tools, children }: Props & { id: string }) {
  const heading = <h3 id={`chart-${id}-title`}>{title}</h3>;
  return (
    <section class="chart-section" aria-labelledby={`chart-${id}-title`}>
      {tools ? (
        <div class="chart-head">
          {heading}
          {tools}
        </div>
      ) : (
        heading
      )}
      {children}
    </section>
  );
}

/** One figure with its heading; `label`: its name for assistive technology. */
export function Figure(props: Props & { label: string; class?: string }) {
  return (
    <figure class={props.class ?? "chart-figure"} aria-label={props.label}>
      <div class="chart-head">
        <h4>{props.title}</h4>
        {props.tools}
      </div>
      {props.children}
    </figure>
  );
}

/** A choice from a list, with its name before it. */
export function Select<T extends string | number>(props: {
  label: string;
  value: T;
  options: [value: T, title: string][];
  onChange: (value: string) => void;
}) {
  return (
    <label>
      {props.label}{" "}
      <select value={props.value} onChange={(e) => props.onChange(e.currentTarget.value)}>
        {props.options.map(([value, title]) => (
          <option key={value} value={value}>
            {title}
          </option>
        ))}
      </select>
    </label>
  );
}

/** Switches by name, and a function that draws the box of one. */
export function useToggles<N extends string>(first: Record<N, boolean>) {
  const [on, setOn] = useState(first);
  const draw = (name: N, title: string) => (
    <label key={name}>
      <input type="checkbox" checked={on[name]} onChange={(e) => setOn({ ...on, [name]: e.currentTarget.checked })} />
      {title}
    </label>
  );
  return [on, draw] as const;
}
