// SPDX-License-Identifier: MIT
/** Switches set by the reader, by name: hidden series, shown panels. */
import { useState } from "preact/hooks";

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
