// What words, or the slides that follow them, make of a curve: places, errors, speeds, and figures of all until a word.

import type { Words } from "../engine/motion_types";
import { lengthOf, nearest, type Curve } from "./curves";

/** A lane as it is drawn, an entry a word; mm and s. */
export interface Track {
  /** s between two entries. */
  readonly period: number;
  readonly count: number;
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** The place of the curve that each is nearest to. */
  readonly trueX: Float64Array;
  readonly trueY: Float64Array;
  /** mm, > 0 to the left of the curve. */
  readonly error: Float64Array;
  /** Over the period before, mm/s. */
  readonly speed: Float64Array;
  /** Greatest and root mean square until each: error, chord error, acceleration, jerk. */
  readonly until: Readonly<Record<Figure, Float64Array>>;
}

export const figureNames = [
  "maxError",
  "rmsError",
  "chordError",
  "maxSpeed",
  "feedError",
  "acceleration",
  "jerk",
] as const;
export type Figure = (typeof figureNames)[number];

function matched(curve: Curve, x: Float64Array, y: Float64Array, speedMost: number, period: number): Float64Array {
  const length = lengthOf(curve);
  const ahead = Math.max(0.02, (4 * speedMost * period) / length);
  const found = new Float64Array(x.length);
  let u = 0;
  for (let i = 0; i < x.length; ++i) found[i] = u = nearest(curve, [x[i] ?? 0, y[i] ?? 0], u, ahead / 4, ahead);
  return found;
}

/** On which side of the curve's tangent. */
function sideOf(curve: Curve, u: number, x: number, y: number): number {
  const [beforeX, beforeY] = curve.at(Math.max(0, u - 1e-6));
  const [behindX, behindY] = curve.at(Math.min(1, u + 1e-6));
  const [atX, atY] = curve.at(u);
  return Math.sign((behindX - beforeX) * (y - atY) - (behindY - beforeY) * (x - atX));
}

/** Of words, or of slides where loops have followed them; `feed` as it is programmed, mm/s. */
export function trackOf(curve: Curve, words: Words, feed: number): Track {
  const { slides } = words;
  const count = slides?.count ?? words.count;
  const [x, y] = [new Float64Array(count), new Float64Array(count)];
  for (let i = 0; i < count; ++i) {
    const width = slides === undefined ? 3 : slides.axes.length;
    const from = slides?.position ?? words.position;
    x[i] = from[i * width] ?? 0;
    y[i] = from[i * width + 1] ?? 0;
  }
  const { period, window = 1 } = words;
  const speed = new Float64Array(count);
  for (let i = window; i < count; ++i)
    speed[i] = Math.hypot(difference(x, i, 1, window), difference(y, i, 1, window)) / (window * period);
  const found = matched(
    curve,
    x,
    y,
    speed.reduce((most, each) => Math.max(most, each), feed),
    period,
  );
  const [trueX, trueY, error] = [new Float64Array(count), new Float64Array(count), new Float64Array(count)];
  for (let i = 0; i < count; ++i) {
    const [px, py, u] = [x[i] ?? 0, y[i] ?? 0, found[i] ?? 0];
    const [cx, cy] = curve.at(u);
    [trueX[i], trueY[i]] = [cx, cy];
    error[i] = Math.hypot(px - cx, py - cy) * (sideOf(curve, u, px, py) || 1);
  }
  const plain = { period, count, x, y, trueX, trueY, error, speed };
  return { ...plain, until: figuresUntil(curve, plain, found, feed, words) };
}

/** Backward, of an order of 1 to 3, over so many entries each. */
function difference(values: Float64Array, i: number, order: number, window: number): number {
  const weights =
    [
      [1, -1],
      [1, -2, 1],
      [1, -3, 3, -1],
    ][order - 1] ?? [];
  return weights.reduce((sum, weight, k) => sum + weight * (values[i - k * window] ?? 0), 0);
}

function figuresUntil(
  curve: Curve,
  track: Omit<Track, "until">,
  found: Float64Array,
  feed: number,
  { steady, window = 1 }: Words,
): Record<Figure, Float64Array> {
  const { count, x, y, error, speed, period } = track;
  const until = Object.fromEntries(figureNames.map((name) => [name, new Float64Array(count)])) as Record<
    Figure,
    Float64Array
  >;
  const raise = (name: Figure, i: number, value: number): void => {
    until[name][i] = Math.max(until[name][i - 1] ?? 0, value);
  };
  let squares = 0;
  for (let i = 0; i < count; ++i) {
    squares += (error[i] ?? 0) ** 2;
    until.rmsError[i] = Math.sqrt(squares / (i + 1));
    raise("maxError", i, Math.abs(error[i] ?? 0));
    raise("chordError", i, i > 0 ? chordError(curve, track, found, i) : 0);
    raise("maxSpeed", i, speed[i] ?? 0);
    raise("feedError", i, steady[i] === 1 && steady[i - 1] === 1 ? Math.abs((speed[i] ?? 0) / feed - 1) : 0);
    const of = (order: number): number =>
      i < order * window
        ? 0
        : Math.max(Math.abs(difference(x, i, order, window)), Math.abs(difference(y, i, order, window))) /
          (window * period) ** order;
    raise("acceleration", i, of(2));
    raise("jerk", i, of(3));
  }
  return until;
}

/** Of the middle between an entry and the one before from the curve. */
function chordError(curve: Curve, { x, y }: Omit<Track, "until">, found: Float64Array, i: number): number {
  const [mx, my] = [((x[i] ?? 0) + (x[i - 1] ?? 0)) / 2, ((y[i] ?? 0) + (y[i - 1] ?? 0)) / 2];
  const [from, to] = [found[i - 1] ?? 0, found[i] ?? 0];
  const u = nearest(curve, [mx, my], from, 1e-6, Math.max(to - from, 1e-6));
  const [cx, cy] = curve.at(u);
  return Math.hypot(mx - cx, my - cy);
}
