// SPDX-License-Identifier: MIT
// Checks the text of the page: the factor of safety without scrolling; criteria, runout, warnings and comparisons anywhere.
import { showsNumber } from "./results.mjs";
import { scrollThrough } from "./session.mjs";

/** The text that a reader sees without scrolling. */
function readFirstScreen(page) {
  return page.evaluate(() => {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const seen = [];
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const parent = node.parentElement;
      if (!node.textContent.trim()) continue;
      if (!parent?.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      const box = range.getBoundingClientRect();
      if (box.width > 1 && box.height > 1 && box.top >= 0 && box.bottom <= innerHeight && box.right <= innerWidth)
        seen.push(node.textContent.trim());
    }
    return seen.join(" ");
  });
}

export async function checkFirstScreen(list, page, report, summary) {
  const first = await readFirstScreen(page);
  // Parts below the first screen are drawn when they are reached.
  await scrollThrough(page);
  await page.evaluate(() => document.querySelectorAll("#answer details").forEach((fold) => (fold.open = true)));
  const all = await page.innerText("body");
  list.expect(first.includes(report.title), "the first screen names the case", first.slice(0, 200));
  const found = summary?.factor_of_safety;
  if (found) {
    if (typeof found.value === "number") {
      const value = found.value.toFixed(3);
      list.expect(first.includes(value), `the factor of safety ${value} is on the first screen`, first.slice(0, 300));
    }
    for (const criterion of found.criteria ?? []) {
      const text = typeof criterion.factor !== "number" ? "none" : criterion.factor.toFixed(3);
      const title = report.answer.factors.find((f) => f.by === criterion.name)?.title;
      const row = page.locator("tr", { hasText: title ?? criterion.name }).filter({ hasText: text });
      const stands = title !== undefined && (await row.count()) > 0;
      list.expect(stands, `the ${criterion.name} criterion's factor ${text} stands in a row named for it`);
    }
  }
  const flow = report.answer.sentences.find((sentence) => sentence.includes("water enters with"));
  if (flow) list.expect(all.includes(flow), "what leaves where stands in the answer", first.slice(0, 600));
  for (const { srf, runout } of summary?.runouts ?? []) {
    const volume = runout.moved_volume;
    const what = `the moved volume ${volume.toPrecision(4)} of the runout at SRF ${srf} is shown`;
    list.expect(showsNumber(all, volume, 3), what);
  }
  for (const warning of report.warnings.slice(0, 3))
    list.expect(all.toLowerCase().includes(warning.toLowerCase()), `the warning '${warning.slice(0, 60)}' is shown`);
  for (const comparison of report.result.comparisons.filter((one) => !one.passes)) {
    const rows = await page.locator("tr", { hasText: comparison.title }).allInnerTexts();
    const named = rows.some((text) => /miss|fail|outside|✗/i.test(text) && text.includes(comparison.source));
    list.expect(named, `the missed comparison '${comparison.title}' is named as such`, rows.join(" | "));
  }
}

/**
 * A study: every variant has a row with its values as the document shows them, and a reason where it failed.
 * checkFirstScreen has scrolled through the page before.
 */
export async function checkStudy(list, page, report) {
  const rows = await page.locator("tr").allInnerTexts();
  for (const [i, variant] of report.study_result.variants.entries()) {
    const values = report.study.columns.map((column) => column.shown[i]).filter(Boolean);
    const row = rows.find((text) => text.includes(variant.name) && values.every((value) => text.includes(value)));
    list.expect(row, `the variant '${variant.name}' has a row with ${values.join(", ")}`);
    if (!variant.reason) continue;
    list.expect(rows.some((text) => text.includes(variant.reason)), `why '${variant.name}' failed is told`);
  }
}
