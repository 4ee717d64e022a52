// What the stage of a comparison shows: lanes on one curve, and strips over their common clock.

import type { Picture } from "../draw/picture";

/** What is seen: so many units across, around a place. */
export interface Camera {
  readonly x: number;
  readonly y: number;
  readonly across: number;
}

export const layouts = ["overlay", "beside"] as const;
export type Layout = (typeof layouts)[number];

export interface Scene {
  /** Clocks, of the longest lane. */
  readonly last: number;
  /** `number`: of all lanes, from 0, its colour and its dashes. */
  readonly lanes: readonly { readonly number: number; readonly title: string; readonly detail: string }[];
  /** That shows all of them, where none is chosen. */
  whole(size: { readonly width: number; readonly height: number }): Camera;
  /** All lanes over one another, or one of them. */
  drawPaths(picture: Picture, lane: number | undefined, camera: Camera | undefined, clock: number): void;
  drawStrip(strip: number, picture: Picture, clock: number): void;
}

export interface View {
  readonly layout: Layout;
  /** Undefined: all of it. */
  readonly camera: Camera | undefined;
}

const dashes: readonly (readonly number[])[] = [[], [9, 4], [3, 4], [10, 4, 2, 4]];

export function dashOf(number: number): readonly number[] {
  return dashes[number] ?? [];
}

/** Where strips have their left and right ends, pixels from those of the picture. */
export const stripMargin = { left: 52, right: 12 } as const;

/** The levels of a strip, and its clock: what belongs to them is drawn with the functions that it gives. */
export interface StripFrame {
  x(clock: number): number;
  y(value: number): number;
  readonly wide: number;
  readonly high: number;
}
