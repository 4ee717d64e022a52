// The path on a picture of two dimensions: as a file, and on the screen of a browser without WebGL.

import type { Picture } from "../draw/picture";
import type { PathData } from "../engine/motion_types";
import { colour } from "../ui/theme";
import { projector, type Camera } from "./camera";

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
  tool: readonly number[] | undefined,
): void {
  to.rectangle(0, 0, to.width, to.height, colour("paper"));
  const project = projector(camera, to.width, to.height);
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
  if (tool !== undefined) to.circle(...project(tool), 5, { fill: colour("warm") });
}
