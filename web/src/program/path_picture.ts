// The path on a picture of two dimensions: as a file, and on the screen of a browser without WebGL.

import type { Picture } from "../draw/picture";
import type { PathData, SurfaceMesh } from "../engine/motion_types";
import { colour } from "../ui/theme";
import { dot, frameOf, projector, type Camera } from "./camera";
import { silhouettesOf, type StandingTool } from "./tool_picture";

function hex(colours: Float32Array, v: number): string {
  const digits = [0, 1, 2].map((i) =>
    Math.round((colours[v * 3 + i] ?? 0) * 31)
      .toString(10)
      .padStart(2, "0"),
  );
  return digits.join(" ");
}

/** One line for each run of vertices with a colour; colours are told apart by 32 steps a channel. */
export function drawPath(
  to: Picture,
  path: PathData,
  colours: Float32Array,
  camera: Camera,
  surfaces: readonly SurfaceMesh[],
  contour: Float32Array,
  tool: StandingTool | undefined,
): void {
  to.rectangle(0, 0, to.width, to.height, colour("paper"));
  const project = projector(camera, to.width, to.height);
  drawSurfaces(to, surfaces, camera, project);
  drawContour(to, contour, project);
  const at = (v: number): [number, number] => project([...path.places.subarray(v * 3, v * 3 + 3)]);
  const nameOf = (v: number): string => (path.isRapid[v] === 1 ? "rapid" : hex(colours, v));
  let points: number[] = [];
  let name = "";
  const flush = (): void => {
    if (points.length >= 4) {
      const isRapid = name === "rapid";
      const channels = name.split(" ").map((each) => Math.round((Number(each) / 31) * 255));
      to.line(points, {
        colour: isRapid ? colour("truth") : `rgb(${channels.join(",")})`,
        width: isRapid ? 1 : 2,
        ...(isRapid ? { dash: [4, 4] } : {}),
      });
    }
  };
  for (let v = 1; v < path.samples.length; ++v) {
    if (nameOf(v) !== name || path.isApart[v] === 1) {
      flush();
      name = nameOf(v);
      points = path.isApart[v] === 1 ? [] : at(v - 1);
    }
    points.push(...at(v));
  }
  flush();
  if (tool === undefined) return;
  for (const { isHolder, points } of silhouettesOf(tool, camera, project))
    to.area(points, colour(isHolder ? "truth" : "y"), 0.55);
  to.circle(...project(tool.tip), 2.5, { fill: colour("ink") });
}

/** Thin and dashed; lines that begin where the last one ends go on. */
function drawContour(to: Picture, ends: Float32Array, project: (at: readonly number[]) => [number, number]): void {
  let points: number[] = [];
  const flush = (): void => {
    if (points.length >= 4) to.line(points, { colour: colour("ink"), width: 1, dash: [2, 3] });
  };
  for (let i = 0; i < ends.length; i += 6) {
    const goesOn = i > 0 && [0, 1, 2].every((k) => ends[i + k] === ends[i + k - 3]);
    if (!goesOn) {
      flush();
      points = project([...ends.subarray(i, i + 3)]);
    }
    points.push(...project([...ends.subarray(i + 3, i + 6)]));
  }
  flush();
}

/** Quadrilaterals, the farther ones first, lit from where one looks. */
function drawSurfaces(
  to: Picture,
  surfaces: readonly SurfaceMesh[],
  camera: Camera,
  project: (at: readonly number[]) => [number, number],
): void {
  const [, , out] = frameOf(camera);
  const cells: { readonly depth: number; readonly points: number[]; readonly light: number }[] = [];
  for (const { corners, normals } of surfaces)
    for (let cell = 0; cell + 12 <= corners.length; cell += 12) {
      const points: number[] = [];
      let [depth, light] = [0, 0];
      for (let corner = cell; corner < cell + 12; corner += 3) {
        const at = [...corners.subarray(corner, corner + 3)];
        points.push(...project(at));
        depth += dot(out, at) / 4;
        light += Math.abs(dot(out, [...normals.subarray(corner, corner + 3)])) / 4;
      }
      cells.push({ depth, points, light });
    }
  cells.sort((a, b) => a.depth - b.depth);
  for (const { points, light } of cells) {
    const grey = Math.round(110 + 95 * light);
    to.area(points, `rgb(${grey},${grey},${Math.min(255, grey + 8)})`, 1, true);
  }
}
