// The planner of a page that is one file: a worker of text that is within it.

import text from "leadscrew:program.wasm?packed";
import { unpacked } from "../ui/packing";
import InlineWorker from "./planner_worker?worker&inline";

export async function compiledModule(): Promise<WebAssembly.Module> {
  return await WebAssembly.compile(await unpacked(text));
}

export function startWorker(): Worker {
  return new InlineWorker();
}
