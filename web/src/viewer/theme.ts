// SPDX-License-Identifier: MIT
/** The page as the drawing needs it: its colours, and what happens on it. */

const light = {
  ground: "#ffffff",
  ink: "#1b2330",
  muted: "#5b6675",
  line: "#d5dae1",
  accent: "#0b62a8",
  panel: "#f5f7f9",
};

export type Theme = typeof light & {
  water: string;
  /** Soil that is cut by the view, symbols of supports. */
  symbol: string;
};

/** For paper. */
export const paperTheme: Theme = { ...light, water: "#1565c0", symbol: light.ink };

export function isDark(): boolean {
  return document.documentElement.dataset.theme === "dark";
}

/** Reads the variables of the page. */
export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const names = Object.keys(light) as (keyof typeof light)[];
  const read = names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]);
  const colours = Object.fromEntries(read) as typeof light;
  return { ...colours, water: isDark() ? "#5aa9ff" : "#1565c0", symbol: colours.ink };
}

/** Calls back when the reader changes from light to dark or back. */
export function watchTheme(changed: () => void): () => void {
  const observer = new MutationObserver(changed);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
  return () => observer.disconnect();
}

/** Calls the handlers of events by name; returns what ends that. */
export function listenTo(target: EventTarget, handlers: Record<string, (event: never) => void>): () => void {
  const pairs = Object.entries(handlers) as [string, EventListener][];
  for (const [name, handle] of pairs) target.addEventListener(name, handle, { passive: false });
  return () => pairs.forEach(([name, handle]) => target.removeEventListener(name, handle));
}
