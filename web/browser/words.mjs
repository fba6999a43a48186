// SPDX-License-Identifier: MIT
// A missing value must not show as a word of the programming language: the page has a dash, or a sentence.

const words = ["NaN", "undefined", "null", "Infinity", "[object Object]"];

/** All that can be read or is read aloud: texts, titles and names, also of what is folded away. */
function readTexts(page) {
  return page.evaluate(() => {
    for (const details of document.querySelectorAll("details")) details.open = true;
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const texts = [];
    for (let node = walker.nextNode(); node; node = walker.nextNode())
      if (!node.parentElement?.closest("script, style, annotation")) texts.push(node.textContent);
    for (const name of ["aria-label", "aria-valuetext", "title", "placeholder", "alt"])
      for (const element of document.querySelectorAll(`[${name}]`)) texts.push(element.getAttribute(name));
    return texts.map((text) => text.trim()).filter(Boolean);
  });
}

/** The texts that the results themselves hold: a case may be called "Null test". */
function gatherOwn(value, own = []) {
  if (typeof value === "string") own.push(value);
  else if (value && typeof value === "object") for (const child of Object.values(value)) gatherOwn(child, own);
  return own;
}

const escape = (word) => word.replace(/[[\]]/g, "\\$&");

export function findBadWords(texts, report) {
  const own = gatherOwn(report);
  const stands = (word, text) => new RegExp(`(?<![\\p{L}\\d_])${escape(word)}(?![\\p{L}\\d_])`, "u").test(text);
  const sought = words.filter((word) => !own.some((text) => text.includes(word)));
  return [...new Set(texts)].filter((text) => sought.some((word) => stands(word, text)));
}

export async function checkWords(list, page, report, name) {
  const bad = findBadWords(await readTexts(page), report);
  const detail = bad.map((text) => text.slice(0, 80)).join(" | ");
  list.expect(bad.length === 0, `no missing value shows as ${words.join(", ")} (${name})`, detail);
}
