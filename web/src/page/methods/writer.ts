// SPDX-License-Identifier: MIT
/** What a writer of the methods section takes and gives. */
import type { Report } from "../../contract";

/** Text with $inline formulas$ and [@references], or an equation in TeX and as plain characters. */
export type Block = { text: string } | { tex: string; plain: string };
export type Writer = (report: Report) => Block[];
