// SPDX-License-Identifier: MIT
/** Selects the engine: the server that delivered the page with a token in its address, or WebAssembly beside the page. */
import type { Engine } from "./engine";
import { HttpEngine, type Workspace } from "./http";
import { WasmEngine } from "./wasm";

export interface Setting {
  engine: Engine;
  workspace: Workspace | null;
}

const stored = "talus-studio-token";

/** The token moves from the address into the session, so that it is in no history and in no picture of the screen. */
function readToken(): string {
  const inAddress = location.hash.slice(1);
  if (/^[A-Za-z0-9_-]{16,}$/.test(inAddress)) {
    sessionStorage.setItem(stored, inAddress);
    history.replaceState(null, "", location.pathname + location.search);
    return inAddress;
  }
  return sessionStorage.getItem(stored) ?? "";
}

export function selectEngine(): Setting {
  const token = readToken();
  if (token) {
    const engine = new HttpEngine(token);
    return { engine, workspace: engine };
  }
  return { engine: new WasmEngine(new URL("talus.js", document.baseURI).href), workspace: null };
}
