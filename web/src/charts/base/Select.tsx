// SPDX-License-Identifier: MIT
/** What a reader sets beside charts and drawings: lists and switches. */
import { useState } from "preact/hooks";

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
