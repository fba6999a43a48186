// SPDX-License-Identifier: MIT
// Usage: node answer.mjs talus.js
// Reads calls from the standard input, one JSON array a line (["solve", text, options]), and writes an answer a line:
// {"answer": text, "milliseconds": time of the call}.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, resolve } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

const script = resolve(process.argv[2]);
// The module of emscripten 3.1.6 uses both in Node, where modules have neither.
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = dirname(script);
const { default: make } = await import(pathToFileURL(script).href);
const engine = await make({ wasmBinary: readFileSync(script.replace(/\.js$/, ".wasm")) });
for await (const line of createInterface({ input: process.stdin })) {
  const [name, ...values] = JSON.parse(line);
  const start = performance.now();
  const answer = engine[name](...values);
  process.stdout.write(JSON.stringify({ answer, milliseconds: performance.now() - start }) + "\n");
}
