// SPDX-License-Identifier: MIT
// The records of the search: one for each section of a page, with the plain text in it.
import { findPage } from "./pages.js";

const flatten = (token) =>
  (token.children ?? [])
    .map((child) =>
      ["text", "code_inline"].includes(child.type) ? child.content : child.type === "softbreak" ? " " : "",
    )
    .join("");

// Nobody searches for the digits in a table with their units, and they are a good part of all text.
const isCellOfNumbers = (tokens, i) => {
  if (tokens[i - 1]?.type !== "td_open") return false;
  const text = flatten(tokens[i]);
  const hasCode = (tokens[i].children ?? []).some(({ type }) => type === "code_inline");
  return /^[^\p{L}]*$/u.test(text) || (!hasCode && /\d/.test(text) && !/\p{L}{4}/u.test(text));
};

/** Appends {url, page, title, text} of every section of the page that `state` holds. */
export function collectRecords(state, records, reference) {
  const { source, title } = state.env;
  const url = findPage(source);
  // The page of a file that is calculated twice would be found twice.
  for (let i = records.length - 1; i >= 0; --i) if (records[i].source === url) records.splice(i, 1);
  const open = (heading, id) =>
    records.push({ source: url, url: id ? `${url}#${id}` : url, page: title, title: heading, text: "" });
  open(title, "");
  state.tokens.forEach((token, i) => {
    if (token.type === "heading_open" && token.tag !== "h1") open(flatten(state.tokens[i + 1]), token.attrGet("id"));
    else if (isCellOfNumbers(state.tokens, i)) return;
    else if (token.type === "inline" && state.tokens[i - 1]?.tag !== "h1") {
      if (state.tokens[i - 1]?.type !== "heading_open") records.at(-1).text += flatten(token) + " ";
    } else if (token.type === "fence") records.at(-1).text += token.content.replace(/\s+/g, " ") + " ";
  });
  for (const key of reference.listKeys(source))
    records.push({ source: url, page: title, ...key, url: `${url}#${key.id}` });
}
