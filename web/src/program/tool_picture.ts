// A tool as a body about its axis: cutter with its round edge, and holder.

import type { ToolShape } from "../engine/motion_types";
import { dot, frameOf, type Camera } from "./camera";

export interface StandingTool {
  readonly tip: readonly number[];
  /** From the tip to the spindle. */
  readonly direction: readonly number[];
  /** Undefined where nothing is told of it. */
  readonly shape: ToolShape | undefined;
}

interface Slice {
  /** Above the tip, and from the axis, mm. */
  readonly height: number;
  readonly radius: number;
}

export interface Body {
  readonly isHolder: boolean;
  /** From below. */
  readonly slices: readonly Slice[];
}

const edgeSlices = 6; // of a round edge
const unknownLength = 4; // diameters, where no length is told
const [pointRadius, pointHeight] = [9, 27]; // px, of a tool of no told shape

/** `scale`: pixels a mm, for the point that stands for a tool of which nothing is told. */
export function outlineOf({ shape }: StandingTool, scale: number): Body[] {
  if (shape === undefined || !(shape.diameter > 0)) {
    const slices = [
      { height: 0, radius: 0 },
      { height: pointHeight / scale, radius: pointRadius / scale },
    ];
    return [{ isHolder: false, slices }];
  }
  const radius = shape.diameter / 2;
  const corner = Math.min(Math.max(shape.cornerRadius, 0), radius);
  const top = Math.max(shape.length > 0 ? shape.length : unknownLength * shape.diameter, corner);
  const slices = [...Array(edgeSlices + 1).keys()].map((i) => {
    const angle = (i / edgeSlices) * (Math.PI / 2);
    return { height: corner * (1 - Math.cos(angle)), radius: radius - corner + corner * Math.sin(angle) };
  });
  const bodies: Body[] = [{ isHolder: false, slices: [...slices, { height: top, radius }] }];
  if (shape.holderDiameter > 0) {
    const holder = shape.holderDiameter / 2;
    const end = top + (shape.holderLength > 0 ? shape.holderLength : shape.holderDiameter);
    const walls = [
      { height: top, radius: holder },
      { height: end, radius: holder },
    ];
    bodies.push({ isHolder: true, slices: walls });
  }
  return bodies;
}

const ringPlaces = 32;

/** What bodies cover of the picture, whose pixels `project` gives: each is convex, and so is what is seen of it. */
export function silhouettesOf(
  tool: StandingTool,
  camera: Camera,
  project: (at: readonly number[]) => [number, number],
): { readonly isHolder: boolean; readonly points: number[] }[] {
  const [right, up, out] = frameOf(camera);
  const { direction } = tool;
  const along = [dot(right, direction), -dot(up, direction)] as const; // of the axis on the screen, its y downwards
  const length = Math.hypot(...along);
  const across = length > 1e-6 ? ([-along[1] / length, along[0] / length] as const) : ([1, 0] as const);
  const flat = Math.abs(dot(out, direction));
  const [x, y] = project(tool.tip);
  return outlineOf(tool, camera.scale).map(({ isHolder, slices }) => {
    const places: [number, number][] = [];
    for (const { height, radius } of slices) {
      const [cx, cy] = [x + along[0] * height * camera.scale, y + along[1] * height * camera.scale];
      const reach = Math.max(radius * camera.scale, 0.5);
      for (let i = 0; i < ringPlaces; ++i) {
        const angle = (2 * Math.PI * i) / ringPlaces;
        const [wide, high] = [reach * Math.cos(angle), reach * flat * Math.sin(angle)];
        places.push([cx + wide * across[0] - high * across[1], cy + wide * across[1] + high * across[0]]);
      }
    }
    return { isHolder, points: hullOf(places).flat() };
  });
}

/** The convex hull, by Andrew's monotone chain. */
function hullOf(places: [number, number][]): [number, number][] {
  places.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (some: readonly [number, number][]): [number, number][] => {
    const hull: [number, number][] = [];
    for (const [x, y] of some) {
      for (; hull.length > 1; hull.pop()) {
        const [[ax, ay], [bx, by]] = hull.slice(-2) as [[number, number], [number, number]];
        if ((bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0) break;
      }
      hull.push([x, y]);
    }
    return hull.slice(0, -1);
  };
  return [...half(places), ...half([...places].reverse())];
}
