// SPDX-License-Identifier: MIT
// The frame of every page: header with search, navigation, the page, its contents, and the ways on.
import { findPage } from "../pages.js";
import { findTitle } from "../markdown.js";
import { readFileSync } from "node:fs";

const escapeHtml = (text) =>
  text.replace(/[&<>"]/g, (sign) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);

export default class Page {
  render({ content, title, source, sections, version, collections }) {
    const url = findPage(source);
    const root = "../".repeat(url.split("/").length - 1);
    const titles = new Map(collections.all.map((page) => [page.data.source, page.data.title]));
    const nameOf = (page) =>
      page === "docs/README.md" ? "Contents" : (titles.get(page) ?? findTitle(readFileSync(page, "utf8")));
    const order = sections.flatMap(([, sources]) => sources);
    const at = order.indexOf(source);
    const way = (page, rel) =>
      page && `<a rel="${rel}" href="${root}${findPage(page)}">${escapeHtml(nameOf(page))}</a>`;
    const navigation = sections
      .map(([name, sources]) => this.writeSection(name, sources, source, root, nameOf))
      .join("");
    return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>${escapeHtml(title)} – Talus</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="${root}assets/katex.css">
<link rel="stylesheet" href="${root}assets/style.css">
<script>try{const t=localStorage.getItem("talus-theme");if(t)document.documentElement.dataset.theme=t}catch{}</script>
<script defer src="${root}assets/minisearch.js"></script>
<script defer src="${root}assets/page.js" data-root="${root}"></script>
</head>
<body>
<a class="skip" href="#content">To the text</a>
<header>
<button id="menu" type="button" aria-expanded="false" aria-controls="navigation">Pages</button>
<a class="home" href="${root}index.html"><b>Talus</b> manual <span>${escapeHtml(version)}</span></a>
<div id="search" role="search">
<input type="search" placeholder="Search  ( / )" aria-label="Search the manual" autocomplete="off" role="combobox" aria-expanded="false" aria-controls="found">
<ol id="found" hidden></ol>
</div>
<button id="theme" type="button" aria-label="Light or dark">◐</button>
</header>
<div class="columns${source.startsWith("docs/reference/") ? " broad" : ""}">
<nav id="navigation" aria-label="Pages">${navigation}</nav>
<main id="content">
${content}
<footer>${way(order[at - 1], "prev") ?? ""}${at >= 0 ? (way(order[at + 1], "next") ?? "") : ""}</footer>
</main>
${source.startsWith("docs/reference/") ? "" : this.writeContents(content)}
</div>
</body>
</html>
`;
  }

  writeSection(name, sources, current, root, nameOf) {
    // The reference has a page for every table, and its first page lists them: elsewhere that link is enough.
    const away = name === "Reference" && !sources.includes(current);
    const items = (away ? [sources[0], sources.at(-1)] : sources).map((page) => {
      // HTML needs no end of a list item, and every page has all of them.
      const here = page === current ? ' aria-current="page"' : "";
      return `<li><a href="${root}${findPage(page)}"${here}>${escapeHtml(nameOf(page))}</a>`;
    });
    const open = sources.includes(current) || name === "Start" ? " open" : "";
    return `<details${open}><summary>${name}</summary><ul>${items.join("")}</ul></details>\n`;
  }

  /** What stands on the page: its headings of the second rank. */
  writeContents(content) {
    const heads = [...content.matchAll(/<h2 id="([^"]+)"[^>]*>(.*?)<\/h2>/gs)];
    if (heads.length < 2) return "<aside></aside>";
    const clean = (html) =>
      html
        .replace(/<a class="anchor".*?<\/a>/s, "")
        .replace(/<\/?a\b[^>]*>/g, "")
        .trim();
    const items = heads.map(([, id, html]) => `<li><a href="#${id}">${clean(html)}</a></li>`);
    return `<aside aria-label="On this page"><p>On this page</p><ul>${items.join("")}</ul></aside>`;
  }
}
