// What a lane makes of the curve, in figures: those of the engine, and what follows from its rows.

import type { Conventions } from "../engine/types";
import type { Session } from "../lesson/session";

export const rippleClocks = 16;

export interface LaneFigures {
  readonly clocks: number;
  readonly pulses: number;
  readonly maxError: number;
  readonly rmsError: number;
  readonly end: readonly [number, number];
  /** Of steps, BLU. */
  readonly length: number;
  /** Greatest departure of the way made in 16 clocks from the mean of all of them, over that mean; NaN of shorter curves. */
  readonly ripple: number;
  /** Greatest second and third difference of X or Y over steps of 16 clocks, BLU; NaN of shorter curves. */
  readonly acceleration: number;
  readonly jerk: number;
}

function stepLength(session: Session, clock: number): number {
  return Math.hypot(session.value(clock, "dx"), session.value(clock, "dy"));
}

/** Until a clock of the lane, its last one at most. */
export function figuresOf(session: Session, until: number): LaneFigures {
  const clock = Math.min(until, session.last);
  let length = 0;
  for (let i = 1; i <= clock; ++i) length += stepLength(session, i);
  return {
    clocks: clock,
    pulses: session.figure(clock, "pulses"),
    maxError: session.figure(clock, "maxError"),
    rmsError: session.figure(clock, "rmsError"),
    end: [session.value(clock, "X"), session.value(clock, "Y")],
    length,
    ripple: rippleOf(session, clock, length),
    acceleration: greatestDifference(session, clock, [1, -2, 1]),
    jerk: greatestDifference(session, clock, [1, -3, 3, -1]),
  };
}

/** Of X or Y at clocks that are 16 apart, weighted so, the latest first. */
function greatestDifference(session: Session, last: number, weights: readonly number[]): number {
  let greatest = NaN;
  for (let clock = rippleClocks * (weights.length - 1); clock <= last; ++clock) {
    for (const axis of ["X", "Y"] as const) {
      const difference = weights.reduce(
        (sum, weight, i) => sum + weight * session.value(clock - rippleClocks * i, axis),
        0,
      );
      greatest = Number.isNaN(greatest) ? Math.abs(difference) : Math.max(greatest, Math.abs(difference));
    }
  }
  return greatest;
}

function rippleOf(session: Session, clock: number, length: number): number {
  if (clock < rippleClocks || length === 0) return NaN;
  const mean = (length / clock) * rippleClocks;
  let way = 0;
  let worst = 0;
  for (let i = 1; i <= clock; ++i) {
    way += stepLength(session, i);
    if (i > rippleClocks) way -= stepLength(session, i - rippleClocks);
    if (i >= rippleClocks) worst = Math.max(worst, Math.abs(way - mean));
  }
  return worst / mean;
}

/** "q = 16, zero, parallel" */
export function conventionsText(conventions: Conventions): string {
  const { capacity, scale, preload, order, tie, places, accumulation } = conventions;
  const parts = [
    capacity > 0 ? `q = ${capacity}${scale > 1 ? ` · ${scale}` : ""}` : "",
    preload,
    order,
    tie === "" || tie === "none" ? "" : `ties ${tie}`,
    conventions.end === "clocks-of-the-angle" ? "no counters" : "",
    places > 0 ? `${places} places` : "",
    accumulation === "" || accumulation === "sign-magnitude" ? "" : accumulation,
  ];
  return parts.filter((part) => part !== "").join(", ");
}
