// SPDX-License-Identifier: MIT
/** The bar at the top: contents, colours, printing with light colours, all parts drawn and unfolded. It stays while the page moves. */
import { useEffect, useRef, useState } from "preact/hooks";

import type { Report } from "../contract";
import { drawEverything } from "./Part";
import { ThemeButton } from "./ThemeButton";
import { formatDate } from "./format";

let screenTheme: string | undefined;
let opened: HTMLDetailsElement[] = [];

function beforePrinting() {
  drawEverything();
  const root = document.documentElement;
  if (screenTheme === undefined) screenTheme = root.dataset.theme;
  root.dataset.theme = "light";
  for (const details of document.querySelectorAll<HTMLDetailsElement>("details:not([open])")) {
    details.open = true;
    opened.push(details);
  }
}

function afterPrinting() {
  if (screenTheme) document.documentElement.dataset.theme = screenTheme;
  screenTheme = undefined;
  for (const details of opened) details.open = false;
  opened = [];
}

const quote = (text: string) => `"${text.replace(/["\\]/g, "\\$&").replace(/[\n\r<>]/g, " ")}"`;

/** Prints once every part has had the time to draw itself. */
async function printReport() {
  beforePrinting();
  await new Promise((resolve) => setTimeout(resolve, 600));
  window.print();
}

/** Text at the head and foot of every page: style sheets cannot read it from the document. */
export function preparePrinting({ title: name, result: { project, provenance } }: Report) {
  const title = [name, project.project].filter(Boolean).join(" · ");
  const state = [project.revision && `Revision ${project.revision}`, formatDate(provenance.started)]
    .filter(Boolean)
    .join(" · ");
  const boxes: [string, string][] = [
    ["top-left", quote(title)],
    ["top-right", quote(state)],
    ["bottom-left", quote(`Talus ${provenance.version} · input ${provenance.input_hash}`)],
    ["bottom-right", '"Page " counter(page) " of " counter(pages)'],
  ];
  const look = 'font: 7.5pt system-ui, "Segoe UI", Roboto, "Liberation Sans", Arial, sans-serif; color: #56626f;';
  const style = document.createElement("style");
  const rules = boxes.map(([place, content]) => `@${place} { content: ${content}; ${look} }`);
  style.textContent = `@page { ${rules.join(" ")} }`;
  document.head.append(style);
  addEventListener("beforeprint", beforePrinting);
  addEventListener("afterprint", afterPrinting);
}

interface Entry {
  id: string;
  label: string;
}

/** The part that the reader is in: the last one whose head has passed under the bar. */
function useCurrent(entries: Entry[]): string {
  const [current, setCurrent] = useState(entries[0]?.id ?? "");
  useEffect(() => {
    let asked = false;
    const look = () => {
      asked = false;
      let found = entries[0]?.id ?? "";
      for (const { id } of entries) {
        const top = document.getElementById(id)?.getBoundingClientRect().top;
        // The section is beside the answer on a wide screen: there the answer is what one reads.
        if (top !== undefined && top < 160 && !(id === "section" && scrollY < 40)) found = id;
      }
      const atEnd = innerHeight + scrollY >= document.documentElement.scrollHeight - 4;
      setCurrent(atEnd && scrollY > 0 ? (entries.at(-1)?.id ?? found) : found);
    };
    const onScroll = () => {
      if (!asked) requestAnimationFrame(look);
      asked = true;
    };
    addEventListener("scroll", onScroll, { passive: true });
    return () => removeEventListener("scroll", onScroll);
  }, [entries]);
  return current;
}

export function TopBar({ entries }: { entries: Entry[] }) {
  const current = useCurrent(entries);
  const list = useRef<HTMLUListElement>(null);
  useEffect(() => {
    // On a narrow screen the contents scroll sideways: the current entry is kept in sight.
    const entry = list.current?.querySelector<HTMLElement>("[aria-current]");
    if (list.current && entry) list.current.scrollLeft = entry.offsetLeft - list.current.clientWidth / 3;
  }, [current]);
  return (
    <header class="top-bar no-print">
      <a class="brand" href="#answer" aria-label="Talus: to the top of the report">
        <svg viewBox="0 0 16 16" width="18" height="18" aria-hidden="true">
          <path d="M1 3h5l5 8h4v3H1z" fill="currentColor" />
        </svg>
        <span>Talus</span>
      </a>
      <nav aria-label="Contents">
        <ul ref={list}>
          {entries.map(({ id, label }) => (
            <li key={id}>
              <a href={`#${id}`} aria-current={id === current ? "true" : undefined}>
                {label}
              </a>
            </li>
          ))}
        </ul>
      </nav>
      <div class="tools">
        <ThemeButton />
        <button type="button" onClick={printReport}>
          Print<span class="wide-only"> or PDF</span>
        </button>
      </div>
    </header>
  );
}
