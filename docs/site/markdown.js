// SPDX-License-Identifier: MIT
// How Markdown becomes HTML: formulas by KaTeX at build time, anchors as GitHub makes them, links to pages of the site,
// names of keys linked to the reference, and the records of the search.
import { tex } from "@mdit/plugin-tex";
import katex from "katex";
import MarkdownIt from "markdown-it";
import anchor from "markdown-it-anchor";

import { findPage, translateLink } from "./pages.js";
import { collectRecords } from "./records.js";

/** The first heading of a page. */
export function findTitle(text) {
  const heading = /^# (.+)$/m.exec(text);
  if (!heading) throw new Error(`a page has no heading: ${text.slice(0, 60)}`);
  return heading[1].replaceAll("`", "");
}

/** GitHub's rule for anchors of headings: lower case, punctuation away, spaces to hyphens. */
export function slugify(text) {
  return text
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\p{M}\p{Pc} -]/gu, "")
    .replaceAll(" ", "-");
}

/** The same style in fewer characters: formulas have tens of thousands of styles. */
const shorten = (style) => style.replaceAll("margin-left:0em;", "").replace(/([:-])0\./g, "$1.").replace(/;$/, "");

/** TeX to HTML (for eyes) with MathML (for readers aloud). The number of an equation stands beside it, not inside. */
function renderFormula(content, isDisplay) {
  const tag = /\\tag\{([^}]*)\}/.exec(content)?.[1];
  // A "…" between symbols is no fault; everything else that KaTeX doubts is.
  const strict = (code) => (code === "unknownSymbol" || code === "unicodeTextInMathMode" ? "ignore" : "error");
  // The MathML without what HTML does not need: its TeX source and the name space.
  const html = katex
    .renderToString(content.replace(/\\tag\{[^}]*\}/, ""), { displayMode: isDisplay, strict })
    .replace(/<annotation [^>]*>.*?<\/annotation>/s, "")
    .replace(/<\/?semantics>/g, "")
    .replace(' xmlns="http://www.w3.org/1998/Math/MathML"', "")
    .replace(/style="([^"]*)"/g, (_, style) => `style="${shorten(style)}"`);
  if (!isDisplay) return html;
  const id = tag && `eq-${tag.toLowerCase().replace(".", "-")}`;
  const number = tag ? `<a class="number" href="#${id}">(${tag})</a>` : "";
  return `<div class="equation"${tag ? ` id="${id}"` : ""}><div class="formula">${html}</div>${number}</div>\n`;
}

/** Inline code that is the name of a key becomes a link to its entry, except on the reference's own pages. */
function linkKeys(tokens, state, reference) {
  const source = state.env.source;
  if (source.startsWith("docs/reference/")) return tokens;
  const page = findPage(source);
  let depth = 0;
  return tokens.flatMap((token) => {
    depth += token.type === "link_open" ? 1 : token.type === "link_close" ? -1 : 0;
    const place = token.type === "code_inline" && depth === 0 && reference.findKey(token.content);
    if (!place) return [token];
    const open = new state.Token("link_open", "a", 1);
    open.attrs = [
      ["href", "../".repeat(page.split("/").length - 1) + place],
      ["class", "key"],
    ];
    return [open, token, new state.Token("link_close", "a", -1)];
  });
}

function rewriteLinks(tokens, source, files, made) {
  for (const token of tokens) {
    const name = token.type === "link_open" ? "href" : token.type === "image" ? "src" : null;
    if (!name || token.attrGet("class") === "key") continue;
    const { href, copy } = translateLink(token.attrGet(name), source, made);
    if (copy) files.add(copy);
    if (href === undefined) token.attrs = token.attrs.filter(([attribute]) => attribute !== name);
    else token.attrSet(name, href);
    if (token.type === "image") token.attrSet("loading", "lazy");
  }
}

/** `files` collects the files that must be copied, `records` the entries of the search. */
export function makeMarkdown({ reference, files, records }) {
  const made = new Set(reference.pages.map((page) => page.source));
  const markdown = new MarkdownIt({ html: true, linkify: false });
  markdown.use(tex, { allowInlineWithSpace: false, mathFence: false, render: renderFormula });
  markdown.use(anchor, {
    slugify,
    level: [1, 2, 3, 4],
    permalink: anchor.permalink.ariaHidden({ placement: "after", class: "anchor" }),
  });
  markdown.core.ruler.push("talus", (state) => {
    if (!state.env.source) return;
    collectRecords(state, records, reference);
    for (const token of state.tokens) {
      if (token.type !== "inline") continue;
      token.children = linkKeys(token.children, state, reference);
      rewriteLinks(token.children, state.env.source, files, made);
      // The anchor of an equation is for GitHub; here the equation itself has it.
      token.children = token.children.filter(
        (child) => child.type !== "html_inline" || !/^<a id="eq-|^<\/a>$/.test(child.content),
      );
    }
    dropEmptyParagraphs(state);
  });
  // Wide tables scroll by themselves, not the page.
  markdown.renderer.rules.table_open = () =>
    '<div class="wide" tabindex="0" role="region" aria-label="Table"><table>\n';
  markdown.renderer.rules.table_close = () => "</table></div>\n";
  return markdown;
}

function dropEmptyParagraphs(state) {
  state.tokens = state.tokens.filter((token, i, all) => {
    const inline =
      token.type === "inline"
        ? token
        : token.type === "paragraph_open"
          ? all[i + 1]
          : token.type === "paragraph_close"
            ? all[i - 1]
            : null;
    return !(inline?.type === "inline" && inline.children.length === 0 && inline.content.startsWith('<a id="eq-'));
  });
}
