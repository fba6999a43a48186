// SPDX-License-Identifier: MIT
// LEM and FEM: the pictures are drawn, the pointer reads them, surfaces can be chosen and switched.
import { join } from "node:path";

/** How many colours the lower canvas of a drawing shows, in steps of 32 of each channel. */
function countColours(page, part) {
  return page
    .locator(`${part} .drawing-below`)
    .first()
    .evaluate((canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const found = new Set();
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 3] > 200) found.add(((data[i] >> 5) << 6) | ((data[i + 1] >> 5) << 3) | (data[i + 2] >> 5));
      return found.size;
    });
}

/** "−1 234.5", "3.2 × 10⁻⁵": as the page writes numbers. */
function readNumber(text) {
  const [mantissa, power = ""] = text.replaceAll(/[\s\u202f]/g, "").replace("−", "-").split("×10");
  const exponent = [...power].map((c) => (c === "⁻" ? "-" : "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c))).join("");
  return Number(mantissa) * 10 ** Number(exponent);
}

function listSurfaces({ result: { lem, methods } }) {
  return lem ? [...lem.critical, ...lem.noncircular, ...lem.given, ...(methods?.optimised ?? [])] : [];
}

async function checkSlices(list, page, report, out) {
  const { trials } = report.slices;
  const surfaces = listSurfaces(report);
  const colours = await countColours(page, "#slices");
  list.expect(
    colours > (trials ? 8 : 1),
    "trial surfaces are drawn in the colours of their factors",
    `${colours} colours`,
  );
  const others = page.locator(".surface-table button");
  list.expect((await others.count()) === surfaces.length, `${surfaces.length} surfaces can be chosen`);
  const last = surfaces.findLastIndex((surface) => surface.slices.left.length > 0 && surface.factor !== null);
  if (last >= 0) {
    await others.nth(last).click();
    const rows = await page.locator(".slice-table tbody tr").count();
    const { left, weight } = surfaces[last].slices;
    list.expect(rows === left.length, `the chosen surface has its ${left.length} slices in the table`, `${rows}`);
    const head = await page.locator(".slice-table thead th").allInnerTexts();
    const at = head.findIndex((text) => text.trim().startsWith("W"));
    const cells = await page.locator(`.slice-table tbody td:nth-child(${at + 1})`).allInnerTexts();
    const sum = cells.reduce((total, text) => total + readNumber(text), 0);
    const whole = weight.reduce((a, b) => a + b, 0) / report.units.stress.si;
    list.expect(Math.abs(sum / whole - 1) < 1e-2, "its weights add up to the mass", `${sum} of ${whole}`);
    await page.locator(".slice-table thead button").nth(at).click();
    const sorted = await page.locator(".slice-table th[aria-sort='ascending']").innerText();
    list.expect(sorted.trim().startsWith("W"), "the table can be sorted", sorted);
  }
  if (trials) {
    await page.locator("#slices").getByRole("button", { name: "critical only" }).click();
    await page.waitForTimeout(200);
    const fewer = await countColours(page, "#slices");
    list.expect(fewer < colours, "the trial surfaces can be switched off", `${colours}, then ${fewer} colours`);
    await page.locator("#slices").getByRole("button", { name: "all", exact: true }).click();
    const stage = page.locator("#slices .drawing-stage").first();
    await stage.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await stage.boundingBox();
    let reading = "";
    for (let share = 0.3; share < 0.8 && !reading.startsWith("F = "); share += 0.02) {
      await page.mouse.move(x + 0.5 * width, y + share * height);
      await page.waitForTimeout(30);
      reading = await page.locator("#slices .drawing .chart-reading").first().innerText();
    }
    list.expect(/^F = \d/.test(reading), "the pointer reads the factor of a trial surface", reading);
  }
  await page.locator("#slices").screenshot({ path: join(out, "slices.png") });
}

async function checkElements(list, page, report, out) {
  const { runs } = report.result.fem;
  const trials = runs.reduce((sum, run) => sum + run.trials.length, 0);
  const rows = await page.locator("#elements figure[aria-label='Trials of the strength reduction'] tbody tr").count();
  list.expect(rows === trials, `all ${trials} trials of FEM have a row`, `${rows}`);
  if (!report.finite_elements) return;
  const colours = await countColours(page, "#elements");
  list.expect(colours > 3, "the strain of FEM is drawn", `${colours} colours`);
  await page
    .locator("#elements")
    .getByLabel(/^Deformed/)
    .check();
  await page.waitForTimeout(300);
  await page.locator("#elements").screenshot({ path: join(out, "elements.png") });
}

/** All parts of the methods; checkFirstScreen has scrolled through the page before. */
export async function checkMethods(list, page, report, out) {
  await page.locator("#compared details").evaluateAll((folds) => folds.forEach((fold) => (fold.open = true)));
  const table = await page.locator("#compared tbody tr").allInnerTexts();
  for (const row of (report.methods_read && report.result.methods.table) ?? []) {
    const factor = row.factor === null ? "none" : row.factor.toFixed(3);
    const stands = table.some((text) => text.includes(row.title) && text.includes(factor));
    list.expect(stands, `${row.title}, ${row.criterion}, has a row with ${factor}`);
  }
  if (report.sequences.length > 0) {
    const legend = await page.locator("#section .viewer-legend").innerText();
    const { surfaces } = report.methods_read ? report.result.methods : { surfaces: [] };
    const governing = report.methods_read?.governing;
    const over = surfaces.filter((s) => s.name === governing || s.method === "fem");
    for (const s of over)
      list.expect(
        legend.includes(s.title),
        `'${s.title}' lies over the material points, named with its factor`,
        legend,
      );
  }
  if (listSurfaces(report).length) await checkSlices(list, page, report, out);
  if (report.result.fem) await checkElements(list, page, report, out);
}
