// SPDX-License-Identifier: MIT
/** The data contract between the program and this page, as the page imports it: every room of this folder. */
export type * from "./answer";
export type * from "./bounds";
export type * from "./elements";
export type * from "./input";
export type * from "./methods";
export type * from "./model";
export type * from "./report";
export type * from "./results";
export type * from "./run";
export type * from "./slices";
export type * from "./study";
export type * from "./timeline";
export type * from "./units";
export type * from "./water";
