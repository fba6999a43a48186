// SPDX-License-Identifier: MIT
// Opens the built manual from file:// in a browser that is refused the network: browse_site.mjs SITE [PICTURES].
// No request may leave the disk, no page may complain, formulas must have a size, the search must find a key.
// Skipped (77) where there is no Chromium or no playwright-core.
import { existsSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [site, pictures] = process.argv.slice(2);
const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((file) =>
  existsSync(file),
);
let playwright;
try {
  playwright = createRequire(path.resolve(import.meta.dirname, "../../web/package.json"))("playwright-core");
} catch {
  playwright = null;
}
if (!chromium || !playwright) {
  console.log(`SKIP: ${chromium ? "playwright-core is not installed in web/" : "there is no Chromium"}`);
  process.exit(77);
}

const faults = [];
const expect = (isTrue, sentence) => isTrue || faults.push(sentence);
const toUrl = (page) => pathToFileURL(path.resolve(site, page)).href;
const browser = await playwright.chromium.launch({
  executablePath: chromium,
  args: [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
  ],
});

async function open(options, page, act) {
  const context = await browser.newContext(options);
  await context.route(/^(?!file:|data:)/, (route) => {
    faults.push(`${page}: asks the network for ${route.request().url()}`);
    return route.abort();
  });
  const tab = await context.newPage();
  tab.on(
    "console",
    (message) =>
      ["error", "warning"].includes(message.type()) && faults.push(`${tab.url()}: console: ${message.text()}`),
  );
  tab.on("pageerror", (error) => faults.push(`${page}: ${error.message}`));
  // A picture that was still loading when the next page came is no fault.
  tab.on(
    "requestfailed",
    (request) =>
      request.failure()?.errorText === "net::ERR_ABORTED" || faults.push(`${page}: cannot load ${request.url()}`),
  );
  await tab.goto(toUrl(page));
  await act(tab, (name) => pictures && tab.screenshot({ path: path.join(pictures, `${name}.png`) }));
  await context.close();
}

const desk = { viewport: { width: 1280, height: 800 } };
const phone = { viewport: { width: 375, height: 740 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 };

const findPages = (folder) =>
  readdirSync(path.join(site, folder), { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory()
      ? findPages(path.join(folder, entry.name))
      : entry.name.endsWith(".html")
        ? [path.join(folder, entry.name)]
        : [],
  );

// Every page, on a phone: nothing may be wider than the screen.
await open(phone, "index.html", async (tab) => {
  for (const page of findPages("")) {
    await tab.goto(toUrl(page));
    const width = await tab.evaluate(() => document.documentElement.scrollWidth);
    expect(width <= 376, `${page}: is ${width} px wide on a phone of 375 px`);
  }
});

for (const colorScheme of ["light", "dark"])
  await open({ ...desk, colorScheme }, "theory/02-step.html", async (tab, shoot) => {
    const size = await tab.locator("#eq-t2-1 .katex-html").boundingBox();
    expect(size && size.width > 100 && size.height > 20, "theory/02-step.html: the first equation has no size");
    const font = await tab.evaluate(async () => {
      await document.fonts.ready;
      return document.fonts.check("20px KaTeX_Math");
    });
    expect(font, "theory/02-step.html: the font of the formulas is not there");
    const paper = await tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
    expect(
      (paper === "rgb(255, 255, 255)") === (colorScheme === "light"),
      `in the ${colorScheme} scheme the paper is ${paper}`,
    );
    await shoot(`theory_${colorScheme}`);
    await tab.click("#theme");
    const turned = await tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
    expect(turned !== paper, "the button for light and dark does nothing");
  });

await open(desk, "index.html", async (tab, shoot) => {
  await shoot("index");
  await tab.keyboard.press("/");
  await tab.keyboard.type("young modulus");
  await tab.waitForSelector("#found a");
  await shoot("search");
  const first = await tab.locator("#found a").first().getAttribute("href");
  expect(
    first.endsWith("materials.html#materials.NAME.young_modulus"),
    `the search for "young modulus" finds ${first} first`,
  );
  await tab.keyboard.press("Enter");
  await tab.waitForURL(/materials\.html/);
  const where = await tab.locator('[id="materials.NAME.young_modulus"]').boundingBox();
  expect(where && where.y > 0 && where.y < 800, "the page does not show the key that was chosen");
  await shoot("reference");
});

await open(phone, "reference/mesh.html", async (tab, shoot) => {
  await shoot("phone_reference");
  await tab.click("#menu");
  expect(await tab.locator("nav").isVisible(), "the list of pages does not open on a phone");
  await shoot("phone_menu");
});
await open({ ...phone, colorScheme: "dark" }, "theory/06-mohr-coulomb.html", async (tab, shoot) => {
  await tab.locator(".equation").first().scrollIntoViewIfNeeded();
  await shoot("phone_theory");
});
if (pictures)
  await open(desk, "theory/02-step.html", async (tab) => {
    await tab.emulateMedia({ media: "print" });
    await tab.pdf({ path: path.join(pictures, "print.pdf"), format: "A4" });
  });

await browser.close();
for (const fault of faults) console.error(fault);
console.log(faults.length ? `${faults.length} faults` : "the manual opens from the disk without a fault");
process.exit(faults.length ? 1 : 0);
