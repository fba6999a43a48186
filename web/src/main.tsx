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
import { readReport } from "./data";
import { Page } from "./page/Page";
import { preparePrinting } from "./page/TopBar";
import { report } from "./state";

const root = document.getElementById("app")!;

function start() {
  const found = readReport();
  if (!found) {
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
