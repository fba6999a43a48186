// SPDX-License-Identifier: MIT
// Starts `talus studio` on a folder of its own and opens its page as a user would.
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";

/** Starts PROGRAM studio FOLDER; an address that is given in its place is used as it is. */
export async function startStudio(program, folder, options = []) {
  if (program.startsWith("http")) return { address: program, stop: () => undefined };
  const server = spawn(program, ["studio", folder, "--no-open", ...options], { stdio: ["ignore", "pipe", "inherit"] });
  const address = await new Promise((resolve, reject) => {
    createInterface({ input: server.stdout }).on("line", (line) => {
      const found = /http:\/\/127\.0\.0\.1:\d+\/\S*/.exec(line);
      if (found) resolve(found[0]);
    });
    server.on("exit", (code) => reject(new Error(`talus studio ended with status ${code}`)));
  });
  return { address, stop: () => server.kill("SIGTERM") };
}

/** The address with a file that the page opens. */
export function addFile(address, path) {
  const url = new URL(address);
  url.searchParams.set("file", path);
  return url.href;
}

/** `faults` fills with errors of the console and of the page, `requests` with all that leave the loopback address. */
export async function openPage(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, acceptDownloads: true, ...options });
  const [faults, requests] = [[], []];
  context.setDefaultTimeout(120_000); // a busy machine takes its time
  const page = await context.newPage();
  page.on("request", (request) => {
    const url = request.url();
    if (!url.startsWith("http://127.0.0.1:") && !/^(data|blob):/.test(url)) requests.push(url);
  });
  page.on("console", (message) => message.type() === "error" && faults.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => faults.push(`page: ${error.message}`));
  page.on("dialog", (dialog) => void dialog.accept(dialog.type() === "prompt" ? "drawn.toml" : undefined));
  // On a busy machine Chromium may draw no frame of a new window; loaded again it does.
  for (let left = 2; ; --left) {
    await page.goto(address, { waitUntil: "load" });
    try {
      await page.locator(".section").waitFor({ timeout: left > 0 ? 40_000 : 120_000 });
      break;
    } catch (error) {
      if (left === 0) throw new Error(`${error.message}\nFaults: ${faults.join("; ") || "none"}`);
      await page.goto("about:blank");
    }
  }
  return { context, page, faults, requests };
}

/** Pixel of a point of the section [m], by the transform of the canvas. */
export async function findPixel(page, [x, y]) {
  const { matrix, left, top } = await page.evaluate(() => {
    const svg = document.querySelector("svg.section");
    const box = svg.getBoundingClientRect();
    return { matrix: svg.querySelector(".world").getAttribute("transform"), left: box.left, top: box.top };
  });
  const [sx, , , sy, tx, ty] = /\((.*)\)/.exec(matrix)[1].split(" ").map(Number);
  return [left + tx + sx * x, top + ty + sy * y];
}

export async function clickAt(page, point, options = {}) {
  const [x, y] = await findPixel(page, point);
  await page.mouse.move(x + 2, y + 1);
  await page.mouse.click(x + 2, y + 1, options);
}

/** The lines that the editor shows: those of a short case are all in the page. */
export async function readText(page) {
  await page.evaluate(() => document.getElementById("tab-text").click());
  const content = page.locator(".text-editor .cm-content");
  await content.waitFor();
  await page.waitForTimeout(80);
  return content.evaluate((element) => [...element.querySelectorAll(".cm-line")].map((line) => line.textContent).join("\n"));
}

/** The shown factor; null while there is none. */
export async function readFactor(page) {
  const text = await page.locator(".factor").innerText();
  return /^\d/.test(text) ? Number(text) : null;
}

/** Waits until a factor satisfies a condition and returns it. */
export async function waitForFactor(page, holds = () => true, timeout = 60_000) {
  const end = Date.now() + timeout;
  for (;;) {
    const factor = await readFactor(page);
    if (factor !== null && holds(factor)) return factor;
    if (Date.now() > end) throw new Error(`no such factor within ${timeout / 1000} s; the last is ${factor}`);
    await page.waitForTimeout(30);
  }
}
