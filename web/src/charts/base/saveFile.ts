// SPDX-License-Identifier: MIT
/** Hands a file to the browser's downloads. */
export function saveFile(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  // The browser has taken the data by then; without this the blob would stay for the life of the page.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
