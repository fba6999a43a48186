// SPDX-License-Identifier: MIT
// Uses the studio as an engineer would, in headless Chromium: node check.mjs PROGRAM|ADDRESS CASE.toml OUT_DIR [PAGE_FOLDER] [--short]
// --short: a case is drawn, saved, run, imported and edited in two windows; one colour scheme, one small screen.
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";

import { checkAccessibility } from "../accessibility.mjs";
import { Checklist } from "../checklist.mjs";
import { checkWidth } from "../layout.mjs";
import { startBrowser } from "../session.mjs";
import { dragCrest, drawDrySlope, makeMistakes, saveAs, undoAll } from "./drawing.mjs";
import { editInTwoWindows, hostileCase, mergeTwoWindows, openHostile, recoverNewCase, recoverText, runCase } from "./files.mjs";
import { useKeysAlone } from "./keyboard.mjs";
import { changeShapes, drawSearch, findOwnEntry, importSurvey, pasteAndKeep, placePicture, switchUnits } from "./parts.mjs";
import { readProgress, readResults, slowCase } from "./reading.mjs";
import { compareRuns, exportAll, followRun, methodsCase } from "./runs.mjs";
import { addFile, openPage, startStudio, waitForFactor } from "./session.mjs";

const isShort = process.argv.includes("--short");
const [program, example, outGiven, pageFolder] = process.argv.slice(2).filter((word) => word !== "--short");
if (!program || !example || !outGiven) {
  console.error("usage: node check.mjs PROGRAM|ADDRESS CASE.toml OUT_DIR [PAGE_FOLDER] [--short]");
  process.exit(2);
}
const out = resolve(outGiven);
mkdirSync(out, { recursive: true });
const folder = mkdtempSync(join(tmpdir(), "talus-studio-"));
// With one file alone the page would open it.
for (const name of ["embankment.toml", "second.toml", "third.toml", "parts.toml"]) copyFileSync(example, join(folder, name));
writeFileSync(join(folder, "hostile.toml"), hostileCase);
writeFileSync(join(folder, "methods.toml"), methodsCase);
writeFileSync(join(folder, "slow.toml"), slowCase);

// Optional modules beside the program; a server that is given by its address has them.
const modules = ["libtalus_gdal.so", "libtalus_xlsx.so"].filter((name) => program.startsWith("http") || existsSync(join(dirname(program), name)));
if (modules.length < 2) console.log("SKIP: this build lacks GDAL or libxlsxwriter ('make program' adds them): their exports were NOT tested");

const list = new Checklist();
const browser = await startBrowser();
const studio = await startStudio(program, folder, pageFolder ? ["--page", pageFolder] : []);
const opened = [];
const open = async (address, options) => {
  const session = await openPage(browser, address, options);
  opened.push(session);
  return session.page;
};

/** Ends the windows of a group, whose faults stay listed. */
const closeAll = () => Promise.all(opened.map(({ context }) => context.close()));

try {
  const page = await open(studio.address);
  let drawn = null;
  await list.group("From nothing", async () => (drawn = await drawDrySlope(list, page, out)));
  if (drawn) {
    await list.group("Dragging", () => dragCrest(list, page, drawn.factor, out));
    await list.group("Undo", () => undoAll(list, page, drawn.empty));
    await list.group("Mistakes", () => makeMistakes(list, page, out));
    await list.group("Saving", () => saveAs(list, page));
    await list.group("Runs", () => runCase(list, page));
  }
  await closeAll();
  if (!isShort) await list.group("Keyboard", async () => useKeysAlone(list, await open(studio.address)));
  const embankment = addFile(studio.address, "embankment.toml");
  const second = addFile(studio.address, "second.toml");
  await list.group("Two windows", async () => editInTwoWindows(list, await open(second), await open(second)));
  if (!isShort) {
    const third = addFile(studio.address, "third.toml");
    await list.group("Merge", async () => mergeTwoWindows(list, await open(third), await open(third)));
    await closeAll();
    const methods = await open(addFile(studio.address, "methods.toml"));
    await list.group("Course of a run", () => followRun(list, methods, out));
    await list.group("Report", () => readResults(list, methods, out));
    await list.group("Comparison", () => compareRuns(list, methods, out));
    await list.group("Exports", () => exportAll(list, methods, out, modules));
    await closeAll();
    await list.group("Report in progress", async () => readProgress(list, await open(addFile(studio.address, "slow.toml")), out));
    await closeAll();
    await list.group("Recovery", async () => recoverText(list, await open(embankment), () => open(embankment), join(folder, "embankment.toml")));
    await list.group("Recovery of a new case", async () => recoverNewCase(list, () => open(studio.address)));
  }
  await closeAll();
  const parts = addFile(studio.address, "parts.toml");
  const path = join(folder, "parts.toml");
  /** A group in a window of its own, which ends afterwards. */
  const openPart = async (name, use) => {
    await list.group(name, async () => {
      const one = await open(parts);
      await waitForFactor(one);
      await use(one);
    });
    await closeAll();
  };
  await openPart("Import", (one) => importSurvey(list, one, out));
  if (!isShort) {
    await openPart("Shapes", (one) => changeShapes(list, one, path, out));
    await openPart("Search and conditions", (one) => drawSearch(list, one, path, out));
    await openPart("Background", (one) => placePicture(list, one, path, out));
    await openPart("Units", (one) => switchUnits(list, one, path, out));
    await openPart("Tables and own soils", (one) => pasteAndKeep(list, one, path));
    await openPart("Own soils again", (one) => findOwnEntry(list, one));
    await list.group("Hostile", async () => openHostile(list, await open(addFile(studio.address, "hostile.toml"))));
  }
  for (const colorScheme of isShort ? ["dark"] : ["light", "dark"]) {
    await list.group(`Accessibility, ${colorScheme}`, async () => {
      const coloured = await open(embankment, { colorScheme });
      await waitForFactor(coloured);
      for (const tab of isShort ? ["Section", "Soils"] : ["Section", "Soils", "Case", "Text", "Runs"]) {
        await coloured.getByRole("tab", { name: tab }).click();
        await coloured.waitForTimeout(300);
        if (tab === "Soils") for (const part of await coloured.locator(".soil > summary").all()) await part.click();
        await coloured.screenshot({ path: join(out, `${tab.toLowerCase()}-${colorScheme}.png`) });
        await checkAccessibility(list, coloured, `${tab}, ${colorScheme}`);
      }
    });
    await closeAll();
  }
  const screens = [["phone", 390, 844], ["tablet", 820, 1180]];
  for (const [name, width, height] of isShort ? screens.slice(0, 1) : screens) {
    await list.group(name, async () => {
      const small = await open(embankment, { viewport: { width, height }, hasTouch: true, isMobile: true });
      await waitForFactor(small);
      await checkWidth(list, small, `at a width of ${width}`);
      await small.screenshot({ path: join(out, `${name}.png`) });
      for (const tab of ["Soils", "Case", "Text", "Runs"]) {
        await small.getByRole("tab", { name: tab }).click();
        await checkWidth(list, small, `at a width of ${width}, ${tab}`);
      }
      await small.screenshot({ path: join(out, `${name}-whole.png`), fullPage: true });
    });
    await closeAll();
  }
  await list.group("Silence", () => {
    const requests = opened.flatMap((session) => session.requests);
    list.expect(requests.length === 0, "nothing is asked of a network", requests.slice(0, 5).join(", "));
    // A refused save or export is shown to the user; the browser notes its status as well.
    const refused = modules.length < 2 ? /status of 40[09]/ : /status of 409/;
    const faults = [...new Set(opened.flatMap((session) => session.faults))].filter((fault) => !refused.test(fault));
    list.expect(faults.length === 0, "no errors in the console", faults.slice(0, 8).join(" | "));
  });
} finally {
  await browser.close();
  studio.stop();
  rmSync(folder, { recursive: true, force: true });
}
process.exit(list.finish());
