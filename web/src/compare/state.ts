// What is compared: one curve, up to four methods or settings, and where one looks; and the link that brings it back.

import type { Method } from "../engine/types";
import { presets, withPreset, type Preset } from "../lesson/presets";
import { fromLink as settingsOf, initial, toLink as linkOf, type Settings } from "../lesson/settings";
import type { Camera, Layout } from "./scene";

export const mostLanes = 4;

/** What of the lesson's settings is a lane's own; all else is of the curve. */
export const laneKeys = [
  "method",
  "bits",
  "capacity",
  "preload",
  "order",
  "tie",
  "ending",
  "accumulation",
  "places",
] as const;
export type LaneKey = (typeof laneKeys)[number];
export type Lane = Record<LaneKey, string>;

export interface State {
  /** The curve, the interval and the clock; its lane keys mean nothing. */
  curve: Settings;
  lanes: Lane[];
  layout: Layout;
  /** Undefined: the whole curve. */
  camera: Camera | undefined;
}

export function laneOf(method: string, more: Partial<Lane> = {}): Lane {
  const none = { bits: "", capacity: "", preload: "", order: "", tie: "", accumulation: "", places: "" };
  return { method, ...none, ending: "counters", ...more };
}

/** Of a lane, as the lesson has them. */
export function settingsOfLane(state: State, lane: Lane): Settings {
  return { ...state.curve, ...lane } as Settings;
}

export interface Comparison {
  readonly id: string;
  readonly title: string;
  /** Whose curve it has. */
  readonly preset: string;
  /** In place of the preset's. */
  readonly curve?: Partial<Settings>;
  readonly lanes: readonly Lane[];
}

const teaching = { bits: "4", preload: "zero" };

export const comparisons: readonly Comparison[] = [
  {
    id: "fpga",
    title: "Four interpolators on a quarter, R = 5",
    preset: "fpga-dda",
    lanes: [laneOf("point-comparison"), laneOf("dda"), laneOf("min-error"), laneOf("improved-min-error")],
  },
  {
    id: "orders",
    title: "Orders of the integrators on a circle, R = 10",
    preset: "koren-circle",
    lanes: ["parallel", "x-first", "shrinking-first", "growing-first"].map((order) =>
      laneOf("koren", { order, preload: "zero" }),
    ),
  },
  {
    id: "loads",
    title: "What the remainders begin with, on a circle, R = 10",
    preset: "koren-circle",
    lanes: ["zero", "half", "half-lagging", "full"].map((preload) => laneOf("koren", { preload })),
  },
  {
    id: "half-turn",
    title: "Koren's program and hardware without counters, half a turn",
    preset: "koren-half-turn",
    lanes: ["koren", "dda"].flatMap((method) =>
      ["zero", "half"].map((preload) => laneOf(method, { preload, ending: "free" })),
    ),
  },
  {
    id: "negative",
    title: "How remainders take negative integrands, half a turn",
    preset: "koren-half-turn",
    lanes: ["sign-magnitude", "floor", "symmetric"].map((accumulation) =>
      laneOf("koren", { preload: "zero", ending: "free", accumulation }),
    ),
  },
  {
    id: "places",
    title: "Binary places of an irrational radius in the capacity",
    preset: "one-quadrant",
    curve: { startX: "5", startY: "5", endX: "-5", endY: "5" },
    lanes: ["", "2", "4", "8"].map((places) => laneOf("dda", { preload: "half", places })),
  },
  {
    id: "line",
    title: "The line to (11, 7), 4 bits",
    preset: "line-11-7",
    lanes: [
      laneOf("dda", teaching),
      laneOf("dda", { ...teaching, preload: "half" }),
      laneOf("bresenham"),
      laneOf("point-comparison"),
    ],
  },
  {
    id: "bits",
    title: "Registers of 4 to 10 bits on an arc across quadrants",
    preset: "across-quadrants",
    lanes: ["4", "6", "8", "10"].map((bits) => laneOf("dda", { ...teaching, bits })),
  },
  {
    id: "ellipse",
    title: "An ellipse, 12 by 7",
    preset: "ellipse",
    lanes: ["zero", "half"].flatMap((preload) => [laneOf("dda", { preload }), laneOf("koren", { preload })]),
  },
];

export function stateOf(comparison: Comparison): State {
  const preset = presets.find(({ id }) => id === comparison.preset);
  const curve = preset === undefined ? { ...initial } : withPreset({ ...initial, interval: "0.1" }, preset);
  Object.assign(curve, comparison.curve);
  return { curve, lanes: comparison.lanes.map((lane) => ({ ...lane })), layout: "overlay", camera: undefined };
}

const first = comparisons[0];
export function initialState(): State {
  return first === undefined
    ? { curve: { ...initial }, lanes: [], layout: "overlay", camera: undefined }
    : stateOf(first);
}

/** The curve as the lesson's link has it; then each lane, its parts divided by commas. */
export function toLink(state: State): string {
  const link = new URLSearchParams(linkOf(state.curve).slice(1));
  link.delete("lesson");
  link.set("compare", "1");
  for (const key of [
    "method",
    "n",
    "q",
    "r0",
    "order",
    "tie",
    "end",
    "acc",
    "places",
    "run",
    "bp",
    "bq",
    "view",
    "predict",
    "poll",
  ])
    link.delete(key);
  for (const lane of state.lanes) link.append("l", laneKeys.map((key) => lane[key]).join(","));
  link.set("layout", state.layout);
  const { camera } = state;
  if (camera !== undefined) link.set("at", cameraText(camera));
  return `#${link.toString()}`;
}

/** What the lesson shows, beside the other methods that draw its curve, as they are by default. */
export function linkFromLesson(settings: Settings, methods: readonly Method[]): string {
  const own = laneOf(settings.method);
  for (const key of laneKeys) own[key] = settings[key];
  const isEllipse = settings.module === "arc" && settings.curve === "ellipse";
  const others = methods
    .filter(({ name, hasEllipses }) => name !== settings.method && (hasEllipses || !isEllipse))
    .map(({ name }) => laneOf(name));
  const lanes = [own, ...others].slice(0, mostLanes);
  return toLink({ curve: settings, lanes, layout: "overlay", camera: undefined });
}

export function cameraText({ x, y, across }: Camera): string {
  return [x, y, across].map((each) => each.toPrecision(8)).join(",");
}

export function cameraOf(text: string | null): Camera | undefined {
  const [x, y, across] = (text ?? "").split(",").map(Number);
  if (x === undefined || y === undefined || across === undefined) return undefined;
  return [x, y, across].every(Number.isFinite) && across > 0 ? { x, y, across } : undefined;
}

export function fromLink(hash: string): State {
  const link = new URLSearchParams(hash.replace(/^#/, ""));
  if (link.get("compare") === null) return initialState();
  const lanes = link
    .getAll("l")
    .slice(0, mostLanes)
    .map((text) => {
      const parts = text.slice(0, 120).split(",");
      const lane = laneOf("");
      laneKeys.forEach((key, i) => (lane[key] = parts[i] ?? ""));
      if (lane.ending !== "free") lane.ending = "counters";
      return lane;
    });
  return {
    curve: settingsOf(hash),
    lanes: lanes.length > 0 ? lanes : initialState().lanes,
    layout: link.get("layout") === "beside" ? "beside" : "overlay",
    camera: cameraOf(link.get("at")),
  };
}

/** The figure of a paper that a lane shows on this curve; its feed is the reader's. */
export function figureOf(state: State, lane: Lane): Preset | undefined {
  const settings = settingsOfLane(state, lane);
  const isLine = settings.module === "line";
  const keys: (keyof Settings)[] = ["module", "startX", "startY", "endX", "endY", ...laneKeys];
  const ofArcs: (keyof Settings)[] = ["centerX", "centerY", "direction", "curve"];
  const ofEllipses: (keyof Settings)[] = ["semiX", "semiY"];
  return presets.find((preset) => {
    const its = withPreset(settings, preset);
    const all = isLine ? keys : its.curve === "ellipse" ? [...keys, ...ofArcs, ...ofEllipses] : [...keys, ...ofArcs];
    return all.every(
      (key) => its[key] === settings[key] || (isLine && /^(order|tie|ending|accumulation|places)$/.test(key)),
    );
  });
}

export function comparisonOf(state: State): Comparison | undefined {
  const text = (of: State): string => toLink({ ...of, layout: "overlay", camera: undefined });
  const mine = text({ ...state, curve: { ...state.curve, clock: 0 } });
  return comparisons.find((each) => {
    const its = stateOf(each);
    return text({ ...its, curve: { ...its.curve, feed: state.curve.feed, interval: state.curve.interval } }) === mine;
  });
}
