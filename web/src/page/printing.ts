// SPDX-License-Identifier: MIT
/** Prepares printing: light colours, all parts drawn, everything unfolded, a running title. */
import { formatDate } from "./format";
import { drawEverything } from "./Part";
import type { Report } from "../contract";

let theme: string | undefined;
let opened: HTMLDetailsElement[] = [];

function beforePrinting() {
  drawEverything();
  const root = document.documentElement;
  if (theme === undefined) theme = root.dataset.theme;
  root.dataset.theme = "light";
  for (const details of document.querySelectorAll<HTMLDetailsElement>("details:not([open])")) {
    details.open = true;
    opened.push(details);
  }
}

function afterPrinting() {
  if (theme) document.documentElement.dataset.theme = theme;
  theme = undefined;
  for (const details of opened) details.open = false;
  opened = [];
}

const quote = (text: string) => `"${text.replace(/["\\]/g, "\\$&").replace(/[\n\r<>]/g, " ")}"`;

/** Prints once every part has had the time to draw itself. */
export async function printReport() {
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
