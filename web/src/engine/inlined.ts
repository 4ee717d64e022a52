// The engine of a page that is one file: within it, for a page from disk may start no worker of its own.

import base64 from "leadscrew:lesson.wasm?base64";
import { EngineModule } from "./module";
import { Recorder } from "./recorder";
import type { Engine } from "./types";

export async function openEngine(): Promise<Engine> {
  const text = atob(base64);
  return new Recorder(await EngineModule.of(Uint8Array.from(text, (character) => character.charCodeAt(0))));
}
