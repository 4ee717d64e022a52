// Who draws the path on a page that a host serves.

export function startWorker(): Worker {
  return new Worker(new URL("./scene_worker.ts", import.meta.url), { type: "module" });
}
