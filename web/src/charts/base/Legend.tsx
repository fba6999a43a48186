// SPDX-License-Identifier: MIT
/** Beside a chart: its legend, whose entries switch series on and off, lists and switches, and the button that saves a table. */
import { useState } from "preact/hooks";

import { report } from "../../state";
import { type CsvColumn, makeFileName, saveFile, writeCsv } from "./rows";
import type { SeriesStyle } from "./styles";

interface LegendItem {
  id: string;
  title: string;
  style: SeriesStyle;
  /** The value under the crosshair; an empty text keeps its space, so that nothing moves when a value appears. */
  value?: string;
}

function Swatch({ style, marker }: { style: SeriesStyle; marker?: boolean }) {
  return (
    <svg class="chart-swatch" width="30" height="12" viewBox="0 0 30 12" aria-hidden="true">
      <line x1="1" y1="6" x2="29" y2="6" stroke={style.colour} stroke-width="2" stroke-dasharray={style.dash} />
      {marker && <Symbol style={style} x={15} y={6} />}
    </svg>
  );
}

/** The symbols as Plot draws them, near enough for a legend. */
export function Symbol({ style, x, y }: { style: SeriesStyle; x: number; y: number }) {
  const common = { stroke: style.colour, "stroke-width": 1.8, fill: "var(--ground)" };
  const at = `translate(${x} ${y})`;
  if (style.symbol === "square") return <rect x="-3.5" y="-3.5" width="7" height="7" transform={at} {...common} />;
  if (style.symbol === "triangle") return <path d="M0 -4.5L4.2 3H-4.2Z" transform={at} {...common} />;
  if (style.symbol === "diamond") return <path d="M0 -5L3.6 0L0 5L-3.6 0Z" transform={at} {...common} />;
  if (style.symbol === "times") return <path d="M-3.5 -3.5L3.5 3.5M3.5 -3.5L-3.5 3.5" transform={at} {...common} />;
  if (style.symbol === "plus") return <path d="M-4.5 0H4.5M0 -4.5V4.5" transform={at} {...common} />;
  if (style.symbol === "star") return <path d="M-4 0H4M-2 -3.5L2 3.5M2 -3.5L-2 3.5" transform={at} {...common} />;
  return <circle r="3.8" transform={at} {...common} />;
}

interface LegendProps {
  items: LegendItem[];
  hidden?: ReadonlySet<string>;
  onToggle?: (id: string) => void;
  markers?: boolean;
}

export function Legend({ items, hidden, onToggle, markers }: LegendProps) {
  return (
    <ul class="chart-legend">
      {items.map((item) => {
        const inside = (
          <>
            <Swatch style={item.style} marker={markers} />
            <span>{item.title}</span>
            {item.value !== undefined && <span class="chart-value">{item.value}</span>}
          </>
        );
        return (
          <li key={item.id} class={hidden?.has(item.id) ? "chart-off" : undefined}>
            {onToggle ?
              <button type="button" aria-pressed={!hidden?.has(item.id)} onClick={() => onToggle(item.id)}>
                {inside}
              </button>
            : <span class="chart-entry">{inside}</span>}
          </li>
        );
      })}
    </ul>
  );
}

/** Saves `columns()` as a file named after the project and `part`. */
export function CsvButton(props: { part: string; columns: () => (CsvColumn | false)[]; what?: string }) {
  const { part, columns, what } = props;
  const save = () => {
    const content = new Blob([writeCsv(columns().filter((column) => column !== false))], { type: "text/csv;charset=utf-8" });
    saveFile(content, makeFileName(report.value.title, part));
  };
  return (
    <button type="button" class="chart-button" onClick={save}>
      Download CSV{what && `: ${what}`}
    </button>
  );
}

/** A choice between a few: radio buttons in a row. */
export function Choice<T extends string>(props: {
  label: string;
  value: T;
  options: { value: T; title: string }[];
  onChange: (value: T) => void;
}) {
  return (
    <span class="chart-choice" role="group" aria-label={props.label}>
      {props.options.map((o) => (
        <button
          type="button"
          key={o.value}
          aria-pressed={o.value === props.value}
          onClick={() => props.onChange(o.value)}
        >
          {o.title}
        </button>
      ))}
    </span>
  );
}

export type AxisKind = "linear" | "log";

interface AxisProps {
  label: string;
  value: AxisKind;
  /** Short names for narrow charts. */
  short?: boolean;
  onChange: (kind: AxisKind) => void;
}

/** A choice between a linear and a logarithmic axis. */
export function AxisChoice({ short, ...props }: AxisProps) {
  const [linear, log] = short ? ["lin", "log"] : ["linear", "logarithmic"];
  return (
    <Choice
      {...props}
      options={[
        { value: "linear", title: linear! },
        { value: "log", title: log! },
      ]}
    />
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

/** The names, a function that switches one of them, and one that clears all; `first` are those at the beginning. */
export function useSwitches(first: () => Iterable<string> = () => []) {
  const [chosen, setChosen] = useState<ReadonlySet<string>>(() => new Set(first()));
  const toggle = (name: string) => {
    const next = new Set(chosen);
    if (!next.delete(name)) next.add(name);
    setChosen(next);
  };
  const clear = () => setChosen(new Set());
  return [chosen, toggle, clear] as const;
}
