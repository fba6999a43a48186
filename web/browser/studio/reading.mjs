// SPDX-License-Identifier: MIT
// The report of a run inside the studio: while the run is in progress, after its end, in other colours.
import { join } from "node:path";

import { checkAccessibility } from "../accessibility.mjs";
import { checkWidth } from "../layout.mjs";
import { methodsCase } from "./runs.mjs";
import { waitForFactor } from "./session.mjs";

/** A strength reduction of minutes, which the test stops. */
export const slowCase = methodsCase
  .replace('title = "Three methods"', 'title = "Slow reduction"')
  .replace("size = 1.5\nmeshes = 1\nresolution = 0.01", "size = 0.5\nmeshes = 1\nresolution = 0.000001");

const frameOf = (page) => page.locator(".report-pane iframe").contentFrame();

/** Trials and fields appear in the report while FEM is in progress; what the reader has chosen stays. */
export async function readProgress(list, page, out) {
  await waitForFactor(page);
  await page.getByRole("tab", { name: "Runs" }).click();
  await page.getByRole("button", { name: /^(Save and run|Run)$/ }).click();
  const row = page.locator(".runs > li", { hasText: "slow.toml" }).first();
  await row.getByRole("button", { name: "Read" }).click();
  const frame = frameOf(page);
  const figure = frame.getByRole("figure", { name: /^Trial at F = / });
  await figure.waitFor({ timeout: 120_000 });
  const countTrials = async () => Number(/(\d+) trials? so far/.exec(await frame.locator("#elements").innerText())?.[1] ?? 0);
  const before = await countTrials();
  list.expect(before > 0, "trials of FEM stand in the report while it is in progress", String(before));
  list.expect(/has not finished/.test(await frame.locator("main").innerText()), "the report says that the run has not finished");
  list.expect(/shear strain of FEM in the last trial/.test(await frame.locator("#section").innerText()), "the first figure has the strains of the last trial");
  await figure.getByRole("button", { name: "displacement" }).click();
  await frame.locator("body").evaluate(() => (window.stays = true));
  await page.screenshot({ path: join(out, "reading.png") });
  for (let left = 240; left > 0 && (await countTrials()) <= before; --left) await page.waitForTimeout(500);
  list.expect((await countTrials()) > before, "later trials follow", `${before}, ${await countTrials()}`);
  list.expect(await frame.locator("body").evaluate(() => window.stays === true), "the page of the report is not loaded anew");
  const pressed = await frame.getByRole("figure", { name: /^Trial at F = / }).getByRole("button", { name: "displacement" }).getAttribute("aria-pressed");
  list.expect(pressed === "true", "the field that the reader chose stays");
  await row.getByRole("button", { name: "Stop" }).click();
  await row.getByRole("button", { name: "Resume" }).waitFor({ timeout: 120_000 });
  await frame.getByText(/was interrupted/).first().waitFor();
  list.expect((await page.locator(".report-pane [role=status]").innerText()) === "", "a stopped run is no longer in progress");
  await page.getByRole("button", { name: "Close the report" }).click();
  list.expect(await page.locator("svg.section").isVisible(), "the section is there again");
}

/** The report of a finished run has its factor, over the section and beside it, in the colours of the studio. */
export async function readResults(list, page, out) {
  const row = page.locator(".runs > li", { hasText: "methods.toml" }).first();
  const factor = /F = (\d\.\d+)/.exec(await row.innerText())[1];
  await row.getByRole("button", { name: "Read" }).click();
  const frame = frameOf(page);
  await frame.locator("h1").first().waitFor();
  list.expect((await frame.locator("#answer").innerText()).includes(factor), "the report has the factor of the run", factor);
  for (const id of ["section", "compared", "slices", "elements", "bounds"]) list.expect((await frame.locator(`#${id}`).count()) === 1, `the report has the part ${id}`);
  list.expect(!(await page.locator("svg.section").isVisible()), "the report lies over the section");
  await page.getByRole("button", { name: "Beside the section" }).click();
  list.expect(await page.locator("svg.section").isVisible(), "the section is beside the report");
  await page.waitForTimeout(500);
  await page.screenshot({ path: join(out, "beside.png") });
  await checkAccessibility(list, page, "report beside the section");
  const readTheme = () => frame.locator("html").evaluate((root) => root.dataset.theme);
  const theme = await readTheme();
  await page.getByRole("button", { name: /^Change to .* colours$/ }).click();
  await page.waitForTimeout(300);
  list.expect((await readTheme()) !== theme, "the report changes its colours with the studio", theme);
  await page.screenshot({ path: join(out, "beside-other-colours.png") });
  await page.getByRole("button", { name: /^Change to .* colours$/ }).click();
  await page.getByRole("button", { name: "Close the report" }).click();
  await page.setViewportSize({ width: 390, height: 844 });
  await row.getByRole("button", { name: "Read" }).click();
  await frame.locator("h1").first().waitFor();
  const box = await page.locator(".report-pane").boundingBox();
  list.expect(box.y >= 0 && box.y + 300 < 844, "on a phone the report comes into sight", JSON.stringify(box));
  await checkWidth(list, page, "with a report at a width of 390");
  await page.screenshot({ path: join(out, "reading-phone.png") });
  await page.getByRole("button", { name: "Close the report" }).click();
  await page.setViewportSize({ width: 1280, height: 800 });
}
