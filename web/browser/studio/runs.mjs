// SPDX-License-Identifier: MIT
// Runs in the page: their course while they are computed, surfaces on the section, two runs side by side, exports, print.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { checkAccessibility } from "../accessibility.mjs";
import { waitForFactor } from "./session.mjs";

/** Limit equilibrium, FEM and limit analysis on coarse meshes: seconds. */
export const methodsCase = `title = "Three methods"

[[geometry.polygon]]
name = "soil"
points = [[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]

[mesh]
size = 2

[materials.clay]
model = "mohr_coulomb"
unit_weight = 20
cohesion = "10 kPa"
friction_angle = 20
young_modulus = "45 MPa"
poisson_ratio = 0.3
dilatancy_angle = 0
tensile_strength = 0

[regions]
soil = "clay"

[analysis]
methods = ["lem", "fem", "bounds"]

[fem]
size = 1.5
meshes = 1
resolution = 0.01

[bounds]
gap = 0.06
`;

/** Runs of the case of this group: the list has those of other cases too. */
const runs = (page) => page.locator(".runs > li", { hasText: "methods.toml" });
const newest = (page) => runs(page).first();

async function startRun(page, count) {
  await page.getByRole("tab", { name: "Runs" }).click();
  await page.getByRole("button", { name: /^(Save and run|Run)$/ }).click();
  await runs(page).nth(count - 1).waitFor();
}

const waitForEnd = (page) => newest(page).getByRole("link", { name: "Report" }).waitFor({ timeout: 300_000 });

/** The course of a run: curves that grow, the factor before its end, a slip surface on the section. */
export async function followRun(list, page, out) {
  await waitForFactor(page);
  await startRun(page, 1);
  const plots = newest(page).locator(".live-plot");
  await plots.first().waitFor({ timeout: 240_000 });
  await page.screenshot({ path: join(out, "live.png") });
  await waitForEnd(page);
  const findings = await newest(page).locator(".findings").innerText();
  const factors = [...findings.matchAll(/(\d\.\d{3})/g)].map((found) => Number(found[1]));
  list.expect(/LEM/.test(findings) && /FEM/.test(findings) && /Limit analysis/.test(findings), "every method has its value", findings);
  list.expect(factors.length >= 4 && Math.max(...factors) / Math.min(...factors) < 1.15, "the methods agree within 15 %", findings);
  list.expect((await plots.count()) >= 2, "FEM and limit analysis have curves", String(await plots.count()));
  await newest(page).getByRole("button", { name: "On the section" }).click();
  await page.locator(".run-surface.fem").waitFor();
  const surfaces = await page.locator(".run-surface").count();
  list.expect(surfaces >= 2, "a finished run shows the surfaces of its methods", String(surfaces));
  await page.screenshot({ path: join(out, "surfaces.png") });
}

/** A second run with another cohesion, beside the first. */
export async function compareRuns(list, page, out) {
  await page.getByRole("tab", { name: "Soils" }).click();
  const field = page.locator("#field-materials-clay-cohesion");
  if (!(await field.isVisible())) await page.locator(".soil > summary", { hasText: "clay" }).click();
  await field.fill("14");
  await field.press("Tab");
  await startRun(page, 2);
  await waitForEnd(page);
  for (const run of await runs(page).all()) await run.locator(".run-head input").check();
  await page.getByRole("button", { name: "Compare two runs" }).click();
  const dialog = page.getByRole("dialog");
  await dialog.locator("tbody").first().waitFor();
  const text = await dialog.innerText();
  list.expect(/materials\.clay\.cohesion\s+10\s+14/.test(text), "the key that differs is listed", text.slice(0, 400));
  list.expect(/factor of safety that governs/.test(text) && /\+\d/.test(text), "the results and their differences are listed", text.slice(0, 800));
  await checkAccessibility(list, page, "two runs side by side");
  await dialog.getByRole("button", { name: "Both reports" }).click();
  const frames = dialog.locator("iframe");
  for (let i = 0; i < 2; ++i) await frames.nth(i).contentFrame().locator("h1").first().waitFor({ timeout: 60_000 });
  list.expect((await frames.count()) === 2, "both reports are beside each other");
  await page.screenshot({ path: join(out, "compared.png") });
  await dialog.getByRole("button", { name: "Close" }).click();
}

async function download(page, press) {
  const [found] = await Promise.all([page.waitForEvent("download"), press()]);
  return readFileSync(await found.path());
}

const countScripts = (page) => page.evaluate(() => performance.getEntriesByType("resource").filter(({ name }) => name.endsWith(".js")).length);

/** Every export has the content of its format; `modules` has those of the program, and exports without theirs end with a sentence. */
export async function exportAll(list, page, out, modules) {
  const hint = page.locator(".hint");
  /** What pressing exports, or an empty file where the page says that the program has no such module. */
  const exportBy = async (module, press) => {
    if (modules.includes(module)) return download(page, press);
    await press();
    await hint.filter({ hasText: "make program" }).waitFor({ timeout: 30_000 });
    list.expect(/this build of the program cannot write/.test(await hint.innerText()), `without ${module} the page names the command that adds it`);
    await page.keyboard.press("Escape");
    return null;
  };
  const choose = (name) => async () => {
    await page.locator(".menu > summary", { hasText: "Export" }).click();
    await page.getByRole("button", { name }).click();
  };
  const svg = (await download(page, choose("Picture, SVG"))).toString();
  list.expect(svg.startsWith("<svg") && /Factor of safety \d/.test(svg) && !/class=/.test(svg), "the SVG stands alone", svg.slice(0, 200));
  const drawn = await page.evaluate((text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelectorAll("path").length, svg);
  list.expect(drawn > 4, "the SVG is well-formed and has the section", String(drawn));
  const png = await download(page, choose("Picture, PNG"));
  list.expect(png.subarray(1, 4).toString() === "PNG" && png.length > 20_000, "the PNG is a picture", String(png.length));
  const csv = (await download(page, choose("Points, CSV"))).toString();
  list.expect(csv.startsWith("kind,name,x,y\r\n") && /region,soil,12,15/.test(csv) && /slip surface/.test(csv), "the points are a table", csv.slice(0, 200));
  const toml = (await download(page, choose("Case file, TOML"))).toString();
  list.expect(/cohesion = 14/.test(toml), "the case file is the text of the page");
  const before = await countScripts(page);
  const docx = await download(page, choose("Document, DOCX"));
  writeFileSync(join(out, "summary.docx"), docx);
  list.expect(docx.subarray(0, 2).toString() === "PK" && docx.length > 20_000, "the summary is a document", String(docx.length));
  list.expect((await countScripts(page)) > before, "the library of documents is loaded with the first one");
  const dxf = (await exportBy("libtalus_gdal.so", choose("Drawing, DXF")))?.toString();
  if (dxf) list.expect(/SECTION/.test(dxf) && /ENTITIES/.test(dxf), "the section is a drawing", dxf.slice(0, 60));
  const row = newest(page);
  const results = (await download(page, () => row.getByRole("button", { name: "CSV" }).click())).toString();
  list.expect(/^fem\.factor,/m.test(results) && /^bounds\.upper,/m.test(results), "results are a table", results.slice(0, 200));
  const workbook = await exportBy("libtalus_xlsx.so", () => row.getByRole("button", { name: "XLSX" }).click());
  if (workbook) list.expect(workbook.subarray(0, 2).toString() === "PK", "results are a workbook");
  const runDxf = (await exportBy("libtalus_gdal.so", () => row.getByRole("button", { name: "DXF" }).click()))?.toString();
  if (runDxf) list.expect(/ENTITIES/.test(runDxf), "the section of a run is a drawing");
  await page.emulateMedia({ media: "print" });
  const hidden = await page.locator(".palette").isHidden();
  list.expect(hidden && (await page.locator("svg.section").isVisible()), "the print has the section without tools");
  await page.pdf({ path: join(out, "print.pdf"), preferCSSPageSize: true });
  await page.screenshot({ path: join(out, "print.png"), fullPage: true });
  await page.emulateMedia({ media: null });
}
