// SPDX-License-Identifier: MIT
/** Which panel is open beside the canvas. */
import { signal } from "@preact/signals";

export type Tab = "selection" | "soils" | "case" | "text" | "runs";

export const tab = signal<Tab>("selection");

export function openTab(wanted: Tab): void {
  tab.value = wanted;
}

/** A range of the text that the text panel selects. */
export const shownSpan = signal<readonly [number, number] | null>(null);
