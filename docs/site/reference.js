// SPDX-License-Identifier: MIT
// The reference of every key and of every command, made of what the program prints about itself: `talus manual` and
// `talus COMMAND --help`. Nothing is typed here.
import { execFileSync } from "node:child_process";
import MarkdownIt from "markdown-it";

const plain = new MarkdownIt({ html: true });
const escapeHtml = plain.utils.escapeHtml;

/** Rows of a Markdown table as lists of cells; "\|" does not end a cell. */
function readRows(lines) {
  const split = (line) =>
    line
      .slice(1, -1)
      .split(/(?<!\\)\|/)
      .map((cell) => cell.trim().replaceAll("\\|", "|"));
  return lines.filter((line) => line.startsWith("|") && !/^\|[-|]+\|$/.test(line)).map(split);
}

/** The blocks of `talus manual`: {header, path, meaning, columns, keys: [{name, cells, example}]}. */
export function readBlocks(text) {
  const [head, ...parts] = text.split(/^## /m);
  const top = head.slice(head.indexOf("\n| Key"));
  return [
    readBlock("", top),
    ...parts.map((part) => readBlock(part.slice(1, part.indexOf("\n") - 1), part.slice(part.indexOf("\n")))),
  ];
}

function readBlock(header, text) {
  const path = header.replace(/[[\]]/g, "");
  const lines = text.split("\n");
  const [columns, ...rows] = readRows(lines);
  const meaning = header
    ? lines.find((line) => line && !line.startsWith("|") && !line.startsWith("```") && line !== "Example of each line:")
    : "";
  const examples = text.includes("```toml") ? text.split("```toml\n")[1].split("\n```")[0].split("\n") : [];
  const keys = rows.map((cells, i) => {
    const name = cells[0].replaceAll("`", "");
    // The first line of an example is the block's header; what follows has one line for each key, in the same order.
    const example = examples[i + (header ? 1 : 0)];
    if (!example?.includes(" = ")) throw new Error(`talus manual: ${header} ${name} has no example`);
    return { name, cells, example, id: path ? `${path}.${name}` : name };
  });
  return { header, path, meaning, columns: columns ?? [], keys };
}

const inline = (text) => plain.renderInline(text);

/** A row: "number [kPa]" is a number with the unit kPa; the example stands below the meaning. */
function writeRow(key) {
  const [, value, range, preset, meaning] = key.cells;
  const [, kind, unit] = /^(.*?)(?: \[([^[\]]+)\])?$/.exec(value);
  const example = `Example: \`${key.example}\``;
  const cells = {
    Value: kind,
    Unit: unit ?? "",
    Range: range,
    Default: preset,
    "Meaning and example": `${meaning}<br>${example}`,
  };
  const writeCell = ([name, text]) => `<td data-label="${name}"${text ? "" : ' class="none"'}>${inline(text)}</td>`;
  const head = `<th scope="row" id="${key.id}"><a href="#${key.id}"><code>${escapeHtml(key.name)}</code></a></th>`;
  return `<tr>${head}${Object.entries(cells).map(writeCell).join("")}</tr>`;
}

function writeTable(block) {
  if (!block.keys.length) return "";
  const wanted = "Key, Value, Range, Default, Meaning";
  if (block.columns.join(", ") !== wanted)
    throw new Error(`talus manual: the columns of ${block.header} are not ${wanted}`);
  const heads = ["Key", "Value", "Unit", "Range", "Default", "Meaning and example"].map(
    (name) => `<th scope="col">${name}</th>`,
  );
  const rows = block.keys.map((key) => writeRow(key));
  return (
    `<div class="wide" tabindex="0" role="region" aria-label="Keys of ${escapeHtml(block.header || "the case")}">` +
    `<table class="keys"><thead><tr>${heads.join("")}</tr></thead><tbody>\n${rows.join("\n")}\n</tbody></table></div>\n`
  );
}

/** "strength_reduction.frozen.rest" stands on the page of "strength_reduction". */
const findGroup = (block) => (block.path ? block.path.split(".")[0] : "title");

function writePages(blocks) {
  const groups = Map.groupBy ? Map.groupBy(blocks, findGroup) : groupBy(blocks, findGroup);
  return [...groups].map(([group, inside]) => {
    const source = `docs/reference/${group}.md`;
    const heading = inside[0].header || "title";
    const text = inside.map((block, i) => {
      // A heading's own anchor has no dots: where the path has some, it is set by hand.
      const anchor = block.path.includes(".") ? `<span id="${block.path}"></span>\n\n` : "";
      const head = block.header ? `${anchor}${i === 0 ? "#" : "##"} \`${block.header}\`` : "# The name of the case";
      return `${head}\n\n${block.meaning ?? ""}\n\n${writeTable(block)}`;
    });
    return { source, title: heading, text: text.join("\n"), blocks: inside };
  });
}

function groupBy(list, choose) {
  const groups = new Map();
  for (const item of list) groups.set(choose(item), [...(groups.get(choose(item)) ?? []), item]);
  return groups;
}

function writeIndex(text, pages) {
  const intro = text.slice(text.indexOf("\n") + 1, text.indexOf("\n| Key"));
  const rows = pages.flatMap((page) =>
    page.blocks.map((block, i) => {
      const file = page.source.replace("docs/reference/", "");
      const href = file + (i ? `#${block.path}` : "");
      const names = block.keys.map((key) => `[\`${key.name}\`](${file}#${key.id})`).join(", ");
      return `| [\`${block.header || "title"}\`](${href}) | ${block.meaning || "The name of the case."} | ${names} |`;
    }),
  );
  return `# Every key of a case file\n\n${intro}\n| block | says | keys |\n|---|---|---|\n${rows.join("\n")}\n`;
}

function writeCommands(run) {
  const help = run(["--help"]);
  const names = [...help.split("Subcommands:")[1].matchAll(/^ {2}(\w+) /gm)].map((match) => match[1]);
  const parts = names.map((name) => `## \`talus ${name}\`\n\n\`\`\`\n${run([name, "--help"]).trim()}\n\`\`\`\n`);
  const intro = "# Every command\n\nAs `talus COMMAND --help` prints it.\n";
  return `${intro}\n\`\`\`\n${help.trim()}\n\`\`\`\n\n${parts.join("\n")}`;
}

/** Asks the program. Returns the pages, and functions that find a key's place from its name. */
export function readReference(program) {
  const run = (words) => execFileSync(program, words, { encoding: "utf8" });
  const text = run(["manual"]);
  const blocks = readBlocks(text);
  const byBlock = writePages(blocks);
  const pages = [
    { source: "docs/reference/README.md", title: "Every key", text: writeIndex(text, byBlock), blocks: [] },
    ...byBlock,
    { source: "docs/reference/commands.md", title: "Every command", text: writeCommands(run), blocks: [] },
  ];
  const places = new Map();
  const owners = new Map();
  for (const page of byBlock)
    for (const block of page.blocks) {
      const html = page.source.replace("docs/", "").replace(".md", ".html");
      if (block.header) places.set(block.header, `${html}#${block.path}`);
      for (const key of block.keys) {
        places.set(key.id, `${html}#${key.id}`);
        owners.set(key.name, [...(owners.get(key.name) ?? []), `${html}#${key.id}`]);
      }
    }
  for (const [, name] of run(["--help"]).matchAll(/^ {2}(\w+) {2,}/gm))
    places.set(`talus ${name}`, `reference/commands.html#talus-${name}`);
  places.set("talus manual", "reference/index.html");
  // A bare name is clear when one block alone has it and it is no everyday word.
  const findBare = (name) => (name.includes("_") && owners.get(name)?.length === 1 ? owners.get(name)[0] : undefined);
  return {
    pages,
    version: run(["version"])
      .trim()
      .replace(/^talus (\S+) \(.*$/s, "$1"),
    findKey: (name) => places.get(name) ?? findBare(name),
    listKeys: (source) =>
      pages
        .find((page) => page.source === source)
        ?.blocks.flatMap((block) =>
          block.keys.map((key) => ({
            id: key.id,
            title: key.id,
            text: key.cells.slice(1).join(" ").replaceAll("<br>", " "),
          })),
        ) ?? [],
  };
}
