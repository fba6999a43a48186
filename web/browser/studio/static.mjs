// SPDX-License-Identifier: MIT
// Opens the studio from a static folder, with the engine in WebAssembly: node static.mjs FOLDER CASE.toml FACTOR OUT_DIR
// The folder is delivered under the strictest Content-Security-Policy that WebAssembly allows.
import { createReadStream, existsSync, mkdirSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, resolve } from "node:path";

import { Checklist } from "../checklist.mjs";
import { startBrowser } from "../session.mjs";
import { openPage, waitForFactor } from "./session.mjs";

const [folderGiven, example, factorGiven, outGiven] = process.argv.slice(2);
if (!outGiven) {
  console.error("usage: node static.mjs FOLDER CASE.toml FACTOR OUT_DIR");
  process.exit(2);
}
const [folder, out] = [resolve(folderGiven), resolve(outGiven)];
mkdirSync(out, { recursive: true });

const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".wasm": "application/wasm" };
const policy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:";
const server = createServer((request, response) => {
  const name = new URL(request.url, "http://127.0.0.1").pathname;
  const file = join(folder, name === "/" ? "index.html" : name);
  if (!file.startsWith(folder) || !existsSync(file)) return response.writeHead(404).end();
  response.writeHead(200, { "Content-Type": types[extname(file)] ?? "application/octet-stream", "Content-Security-Policy": policy });
  createReadStream(file).pipe(response);
});
await new Promise((listening) => server.listen(0, "127.0.0.1", listening));

const list = new Checklist();
const browser = await startBrowser();
try {
  const { page, faults, requests } = await openPage(browser, `http://127.0.0.1:${server.address().port}/`);
  await list.group("Static folder", async () => {
    await page.locator("#case-file").setInputFiles(example);
    const factor = await waitForFactor(page, (found) => Math.abs(found - Number(factorGiven)) < 0.02, 120_000);
    list.expect(true, `the engine in WebAssembly finds a factor near ${factorGiven}`, String(factor));
    await page.screenshot({ path: join(out, "static.png") });
    list.expect(requests.length === 0, "nothing is asked of a network", requests.slice(0, 5).join(", "));
    list.expect(faults.length === 0, "no errors in the console", faults.slice(0, 8).join(" | "));
  });
} finally {
  await browser.close();
  server.close();
}
process.exit(list.finish());
