// The page's side of the planner: calls it in its worker, and ends the worker to end a call.

import { compiledModule, startWorker } from "leadscrew:planner";
import type { Phase, PlannerCalls, PlannerMethod } from "./motion_types";
import type { Reply, Request } from "./planner_worker";

/** The call was ended before it was done. */
class Cancelled extends Error {}

/** What a call gives, or nothing where it was ended before it was done. */
export async function unlessCancelled<T>(call: Promise<T>): Promise<T | undefined> {
  try {
    return await call;
  } catch (failure) {
    if (failure instanceof Cancelled) return undefined;
    throw failure;
  }
}

interface Waiting {
  readonly resolve: (result: unknown) => void;
  readonly reject: (reason: Error) => void;
}

export class PlannerClient implements PlannerCalls {
  onProgress: (phase: Phase, share: number) => void = () => {};
  private waiting = new Map<number, Waiting>();
  private last = 0;

  private constructor(
    private readonly compiled: WebAssembly.Module,
    private worker: Worker,
  ) {
    this.begin(worker);
  }

  /** The worker starts while its module is compiled. */
  static async open(): Promise<PlannerClient> {
    const compiled = compiledModule();
    const worker = startWorker();
    return new PlannerClient(await compiled, worker);
  }

  readonly limits: PlannerCalls["limits"] = (machine) => this.call("limits", [machine]);
  readonly check: PlannerCalls["check"] = (task) => this.call("check", [task]);
  readonly plan: PlannerCalls["plan"] = (task, most) => this.call("plan", [task, most]);
  readonly sampled: PlannerCalls["sampled"] = (most) => this.call("sampled", [most]);
  readonly equipment: PlannerCalls["equipment"] = (task) => this.call("equipment", [task]);
  readonly gouges: PlannerCalls["gouges"] = (task) => this.call("gouges", [task]);
  readonly words: PlannerCalls["words"] = (task) => this.call("words", [task]);
  readonly circle: PlannerCalls["circle"] = (task) => this.call("circle", [task]);
  readonly slides: PlannerCalls["slides"] = (task, loops) => this.call("slides", [task, loops]);
  readonly judged: PlannerCalls["judged"] = (most) => this.call("judged", [most]);
  readonly trace: PlannerCalls["trace"] = () => this.call("trace", []);
  readonly steps: PlannerCalls["steps"] = (clock) => this.call("steps", [clock]);
  readonly explain: PlannerCalls["explain"] = (block) => this.call("explain", [block]);

  get isBusy(): boolean {
    return this.waiting.size > 0;
  }

  /** Ends what is under way; what was planned is forgotten. */
  cancel(): void {
    if (!this.isBusy) return;
    this.worker.terminate();
    const ended = this.waiting;
    this.waiting = new Map();
    this.worker = startWorker();
    this.begin(this.worker);
    for (const { reject } of ended.values()) reject(new Cancelled("cancelled"));
  }

  private begin(worker: Worker): void {
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      if ("phase" in data) return this.onProgress(data.phase, data.share);
      const asked = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if (data.failure === undefined) asked?.resolve(data.result);
      else asked?.reject(new Error(data.failure));
    };
    worker.postMessage({ compiled: this.compiled } satisfies Request);
  }

  private call(method: PlannerMethod, args: unknown[]): Promise<never> {
    return new Promise((resolve, reject) => {
      const id = ++this.last;
      this.waiting.set(id, { resolve: resolve as (result: unknown) => void, reject });
      this.worker.postMessage({ id, method, args } satisfies Request);
    });
  }
}
