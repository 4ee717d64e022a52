// The planner in a worker: a call a message, and how far it is while it works.

import { buffersOf } from "./buffers";
import type { Phase, PlannerMethod } from "./motion_types";
import { Planner } from "./planner";

export type Request =
  | { readonly compiled: WebAssembly.Module }
  | { readonly id: number; readonly method: PlannerMethod; readonly args: unknown[] };
export type Reply =
  | { readonly phase: Phase; readonly share: number }
  | { readonly id: number; readonly result?: unknown; readonly failure?: string };

const betweenTellings = 50; // ms

let planner: Promise<Planner> | undefined;
let last = 0;

function tell(phase: Phase, share: number): void {
  const now = performance.now();
  if (share > 0 && now - last < betweenTellings) return;
  last = now;
  self.postMessage({ phase, share } satisfies Reply);
}

self.onmessage = async ({ data }: MessageEvent<Request>) => {
  if ("compiled" in data) {
    planner = Planner.of(data.compiled, tell);
    return;
  }
  try {
    const call = (await planner)?.[data.method] as (...args: unknown[]) => Promise<unknown>;
    const result = await call.apply(await planner, data.args);
    self.postMessage({ id: data.id, result } satisfies Reply, { transfer: buffersOf(result) });
  } catch (failure) {
    self.postMessage({ id: data.id, failure: String(failure) } satisfies Reply);
  }
};
