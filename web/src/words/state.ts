// What words are compared: one curve, feed and limits, up to four lanes of a method and the loops that follow it.

import type { Asked, CircleRule, CircleTask, Limits, LoopOptions, StepRule, WordTask } from "../engine/motion_types";
import { circleRules, stepRules } from "../engine/motion_types";
import type { Camera, Layout } from "../compare/scene";
import { quantity, type FieldErrors } from "../lesson/settings";
import { curveOf, programOf, type Course, type CurveKind } from "./curves";

/** Of reference pulses, as the engine names them. */
export const pulseMethods = [
  "dda",
  "koren",
  "point-comparison",
  "min-error",
  "improved-min-error",
  "bresenham",
] as const;
export type PulseMethod = (typeof pulseMethods)[number];
export const methods = [...stepRules, "stops", "blend", ...circleRules, ...pulseMethods] as const;
export type Method = (typeof methods)[number];

export function isCircleRule(method: Method): method is CircleRule {
  return (circleRules as readonly string[]).includes(method);
}
export function isPulseMethod(method: Method): method is PulseMethod {
  return (pulseMethods as readonly string[]).includes(method);
}
export const loopKinds = ["none", "pid", "cascade", "pulses"] as const;
export type LoopKind = (typeof loopKinds)[number];

/** Numbers of a lane, as they were typed; a period that is empty is the curve's. */
export const laneNumbers = ["period", "lines", "p", "i", "d", "kv", "forward", "blu"] as const;
export type LaneNumber = (typeof laneNumbers)[number];
export interface Lane extends Record<LaneNumber, string> {
  method: Method;
  loops: LoopKind;
}

/** Numbers that all lanes have: mm, mm/s, ms, mm/s², mm/s³. */
export const curveNumbers = ["a", "b", "feed", "period", "acceleration", "jerk", "tolerance"] as const;
export type CurveNumber = (typeof curveNumbers)[number];

export interface State extends Record<CurveNumber, string> {
  curve: CurveKind;
  lanes: Lane[];
  layout: Layout;
  camera: Camera | undefined;
  /** How many times errors are drawn. */
  magnified: number;
  interval: string;
  clock: number;
}

export const magnifications = [1, 10, 100, 1000, 10_000] as const;

export function laneOf(method: Method, more: Partial<Lane> = {}): Lane {
  const gains = { p: "2", i: "2", d: "15", kv: "40", forward: "0" };
  return { method, loops: "none", period: "", lines: "92", ...gains, blu: "0.1", ...more };
}

const plain = {
  a: "10",
  b: "6",
  feed: "10",
  period: "10",
  acceleration: "1000",
  jerk: "20000",
  tolerance: "0.01",
  layout: "overlay" as Layout,
  camera: undefined,
  interval: "0.02",
  clock: 0,
};

export interface Comparison {
  readonly id: string;
  readonly title: string;
  readonly state: Omit<State, "interval" | "layout" | "camera" | "clock">;
  /** Of a paper, for a lane each; empty where it prints nothing of it. */
  readonly published: readonly string[];
}

const paper = "Real-time interpolators";
const koren = "Interpolator for a computer numerical control system";

export const comparisons: readonly Comparison[] = [
  {
    id: "rules",
    title: "Rules that step a curve's parameter, the plane cubic",
    state: {
      ...plain,
      curve: "cubic",
      lanes: [laneOf("arc-length"), laneOf("taylor1"), laneOf("taylor2"), laneOf("uniform")],
      magnified: 1000,
    },
    published: ["", `feed error below 2 % (${paper}, section 4)`, `feed error below 2 % (${paper}, section 4)`, ""],
  },
  {
    id: "one-block",
    title: "The plane cubic as one block, and as 92 lines",
    state: {
      ...plain,
      curve: "cubic",
      acceleration: "106.3",
      jerk: "1000000",
      lanes: [laneOf("taylor2"), laneOf("stops"), laneOf("blend")],
      magnified: 100,
    },
    published: [`3.0 s (${paper}, section 5)`, `10.1 s, and 0.3 s of decoding (${paper}, section 5)`, ""],
  },
  {
    id: "gains",
    title: "Two sets of gains, on one block and on lines",
    state: {
      ...plain,
      curve: "cubic",
      acceleration: "106.3",
      jerk: "1000000",
      lanes: [
        laneOf("arc-length", { loops: "pid" }),
        laneOf("arc-length", { loops: "pid", p: "6", i: "50", d: "25" }),
        laneOf("stops", { loops: "pid" }),
        laneOf("stops", { loops: "pid", p: "6", i: "50", d: "25" }),
      ],
      magnified: 1,
    },
    published: [
      `a picture, of a plant it does not name: hardly any overshoot of the feed (${paper}, section 5)`,
      `a picture, of a plant it does not name: a large overshoot of the feed (${paper}, section 5)`,
      "",
      "",
    ],
  },
  {
    id: "loops",
    title: "A circle under PID, cascade and pulse loop",
    state: {
      ...plain,
      curve: "circle",
      feed: "50",
      period: "1",
      lanes: [
        laneOf("arc-length"),
        laneOf("arc-length", { loops: "pid", p: "1.25", i: "0", d: "0" }),
        laneOf("arc-length", { loops: "cascade" }),
        laneOf("arc-length", { loops: "pulses" }),
      ],
      magnified: 1,
    },
    published: [],
  },
  {
    id: "pulses",
    title: "Pulses beside words, a circle of R = 10",
    state: {
      ...plain,
      curve: "circle",
      feed: "20",
      lanes: [laneOf("arc-length"), laneOf("taylor1"), laneOf("dda"), laneOf("koren", { blu: "0.05" })],
      magnified: 1,
    },
    published: [],
  },
  {
    id: "integration",
    title: "A circle by integration, a step a period",
    state: {
      ...plain,
      curve: "circle",
      feed: "50",
      lanes: [laneOf("euler"), laneOf("heun"), laneOf("tustin"), laneOf("x-first")],
      magnified: 10,
    },
    published: [
      `the radius errs by T² a step (${koren}, below eq. 27)`,
      `the radius errs by T⁴ a step (${koren}, below eq. 24)`,
      "",
      `the radius errs by T⁴ (${koren}, below eq. 27): an ellipse, T/4 off`,
    ],
  },
  {
    id: "periods",
    title: "Four servo periods on an ellipse",
    state: {
      ...plain,
      curve: "ellipse",
      feed: "50",
      lanes: ["1", "2", "5", "10"].map((period) => laneOf("taylor1", { period })),
      magnified: 1000,
    },
    published: [],
  },
  {
    id: "corner",
    title: "A corner: a stop, blended, and what loops make of it",
    state: {
      ...plain,
      curve: "corner",
      feed: "50",
      period: "1",
      tolerance: "0.2",
      lanes: [
        laneOf("stops"),
        laneOf("blend"),
        laneOf("stops", { loops: "cascade" }),
        laneOf("blend", { loops: "cascade" }),
      ],
      magnified: 1,
    },
    published: [],
  },
];

export function stateOf(comparison: Comparison): State {
  return { ...plain, ...structuredClone(comparison.state) };
}

export function initialState(): State {
  const [first] = comparisons;
  if (first === undefined) throw new Error("there are no comparisons");
  return stateOf(first);
}

/** The ready one that this is, but for layout, camera, magnification and clock. */
export function comparisonOf(state: State): Comparison | undefined {
  const text = (of: State): string => {
    const { curve, lanes } = of;
    return JSON.stringify([curve, lanes, curveNumbers.map((key) => of[key])]);
  };
  return comparisons.find((each) => text(stateOf(each)) === text(state));
}

const ranges: Readonly<Record<CurveNumber | LaneNumber, readonly [number, number, string]>> = {
  a: [0.1, 400, "mm"],
  b: [0.1, 400, "mm"],
  feed: [0.1, 200, "mm/s"],
  period: [0.05, 20, "ms"],
  acceleration: [1, 100_000, "mm/s²"],
  jerk: [10, 1e7, "mm/s³"],
  tolerance: [0.0001, 5, "mm"],
  lines: [1, 2000, "lines"],
  p: [0, 100, "units/mm"],
  i: [0, 1000, "units/(mm·s)"],
  d: [0, 200, "units/mm"],
  kv: [0.1, 1000, "1/s"],
  forward: [0, 1, "of velocity and acceleration"],
  blu: [0.001, 1, "mm"],
};
export function rangeOf(key: CurveNumber | LaneNumber): readonly [number, number, string] {
  return ranges[key];
}

export function number(key: CurveNumber | LaneNumber, text: string, errors: FieldErrors): number {
  const [least, most, unit] = ranges[key];
  const value = quantity(text);
  if (!(value >= least && value <= most)) errors.set(key, `“${text}” is none of ${least} to ${most} ${unit}`);
  else if (key === "lines" && !Number.isInteger(value)) errors.set(key, `“${text}” is no whole number of lines`);
  return value;
}

/** Lines are lines by any method. */
function isCurved({ curve }: State): boolean {
  return curve !== "corner" && curve !== "line";
}

/** Words of a plan alone are followed. */
export function hasLoops({ method }: Lane): boolean {
  return !isPulseMethod(method) && !isCircleRule(method);
}

/** Which numbers of a lane count. */
export function usesOf(lane: Lane, state: State): Readonly<Record<LaneNumber, boolean>> {
  const loops = hasLoops(lane) ? lane.loops : "none";
  const isPid = loops === "pid";
  return {
    period: !isPulseMethod(lane.method),
    blu: isPulseMethod(lane.method),
    lines: (lane.method === "stops" || lane.method === "blend") && isCurved(state),
    p: isPid,
    i: isPid,
    d: isPid,
    kv: loops === "cascade" || loops === "pulses",
    forward: isPid || loops === "cascade",
  };
}

export function curveIn(state: State, errors: FieldErrors): ReturnType<typeof curveOf> {
  const isSized = state.curve !== "cubic";
  const a = isSized ? number("a", state.a, errors) : 1;
  const b = isSized && state.curve !== "circle" ? number("b", state.b, errors) : 1;
  return curveOf(state.curve, a, b);
}

function loopsOf(lane: Lane, errors: FieldErrors): LoopOptions | undefined {
  const of = (key: LaneNumber): number => number(key, lane[key], errors);
  switch (lane.loops) {
    case "none":
      return undefined;
    case "pid": {
      const gains = { proportional: of("p"), integral: of("i"), derivative: of("d"), forward: of("forward") };
      return { controller: "pid", encoder: "own", gains };
    }
    case "cascade":
      return { controller: "cascade", encoder: "own", gains: { positionGain: of("kv"), forward: of("forward") } };
    case "pulses":
      return { controller: "pulses", encoder: "own", gains: { positionGain: of("kv") } };
  }
}

function courseOf(lane: Lane, state: State, errors: FieldErrors): Course {
  if (lane.method !== "stops" && lane.method !== "blend") return { kind: "curve" };
  const lines = isCurved(state) ? number("lines", lane.lines, errors) : 1;
  return lane.method === "stops"
    ? { kind: "stops", lines }
    : { kind: "blend", lines, tolerance: number("tolerance", state.tolerance, errors) };
}

/** s */
export function periodOf(state: State, lane: Lane, errors: FieldErrors): number {
  return number("period", lane.period.trim() === "" ? state.period : lane.period, errors) / 1000;
}

/** The limits of the mill with those of the comparison, X and Y alike. */
export function limitsOf(mill: Limits, state: State, lane: Lane, errors: FieldErrors): Limits {
  const limits = structuredClone(mill);
  limits.acceleration = limits.acceleration.map((each) =>
    each > 0 ? number("acceleration", state.acceleration, errors) : 0,
  );
  limits.jerk = limits.jerk.map((each) => (each > 0 ? number("jerk", state.jerk, errors) : 0));
  limits.period = periodOf(state, lane, errors);
  return limits;
}

/** What the planner is asked for; errors of fields that are wrong. */
export function taskOf(mill: Limits, state: State, lane: Lane, most: number, errors: FieldErrors): WordTask {
  const curve = curveIn(state, errors);
  const feed = number("feed", state.feed, errors);
  const course = courseOf(lane, state, errors);
  const limits = limitsOf(mill, state, lane, errors);
  const loops = loopsOf(lane, errors);
  const rule: StepRule = stepRules.find((each) => each === lane.method) ?? "arc-length";
  const text = errors.size > 0 ? "" : programOf(curve, course, feed);
  const asked: Asked = { mode: "programmed", start: curve.at(0) };
  return { text, machine: "", limits, tools: "", override: 1, changes: [], rule, asked, loops, most };
}

/** The same of a circle by integration. */
export function circleTaskOf(
  state: State,
  lane: Lane,
  rule: CircleRule,
  most: number,
  errors: FieldErrors,
): CircleTask {
  if (state.curve !== "circle") errors.set("method", "integrates circles alone: choose a circle");
  const [radius, feed] = [number("a", state.a, errors), number("feed", state.feed, errors)];
  return { rule, radius, feed, period: periodOf(state, lane, errors), most };
}
