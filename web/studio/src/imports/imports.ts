// SPDX-License-Identifier: MIT
/** Import of drawings, tables and GeoStudio files: by the program, or of plain tables of points into the present case. */
import { signal } from "@preact/signals";

import { isPicture, takePicture } from "../background/background";
import { appendEntry, EditFault, setValue, writeNumber, writePoints, writeText } from "../document/edits";
import { addChain, addRegion, emptyCase, listRegionNames, makeName, setWaterTable } from "../document/operations";
import { type CaseTree, findNode, readTree } from "../document/tree";
import { applyInTurn } from "../document/vertices";
import { findExtent, type Point } from "../geometry/plane";
import { forgetText, showCase } from "../openCase";
import { isChanged, openLocal, setting } from "../session";
import * as state from "../state";
import { type PointTable, readPointTable } from "./pointTable";

/** What becomes of dropped files. */
export type Purpose = "case" | "ground" | "region" | "line" | "water" | "surface";

export interface Pending {
  files: File[];
  /** Of a single table; null for other files. */
  table: PointTable | null;
  kind: "drawing" | "model" | "tables";
}

/** Files that wait for an answer in the dialog; null for none. */
export const pending = signal<Pending | null>(null);
/** What the program recognised, shown after an import. */
export const remarks = signal<string[] | null>(null);

const drawings = /\.(dxf|gpkg|geojson|json)$/i;
const tables = /\.(csv|txt|tsv|dat|xyz|ags)$/i;
export const accepted = ".toml,.dxf,.gpkg,.geojson,.json,.gsz,.csv,.txt,.tsv,.dat,.xyz,.ags";

const show = (text: string, bad = true) => (state.notice.value = { text, bad });

/** Dropped or chosen files: a case is opened, others wait in the dialog. */
export async function takeFiles(files: readonly File[]): Promise<void> {
  const [first] = files;
  if (!first) return;
  if (isPicture(first)) return takePicture(first);
  const names = files.map(({ name }) => name);
  if (names.some((name) => name.toLowerCase().endsWith(".toml"))) {
    if (files.length > 1) show("Drop one case file alone.");
    else if (isChanged() && state.undoNames.value.length) show("Save or undo the changes before another case is opened.");
    else openLocal(first.name, await first.text());
    return;
  }
  const unknown = names.find((name) => !drawings.test(name) && !tables.test(name) && !/\.gsz$/i.test(name));
  if (unknown) return void show(`“${unknown}” cannot be imported. Known are .toml, .dxf, .gpkg, .geojson, .gsz, .csv, .txt, .tsv, .dat, .xyz and .ags.`);
  const areTables = names.every((name) => tables.test(name));
  if (!areTables && files.length > 1) return void show("Drop a drawing or a GeoStudio file alone; several files must be tables.");
  const table = areTables && files.length === 1 && !/\.ags$/i.test(first.name) ? readPointTable(await first.text()) : null;
  remarks.value = null;
  pending.value = { files: [...files], table, kind: areTables ? "tables" : drawings.test(first.name) ? "drawing" : "model" };
}

/** The level a quarter of the width of the points below their lowest one, on a whole metre. */
export function suggestBase(points: readonly Point[]): number {
  const { low, high } = findExtent(points)!;
  return Math.floor(low[1] - Math.max(0.25 * (high[0] - low[0]), high[1] - low[1], 1));
}

const isClosed = (points: readonly Point[]) =>
  points.length > 3 && Math.hypot(points[0]![0] - points.at(-1)![0], points[0]![1] - points.at(-1)![1]) < 1e-9;

const isForward = (points: readonly Point[]) => points.every((p, i) => i === 0 || p[0] >= points[i - 1]![0]);

/** From left to right; a line that runs from right to left is turned round. */
function sortLine(points: readonly Point[]): readonly Point[] {
  if (isForward(points)) return points;
  const turned = points.toReversed();
  return isForward(turned) ? turned : points.toSorted((a, b) => a[0] - b[0]);
}

function setGround(tree: CaseTree, points: readonly Point[], base: number): string {
  if (findNode(tree, ["geometry", "polygon"]))
    throw new EditFault("This case has regions, so that it can have no ground with layers. Import the points as a region.");
  const names = listRegionNames(tree);
  const steps: ((now: CaseTree) => ReturnType<typeof setValue>)[] = [(now) => setValue(now, ["geometry", "ground"], writePoints(points))];
  if (!findNode(tree, ["geometry", "layer"])) {
    const name = makeName("ground", names);
    steps.push((now) => appendEntry(now, ["geometry", "layer"], { name: writeText(name), level: writeNumber(base) }));
    steps.push((now) => setValue(now, ["regions", name], writeText(state.soils.value[0] ?? "soil")));
  }
  return applyInTurn(tree.text, steps);
}

/** Adds points to the present case: one step of the history, named after the file. */
export function addPoints(name: string, points: readonly Point[], purpose: Exclude<Purpose, "case">, base: number): boolean {
  const tree = state.tree.value;
  const line = sortLine(points);
  const low = findExtent(points)!.low[1];
  return state.attempt(`Import ${name}`, () => {
    if (purpose === "water") return setWaterTable(tree, line);
    if (purpose === "line" || purpose === "surface") return addChain(tree, purpose, purpose === "line" ? points : line);
    if (purpose === "region" && isClosed(points))
      return addRegion(tree, points.slice(0, -1), makeName("region", listRegionNames(tree)), state.soils.value[0] ?? "soil").text;
    if (!(base < low)) throw new EditFault(`The base must be below the lowest point, ${writeNumber(low)} m.`);
    if (purpose === "ground") return setGround(tree, line, base);
    const ring: Point[] = [...line, [line.at(-1)![0], base], [line[0]![0], base]];
    return addRegion(tree, ring, makeName("ground", listRegionNames(tree)), state.soils.value[0] ?? "soil").text;
  });
}

async function encode(found: File): Promise<string> {
  const bytes = new Uint8Array(await found.arrayBuffer());
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
}

export type ImportOptions = Record<string, string | string[]>;

/** A new case by `talus import`; throws its sentence. The import is a step that can be undone to an empty case. */
export async function importCase(files: readonly File[], options: ImportOptions): Promise<void> {
  const workspace = setting.value?.workspace;
  if (!workspace) throw new Error("The page in a browser alone cannot read these files. Start talus studio, or use talus import on the command line.");
  const sent = await Promise.all(files.map(async (found) => ({ name: found.name, data: await encode(found) })));
  const answer = await workspace.importFiles(sent, options);
  if (readTree(answer.text).fault) throw new Error("The program gave no case file.");
  forgetText();
  showCase(emptyCase, null);
  state.change(`Import ${files.map(({ name }) => name).join(", ")}`, answer.text);
  ++state.opened.value;
  remarks.value = answer.remarks;
}
