// The engine of a page that is one file: within it, for a page from disk may start no worker of its own.

import text from "leadscrew:lesson.wasm?packed";
import { unpacked } from "../ui/packing";
import { EngineModule } from "./module";
import { Recorder } from "./recorder";
import type { Engine } from "./types";

export async function openEngine(): Promise<Engine> {
  return new Recorder(await EngineModule.of(await unpacked(text)));
}
