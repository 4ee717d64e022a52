// The planner of a page that is one file: a worker of text that is within it.

import base64 from "leadscrew:program.wasm?base64";
import InlineWorker from "./planner_worker?worker&inline";

export async function wasmBytes(): Promise<Uint8Array> {
  const text = atob(base64);
  return Uint8Array.from(text, (character) => character.charCodeAt(0));
}

export function startWorker(): Worker {
  return new InlineWorker();
}
