// SPDX-License-Identifier: MIT
/** Interface of the writers of the methods section. */
import type { Report } from "../../contract";

/** Text with $inline formulas$ and [@references], or an equation in TeX and as plain characters. */
export type Block = { text: string } | { tex: string; plain: string };
export type Writer = (report: Report) => Block[];
