// SPDX-License-Identifier: MIT
// Frames and searches a second of the studio, for docs/performance.md: node measure.mjs PROGRAM. On an otherwise idle machine.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { startBrowser } from "../session.mjs";
import { addFile, findPixel, openPage, startStudio, waitForFactor } from "./session.mjs";

const [program] = process.argv.slice(2);
if (!program) {
  console.error("usage: node measure.mjs PROGRAM");
  process.exit(2);
}

const soil = (name, cohesion) =>
  `[materials.${name}]\nmodel = "mohr_coulomb"\nunit_weight = 20\ncohesion = ${cohesion}\nfriction_angle = 25\n\n`;
const write = (polygons, more = "") => {
  const shapes = polygons.map((points, i) => `[[geometry.polygon]]\nname = "r${i}"\npoints = [${points.map(([x, y]) => `[${x}, ${y}]`).join(", ")}]\n\n`);
  const regions = polygons.map((_, i) => `r${i} = "${i % 2 ? "silt" : "clay"}"`);
  return `title = "Measured"\n\n${shapes.join("")}${soil("clay", 10)}${soil("silt", 14)}[regions]\n${regions.join("\n")}\n\n[analysis]\nmethods = ["lem"]\n${more}`;
};

const dry = [[[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]];
const survey = readFileSync(fileURLToPath(new URL("../../../tests/data/tables/own_slope_surface.csv", import.meta.url)), "utf8")
  .trim().split("\n").slice(1).map((row) => row.split(",").map(Number));
const surveyed = [[[survey[0][0], -20], [survey.at(-1)[0], -20], ...survey.toReversed()]];

/** The dry slope in 25 columns of 8 regions. */
function divide() {
  const ground = (x) => (x <= 12 ? 15 : x >= 32 ? 5 : 15 - (x - 12) / 2);
  const xs = [...[0, 3, 6, 9, 12], ...Array.from({ length: 16 }, (_, i) => 12 + (20 * (i + 1)) / 16), ...[35, 38, 41, 43, 44]];
  const at = (x, share) => [x, Number((ground(x) * share).toFixed(6))];
  return xs.slice(1).flatMap((x, i) =>
    Array.from({ length: 8 }, (_, k) => [at(xs[i], k / 8), at(x, k / 8), at(x, (k + 1) / 8), at(xs[i], (k + 1) / 8)]),
  );
}

const cases = {
  "dry.toml": { name: "dry slope", text: write(dry), vertex: [12, 15], ground: [[0, 14], [44, 0]] },
  "surveyed.toml": { name: "surveyed slope, 60 points", text: write(surveyed), vertex: survey[20] },
  "regions.toml": {
    name: "200 regions",
    text: write(divide(), "\n[lem]\nmethods = [\"bishop\"]\nnoncircular = false\nreferee = false\n\n[lem.entry_exit]\nentries = 38\nexits = 38\ndepths = 15\n"),
    vertex: [12, 15],
  },
};

/** Runs `act` for some seconds and counts the frames that the browser draws meanwhile. */
async function countFrames(target, act) {
  await target.evaluate(() => {
    window.frames_ = [];
    const tick = (now) => {
      window.frames_.push(now);
      window.request_ = requestAnimationFrame(tick);
    };
    window.request_ = requestAnimationFrame(tick);
  });
  const from = Date.now();
  await act();
  const seconds = (Date.now() - from) / 1000;
  const times = await target.evaluate(() => {
    cancelAnimationFrame(window.request_);
    return window.frames_;
  });
  const gaps = times.slice(1).map((t, i) => t - times[i]);
  return { rate: times.length / seconds, worst: Math.max(...gaps), seconds };
}

async function moveAround(page, [x, y], seconds, reach) {
  const end = Date.now() + 1000 * seconds;
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; Date.now() < end; ++i) {
    await page.mouse.move(x + reach * Math.sin(i / 12), y + 0.3 * reach * Math.sin(i / 7));
    await page.waitForTimeout(8);
  }
  await page.mouse.up();
}

const row = (...cells) => console.log(`| ${cells.join(" | ")} |`);
const show = ({ rate, worst }) => `${rate.toFixed(0)} (${worst.toFixed(0)} ms)`;

const folder = mkdtempSync(join(tmpdir(), "talus-measure-"));
for (const [path, { text }] of Object.entries(cases)) writeFileSync(join(folder, path), text);
const browser = await startBrowser();
const studio = await startStudio(program, folder);
try {
  row("case", "frames a second while a vertex is dragged (longest frame)", "searches a second", "frames a second while the section is moved");
  row("---", "--:", "--:", "--:");
  for (const [path, { name, vertex }] of Object.entries(cases)) {
    const { page, context } = await openPage(browser, addFile(studio.address, path));
    await waitForFactor(page);
    let searches = 0;
    page.on("response", (response) => response.url().endsWith("/api/solve") && ++searches);
    const at = await findPixel(page, vertex);
    const dragged = await countFrames(page, () => moveAround(page, at, 6, 25));
    const rate = searches / dragged.seconds;
    await page.keyboard.press("Escape");
    const box = await page.locator("svg.section").boundingBox();
    // Above the ground there is nothing to drag: the section moves.
    const moved = await countFrames(page, () => moveAround(page, [box.x + box.width * 0.6, box.y + 40], 4, 150));
    row(name, show(dragged), rate.toFixed(1), show(moved));
    await context.close();
  }
  const { page, context } = await openPage(browser, addFile(studio.address, "regions.toml"), { viewport: { width: 1600, height: 900 } });
  await waitForFactor(page);
  await page.getByRole("tab", { name: "Runs" }).click();
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.locator(".runs").getByRole("link", { name: "Report" }).waitFor({ timeout: 600_000 });
  await page.locator(".runs").getByRole("button", { name: "Read" }).click();
  const frame = page.locator(".report-pane iframe").contentFrame();
  const figure = frame.locator("#slices .drawing-stage").first();
  await figure.waitFor({ timeout: 120_000 });
  await figure.scrollIntoViewIfNeeded();
  await page.waitForTimeout(3000);
  const { trials } = JSON.parse(readFileSync(join(folder, "studio_runs/0001/lem.json"), "utf8"));
  const box = await figure.boundingBox();
  const moved = await countFrames(frame.locator("body"), () => moveAround(page, [box.x + box.width / 2, box.y + box.height / 2], 6, 120));
  console.log(`\nReport of 200 regions, ${trials.length} trial surfaces moved with the mouse: ${show(moved)} frames a second`);
  await context.close();
} finally {
  await browser.close();
  studio.stop();
  rmSync(folder, { recursive: true, force: true });
}
