// The planner of a page that a host serves.

import wasm from "leadscrew:program.wasm?url";

export async function wasmBytes(): Promise<ArrayBuffer> {
  return await (await fetch(new URL(wasm, document.baseURI))).arrayBuffer();
}

export function startWorker(): Worker {
  return new Worker(new URL("./planner_worker.ts", import.meta.url), { type: "module" });
}
