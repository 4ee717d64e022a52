// The engine of a page that a host serves: in a worker, so that the page never waits for it.

import wasm from "leadscrew:lesson.wasm?url";
import type { Engine, EngineMethod } from "./types";
import type { Reply, Request } from "./worker";

export async function openEngine(): Promise<Engine> {
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  const waiting = new Map<number, { resolve: (result: unknown) => void; reject: (reason: Error) => void }>();
  let last = 0;
  worker.onmessage = ({ data }: MessageEvent<Reply>) => {
    const asked = waiting.get(data.id);
    waiting.delete(data.id);
    if (data.failure === undefined) asked?.resolve(data.result);
    else asked?.reject(new Error(data.failure));
  };
  worker.postMessage({ wasm: new URL(wasm, document.baseURI).href } satisfies Request);
  const call = (method: EngineMethod, args: unknown[]): Promise<never> =>
    new Promise((resolve, reject) => {
      const id = ++last;
      waiting.set(id, { resolve: resolve as (result: unknown) => void, reject });
      worker.postMessage({ id, method, args } satisfies Request);
    });
  return {
    catalogue: () => call("catalogue", []),
    problems: (task) => call("problems", [task]),
    load: (task, most) => call("load", [task, most]),
    why: (clock) => call("why", [clock]),
  };
}
