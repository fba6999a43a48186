/** The colours of the page as the drawing needs them. */

export interface Theme {
  ground: string;
  ink: string;
  muted: string;
  line: string;
  accent: string;
  panel: string;
  water: string;
  /** Soil that is cut by the view, symbols of supports. */
  symbol: string;
}

const light = {
  ground: "#ffffff",
  ink: "#1b2330",
  muted: "#5b6675",
  line: "#d5dae1",
  accent: "#0b62a8",
  panel: "#f5f7f9",
};
const dark = {
  ground: "#14181d",
  ink: "#e6eaef",
  muted: "#9aa5b1",
  line: "#333c46",
  accent: "#6fb3ee",
  panel: "#1c2229",
};

/** For paper. */
export const paperTheme: Theme = { ...light, water: "#1565c0", symbol: light.ink };

export function isDark(): boolean {
  const chosen = document.documentElement.dataset.theme;
  if (chosen === "dark" || chosen === "light") return chosen === "dark";
  return matchMedia("(prefers-color-scheme: dark)").matches;
}

/** Reads the variables of the page; where it sets none, plain colours of the same kind. */
export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const base = isDark() ? dark : light;
  const read = (name: keyof typeof light) => style.getPropertyValue(`--${name}`).trim() || base[name];
  const colours = {
    ground: read("ground"),
    ink: read("ink"),
    muted: read("muted"),
    line: read("line"),
    accent: read("accent"),
    panel: read("panel"),
  };
  return { ...colours, water: isDark() ? "#5aa9ff" : "#1565c0", symbol: colours.ink };
}

/** Calls back when the reader changes from light to dark or back. */
export function watchTheme(changed: () => void): () => void {
  const query = matchMedia("(prefers-color-scheme: dark)");
  const observer = new MutationObserver(changed);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme", "class", "style"] });
  query.addEventListener("change", changed);
  return () => {
    observer.disconnect();
    query.removeEventListener("change", changed);
  };
}
