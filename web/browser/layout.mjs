// SPDX-License-Identifier: MIT
// How the page looks: dark and light, on a phone, on paper. Screenshots are for people to look at.
import { join } from "node:path";

import { scrollThrough } from "./session.mjs";

/** Perceived lightness of the page behind the text, 0 black to 1 white. */
function measureLightness(page) {
  return page.evaluate(() => {
    const colour = [document.body, document.documentElement]
      .map((element) => getComputedStyle(element).backgroundColor)
      .find((text) => !/, 0\)$|transparent/.test(text));
    const canvas = document.createElement("canvas").getContext("2d");
    canvas.fillStyle = colour ?? "white";
    canvas.fillRect(0, 0, 1, 1);
    const [r, g, b] = canvas.getImageData(0, 0, 1, 1).data;
    return (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
  });
}

/**
 * Checks that a page opened in the system's colours, light or dark, has them, and scrolls through it. Takes its first
 * screen, and the whole page once.
 */
export async function checkColours(list, page, colorScheme, out) {
  await page.waitForTimeout(1500);
  const lightness = await measureLightness(page);
  const holds = colorScheme === "dark" ? lightness < 0.25 : lightness > 0.8;
  list.expect(holds, `the page is ${colorScheme} where the system is`, `lightness ${lightness.toFixed(2)}`);
  await page.screenshot({ path: join(out, `first-${colorScheme}.png`) });
  await scrollThrough(page);
  if (colorScheme === "light") await page.screenshot({ path: join(out, "whole-page.png"), fullPage: true });
}

/** No part may be wider than the window: the body would scroll sideways. */
export async function checkWidth(list, page, name) {
  const found = await page.evaluate(() => {
    const width = document.documentElement.clientWidth;
    scrollTo({ left: 10_000, behavior: "instant" });
    const moved = scrollX;
    scrollTo({ left: 0, behavior: "instant" });
    const wide = [...document.body.querySelectorAll("*")]
      .filter((element) => element.getBoundingClientRect().right > width + 1)
      .slice(0, 5)
      .map((element) => `${element.tagName.toLowerCase()}.${element.getAttribute("class") ?? ""}`);
    return { moved, scroll: document.documentElement.scrollWidth, width, wide };
  });
  const holds = found.moved === 0 && found.scroll <= found.width;
  const detail = `${found.scroll} of ${found.width} px: ${found.wide.join(", ")}`;
  list.expect(holds, `the page does not scroll sideways ${name}`, detail);
}

export async function checkPhone(list, page, out, takesWhole) {
  await scrollThrough(page);
  await checkWidth(list, page, "at a width of 390");
  await page.screenshot({ path: join(out, "phone.png") });
  if (takesWhole) await page.screenshot({ path: join(out, "phone-whole.png"), fullPage: true });
}

/** Prints as A4. Returns the number of pages. */
export async function checkPrint(list, page, out) {
  const path = join(out, "report.pdf");
  const bytes = await page.pdf({ path, format: "A4", printBackground: false, preferCSSPageSize: true });
  const pages = (bytes.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g) ?? []).length;
  list.expect(pages > 1, "the report prints on more than one page", `${pages}`);
  list.note(`printed: ${pages} pages, ${Math.round(bytes.length / 1024)} KiB`);
}
