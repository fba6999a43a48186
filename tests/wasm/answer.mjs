// SPDX-License-Identifier: MIT
// Usage: node answer.mjs talus.js
// Reads calls from the standard input, one JSON array a line (["solve", text, options]), and writes an answer a line:
// {"answer": text, "milliseconds": time of the call}.
import { createInterface } from "node:readline";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const { default: make } = await import(pathToFileURL(resolve(process.argv[2])).href);
const engine = await make();
for await (const line of createInterface({ input: process.stdin })) {
  const [name, ...values] = JSON.parse(line);
  const start = performance.now();
  const answer = engine[name](...values);
  process.stdout.write(JSON.stringify({ answer, milliseconds: performance.now() - start }) + "\n");
}
