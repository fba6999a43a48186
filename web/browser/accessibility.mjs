// SPDX-License-Identifier: MIT
// Accessibility: names of controls, order of headings, and what axe-core finds (contrast among it).
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(import.meta.url);

function findAxe() {
  try {
    return require.resolve("axe-core/axe.min.js");
  } catch {
    return null;
  }
}

/** Headings that skip a level or are missing, in the order of the page. */
function findHeadingFaults(page) {
  return page.evaluate(() => {
    const levels = [...document.querySelectorAll("h1, h2, h3, h4, h5, h6")]
      .filter((heading) => heading.checkVisibility())
      .map((heading) => ({ level: Number(heading.tagName[1]), text: heading.textContent.trim() }));
    const faults = levels
      .filter(({ level }, i) => level > (levels[i - 1]?.level ?? 0) + 1)
      .map(({ level, text }) => `h${level} '${text}' skips a level`);
    const firsts = levels.filter(({ level }) => level === 1).length;
    if (firsts !== 1) faults.push(`${firsts} headings of the first level`);
    return faults;
  });
}

/** Controls without a name, by the browser's own accessibility tree. */
async function findNamelessControls(page) {
  const client = await page.context().newCDPSession(page);
  await client.send("Accessibility.enable");
  const { nodes } = await client.send("Accessibility.getFullAXTree");
  await client.detach();
  const roles = new Set(
    "button link slider spinbutton combobox listbox checkbox radio switch tab textbox menuitem".split(" "),
  );
  return nodes
    .filter((node) => !node.ignored && roles.has(node.role?.value) && !node.name?.value?.trim())
    .map((node) => node.role.value);
}

/** Ids that occur more than once: labels and links then lead to the wrong element. */
function findDoubledIds(page) {
  return page.evaluate(() => {
    const ids = [...document.querySelectorAll("[id]")].map((element) => element.id);
    return [...new Set(ids.filter((id, i) => ids.indexOf(id) !== i))];
  });
}

export async function checkAccessibility(list, page, name) {
  const doubled = await findDoubledIds(page);
  list.expect(doubled.length === 0, `ids are unique (${name})`, doubled.join(", "));
  const headings = await findHeadingFaults(page);
  list.expect(headings.length === 0, `headings are in order (${name})`, headings.join("; "));
  const nameless = await findNamelessControls(page);
  list.expect(nameless.length === 0, `every control has a name (${name})`, nameless.join(", "));
  const axe = findAxe();
  if (!axe) return list.note(`*** axe-core is not installed: contrast and the rest are NOT checked (${name}) ***`);
  // Not as a script of the page, whose Content-Security-Policy may refuse it.
  await page.evaluate(readFileSync(axe, "utf8"));
  const { violations, passes } = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
  for (const { id, impact, help, nodes } of violations) {
    const describe = (node) => `${node.target.join(" ")} (${node.any[0]?.message ?? node.failureSummary})`;
    const where = nodes.slice(0, 4).map(describe);
    const text = `${id}: ${help}, ${nodes.length} times: ${where.join("; ")}`;
    if (impact === "serious" || impact === "critical") list.expect(false, `axe (${name}) ${impact}: ${text}`);
    else list.note(`axe (${name}) ${impact}: ${text}`);
  }
  list.expect(passes.some((rule) => rule.id === "color-contrast"), `axe looked at the contrast (${name})`);
}
