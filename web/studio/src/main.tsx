// SPDX-License-Identifier: MIT
// Starts the studio: selects the engine, draws the page.
import { render } from "preact";

import "../../src/styles/tokens.css";
import "../../src/styles/base.css";
import "../../src/styles/bar.css";
import "./styles/layout.css";
import "./styles/canvas.css";
import "./styles/forms.css";
import { keepBackground } from "./background/background";
import "./styles/runs.css";
import { App } from "./App";
import { selectEngine } from "./engine/select";
import { keepLibrary } from "./library/library";
import { start, whenStarted } from "./session";

render(<App />, document.getElementById("app")!);
whenStarted(keepBackground);
whenStarted(keepLibrary);
void start(selectEngine());
