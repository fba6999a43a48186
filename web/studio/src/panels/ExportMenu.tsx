// SPDX-License-Identifier: MIT
/** The section as a file: picture, print, drawing, points, case. */
import { useSignal } from "@preact/signals";

import { formatFactor } from "../../../src/page/format";
import { pointsOf } from "../document/vertices";
import { writePoints } from "../output/csv";
import { downloadBlob, downloadText } from "../output/download";
import { drawPng, writeSvg } from "../output/picture";
import { summarise } from "../output/summary";
import { file, setting } from "../session";
import * as state from "../state";

const stem = () => (file.value?.path ?? "case.toml").replace(/^.*\//, "").replace(/\.toml$/, "");

/** What stands below the picture. */
function listRemarks(): string[] {
  const found = state.solved.value;
  const remarks = [state.title.value || stem()];
  if (found?.factor && !state.isSolving.value)
    remarks.push(`Factor of safety ${formatFactor(found.factor)}, ${found.title ?? found.method}, quick search of ${found.searched} circles`);
  return remarks;
}

const makeSvg = () => writeSvg(state.title.value || stem(), listRemarks());

/** A document is printed on paper: its picture has light colours. */
function makeLightSvg(): string {
  const { dataset } = document.documentElement;
  const { theme } = dataset;
  dataset.theme = "light";
  try {
    return writeSvg(state.title.value || stem(), []);
  } finally {
    dataset.theme = theme;
  }
}

/** The library of documents is loaded with the first one. */
async function makeDocument(): Promise<Blob> {
  const [{ writeDocument }, summary, picture] = await Promise.all([import("../output/wordDocument"), summarise(), drawPng(makeLightSvg())]);
  const { width, height } = await createImageBitmap(picture);
  return writeDocument(summary, { data: new Uint8Array(await picture.arrayBuffer()), width, height });
}

function listLines(): { kind: string; name: string; points: readonly (readonly [number, number])[] }[] {
  const lines = state.chains.value.map((chain) => ({ kind: chain.kind as string, name: chain.name, points: pointsOf(chain) }));
  const found = state.solved.value;
  if (found?.surface.length && !state.isSolving.value) lines.push({ kind: "slip surface", name: found.method, points: found.surface });
  return lines;
}

export function ExportMenu() {
  const isOpen = useSignal(false);
  const workspace = setting.value?.workspace;
  const item = (name: string, act: () => void | Promise<void>) => (
    <li key={name}>
      <button
        type="button"
        onClick={() => {
          isOpen.value = false;
          Promise.resolve()
            .then(act)
            .catch((error) => (state.notice.value = { text: error instanceof Error ? error.message : String(error), bad: true }));
        }}
      >
        {name}
      </button>
    </li>
  );
  return (
    <details class="menu" open={isOpen.value} onToggle={(e) => (isOpen.value = e.currentTarget.open)}>
      <summary>Export</summary>
      <ul>
        {item("Picture, SVG", () => downloadText(`${stem()}.svg`, makeSvg(), "image/svg+xml"))}
        {item("Picture, PNG", async () => downloadBlob(`${stem()}.png`, await drawPng(makeSvg())))}
        {item("Print, or PDF by the browser …", () => print())}
        {item("Document, DOCX", async () => downloadBlob(`${stem()}.docx`, await makeDocument()))}
        {item("Points, CSV", () => downloadText(`${stem()}.csv`, writePoints(listLines()), "text/csv"))}
        {workspace && item("Drawing, DXF", async () => downloadBlob(`${stem()}.dxf`, await workspace.exportCase(state.text.value)))}
        {item("Case file, TOML", () => downloadText(`${stem()}.toml`, state.text.value, "application/toml"))}
      </ul>
    </details>
  );
}
