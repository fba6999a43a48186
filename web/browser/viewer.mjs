// SPDX-License-Identifier: MIT
// The viewer, used as a reader uses it: playing, scrubbing, fields, sequences, picking a point, turning in space.
import { join } from "node:path";

import { findNumbers, readFrame } from "./results.mjs";

const region = "Values at the picked point";
/** Other parts have selects and sliders too; those of the viewer are here. */
const findViewer = (page) => page.locator("#section");
const findSlider = (page) => findViewer(page).getByRole("slider", { name: "Frame", exact: true });

/** The picture: what takes clicks and keys, with its canvases on top of each other. */
function findStage(page) {
  return page.locator("#section [role='application']");
}

/** How many different colours a picture has: an empty canvas has one. */
async function countColours(page, png) {
  const url = `data:image/png;base64,${png.toString("base64")}`;
  return page.evaluate(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, url);
}

const settle = (page) => page.waitForTimeout(500);
const readSlider = async (page) => Number(await findSlider(page).inputValue());

async function setSlider(page, value) {
  const slider = findSlider(page);
  await slider.focus();
  await slider.fill(String(value));
  await settle(page);
}

/** Chooses by value or by text, whichever the select has. */
async function choose(page, name, { id, title }) {
  const select = findViewer(page).getByRole("combobox", { name, exact: true });
  const read = (all) => all.map((option) => ({ value: option.value, text: option.textContent }));
  const options = await select.locator("option").evaluateAll(read);
  const option = options.find((o) => o.value === id) ?? options.find((o) => o.text.trim().startsWith(title));
  if (!option) throw new Error(`the select '${name}' has no '${id}': ${options.map((o) => o.value).join(", ")}`);
  await select.selectOption(option.value);
  await settle(page);
}

const chooseSequence = (page, report, sequence) =>
  choose(page, "Sequence", { id: String(report.sequences.indexOf(sequence)), title: sequence.title });
const chooseField = (page, field) => choose(page, "Field", { id: field.name, title: field.title });

export async function checkPlaying(list, page, report, sequence) {
  await chooseSequence(page, report, sequence);
  const slider = findSlider(page);
  const last = Number(await slider.getAttribute("max"));
  const count = sequence.frames.length;
  list.expect(last === count - 1, `the slider runs over the ${count} frames`, `to ${last}`);
  await setSlider(page, 0);
  const before = await findStage(page).screenshot();
  list.expect((await countColours(page, before)) > 20, "the viewer draws the soil");
  await findViewer(page).getByRole("button", { name: "Play", exact: true }).click();
  let moved = 0;
  for (let i = 0; i < 50 && moved === 0; ++i) {
    await page.waitForTimeout(100);
    moved = await readSlider(page);
  }
  list.expect(moved > 0, "playing moves the frame on");
  const pause = findViewer(page).getByRole("button", { name: /^(Pause|Stop)$/ });
  if (await pause.count()) await pause.first().click();
  await setSlider(page, last);
  list.expect((await readSlider(page)) === last, "the slider goes to the last frame");
  const after = await findStage(page).screenshot();
  list.expect(!after.equals(before), "the last frame looks different from the first");
  await slider.press("ArrowLeft");
  list.expect((await readSlider(page)) === last - 1, "an arrow key goes one frame back");
}

export async function checkFields(list, page, sequence) {
  await setSlider(page, sequence.frames.length - 1);
  const pictures = new Set();
  const wanted = ["deviatoric_strain", "displacement", "stress_yy", "mean_stress"];
  const fields = sequence.fields.filter((field) => wanted.includes(field.name));
  for (const field of fields) {
    await chooseField(page, field);
    pictures.add((await findStage(page).screenshot()).toString("base64"));
  }
  const count = fields.length;
  list.expect(pictures.size === count, `${count} fields give ${count} pictures`, `${pictures.size}`);
}

/** Picks a point of the last frame by a click, and holds what is shown against the packed arrays. */
export async function checkPicking(list, page, report, sequence) {
  const frame = sequence.frames.length - 1;
  const field = sequence.fields.find((f) => f.name === "displacement") ?? sequence.fields[0];
  await chooseSequence(page, report, sequence);
  await setSlider(page, frame);
  await chooseField(page, field);
  const box = await findStage(page).boundingBox();
  const values = page.getByRole("region", { name: region });
  for (const [x, y] of [[0.5, 0.55], [0.4, 0.6], [0.5, 0.7], [0.3, 0.5]]) {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    await settle(page);
    if ((await values.count()) && findNumbers(await values.innerText()).length >= 3) break;
  }
  const text = await values.innerText();
  await comparePicked(list, page, report, sequence, frame, field, text, "click");
  const before = text;
  await findStage(page).focus();
  for (const key of ["ArrowRight", "ArrowRight", "ArrowDown"]) await page.keyboard.press(`Shift+${key}`);
  await settle(page);
  const after = (await values.count()) ? await values.innerText() : "";
  const other = after !== before && findNumbers(after).length >= 3;
  list.expect(other, "Shift with arrow keys picks another point", after.slice(0, 200));
  if (other) await comparePicked(list, page, report, sequence, frame, field, after, "keys");
}

/** Some point of the frame has the x, y and value that the region shows. */
async function comparePicked(list, page, report, sequence, frame, field, text, by) {
  const numbers = findNumbers(text);
  const dimension = report.model.dimension;
  const positions = await readFrame(page, sequence.positions, frame);
  const values = await readFrame(page, field.values, frame);
  const near = (a, b) => Math.abs(a - b) <= Math.max(0.005 * Math.abs(b), 0.0051);
  const shows = (value, unit) => numbers.some((n) => near(n, value / unit.si));
  const found = values.findIndex((value, i) => {
    const x = positions.slice(i * dimension, i * dimension + dimension);
    return x.every((coordinate) => shows(coordinate, report.units.length)) && shows(value, field.unit);
  });
  list.expect(/\bx\b/.test(text) && /\by\b/.test(text), `the picked point (${by}) shows x and y`, text.slice(0, 200));
  list.expect(found >= 0, `the picked point (${by}) has the values of a point of the results`, text.slice(0, 300));
}

export async function checkSequences(list, page, report) {
  for (const sequence of report.sequences) {
    await chooseSequence(page, report, sequence);
    const max = Number(await findSlider(page).getAttribute("max").catch(() => "0"));
    const count = sequence.frames.length;
    list.expect(max === count - 1, `the sequence '${sequence.title}' has ${count} frames`, `${max + 1}`);
  }
}

/** Turns the view in space; in a 3D model it is there from the start. */
export async function takeSpace(list, page, out) {
  const control = findViewer(page).getByRole("button", { name: "3D", exact: true });
  if (await control.count()) await control.click();
  await settle(page);
  const before = await findStage(page).screenshot({ path: join(out, "viewer-3d.png") });
  list.expect((await countColours(page, before)) > 20, "the view in space draws the soil");
  const box = await findStage(page).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2 + 20, { steps: 6 });
  await page.mouse.up();
  await settle(page);
  const after = await findStage(page).screenshot();
  list.expect((await countColours(page, after)) > 20 && !after.equals(before), "dragging turns it");
}
