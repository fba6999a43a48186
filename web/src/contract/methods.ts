// SPDX-License-Identifier: MIT
/** What the report adds to `methods` of the results. */

/** Of a case that asks for several methods, or for others than MPM. */
export interface MethodsRead {
  /** Name of the governing slip surface of LEM; absent where LEM has no factor. */
  governing?: string;
  /** The remarks by topic: "LEM", "Mechanism". */
  reading: { topic: string; sentences: string[] }[];
}
