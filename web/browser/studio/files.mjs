// SPDX-License-Identifier: MIT
// Files in two windows, unsaved texts after a crash, runs, and a hostile case file.
import { readFileSync } from "node:fs";

import { readFactor, readText, waitForFactor } from "./session.mjs";

async function findCohesion(page, soil) {
  // A window behind another draws nothing, and its buttons are never stable.
  await page.bringToFront();
  await page.getByRole("tab", { name: "Soils" }).click();
  const field = page.locator(`#field-materials-${soil}-cohesion`);
  if (!(await field.isVisible())) await page.locator(".soil > summary", { hasText: soil }).click();
  return field;
}

async function setCohesion(page, soil, value) {
  const field = await findCohesion(page, soil);
  await field.fill(value);
  await field.press("Tab");
}

/** Two windows change one file: the second to save is asked, and nothing is lost. */
export async function editInTwoWindows(list, first, second) {
  await waitForFactor(first);
  await waitForFactor(second);
  await setCohesion(first, "fill", "11");
  await first.getByRole("button", { name: "Save", exact: true }).click();
  await first.locator(".changed").waitFor({ state: "detached" });
  await setCohesion(second, "fill", "22");
  await second.getByRole("button", { name: "Save", exact: true }).click();
  const question = second.locator(".question");
  await question.waitFor();
  list.expect(/Nothing was overwritten/.test(await question.innerText()), "a file that has changed is not overwritten");
  await second.getByRole("button", { name: /^Open the other text/ }).click();
  list.expect(/cohesion = 11/.test(await readText(second)), "the other text can be opened");
  await second.keyboard.press("Control+z");
  list.expect(/cohesion = 22/.test(await readText(second)), "and the own one is a step back");
}

/** Two windows change different lines: both changes are merged and saved; a place that both changed keeps both. */
export async function mergeTwoWindows(list, first, second) {
  await waitForFactor(first);
  await waitForFactor(second);
  await setCohesion(first, "fill", "41");
  await first.getByRole("button", { name: "Save", exact: true }).click();
  await first.locator(".changed").waitFor({ state: "detached" });
  await setCohesion(second, "clay", "42");
  await second.getByRole("button", { name: "Save", exact: true }).click();
  await second.getByRole("button", { name: /^Merge both/ }).click();
  const merged = await readText(second);
  list.expect(/cohesion = 41/.test(merged) && /cohesion = 42/.test(merged), "changes of different lines are merged", merged);
  await second.getByRole("button", { name: "Save", exact: true }).click();
  await second.locator(".changed").waitFor({ state: "detached" });
  await setCohesion(first, "fill", "43");
  await setCohesion(second, "fill", "44");
  await second.getByRole("button", { name: "Save", exact: true }).click();
  await second.locator(".changed").waitFor({ state: "detached" });
  await first.bringToFront();
  await first.getByRole("button", { name: "Save", exact: true }).click();
  await first.getByRole("button", { name: /^Merge both/ }).click();
  const both = await readText(first);
  list.expect(/cohesion = 43/.test(both) && /# other text: cohesion = 44/.test(both), "a line that both changed is kept twice", both);
  list.expect(/cohesion = 42/.test(both), "the rest of the other change is there");
  await first.keyboard.press("Control+z");
  list.expect(!/other text/.test(await readText(first)), "a merge is a step that can be undone");
}

/**
 * A window ends without saving, a second one saves another change while the recovery is offered, a third one recovers the text of
 * the first: it is merged with the newer file, which it does not overwrite.
 */
export async function recoverText(list, page, reopen, path) {
  await waitForFactor(page);
  await setCohesion(page, "fill", "33");
  await page.waitForTimeout(2500);
  await page.close();
  const second = await reopen();
  await second.getByRole("button", { name: "Recover them" }).waitFor();
  await setCohesion(second, "clay", "34");
  await second.getByRole("button", { name: "Save", exact: true }).click();
  await second.locator(".changed").waitFor({ state: "detached" });
  await second.close();
  const third = await reopen();
  await third.getByRole("button", { name: "Recover them" }).click();
  await third.getByRole("button", { name: "Recover them" }).waitFor({ state: "detached" });
  const values = [await (await findCohesion(third, "fill")).inputValue(), await (await findCohesion(third, "clay")).inputValue()];
  list.expect(values[0] === "33" && values[1] !== "34", "the unsaved text is recovered", values.join(", "));
  await third.getByRole("button", { name: "Save", exact: true }).click();
  await third.getByRole("button", { name: /^Merge both/ }).waitFor();
  list.expect(/cohesion = 34/.test(readFileSync(path, "utf8")), "the newer file is not overwritten");
  await third.getByRole("button", { name: /^Merge both/ }).click();
  await third.getByRole("button", { name: "Save", exact: true }).click();
  await third.locator(".changed").waitFor({ state: "detached" });
  const saved = readFileSync(path, "utf8");
  list.expect(/cohesion = 33/.test(saved) && /cohesion = 34/.test(saved), "both changes are saved", saved);
}

/** A case that was never saved is offered by the next window. */
export async function recoverNewCase(list, open) {
  const page = await open();
  await page.getByRole("tab", { name: "Text" }).click();
  await page.locator(".cm-content").click();
  await page.keyboard.type("# drawn and lost");
  await page.waitForTimeout(2500);
  await page.close();
  const again = await open();
  const question = again.locator(".question");
  await question.waitFor();
  list.expect(/never saved/.test(await question.innerText()), "a case that was never saved is offered", await question.innerText());
  await again.getByRole("button", { name: "Recover them" }).click();
  list.expect(/# drawn and lost/.test(await readText(again)), "and recovered");
}

/** Runs the drawn slope by the program itself and reads its report. */
export async function runCase(list, page) {
  await page.getByRole("tab", { name: "Runs" }).click();
  await page.getByRole("button", { name: "Calculate" }).click();
  await page.locator(".factors").waitFor();
  const factors = await page.locator(".factors td.number").allInnerTexts();
  list.note(`factors by the settings of the case: ${factors.join(", ")}`);
  list.expect(factors.length >= 2 && factors.every((text) => Number(text) > 0.5), "every method has a factor", factors.join(", "));
  await page.getByRole("button", { name: /^(Save and run|Run)$/ }).click();
  const report = page.getByRole("link", { name: "Report" });
  await report.waitFor({ timeout: 240_000 });
  const shown = /F = (\d\.\d+)/.exec(await page.locator(".runs li").first().innerText());
  list.expect(shown !== null, "a finished run shows its factor", await page.locator(".runs").innerText());
  const [opened] = await Promise.all([page.context().waitForEvent("page"), report.click()]);
  await opened.waitForLoadState();
  await opened.locator("h1").first().waitFor();
  list.expect(/Talus report/.test(await opened.title()), "its report opens", await opened.title());
  await opened.close();
}

/** Names that would be scripts in a page that writes HTML. */
export const hostileCase = String.raw`title = "<img src=x onerror=window.hostile=1>"

[[geometry.polygon]]
name = "<script>window.hostile=1</script>"
points = [[0, 0], [40, 0], [40, 5], [30, 5], [12, 14], [0, 14]]

[regions]
"<script>window.hostile=1</script>" = "javascript:alert(1)//'\"><svg onload=window.hostile=1>"

[materials."javascript:alert(1)//'\"><svg onload=window.hostile=1>"]
model = "mohr_coulomb"
unit_weight = 18
cohesion = "<b>5</b>"
friction_angle = 28

[analysis]
methods = ["lem"]
`;

export async function openHostile(list, page) {
  await page.waitForTimeout(1500);
  for (const tab of ["Section", "Soils", "Case", "Text", "Runs"]) {
    await page.getByRole("tab", { name: tab }).click();
    await page.waitForTimeout(200);
  }
  list.expect((await page.locator(".labels text").count()) > 0, "a hostile case is shown");
  list.expect((await page.evaluate(() => window.hostile)) === undefined, "a hostile case file executes nothing");
  const foreign = await page.evaluate(() => document.querySelectorAll("#app img, #app script, #app b > b").length);
  list.expect(foreign === 0, "its names are text", String(foreign));
  list.expect((await readFactor(page)) === null, "its faults have messages", await page.locator(".messages").innerText());
}
