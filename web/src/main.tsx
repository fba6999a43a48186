// SPDX-License-Identifier: MIT
// Starts the page: reads the report that was filled in and draws it.
import { render } from "preact";

import "./styles/tokens.css";
import "./styles/base.css";
import "./styles/tables.css";
import "./styles/bar.css";
import "./styles/answer.css";
import "./styles/parts.css";
import "./styles/print.css";
import { type ReportData, readReport } from "./data";
import { Page } from "./page/Page";
import { preparePrinting } from "./page/TopBar";
import { followReport, report } from "./state";

const root = document.getElementById("app")!;

/** In a frame of the studio, which sends the report and its later states. */
function follow() {
  root.textContent = "";
  document.documentElement.dataset.embedded = "";
  addEventListener("message", ({ source, data }: MessageEvent<{ theme?: string; data?: ReportData }>) => {
    if (source !== window.parent) return;
    if (data.theme) document.documentElement.dataset.theme = data.theme;
    if (!data.data) return;
    const isFirst = report.peek() === null;
    followReport(data.data);
    document.title = `${report.value.title} – Talus report`;
    if (!isFirst) return;
    preparePrinting(report.value);
    render(<Page />, root);
  });
  window.parent.postMessage("talus-report", "*");
}

function start() {
  const found = readReport();
  if (!found) {
    if (window.parent !== window) return follow();
    root.textContent = "This page holds no report. It is filled by `talus report DIR`.";
    return;
  }
  report.value = found;
  document.title = `${found.title} – Talus report`;
  preparePrinting(found);
  render(<Page />, root);
}

try {
  start();
} catch (error) {
  root.textContent = `This report cannot be shown: ${error instanceof Error ? error.message : String(error)}.`;
}
