// SPDX-License-Identifier: MIT
/** An input that keeps what is being typed while answers of the engine draw the page anew; it commits when it is left or on Enter. */
import { useSignal } from "@preact/signals";

interface Props {
  value: string;
  id?: string;
  placeholder?: string;
  inputMode?: "decimal";
  "aria-label"?: string;
  "aria-describedby"?: string;
  "aria-invalid"?: boolean;
  /** Returns false for a text that is refused: it stays in the field. */
  commit: (typed: string) => boolean | void;
}

export function TextInput({ value, commit, ...others }: Props) {
  const draft = useSignal<string | null>(null);
  const leave = () => {
    if (draft.value === null) return;
    if (draft.value === value || commit(draft.value) !== false) draft.value = null;
  };
  const press = (event: KeyboardEvent) => {
    if (event.key === "Enter") leave();
    else if (event.key === "Escape") draft.value = null;
  };
  return (
    <input
      spellcheck={false}
      autocomplete="off"
      {...others}
      value={draft.value ?? value}
      onInput={(e) => (draft.value = e.currentTarget.value)}
      onBlur={leave}
      onKeyDown={press}
    />
  );
}
