// SPDX-License-Identifier: MIT
// Builds the manual: every Markdown page of docs/, and the reference that `talus manual` prints. Run by tools/docs.sh
// from the root of the repository; TALUS names the program, TALUS_SITE the folder of the site.
import { copyFileSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";

import { findTitle, makeMarkdown } from "./markdown.js";
import { outsidePages, sections } from "./navigation.js";
import { findFiles, findPage, listDecisions } from "./pages.js";
import { readReference } from "./reference.js";

const site = path.resolve(process.env.TALUS_SITE ?? "build/site");
const here = import.meta.dirname;

export default function (config) {
  const reference = readReference(process.env.TALUS ?? "build/release/bin/talus");
  const files = new Set();
  const records = [];
  const markdown = makeMarkdown({ reference, files, records });

  config.setUseGitIgnore(false);
  config.setQuietMode(true);
  config.setLibrary("md", markdown);
  config.ignores.add("docs/site/**");
  config.addGlobalData("layout", "page.11ty.js");
  config.addGlobalData("sections", sections(reference.pages));
  config.addGlobalData("version", reference.version);
  config.addGlobalData("eleventyComputed", {
    source: findSource,
    permalink: (data) => findPage(findSource(data)),
    title: (data) => data.heading ?? findTitle(readFileSync(findSource(data), "utf8")),
  });

  for (const page of reference.pages) addPage(page.source, page.text, page.title);
  addPage("docs/decisions/README.md", listDecisions(), "Decisions");
  for (const source of outsidePages()) addPage(source, readFileSync(source, "utf8"));

  /** A page that is no file of docs/. */
  function addPage(origin, text, heading) {
    config.addTemplate(`made/${origin}`, text, { origin, heading });
  }

  config.on("eleventy.after", () => {
    copyAssets();
    for (const file of files) copyTo(file, findFiles(file));
    records.sort((a, b) => (a.url < b.url ? -1 : a.url > b.url ? 1 : 0));
    // A long list is looked through on its own page, and so is the rest of a table of runs.
    const shown = records.filter(({ url }) => !url.startsWith("verification_data/published"));
    const shorten = ({ url, text }) => (url.startsWith("verification_data/") ? text?.slice(0, 600) : text);
    // `source` served the collecting only.
    const text = JSON.stringify(shown.map(({ source, ...found }) => ({ ...found, text: shorten(found) })));
    writeFileSync(path.join(site, "assets/search-records.js"), `window.talusRecords = ${text};\n`);
  });

  return {
    dir: { input: "docs", output: path.relative(".", site), layouts: "site/layouts", includes: "site/layouts" },
    markdownTemplateEngine: false,
    templateFormats: ["md"],
  };
}

/** The page's file in the repository; the first call of Eleventy only asks which data are used. */
function findSource(data) {
  return data.origin ?? path.relative(".", data.page.inputPath ?? "docs/README.md");
}

function copyTo(from, to) {
  const target = path.join(site, to);
  mkdirSync(path.dirname(target), { recursive: true });
  if (from.endsWith(".svg")) writeFileSync(target, shortenPicture(readFileSync(from, "utf8")));
  else copyFileSync(from, target);
}

/** A picture of matplotlib without rotations by nothing and without its long list of fonts at each text. */
function shortenPicture(svg) {
  return svg
    .replace(/ transform="rotate\(-0 [^)]*\)"/g, "")
    .replace(/'DejaVu Sans'(?:, (?:'[^']*'|[A-Z]\w*))+, sans-serif/g, "'DejaVu Sans', sans-serif");
}

/** Style, script, and the parts of KaTeX and MiniSearch that a browser needs; one font format, which all read. */
function copyAssets() {
  const modules = path.join(here, "node_modules");
  for (const name of ["style.css", "page.js"]) copyTo(path.join(here, "assets", name), `assets/${name}`);
  copyTo(path.join(modules, "minisearch/dist/umd/index.js"), "assets/minisearch.js");
  const css = readFileSync(path.join(modules, "katex/dist/katex.min.css"), "utf8");
  const woff2Only = css.replace(/,url\([^)]*\.(?:woff|ttf)\) format\("[^"]*"\)/g, "");
  writeFileSync(path.join(site, "assets/katex.css"), woff2Only);
  const fonts = path.join(modules, "katex/dist/fonts");
  for (const name of readdirSync(fonts))
    if (name.endsWith(".woff2")) copyTo(path.join(fonts, name), `assets/fonts/${name}`);
  const minisearch = readFileSync(path.join(site, "assets/minisearch.js"), "utf8");
  writeFileSync(path.join(site, "assets/minisearch.js"), minisearch.replace(/\n\/\/# sourceMappingURL=.*\n?$/, "\n"));
}
