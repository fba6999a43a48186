// SPDX-License-Identifier: MIT
// Opens a report in headless Chromium as a reader would from a disk, without a network, and watches what it does.
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const flags = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  // No graphics card on a build machine: WebGL is drawn in software.
  "--enable-unsafe-swiftshader",
];

export function startBrowser() {
  return chromium.launch({ executablePath: process.env.TALUS_CHROMIUM ?? "/usr/bin/chromium", args: flags });
}

/**
 * Opens the report in a page of its own. `faults` fills with errors of the console and of the page, `requests` with
 * all network requests, which are refused.
 */
export async function openReport(browser, file, options = {}) {
  const viewport = { width: 1280, height: 800 };
  const context = await browser.newContext({ viewport, acceptDownloads: true, ...options });
  await context.setOffline(true);
  const requests = [];
  const faults = [];
  const isLocal = (url) => /^(file|data|blob|about):/.test(url);
  await context.route("**/*", (route) => (isLocal(route.request().url()) ? route.continue() : route.abort()));
  const page = await context.newPage();
  page.setDefaultTimeout(120_000); // a busy machine takes its time; a part that hangs still ends the check
  page.on("request", (request) => isLocal(request.url()) || requests.push(request.url()));
  page.on("websocket", (socket) => requests.push(socket.url()));
  page.on("console", (message) => message.type() === "error" && faults.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => faults.push(`page: ${error.message}`));
  await page.goto(pathToFileURL(file).href, { waitUntil: "load" });
  return { context, page, requests, faults };
}

/** The document that the page holds, and the results beside it. */
export function readDocument(page) {
  return page.evaluate(() => {
    const read = (id) => JSON.parse(document.getElementById(id)?.textContent ?? "null");
    return { ...read("talus-report"), ...read("talus-results") };
  });
}

/** Milliseconds from the start of loading to the mark that the viewer sets after its first picture; null: no mark. */
export async function measureInteractive(page, timeout = 120_000) {
  const find = () => performance.getEntriesByName("talus-interactive")[0]?.startTime ?? null;
  await page.waitForFunction(find, null, { timeout, polling: 50 }).catch(() => null);
  return page.evaluate(find);
}

/** Goes through the page once, so that parts which wait to be seen are drawn. */
export async function scrollThrough(page) {
  await page.evaluate(async () => {
    const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
    // The page scrolls smoothly; a picture must not catch it on its way.
    const goTo = (top) => scrollTo({ top, behavior: "instant" });
    for (let y = 0; y < document.documentElement.scrollHeight; y += innerHeight / 2) {
      goTo(y);
      await pause(60);
    }
    await pause(400);
    goTo(0);
    await pause(200);
  });
}
