// Tools, surfaces, contours and gouges, as leadscrew.h tells them.

import * as layout from "./layout";
import type { MotionModule } from "./motion_module";
import type { Gouge, SurfaceMesh, ToolShape } from "./motion_types";

export function toolAt(module: MotionModule, at: number): ToolShape {
  const of = layout.tool;
  return {
    number: module.view.getInt32(at + of.number, true),
    diameter: module.number(at + of.diameter),
    cornerRadius: module.number(at + of.cornerRadius),
    length: module.number(at + of.length),
    holderDiameter: module.number(at + of.holderDiameter),
    holderLength: module.number(at + of.holderLength),
  };
}

export function surfaceAt(module: MotionModule, at: number): SurfaceMesh {
  const of = layout.surface;
  const cells = module.view.getUint32(at + of.cells, true);
  const numbers = (field: number): Float32Array =>
    Float32Array.from(
      new Float64Array(module.calls.memory.buffer, module.view.getUint32(at + field, true), cells * 12),
    );
  return {
    number: module.view.getInt32(at + of.number, true),
    corners: numbers(of.corners),
    normals: numbers(of.normals),
  };
}

/** Its lines, behind those that there are. */
export function takeContour(module: MotionModule, at: number, lines: number[]): void {
  const of = layout.contour;
  const count = module.view.getUint32(at + of.count, true);
  const places = module.numbers(module.view.getUint32(at + of.places, true), 3 * count);
  for (let i = 3; i < places.length; i += 3) lines.push(...places.slice(i - 3, i + 3));
}

export function gougeAt(module: MotionModule, at: number): Gouge {
  const of = layout.gouge;
  const whole = (field: number): number => module.view.getInt32(at + field, true);
  return {
    line: module.integer(at + of.line),
    part: whole(of.part),
    toolPart: whole(of.toolPart),
    pass: whole(of.pass),
    surface: whole(of.surface),
    depth: module.number(at + of.depth),
    u: module.number(at + of.u),
    v: module.number(at + of.v),
    place: module.numbers(at + of.place, 3),
    tip: module.numbers(at + of.tip, 3),
  };
}
