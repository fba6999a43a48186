// SPDX-License-Identifier: MIT
/** The worker of the engine: loads talus.js once, then answers calls one after the other. */
interface TalusModule {
  check(text: string): string;
  solve(text: string, options: string): string;
  schema(): string;
  template(): string;
}

type Call = { address: string } | { id: number; name: keyof TalusModule; values: string[] };

let engine: Promise<TalusModule> | null = null;

async function load(address: string): Promise<TalusModule> {
  const { default: make } = (await import(/* @vite-ignore */ address)) as { default: () => Promise<TalusModule> };
  return make();
}

self.onmessage = async ({ data }: MessageEvent<Call>) => {
  if ("address" in data) {
    engine = load(data.address);
    // The first call reports why it cannot be loaded.
    engine.catch(() => undefined);
    return;
  }
  const { id, name, values } = data;
  try {
    const found = (await engine!) as unknown as Record<string, (...texts: string[]) => string>;
    self.postMessage({ id, answer: found[name]!(...values) });
  } catch (error) {
    const text = error instanceof Error ? error.message : String(error);
    self.postMessage({ id, error: `The engine cannot answer: ${text}` });
  }
};
