// SPDX-License-Identifier: MIT
// Where a file of the repository lies in the site. Markdown becomes HTML; other files that a page links to are copied.
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";

import { outsidePages } from "./navigation.js";
import { findTitle } from "./markdown.js";

/** The page of the site made from this Markdown file ("docs/manual/study.md"), or null if there is none. */
export function findPage(source) {
  if (!source.endsWith(".md")) return null;
  const html = source.replace(/README\.md$/, "index.html").replace(/\.md$/, ".html");
  if (source.startsWith("docs/")) return html.replace(/^docs\//, "");
  return outsidePages().includes(source) ? `project/${html}` : null;
}

/** The place of a copied file. */
export function findFiles(source) {
  return source.startsWith("docs/") ? source.replace(/^docs\//, "") : `files/${source}`;
}

/**
 * Translates a link of a page, as GitHub would follow it, into a link of the site. Returns {href}, {href, copy} for a
 * file that must be copied, or {} for a folder without a page. `made` holds the pages that are no files. Throws for a
 * target that does not exist.
 */
export function translateLink(href, source, made) {
  if (/^[a-z]+:/i.test(href) || href.startsWith("#")) return { href };
  const [target, hash] = href.split("#");
  const file = path.normalize(path.join(path.dirname(source), decodeURI(target))).replace(/\/$/, "");
  const from = path.dirname(findPage(source));
  const suffix = hash ? `#${hash}` : "";
  const relate = (to) => path.relative(from, to) + suffix;
  if (file === "docs/decisions") return { href: relate(findPage("docs/decisions/README.md")) };
  if (made.has(file)) return { href: relate(findPage(file)) };
  if (!existsSync(file)) throw new Error(`${source}: the link '${href}' leads to no file`);
  if (statSync(file).isDirectory()) {
    const page = existsSync(`${file}/README.md`) && findPage(`${file}/README.md`);
    return page ? { href: relate(page) } : {};
  }
  const page = findPage(file);
  return page ? { href: relate(page) } : { href: relate(findFiles(file)), copy: file };
}

/** A page that lists the decisions; GitHub shows the folder instead. */
export function listDecisions() {
  const names = readdirSync("docs/decisions").filter((name) => name.endsWith(".md"));
  const lines = names.sort().map((name) => {
    const title = findTitle(readFileSync(`docs/decisions/${name}`, "utf8"));
    return `- [${title}](${name})`;
  });
  const intro = "Why it is so. One page for each decision, in the order in which they were taken.";
  return `# Decisions\n\n${intro}\n\n${lines.join("\n")}\n`;
}
