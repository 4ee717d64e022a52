// What moves over the path: the line in motion, and the tool.

import type { PathData } from "../engine/motion_types";
import { colour } from "../ui/theme";
import { projector, type Camera } from "./camera";

const mostMarked = 60_000; // segments; a line with more of them is not told apart
const [toolRadius, toolHeight] = [9, 27]; // px

export class Overlay {
  readonly canvas = document.createElement("canvas");
  private marked: readonly number[] = [];

  /** Segments that lead to these vertices stand out. */
  mark(vertices: readonly number[]): void {
    this.marked = vertices.length > mostMarked ? [] : vertices;
  }

  draw(camera: Camera, width: number, height: number, path: PathData, tool: readonly number[] | undefined): void {
    const { canvas } = this;
    const ratio = devicePixelRatio || 1;
    canvas.width = Math.round(width * ratio); // and is empty
    canvas.height = Math.round(height * ratio);
    const to = canvas.getContext("2d");
    if (to === null) return;
    to.scale(ratio, ratio);
    const project = projector(camera, width, height);
    this.drawMarked(to, path, project);
    if (tool !== undefined) drawTool(to, project(tool), camera);
  }

  private drawMarked(
    to: CanvasRenderingContext2D,
    path: PathData,
    project: (at: readonly number[]) => [number, number],
  ): void {
    const at = (v: number): [number, number] => project([...path.places.subarray(v * 3, v * 3 + 3)]);
    to.beginPath();
    let last = -1;
    for (const v of this.marked) {
      if (v - 1 !== last) to.moveTo(...at(v - 1));
      to.lineTo(...at(v));
      last = v;
    }
    to.lineCap = "round";
    to.lineJoin = "round";
    to.lineWidth = 6;
    to.globalAlpha = 0.5;
    to.strokeStyle = colour("accent");
    to.stroke();
    to.globalAlpha = 1;
  }
}

/** A cone that stands on its point. */
function drawTool(to: CanvasRenderingContext2D, [x, y]: [number, number], camera: Camera): void {
  const elevation = (camera.elevation * Math.PI) / 180;
  const top = y - toolHeight * Math.cos(elevation);
  const flat = toolRadius * Math.abs(Math.sin(elevation));
  to.globalAlpha = 0.85;
  to.fillStyle = colour("warm");
  to.beginPath();
  to.moveTo(x - toolRadius, top);
  to.lineTo(x, y);
  to.lineTo(x + toolRadius, top);
  to.ellipse(x, top, toolRadius, flat, 0, 0, 2 * Math.PI);
  to.fill("nonzero");
  to.globalAlpha = 1;
}
