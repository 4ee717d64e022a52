// The page's side of the picture by WebGL.

import { startWorker } from "leadscrew:scene";
import { buffersOf } from "../engine/buffers";
import type { PathData, SurfaceMesh } from "../engine/motion_types";
import { colour } from "../ui/theme";
import type { Camera } from "./camera";
import type { Look } from "./colours";
import type { SceneRequest } from "./scene_worker";

export class SceneClient {
  readonly canvas = document.createElement("canvas");
  private readonly worker: Worker;
  private isDrawing = false;
  private wanted: Camera | undefined;

  /** Throws where there is no WebGL, or none for workers. `drawn` hears of each picture. */
  constructor(drawn: () => void) {
    const probe = document.createElement("canvas").getContext("webgl2");
    if (probe === null) throw new Error("no WebGL");
    probe.getExtension("WEBGL_lose_context")?.loseContext();
    const canvas = this.canvas.transferControlToOffscreen();
    this.worker = startWorker();
    this.worker.onmessage = () => {
      this.isDrawing = false;
      if (this.wanted !== undefined) this.draw(this.wanted);
      drawn();
    };
    this.worker.postMessage({ canvas } satisfies SceneRequest, [canvas]);
  }

  size(width: number, height: number): void {
    this.send({ width, height, ratio: devicePixelRatio || 1 });
  }

  /** The page has the path's arrays no more. */
  load(path: PathData, surfaces: readonly SurfaceMesh[], contour: Float32Array): void {
    this.worker.postMessage({ path, surfaces, contour } satisfies SceneRequest, buffersOf(path));
  }

  /** How far each vertex is from the program, of its tolerance. */
  judge(share: Float32Array): void {
    this.send({ share });
  }

  paint(look: Look, hasContour: boolean): void {
    const contour = hasContour ? colour("ink") : undefined;
    this.send({ look, paints: { rapid: colour("truth"), surface: colour("truth"), contour } });
  }

  /** Nothing is being drawn, and nothing is to be. */
  get isIdle(): boolean {
    return !this.isDrawing && this.wanted === undefined;
  }

  /** From there; of several asked for while one is drawn, the last. */
  draw(camera: Camera): void {
    this.wanted = this.isDrawing ? camera : undefined;
    if (this.isDrawing) return;
    this.isDrawing = true;
    this.send({ camera, paper: colour("paper") });
  }

  private send(request: SceneRequest): void {
    this.worker.postMessage(request);
  }
}
