// SPDX-License-Identifier: MIT
/** The engine in WebAssembly, in a worker of its own, so that the page stays responsive while it calculates. */
import { type Checked, type Engine, EngineFault, type JsonSchema, openAnswer, type Solved, type SolveOptions } from "./engine";

type Call = "check" | "solve" | "schema" | "template";

interface Answer {
  id: number;
  answer?: string;
  error?: string;
}

export class WasmEngine implements Engine {
  readonly name = "WebAssembly";
  private readonly worker: Worker;
  private readonly waiting = new Map<number, { resolve: (text: string) => void; reject: (error: Error) => void }>();
  private next = 0;

  /** `address`: of talus.js, beside which talus.wasm lies. */
  constructor(address: string) {
    this.worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    this.worker.onmessage = ({ data }: MessageEvent<Answer>) => {
      const call = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if (data.error !== undefined) call?.reject(new EngineFault(data.error));
      else call?.resolve(data.answer ?? "null");
    };
    this.worker.onerror = (event) => {
      const fault = new EngineFault(`The engine stopped: ${event.message || "it could not be loaded"}. Reload the page; your text is kept.`);
      for (const { reject } of this.waiting.values()) reject(fault);
      this.waiting.clear();
    };
    this.worker.postMessage({ address });
  }

  private call(name: Call, ...values: string[]): Promise<string> {
    return new Promise((resolve, reject) => {
      const id = this.next++;
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, name, values });
    });
  }

  check = async (text: string) => openAnswer<Checked>(JSON.parse(await this.call("check", text)));
  solve = async (text: string, options: SolveOptions) =>
    openAnswer<Solved>(JSON.parse(await this.call("solve", text, JSON.stringify(options))));
  schema = async () => openAnswer<JsonSchema>(JSON.parse(await this.call("schema")));
  template = () => this.call("template");
}
