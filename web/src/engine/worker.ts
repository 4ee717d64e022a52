// The engine in a worker: a call a message.

import { EngineModule } from "./module";
import { Recorder } from "./recorder";
import type { Engine, EngineMethod } from "./types";

export type Request =
  | { readonly wasm: string }
  | { readonly id: number; readonly method: EngineMethod; readonly args: unknown[] };
export type Reply = { readonly id: number; readonly result?: unknown; readonly failure?: string };

let engine: Promise<Engine> | undefined;

async function begin(address: string): Promise<Engine> {
  const bytes = await (await fetch(address)).arrayBuffer();
  return new Recorder(await EngineModule.of(bytes));
}

self.onmessage = async ({ data }: MessageEvent<Request>) => {
  if ("wasm" in data) {
    engine = begin(data.wasm);
    return;
  }
  try {
    const call = (await engine)?.[data.method] as (...args: unknown[]) => Promise<unknown>;
    const result = await call.apply(await engine, data.args);
    self.postMessage({ id: data.id, result } satisfies Reply);
  } catch (failure) {
    self.postMessage({ id: data.id, failure: String(failure) } satisfies Reply);
  }
};
