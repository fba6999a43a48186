// SPDX-License-Identifier: MIT
/** The data contract between the program and this page, as the page imports it: every room of this folder. */
export type * from "./answer";
export type * from "./drawn";
export type * from "./model";
export type * from "./report";
export type * from "./results";
export type * from "./run";
export type * from "./units";
