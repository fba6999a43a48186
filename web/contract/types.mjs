// SPDX-License-Identifier: MIT
// Writes src/contract/results.ts, the types of the results, from results.schema.json (`npm run types`).
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { compile } from "json-schema-to-typescript";

const read = new URL("results.schema.json", import.meta.url);
const write = new URL("../src/contract/results.ts", import.meta.url);

// Any number may be null in a damaged run. The page expects null where the description of the result names it.
const takeNumber = (key, value) => (key === "type" && Array.isArray(value) && value[0] === "number" ? "number" : value);
const { $defs } = JSON.parse(readFileSync(read, "utf8"), takeNumber);
const text = await compile({ $defs, title: "AllResults", type: "object", additionalProperties: false }, "AllResults", {
  bannerComment: "// SPDX-License-Identifier: MIT\n/** The results of the program, generated from contract/results.schema.json. */",
  unreachableDefinitions: true,
});
// The file keeps its time where nothing changes, so that no build starts anew.
if (!existsSync(write) || readFileSync(write, "utf8") !== text) writeFileSync(write, text);
