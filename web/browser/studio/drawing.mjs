// SPDX-License-Identifier: MIT
// Draws the dry slope from nothing with the mouse and typed coordinates, drags, undoes everything, saves.
import { join } from "node:path";

import { clickAt, findPixel, readFactor, readText, waitForFactor } from "./session.mjs";

async function type(page, text) {
  const field = page.locator("#typed-coordinates");
  await field.fill(text);
  await field.press("Enter");
}

async function fillField(page, label, value) {
  const field = page.getByLabel(label).first();
  await field.fill(value);
  await field.press("Tab");
}

/** 2:1, 10 m high on 5 m of the same sand: the dry slope of the examples, with its weight of 15.6 kN/m³. */
export async function drawDrySlope(list, page, out) {
  const from = Date.now();
  await page.getByText("File", { exact: true }).click();
  await page.getByRole("button", { name: "New case" }).click();
  const empty = await readText(page);
  await page.getByRole("button", { name: /^Draw a region/ }).click();
  await clickAt(page, [0, 0]);
  for (const typed of ["44,0", "@0,5", "@-12,0", "22.360679775<153.434948823"]) await type(page, typed);
  await page.screenshot({ path: join(out, "drawing.png") });
  await type(page, "0,15");
  await clickAt(page, [0, 0]);
  const drawn = await readText(page);
  list.expect(/points = \[\[0, 0\], \[44, 0\], \[44, 5\], \[32, 5\], \[12, 15\], \[0, 15\]\]/.test(drawn), "the region has the drawn corners", drawn);
  await page.getByRole("tab", { name: "Soils" }).click();
  await page.getByRole("button", { name: "Describe soil" }).click();
  await fillField(page, /^Unit weight/, "15.6");
  await fillField(page, /^Cohesion/, "2");
  await fillField(page, /^Friction angle/, "30");
  const factor = await waitForFactor(page);
  list.note(`drawn and calculated in ${((Date.now() - from) / 1000).toFixed(1)} s: F = ${factor}`);
  list.expect(Date.now() - from < 120_000, "the dry slope is drawn in less than two minutes");
  // Bishop's factor of the example by `talus run` is 1.439.
  list.expect(Math.abs(factor - 1.44) < 0.015, "its factor is that of the example", String(factor));
  await page.screenshot({ path: join(out, "drawn.png") });
  return { empty, factor };
}

/** Drags the crest towards the toe: steeper, so that the factor falls while the mouse moves. */
export async function dragCrest(list, page, before, out) {
  const [x, y] = await findPixel(page, [12, 15]);
  const [x2] = await findPixel(page, [18, 15]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  const seen = new Set();
  const from = Date.now();
  const steps = 40;
  for (let i = 1; i <= steps; ++i) {
    await page.mouse.move(x + ((x2 - x) * i) / steps, y);
    await page.waitForTimeout(25);
    seen.add(await readFactor(page));
  }
  const seconds = (Date.now() - from) / 1000;
  await page.screenshot({ path: join(out, "dragging.png") });
  await page.mouse.up();
  list.note(`${seen.size} different factors in ${seconds.toFixed(1)} s of dragging`);
  list.expect(seen.size >= 5, "the factor follows the mouse", [...seen].join(", "));
  const after = await waitForFactor(page, (factor) => factor < before - 0.1);
  list.expect(after < before - 0.1, "a steeper slope has a smaller factor", `${before} and ${after}`);
  const text = await readText(page);
  list.expect(/\[18, 15\]/.test(text), "the text has the new place");
  return after;
}

export async function undoAll(list, page, empty) {
  const undo = page.getByRole("button", { name: /^Undo/ });
  const names = [];
  while (!(await undo.isDisabled())) {
    names.push((await undo.getAttribute("aria-label")).replace("Undo: ", ""));
    await undo.click();
  }
  list.note(`undone: ${names.join(", ")}`);
  list.expect(names[0] === "Move a vertex" && names.at(-1) === "Draw a region", "steps have names", names.join(", "));
  list.expect((await readText(page)) === empty, "after undoing everything the text is that of the beginning");
  const redo = page.getByRole("button", { name: /^Redo/ });
  while (!(await redo.isDisabled())) await redo.click();
  list.expect(/\[18, 15\]/.test(await readText(page)), "everything can be redone");
}

/** One mistake of each kind gives a message at its field, in the text and on the canvas. */
export async function makeMistakes(list, page, out) {
  await page.getByRole("tab", { name: "Soils" }).click();
  const cohesion = page.getByLabel(/^Cohesion/).first();
  const note = page.locator("#field-materials-soil-cohesion-note");
  for (const [typed, expected] of [["abc", /not a number/], ["2,5", /decimal point/], ["-5", /At least 0/]]) {
    await cohesion.fill(typed);
    await cohesion.press("Tab");
    list.expect(expected.test(await note.innerText()), `“${typed}” is refused at the field`, await note.innerText());
  }
  await cohesion.fill("3 m");
  await cohesion.press("Tab");
  const shown = page.locator(".messages li.error");
  await shown.first().waitFor();
  list.expect(/cohesion/.test(await shown.first().innerText()), "a wrong unit is an error of the checker", await shown.first().innerText());
  await note.locator(".bad").waitFor();
  list.expect((await note.locator(".bad").count()) > 0, "and stands at its field");
  await page.screenshot({ path: join(out, "mistake.png") });
  await page.keyboard.press("Control+z");
  await shown.first().waitFor({ state: "detached" });
  list.expect((await readFactor(page)) !== null || (await waitForFactor(page)) > 0, "undone, the factor is back");
}

export async function saveAs(list, page) {
  await page.getByText("File", { exact: true }).click();
  await page.getByRole("button", { name: "Save as …" }).click();
  await page.locator(".file-name", { hasText: "drawn.toml" }).waitFor();
  list.expect((await page.locator(".changed").count()) === 0, "after saving nothing is changed");
}
