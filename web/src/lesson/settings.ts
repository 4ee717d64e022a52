// What the reader has set, as it was typed; and the link that brings all of it back.

import type { Method, Task } from "../engine/types";

export interface Settings {
  module: "line" | "arc";
  startX: string;
  startY: string;
  endX: string;
  endY: string;
  centerX: string;
  centerY: string;
  direction: "ccw" | "cw";
  /** Of the circular module. */
  curve: "circle" | "ellipse";
  semiX: string;
  semiY: string;
  /** How an arc of a circle ends. */
  ending: "counters" | "free";
  /** Of an arc of a circle that runs freely: how remainders take negative integrands. */
  accumulation: string;
  /** Of one with counters: binary places of the radius in the capacity. */
  places: string;
  bits: string;
  capacity: string;
  feed: string;
  method: string;
  preload: string;
  order: string;
  tie: string;
  /** Between two checks of the start switch, s. */
  polling: string;
  /** Between two cycles, s. */
  interval: string;
  run: "automatic" | "single";
  stopAtPulse: boolean;
  stopAtBorder: boolean;
  view: "whole" | "near";
  predict: boolean;
  clock: number;
}

export const initial: Settings = {
  module: "line",
  startX: "3",
  startY: "4",
  endX: "-9",
  endY: "-6",
  centerX: "0",
  centerY: "0",
  direction: "ccw",
  curve: "circle",
  semiX: "12",
  semiY: "7",
  ending: "counters",
  accumulation: "",
  places: "",
  bits: "4",
  capacity: "",
  feed: "10",
  method: "dda",
  preload: "zero",
  order: "",
  tie: "",
  polling: "0.5",
  interval: "0.1",
  run: "automatic",
  stopAtPulse: false,
  stopAtBorder: false,
  view: "whole",
  predict: false,
  clock: 0,
};

/** Short names for the link; none is ever given another meaning. */
const names: Readonly<Record<keyof Settings, string>> = {
  module: "m",
  startX: "sx",
  startY: "sy",
  endX: "ex",
  endY: "ey",
  centerX: "cx",
  centerY: "cy",
  direction: "d",
  curve: "curve",
  semiX: "a",
  semiY: "b",
  ending: "end",
  accumulation: "acc",
  places: "places",
  bits: "n",
  capacity: "q",
  feed: "v",
  method: "method",
  preload: "r0",
  order: "order",
  tie: "tie",
  polling: "poll",
  interval: "t",
  run: "run",
  stopAtPulse: "bp",
  stopAtBorder: "bq",
  view: "view",
  predict: "predict",
  clock: "k",
};

/** All of it: the link means the same when defaults change. */
export function toLink(settings: Settings): string {
  const link = new URLSearchParams();
  link.set("lesson", "1");
  for (const key of Object.keys(names) as (keyof Settings)[]) {
    const value = settings[key];
    link.set(names[key], typeof value === "boolean" ? (value ? "1" : "0") : String(value));
  }
  return `#${link.toString()}`;
}

const choices: Partial<Record<keyof Settings, readonly string[]>> = {
  module: ["line", "arc"],
  direction: ["ccw", "cw"],
  curve: ["circle", "ellipse"],
  ending: ["counters", "free"],
  run: ["automatic", "single"],
  view: ["whole", "near"],
};

/** Of a link; what it does not have, or what is none of the choices, is as at first. */
export function fromLink(hash: string): Settings {
  const link = new URLSearchParams(hash.replace(/^#/, ""));
  const settings: Record<string, unknown> = { ...initial };
  for (const key of Object.keys(names) as (keyof Settings)[]) {
    const text = link.get(names[key]);
    if (text === null || text.length > 40) continue;
    const allowed = choices[key];
    if (allowed !== undefined && !allowed.includes(text)) continue;
    if (typeof initial[key] === "boolean") settings[key] = text === "1";
    else if (typeof initial[key] === "number") settings[key] = /^\d{1,9}$/.test(text) ? Number(text) : 0;
    else settings[key] = text;
  }
  return settings as unknown as Settings;
}

/** What is wrong with a field, and what would be right. */
export type FieldErrors = Map<string, string>;

const whole = /^[+-]?\d{1,10}$/;

function coordinate(settings: Settings, key: keyof Settings, what: string, errors: FieldErrors): number {
  const text = String(settings[key]).trim().replace("−", "-");
  if (whole.test(text)) return Number(text);
  errors.set(
    key,
    text === ""
      ? `${what} is missing: a whole number of BLU, such as 5`
      : `“${text}” is no whole number: ${what} is in BLU, such as 5 or -12`,
  );
  return 0;
}

function count(text: string, what: string, most: number, errors: FieldErrors, key: string): number {
  const trimmed = text.trim();
  if (trimmed === "") return 0;
  const value = Number(trimmed);
  if (/^\d{1,10}$/.test(trimmed) && value >= 1 && value <= most) return value;
  errors.set(key, `“${trimmed}” is no ${what}: a whole number from 1 to ${most}, or empty for the method's own`);
  return 0;
}

/** A number of seconds or BLU/s. */
export function quantity(text: string): number {
  const trimmed = text.trim().replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(trimmed) ? Number(trimmed) : NaN;
}

function checkTimes(settings: Settings, errors: FieldErrors): void {
  const feed = quantity(settings.feed);
  if (!(feed > 0)) errors.set("feed", "the feed is more than 0 BLU/s, such as 10");
  const interval = quantity(settings.interval);
  if (!(interval >= 0 && interval <= 60))
    errors.set("interval", "the interval is 0 (as fast as can be) to 60 s, such as 0.1");
  const polling = quantity(settings.polling);
  if (!(polling > 0 && polling <= 60)) errors.set("polling", "the switch is polled every 0.01 to 60 s, such as 0.5");
}

/** What the engine is asked for; errors of fields that it could not understand. Choices that the method has not are left out. */
export function taskOf(settings: Settings, method: Method | undefined, errors: FieldErrors): Task {
  const point = (x: keyof Settings, y: keyof Settings, of: string): [number, number] => [
    coordinate(settings, x, `x of the ${of}`, errors),
    coordinate(settings, y, `y of the ${of}`, errors),
  ];
  const isArc = settings.module === "arc";
  const isEllipse = isArc && settings.curve === "ellipse";
  const bits = count(settings.bits, "number of bits", 30, errors, "bits");
  const capacity = method?.hasCapacity === true ? count(settings.capacity, "capacity", 2 ** 30, errors, "capacity") : 0;
  if (bits > 0 && capacity > 0)
    errors.set("capacity", `registers of ${bits} bits have the capacity ${2 ** bits}: leave one of the two empty`);
  checkTimes(settings, errors);
  const isFree = isArc && !isEllipse && method?.hasFree === true && settings.ending === "free";
  const ofCounters = isArc && !isEllipse && !isFree && method?.hasPlaces === true;
  const places = ofCounters ? count(settings.places, "number of places", 16, errors, "places") : 0;
  if (places > 0 && (bits > 0 || capacity > 0))
    errors.set("places", "places of the radius make the capacity: leave bits and capacity empty, or this");
  const accumulation = isFree && method?.hasAccumulation === true ? settings.accumulation : "";
  if (!["", "sign-magnitude"].includes(accumulation) && settings.preload === "minus-one")
    errors.set("preload", "remainders that begin at −1 are for magnitudes: sign-magnitude, or another load");
  return {
    shape: settings.module,
    start: point("startX", "startY", "start"),
    end: point("endX", "endY", "end"),
    center: isArc ? point("centerX", "centerY", "centre") : [0, 0],
    clockwise: isArc && settings.direction === "cw",
    ...(isEllipse ? { semiAxes: semiAxesOf(settings, errors) } : {}),
    isFree,
    places,
    accumulation,
    bits,
    capacity,
    method: settings.method,
    preload: method?.hasPreload === true ? settings.preload : "",
    order: method?.hasOrder === true && isArc ? settings.order : "",
    tie: method?.hasTie === true && isArc && !isEllipse ? settings.tie : "",
  };
}

/** 0 would be a circle's. */
function semiAxesOf(settings: Settings, errors: FieldErrors): [number, number] {
  const axes: [number, number] = [
    coordinate(settings, "semiX", "the semi-axis along x", errors),
    coordinate(settings, "semiY", "the semi-axis along y", errors),
  ];
  for (const [i, key] of (["semiX", "semiY"] as const).entries())
    if (!errors.has(key) && !((axes[i] ?? 0) > 0)) errors.set(key, "a semi-axis is 1 BLU or more");
  return axes;
}

/** Of the engine's "end.x": the field of the page. */
export function fieldOf(name: string): keyof Settings {
  const fields: Readonly<Record<string, keyof Settings>> = {
    "start.x": "startX",
    "start.y": "startY",
    start: "startX",
    "end.x": "endX",
    "end.y": "endY",
    end: "endX",
    "center.x": "centerX",
    "center.y": "centerY",
    center: "centerX",
    "semi_axes.x": "semiX",
    "semi_axes.y": "semiY",
    semi_axes: "semiX",
    bits: "bits",
    capacity: "capacity",
  };
  return fields[name] ?? "method";
}

/** The command that prints the same rows. */
export function commandOf(task: Task): string {
  const at = ([x, y]: readonly [number, number]): string => `${x},${y}`;
  const shape = task.semiAxes === undefined ? [`--${task.shape}`] : ["--ellipse", at(task.semiAxes)];
  const words = ["leadscrew", "pulse", ...shape, "--start", at(task.start), "--end", at(task.end)];
  if (task.shape === "arc") words.push("--center", at(task.center), task.clockwise ? "--cw" : "--ccw");
  words.push("--method", task.method);
  if (task.bits > 0) words.push("--bits", String(task.bits));
  if (task.capacity > 0) words.push("--capacity", String(task.capacity));
  if (task.preload !== "") words.push("--preload", task.preload);
  if (task.order !== "") words.push("--order", task.order);
  if (task.tie !== "") words.push("--tie", task.tie);
  if (task.isFree === true) words.push("--free");
  if (task.accumulation !== "") words.push("--accumulation", task.accumulation);
  if (task.places > 0) words.push("--places", String(task.places));
  return [...words, "--table"].join(" ");
}
