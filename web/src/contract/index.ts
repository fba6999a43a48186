/** The data contract between the program and this page, as the page imports it: every room of this folder. */
export type * from "./calibration";
export type * from "./methods";
export type * from "./report";
export type * from "./sampling";
export type * from "./water";
