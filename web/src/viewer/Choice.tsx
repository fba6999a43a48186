// SPDX-License-Identifier: MIT
/** A select with its name before it. */
export interface ChoiceProps {
  label: string;
  value: string;
  choose: (value: string) => void;
  /** Values with their titles. */
  items: [string, string][];
}

export function Choice(props: ChoiceProps) {
  const { label, value, choose } = props;
  return (
    <label class="viewer-choice">
      <span>{label}</span>
      <select aria-label={label} value={value} onChange={(event) => choose(event.currentTarget.value)}>
        {props.items.map(([item, title]) => (
          <option key={item} value={item} selected={item === value}>
            {title}
          </option>
        ))}
      </select>
    </label>
  );
}
