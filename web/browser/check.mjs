// SPDX-License-Identifier: MIT
// Uses a report as a reader would, in headless Chromium: node check.mjs REPORT.html RESULTS_DIR OUT_DIR [--short]
// --short: one colour scheme instead of two, no pictures of whole pages, and the page that was used is printed.
import { existsSync, mkdirSync, statSync } from "node:fs";
import { resolve } from "node:path";

import { checkAccessibility } from "./accessibility.mjs";
import { Checklist } from "./checklist.mjs";
import { checkCurve } from "./curve.mjs";
import { checkFirstScreen, checkStudy } from "./firstScreen.mjs";
import { checkColours, checkPhone, checkPrint, checkWidth } from "./layout.mjs";
import { checkMethods } from "./methods.mjs";
import { readSummary } from "./results.mjs";
import { measureInteractive, openReport, readDocument, startBrowser } from "./session.mjs";
import { checkFields, checkPicking, checkPlaying, checkSequences, takeSpace } from "./viewer.mjs";
import { checkWords } from "./words.mjs";

const isShort = process.argv[5] === "--short";
const [file, folder, out] = process.argv.slice(2, 5).map((path) => resolve(path));
if (!file || !folder || !out || !existsSync(file) || !existsSync(folder)) {
  console.error("usage: node check.mjs REPORT.html RESULTS_DIR OUT_DIR (the report and the results must be there)");
  process.exit(2);
}
mkdirSync(out, { recursive: true });

const list = new Checklist();
const summary = readSummary(folder);
const browser = await startBrowser();
const opened = [];
const open = async (options) => {
  const session = await openReport(browser, file, options);
  opened.push(session);
  return session.page;
};

try {
  const page = await open();
  const report = await readDocument(page);
  const sequence = report.sequences.find((s) => s.kind === "runout") ?? report.sequences.at(-1);

  await list.group("Loading", async () => {
    list.note(`${(statSync(file).size / 2 ** 20).toFixed(2)} MiB`);
    if (!sequence && !report.methods_read) return;
    const time = await measureInteractive(page);
    list.note(`load to interactive: ${time === null ? "never" : `${Math.round(time)} ms`}`);
    // The time depends on the machine, which may be busy: it is printed and not checked.
    list.expect(time !== null, "the page becomes interactive", "no mark 'talus-interactive'");
  });
  await list.group("First screen", () => checkFirstScreen(list, page, report, summary));
  if (report.study) await list.group("Study", () => checkStudy(list, page, report));
  if (sequence) {
    await list.group("Playing", () => checkPlaying(list, page, report, sequence));
    await list.group("Fields", () => checkFields(list, page, sequence));
    await list.group("Picking", () => checkPicking(list, page, report, sequence));
    await list.group("Sequences", () => checkSequences(list, page, report));
    await list.group("In space", () => takeSpace(list, page, out));
  }
  if (report.result.lem || report.result.fem)
    await list.group("Methods", () => checkMethods(list, page, report, out));
  if (report.result.curve) await list.group("Curve", () => checkCurve(list, page, folder, out));
  await list.group("Width", () => checkWidth(list, page, "at a width of 1280"));
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  await list.group("Phone", async () => checkPhone(list, await open(phone), out, !isShort));
  await list.group("Print", async () => checkPrint(list, isShort ? page : await open(), out));
  for (const colorScheme of isShort ? ["dark"] : ["light", "dark"]) {
    const coloured = await open({ colorScheme });
    await list.group(`Colours, ${colorScheme}`, () => checkColours(list, coloured, colorScheme, out));
    await list.group(`Accessibility, ${colorScheme}`, () => checkAccessibility(list, coloured, colorScheme));
  }
  await list.group("Words", async () => {
    // Last: every part of these pages has been drawn, used and scrolled through.
    for (const [i, session] of opened.entries()) await checkWords(list, session.page, report, `page ${i + 1}`);
  });
  await list.group("Silence", () => {
    const requests = opened.flatMap((session) => session.requests);
    list.expect(requests.length === 0, "nothing is asked of a network", requests.slice(0, 5).join(", "));
    const faults = [...new Set(opened.flatMap((session) => session.faults))];
    list.expect(faults.length === 0, "no errors in the console", faults.slice(0, 8).join(" | "));
  });
  await list.group("All parts work", async () => {
    // A part that fails is replaced by a message.
    const texts = await Promise.all(opened.map((session) => session.page.getByRole("alert").allInnerTexts()));
    const broken = [...new Set(texts.flat())].filter((text) => /cannot be/.test(text));
    list.expect(broken.length === 0, "no part of the page gave up", broken.join(" | "));
  });
} finally {
  await browser.close();
}
process.exit(list.finish());
