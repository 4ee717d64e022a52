// The figures of lanes of reference pulses.

import { fixed } from "../ui/dom";
import { figuresOf, rippleClocks, type LaneFigures } from "./figures";
import { LaneTable, type Column, type LaneRow } from "./lane_table";
import type { Drawn } from "./pictures";

export interface Compared {
  readonly drawn: Drawn;
  readonly conventions: string;
  /** Of the paper whose figure this is; empty where there is none. */
  readonly source: string;
  readonly published: string;
  readonly command: string;
  /** Of integrators; 0 of methods whose rate depends on the course. */
  readonly clocksPerBlu: number;
}

/** Figures of a lane, and its time at the feed: NaN where the clock does not set that. */
type Told = LaneFigures & { readonly time: number };

const columns: readonly Column<Told>[] = [
  ["Clocks", "until here", ({ clocks }) => String(clocks)],
  ["Pulses", "clocks with a step", ({ pulses }) => String(pulses)],
  ["Clocks a pulse", "what a step costs", ({ clocks, pulses }) => (pulses > 0 ? fixed(clocks / pulses, 3) : "")],
  ["Time", "at the feed, s; of integrators, whose clock sets it", ({ time }) => (time >= 0 ? fixed(time, 2) : "")],
  ["Greatest error", "distance from the curve, BLU", ({ maxError }) => fixed(maxError, 3)],
  ["RMS error", "over the places after each pulse, BLU", ({ rmsError }) => fixed(rmsError, 3)],
  ["Length", "of the steps, BLU", ({ length }) => fixed(length, 2)],
  [
    "Ripple",
    `greatest departure of the way in ${rippleClocks} clocks from its mean`,
    ({ ripple }) => (Number.isNaN(ripple) ? "" : `${fixed(100 * ripple, 1)} %`),
  ],
  [
    "Acceleration",
    `greatest second difference of X or Y over steps of ${rippleClocks} clocks, BLU`,
    ({ acceleration }) => (Number.isNaN(acceleration) ? "" : String(acceleration)),
  ],
  [
    "Jerk",
    `greatest third difference of X or Y over steps of ${rippleClocks} clocks, BLU`,
    ({ jerk }) => (Number.isNaN(jerk) ? "" : String(jerk)),
  ],
  ["End", "where it stands, BLU", ({ end }) => `(${end.join(", ")})`.replaceAll("-", "−")],
];

export function pulseTable(): LaneTable<Told> {
  return new LaneTable("Figures of all methods", "conventions", columns);
}

/** Until a clock, at a feed in BLU/s. */
export function rowOf(compared: Compared, clock: number, feed: number): LaneRow<Told> {
  const { drawn, conventions, source, published, clocksPerBlu } = compared;
  const until = figuresOf(drawn.session, clock);
  const time = clocksPerBlu > 0 && feed > 0 ? until.clocks / (clocksPerBlu * feed) : NaN;
  return {
    number: drawn.number,
    title: drawn.title,
    detail: conventions,
    told: { ...until, time },
    published: published === "" ? "" : `${published} (${source})`,
  };
}
