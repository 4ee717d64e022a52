// What moves over the path: the line in motion, and the tool.

import type { PathData } from "../engine/motion_types";
import { colour } from "../ui/theme";
import { projector, type Camera } from "./camera";
import { silhouettesOf, type StandingTool } from "./tool_picture";

export type { StandingTool } from "./tool_picture";

const mostMarked = 60_000; // segments; a line with more of them is not told apart
const markRadius = 6; // px

export class Overlay {
  readonly canvas = document.createElement("canvas");
  /** Places, mm: where the tool cuts too deep, and where it passes a pole. */
  gouges: readonly (readonly number[])[] = [];
  poles: readonly (readonly number[])[] = [];
  private marked: readonly number[] = [];

  /** Segments that lead to these vertices stand out. */
  mark(vertices: readonly number[]): void {
    this.marked = vertices.length > mostMarked ? [] : vertices;
  }

  draw(camera: Camera, width: number, height: number, path: PathData, tool: StandingTool | undefined): void {
    const { canvas } = this;
    const ratio = devicePixelRatio || 1;
    canvas.width = Math.round(width * ratio); // and is empty
    canvas.height = Math.round(height * ratio);
    const to = canvas.getContext("2d");
    if (to === null) return;
    to.scale(ratio, ratio);
    const project = projector(camera, width, height);
    this.drawMarked(to, path, project);
    for (const place of this.poles) drawPole(to, project(place));
    if (tool !== undefined) drawTool(to, tool, camera, project);
    for (const place of this.gouges) drawGouge(to, project(place));
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

function drawTool(
  to: CanvasRenderingContext2D,
  tool: StandingTool,
  camera: Camera,
  project: (at: readonly number[]) => [number, number],
): void {
  to.globalAlpha = 0.55;
  for (const { isHolder, points } of silhouettesOf(tool, camera, project)) {
    to.fillStyle = colour(isHolder ? "truth" : "y");
    to.beginPath();
    for (let i = 0; i < points.length; i += 2) to.lineTo(points[i] ?? 0, points[i + 1] ?? 0);
    to.fill();
  }
  to.globalAlpha = 1;
  to.beginPath();
  to.arc(...project(tool.tip), 2.5, 0, 2 * Math.PI);
  to.fillStyle = colour("ink");
  to.fill();
}

function drawGouge(to: CanvasRenderingContext2D, [x, y]: [number, number]): void {
  to.lineWidth = 2.5;
  to.strokeStyle = colour("warm");
  to.beginPath();
  to.moveTo(x - markRadius, y - markRadius);
  to.lineTo(x + markRadius, y + markRadius);
  to.moveTo(x - markRadius, y + markRadius);
  to.lineTo(x + markRadius, y - markRadius);
  to.stroke();
}

function drawPole(to: CanvasRenderingContext2D, [x, y]: [number, number]): void {
  to.lineWidth = 2;
  to.strokeStyle = colour("accent");
  to.beginPath();
  to.arc(x, y, markRadius, 0, 2 * Math.PI);
  to.moveTo(x - markRadius - 3, y);
  to.lineTo(x + markRadius + 3, y);
  to.stroke();
}
