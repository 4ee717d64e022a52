// The path by WebGL in a worker: however long a large path takes to draw, the page stays free.

import type { PathData, SurfaceMesh } from "../engine/motion_types";
import type { Camera } from "./camera";
import { coloursOf, type Look } from "./colours";
import { Scene, type Paints } from "./scene";

export type SceneRequest =
  | { readonly canvas: OffscreenCanvas }
  | { readonly width: number; readonly height: number; readonly ratio: number }
  | { readonly path: PathData; readonly surfaces: readonly SurfaceMesh[]; readonly contour: Float32Array }
  | { readonly share: Float32Array }
  | { readonly look: Look; readonly paints: Paints }
  | { readonly camera: Camera; readonly paper: string };
/** A picture has been drawn. */
export type SceneReply = "drawn";

let scene: Scene | undefined;
let path: PathData | undefined;

self.onmessage = ({ data }: MessageEvent<SceneRequest>) => {
  if ("canvas" in data) {
    scene = new Scene(data.canvas);
  } else if ("path" in data) {
    path = data.path;
    scene?.load(path, data.surfaces, data.contour);
  } else if ("share" in data) {
    if (path !== undefined) path.share = data.share;
  } else if ("look" in data) {
    if (path !== undefined) scene?.paint(coloursOf(path, data.look), data.paints);
  } else if ("width" in data) {
    scene?.size(data.width, data.height, data.ratio);
  } else {
    // Within a frame: what is drawn between two is shown when the next one is.
    self.requestAnimationFrame(() => {
      scene?.draw(data.camera, data.paper);
      self.postMessage("drawn" satisfies SceneReply);
    });
  }
};
