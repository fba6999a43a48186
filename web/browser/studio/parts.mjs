// SPDX-License-Identifier: MIT
// Imports by dropping, copies and splits of shapes, search and conditions on the canvas, background, units, tables, own entries.
import { readFileSync } from "node:fs";
import { basename, join } from "node:path";

import { checkAccessibility } from "../accessibility.mjs";
import { findPixel, readText, waitForFactor } from "./session.mjs";

const tables = join(import.meta.dirname, "../../../tests/data/tables");
const survey = join(tables, "own_slope_surface.csv");

async function type(page, ...lines) {
  const field = page.locator("#typed-coordinates");
  for (const line of lines) {
    await field.fill(line);
    await field.press("Enter");
  }
}

/** Drops files on the page as a file manager does. */
async function dropFiles(page, files) {
  const data = files.map(({ name, bytes, type: kind = "" }) => ({ name, kind, text: Buffer.from(bytes).toString("base64") }));
  const transfer = await page.evaluateHandle((given) => {
    const made = new DataTransfer();
    for (const { name, kind, text } of given) {
      const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      made.items.add(new File([bytes], name, { type: kind }));
    }
    return made;
  }, data);
  await page.dispatchEvent(".studio", "drop", { dataTransfer: transfer });
}

const readFiles = (...paths) => paths.map((path) => ({ name: basename(path), bytes: readFileSync(path) }));

async function press(page, ...keys) {
  await page.locator("svg.section").focus();
  for (const key of keys) await page.keyboard.press(key);
}

/** The text of the open file after saving it: the editor shows only a part of a long one. */
async function saveAndRead(page, path) {
  await page.keyboard.press("Control+s");
  await page.locator(".changed").waitFor({ state: "detached" });
  return readFileSync(path, "utf8");
}

const showSection = (page) => page.getByRole("tab", { name: "Section" }).click();

/** The survey of 60 points as a region of the page, and as a case by the program with boreholes below it. */
export async function importSurvey(list, page, out) {
  await page.getByText("File", { exact: true }).click();
  await page.getByRole("button", { name: "New case" }).click();
  await dropFiles(page, readFiles(survey));
  const dialog = page.getByRole("dialog", { name: "Import" });
  await dialog.waitFor();
  list.expect(/60 points/.test(await dialog.innerText()), "the survey has 60 points", await dialog.innerText());
  await checkAccessibility(list, page, "dialog of an import");
  await page.screenshot({ path: join(out, "import.png") });
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" });
  list.expect(!/polygon|ground =/.test(await readText(page)), "Escape imports nothing");
  await dropFiles(page, readFiles(survey));
  await dialog.getByLabel(/^Region of this case/).check();
  await dialog.getByRole("button", { name: "Import", exact: true }).click();
  await dialog.waitFor({ state: "detached" });
  const points = /points = (\[\[.*\]\])/.exec(await readText(page));
  list.expect(points !== null && JSON.parse(points[1]).length === 62, "60 points and two corners of the base are a region", points?.[1].slice(0, 80));
  await page.screenshot({ path: join(out, "imported.png") });
  await page.keyboard.press("Control+z");
  await dropFiles(page, readFiles(survey, join(tables, "own_slope_base.csv")));
  await dialog.getByLabel(/Level of the base/).fill("-20");
  await dialog.getByRole("button", { name: "Import", exact: true }).click();
  await dialog.getByRole("heading", { name: "Imported" }).waitFor();
  list.expect(/strengths and weights/.test(await dialog.innerText()), "the program names what it recognised", await dialog.innerText());
  await dialog.getByRole("button", { name: "Close" }).click();
  const text = await readText(page);
  list.expect(/ground = \[/.test(text) && (text.match(/\[\[geometry\.layer\]\]/g) ?? []).length === 2, "two tables are a ground and two layers", text.slice(0, 300));
  await dropFiles(page, [{ name: "notes.docx", bytes: "x" }]);
  list.expect(/cannot be imported/.test(await page.locator(".hint").innerText()), "other files are refused with a sentence");
}

/** Copies, a mirror, a parallel and a split of the drawn line, by keyboard and forms. */
export async function changeShapes(list, page, path, out) {
  const read = () => saveAndRead(page, path);
  await press(page, "g");
  await type(page, "40,9", "50,9", "58,9", "");
  const apply = async (operation, button, fields) => {
    if (!(await page.locator(".transform select").isVisible())) await page.locator(".transform > summary").click();
    await page.locator(".transform select").selectOption(operation);
    for (const [label, value] of fields) await page.locator(".transform").getByLabel(label).fill(value);
    await page.locator(".transform").getByRole("button", { name: button }).click();
  };
  await apply("shift", "Move", [[/^Δx/, "0"], [/^Δy/, "1"]]);
  list.expect(/name = "line 2"\npoints = \[\[40, 10\], \[50, 10\], \[58, 10\]\]/.test(await read()), "a line is copied");
  await apply("offset", "Parallel", [[/^Distance/, "-0.5"]]);
  list.expect(/points = \[\[40, 8\.5\], \[50, 8\.5\], \[58, 8\.5\]\]/.test(await read()), "a parallel runs below it");
  await apply("mirrorX", "Mirror", [[/^x of the line/, "40"]]);
  list.expect(/points = \[\[40, 9\], \[30, 9\], \[22, 9\]\]/.test(await read()), "a copy is mirrored");
  if (!(await page.locator(".transform select").isVisible())) await page.locator(".transform > summary").click();
  await page.locator(".transform details > summary").click();
  await page.locator(".transform details").getByLabel("line 2", { exact: true }).check();
  await page.screenshot({ path: join(out, "shapes.png") });
  await page.locator(".transform").getByLabel(/Keep the original/).uncheck();
  await apply("shift", "Move", [[/^Δx/, "1"], [/^Δy/, "0"]]);
  const moved = await read();
  list.expect(/\[\[41, 9\], \[51, 9\], \[59, 9\]\]/.test(moved) && /\[\[41, 10\], \[51, 10\], \[59, 10\]\]/.test(moved), "two lines move together");
  await showSection(page);
  await press(page, "s");
  await type(page, "55,12", "55,7", "");
  list.expect(/\[\[41, 9\], \[51, 9\], \[55, 9\]\]/.test(await read()), "a line is split where another crosses it");
}

/** Ranges, a circle, a window and conditions are drawn by keys, dragged by the mouse, edited in their forms and deleted. */
export async function drawSearch(list, page, path, out) {
  const read = () => saveAndRead(page, path);
  await page.getByRole("button", { name: "Further tools" }).click();
  await checkAccessibility(list, page, "further tools");
  await page.getByRole("button", { name: /^Entry range/ }).click();
  await type(page, "10,0", "20,0");
  await press(page, "x");
  await type(page, "34,0", "46,0");
  list.expect(/entry = \[10, 20\]\nexit = \[34, 46\]/.test(await read()), "entry and exit ranges are drawn");
  const before = await waitForFactor(page);
  const [x, y] = await findPixel(page, [34, 10]);
  const [x2] = await findPixel(page, [40, 8]);
  await press(page, "Escape", "Escape");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move((x + x2) / 2, y + 4, { steps: 4 });
  await page.mouse.move(x2, y + 8, { steps: 4 });
  await page.mouse.up();
  list.expect(/exit = \[(39|40)(\.\d+)?, 46\]/.test(await read()), "the end of a range is dragged", (await read()).match(/exit = .*/)?.[0]);
  list.note(`F = ${before} before, ${await waitForFactor(page)} after`);
  await press(page, "ArrowRight");
  await press(page, "o");
  await type(page, "34,24", "34,4");
  await showSection(page);
  const radius = page.getByLabel(/^Radius/).first();
  list.expect((await radius.inputValue()) === "20", "a circle has its radius", await radius.inputValue());
  await radius.fill("19");
  await radius.press("Tab");
  list.expect(/centre = \[34, 24\]\nradius = 19/.test(await read()), "its radius is edited in the form");
  await press(page, "p");
  await type(page, "20,6");
  list.expect(/\[\[output\.monitor\]\]\nname = "monitor"\nat = \[20, 6\]/.test(await read()), "a monitor is drawn");
  await showSection(page);
  await press(page, "Escape", "Escape");
  for (const side of ["bottom", "left"]) {
    await page.locator("form.one-line select").nth(1).selectOption(side);
    await page.locator("form.one-line").getByRole("button", { name: "Add" }).click();
    if (side === "left") await page.getByLabel(/^Fix/).first().selectOption("normal");
    await press(page, "Escape");
  }
  await page.screenshot({ path: join(out, "search.png") });
  list.expect((await page.locator(".part.symbol").count()) === 2, "conditions have symbols on the canvas");
  const [bx, by] = await findPixel(page, [30, 0]);
  await page.mouse.click(bx, by + 14);
  list.expect(/Fixity on bottom/.test(await page.locator(".panel h2").innerText()), "a symbol is selected by a click", await page.locator(".panel h2").innerText());
  await press(page, "Delete");
  list.expect(!/on = "bottom"/.test(await read()) && /fix = "normal"/.test(await read()), "and deleted");
}

/** A picture of 200 by 100 pixels is placed by two points. */
export async function placePicture(list, page, path, out) {
  const read = () => saveAndRead(page, path);
  const bytes = await page.evaluate(async () => {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [200, 100];
    const pen = canvas.getContext("2d");
    pen.fillStyle = "#e8d8b0";
    pen.fillRect(0, 0, 200, 100);
    pen.fillStyle = "#7a5c2e";
    pen.fillRect(0, 50, 200, 50);
    const blob = await new Promise((resolve) => canvas.toBlob(resolve));
    return [...new Uint8Array(await blob.arrayBuffer())];
  });
  await dropFiles(page, [{ name: "scan.png", bytes, type: "image/png" }]);
  await page.locator("image.picture").waitFor();
  const now = await page.locator("image.picture").getAttribute("transform");
  const [scale, , , , x0, y0] = /\((.*)\)/.exec(now)[1].split(" ").map(Number);
  // Pixels (0, 100) and (200, 50) of the picture.
  await press(page, "k");
  await type(page, `${x0},${y0 - 100 * scale}`, `${x0 + 200 * scale},${y0 - 50 * scale}`);
  await page.locator("#picture-point-1").fill("10,2");
  await page.locator("#picture-point-2").fill("50,12");
  await page.getByRole("button", { name: "Place the picture" }).click();
  const placed = /\((.*)\)/.exec(await page.locator("image.picture").getAttribute("transform"))[1].split(" ").map(Number);
  // 0.2 m a pixel, its lower left corner at (10, 2).
  const expected = [0.2, 0, 0, -0.2, 10, 22];
  list.expect(placed.every((value, i) => Math.abs(value - expected[i]) < 1e-6), "two points scale and shift the picture", placed.join(", "));
  await page.screenshot({ path: join(out, "background.png") });
  list.expect(!/scan/.test(await read()), "the case does not name it");
}

/** Feet and pounds: forms, typed coordinates and loads convert; the text keeps its units. */
export async function switchUnits(list, page, path, out) {
  const read = () => saveAndRead(page, path);
  const before = await read();
  await page.locator("button.units").click();
  await page.getByRole("tab", { name: "Soils" }).click();
  const field = page.locator("#field-materials-fill-unit_weight");
  if (!(await field.isVisible())) await page.locator(".soil > summary", { hasText: "fill" }).click();
  const shown = Number(await field.inputValue());
  const written = Number(/\[materials\.fill\][^[]*?unit_weight = ([\d.]+)/.exec(before)[1]);
  // 1 pcf is 0.45359237 kg · 9.80665 m/s² over (0.3048 m)³.
  const pcf = (0.45359237 * 9.80665) / 0.3048 ** 3 / 1000;
  list.expect(Math.abs(shown * pcf - written) < 1e-3, "a unit weight is shown in pcf", `${shown} pcf, ${written} kN/m³`);
  await page.screenshot({ path: join(out, "units.png") });
  list.expect((await read()) === before, "the text stays as it is");
  await page.getByRole("tab", { name: "Soils" }).click();
  await field.fill("125");
  await field.press("Tab");
  const after = /\[materials\.fill\][^[]*?unit_weight = (\S+)/.exec(await read())[1];
  list.expect(Math.abs(Number(after) - 125 * pcf) < 1e-6, "a plain number stays one in kN/m³", after);
  await press(page, "m");
  await type(page, "10,10", "@100,0");
  list.expect(/Length 100\.000 ft/.test(await page.locator(".hint").innerText()), "coordinates are typed in feet", await page.locator(".hint").innerText());
  await press(page, "Escape");
  await page.keyboard.press("Control+z");
  await page.locator("button.units").click();
}

/** A table of the clipboard fills a list; an own entry of the library survives a reload. */
export async function pasteAndKeep(list, page, path) {
  const read = () => saveAndRead(page, path);
  await showSection(page);
  await press(page, "Escape", "Escape");
  await page.locator(".parts").getByRole("button", { name: /^Surcharge/ }).click();
  const row = page.getByLabel("X, row 1", { exact: true });
  if (!(await row.isVisible())) await page.locator(".rows-field > summary").first().click();
  await row.evaluate((element) => {
    const data = new DataTransfer();
    data.setData("text/plain", "from\n12\n22.5\n");
    element.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  });
  list.expect(/x = \[12, 22\.5\]/.test(await read()), "a column of a spreadsheet fills a list", (await read()).match(/^x = .*/m)?.[0]);
  await page.keyboard.press("Control+z");
  await page.getByRole("tab", { name: "Soils" }).click();
  const part = page.locator(".soil", { has: page.locator("b", { hasText: /^clay$/ }) });
  if (!(await part.locator(".library > summary").isVisible())) await part.locator(":scope > summary").click();
  await part.locator(".library > summary").click();
  await part.getByRole("button", { name: "Keep “clay” as an own entry" }).click();
  await part.getByLabel("Source or remark").fill("borehole 3");
  await part.getByLabel("Source or remark").press("Tab");
  await page.waitForTimeout(1500);
}

export async function findOwnEntry(list, page) {
  await page.getByRole("tab", { name: "Soils" }).click();
  const part = page.locator(".soil", { has: page.locator("b", { hasText: /^fill$/ }) });
  if (!(await part.locator(".library > summary").isVisible())) await part.locator(":scope > summary").click();
  await part.locator(".library > summary").click();
  await part.locator(".library select").selectOption("clay");
  list.expect((await part.getByLabel("Source or remark").inputValue()) === "borehole 3", "an own entry is there in another window");
}
