// SPDX-License-Identifier: MIT
// Starts the studio: selects the engine, draws the page.
import { render } from "preact";

import "../../src/styles/tokens.css";
import "../../src/styles/base.css";
import "../../src/styles/bar.css";
import "./styles/layout.css";
import "./styles/canvas.css";
import "./styles/forms.css";
import { App } from "./App";
import { selectEngine } from "./engine/select";
import { start } from "./session";

render(<App />, document.getElementById("app")!);
void start(selectEngine());
