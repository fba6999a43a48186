// SPDX-License-Identifier: MIT
/** What the report adds to `methods` of the results. */

/** Of a case that asks for several methods, or for others than material points. */
export interface MethodsRead {
  /** Name of the slip surface of the slices that governs; absent where they have no factor. */
  governing?: string;
  /** The remarks by topic: "Slices", "Mechanism". */
  reading: { topic: string; sentences: string[] }[];
}
