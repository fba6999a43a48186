// SPDX-License-Identifier: MIT
/** The case as it was understood: nested tables whose leaves are InputValue. */

export interface InputValue {
  value: unknown;
  given: boolean;
  unit?: string;
}

export type InputTable = { [key: string]: InputTable | InputTable[] | InputValue };
