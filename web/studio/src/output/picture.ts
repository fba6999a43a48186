// SPDX-License-Identifier: MIT
/** The canvas as a picture: an SVG without style sheets, and a PNG of it. */

/** Properties that the style sheets of the canvas set. */
const properties = [
  "display",
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-width",
  "stroke-opacity",
  "stroke-dasharray",
  "stroke-linejoin",
  "stroke-linecap",
  "opacity",
  "vector-effect",
  "font-size",
  "font-weight",
  "font-family",
  "text-anchor",
  "paint-order",
];

/** Parts that serve drawing alone. */
const tools = ".grid, .handles, .draft, .snap-marker, .message-marks";

function copyStyles(from: Element, to: Element): void {
  const style = getComputedStyle(from);
  for (const name of properties) {
    const value = style.getPropertyValue(name);
    if (value) to.setAttribute(name, value);
  }
  to.removeAttribute("class");
  to.removeAttribute("style");
  for (let i = 0; i < from.children.length; ++i) copyStyles(from.children[i]!, to.children[i]!);
}

/** Returns the SVG of the canvas with a title and the lines of text below the section. */
export function writeSvg(title: string, remarks: string[]): string {
  const canvas = document.querySelector<SVGSVGElement>("svg.section")!;
  const copy = canvas.cloneNode(true) as SVGSVGElement;
  copyStyles(canvas, copy);
  const drawn = [...canvas.querySelectorAll(tools)];
  const all = [...canvas.querySelectorAll("*")];
  const copies = [...copy.querySelectorAll("*")];
  for (const part of drawn) copies[all.indexOf(part)]?.remove();
  const { width, height } = canvas.getBoundingClientRect();
  const whole = height + 22 * remarks.length + 14;
  for (const name of ["tabindex", "role", "aria-label", "aria-roledescription", "data-over"]) copy.removeAttribute(name);
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("viewBox", `0 0 ${width} ${whole}`);
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(whole));
  const add = (name: string, attributes: Record<string, string>, text = "") => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.textContent = text;
    return element;
  };
  const { backgroundColor, color, fontFamily } = getComputedStyle(document.body);
  remarks.forEach((text, i) =>
    copy.append(add("text", { x: "12", y: String(height + 20 + 22 * i), fill: color, "font-size": "14", "font-family": fontFamily }, text)),
  );
  copy.prepend(add("rect", { width: String(width), height: String(whole), fill: backgroundColor }));
  copy.prepend(add("title", {}, title));
  return new XMLSerializer().serializeToString(copy);
}

/** Draws an SVG with twice the pixels of the screen. */
export async function drawPng(svg: string): Promise<Blob> {
  const image = new Image();
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    await new Promise((resolve, reject) => {
      image.onload = resolve;
      image.onerror = () => reject(new Error("The browser cannot draw the picture."));
      image.src = address;
    });
    const canvas = document.createElement("canvas");
    const ratio = 2;
    [canvas.width, canvas.height] = [image.naturalWidth * ratio, image.naturalHeight * ratio];
    canvas.getContext("2d")!.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) =>
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("The browser cannot write the picture."))), "image/png"),
    );
  } finally {
    URL.revokeObjectURL(address);
  }
}
