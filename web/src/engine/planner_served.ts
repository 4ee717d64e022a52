// The planner of a page that a host serves.

import wasm from "leadscrew:program.wasm?url";

/** While it comes, where the host says what it is. */
export async function compiledModule(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL(wasm, document.baseURI));
  if (response.headers.get("content-type") === "application/wasm") return await WebAssembly.compileStreaming(response);
  return await WebAssembly.compile(await response.arrayBuffer());
}

export function startWorker(): Worker {
  return new Worker(new URL("./planner_worker.ts", import.meta.url), { type: "module" });
}
