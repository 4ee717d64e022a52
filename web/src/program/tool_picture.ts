// A tool as a body about its axis: cutter with its round edge, and holder.

import type { ToolShape } from "../engine/motion_types";

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
