// SPDX-License-Identifier: MIT
// Draws, describes, moves and undoes with the keyboard alone.
import { readText, waitForFactor } from "./session.mjs";

/** Presses Tab until the focused element has a name or id. */
async function tabTo(page, wanted, key = "Tab") {
  for (let i = 0; i < 150; ++i) {
    const name = await page.evaluate(() => {
      const element = document.activeElement;
      if (element === document.body) return "";
      return `#${element.id} .${element.getAttribute("class")} ${element.getAttribute("aria-label") ?? element.labels?.[0]?.textContent ?? element.textContent ?? ""}`;
    });
    if (wanted.test(name)) return true;
    await page.keyboard.press(key);
  }
  return false;
}

async function typeLine(page, text) {
  await page.keyboard.type(text);
  await page.keyboard.press("Enter");
}

export async function useKeysAlone(list, page) {
  list.expect(await tabTo(page, /\.section tool/), "the canvas takes the focus by Tab");
  await page.keyboard.press("r");
  for (const point of ["0,0", "40,0", "40,5", "30,5", "12,14", "0,14"]) await typeLine(page, point);
  await page.keyboard.press("Enter");
  list.expect(/\[12, 14\], \[0, 14\]\]/.test(await readText(page)), "a region is drawn by typed coordinates");
  list.expect(await tabTo(page, /#tab-/), "the panels are reached by Tab");
  for (let i = 0; i < 5 && !(await page.evaluate(() => document.activeElement.id === "tab-soils")); ++i) {
    await page.keyboard.press("ArrowLeft");
    await page.waitForTimeout(50);
  }
  list.expect(await tabTo(page, /Describe soil/), "the undescribed soil is reached");
  await page.keyboard.press("Enter");
  await page.locator("#field-materials-soil-model:focus").waitFor();
  for (const [label, value] of [[/Unit weight/, "18"], [/Cohesion \*|Cohesion/, "5"], [/Friction angle/, "28"]]) {
    list.expect(await tabTo(page, label), `the field ${label} is reached`);
    await page.keyboard.type(value);
    await page.keyboard.press("Tab");
  }
  const factor = await waitForFactor(page);
  list.note(`F = ${factor}`);
  list.expect(await tabTo(page, /\.section tool/, "Shift+Tab"), "the canvas is reached again");
  for (let i = 0; i < 3; ++i) await page.keyboard.press(".");
  for (let i = 0; i < 2; ++i) await page.keyboard.press("ArrowRight");
  const text = await readText(page);
  list.expect(/\[1[3-9](\.\d+)?, 14\]/.test(text), "arrow keys move the selected vertex", text.match(/points = .*/)?.[0]);
  await page.keyboard.press("Control+z");
  list.expect(/\[12, 14\]/.test(await readText(page)), "Ctrl+Z undoes the move in one step");
}
