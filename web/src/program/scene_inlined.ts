// Who draws the path on a page that is one file: a worker of text that is within it.

import InlineWorker from "./scene_worker?worker&inline";

export function startWorker(): Worker {
  return new InlineWorker();
}
