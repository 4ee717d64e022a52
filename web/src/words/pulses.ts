// A lane of reference pulses among words: the engine's registers on the curve of the page, in mm and s.

import type { Words } from "../engine/motion_types";
import type { Engine, Recording, Task } from "../engine/types";
import { commandOf, fieldOf, type FieldErrors } from "../lesson/settings";
import { lengthOf, type Curve } from "./curves";
import { number, type Lane, type PulseMethod, type State } from "./state";

/** Words of pulses: an entry a clock. */
export interface PulseWords extends Words {
  /** Until each clock. */
  readonly pulses: Float64Array;
}

/** So many BLU; an error where that is no whole number of them. */
function inBlu(state: State, key: "a" | "b", blu: number, errors: FieldErrors): number {
  const value = number(key, state[key], errors);
  const count = Math.round(value / blu);
  if (!errors.has(key) && !errors.has("blu") && Math.abs(value / blu - count) > 1e-6)
    errors.set("blu", `${key} = ${value} mm is no whole number of ${blu} mm`);
  return count;
}

/** The curve in BLU, for a method; errors of fields that are wrong. */
export function pulseTaskOf(state: State, lane: Lane, method: PulseMethod, errors: FieldErrors): Task | undefined {
  const { curve } = state;
  if (curve === "cubic" || curve === "corner") {
    errors.set("method", "draws lines, circles and ellipses: choose one of these");
    return undefined;
  }
  const blu = number("blu", lane.blu, errors);
  const a = inBlu(state, "a", blu, errors);
  const b = curve === "circle" ? a : inBlu(state, "b", blu, errors);
  if (errors.size > 0) return undefined;
  const isLine = curve === "line";
  return {
    shape: isLine ? "line" : "arc",
    start: isLine ? [0, 0] : [a, 0],
    end: isLine ? [a, b] : [a, 0],
    center: [0, 0],
    clockwise: false,
    ...(curve === "ellipse" ? { semiAxes: [a, b] as const } : {}),
    places: 0,
    accumulation: "",
    bits: 0,
    capacity: 0,
    method,
    preload: "",
    order: "",
    tie: "",
  };
}

/** s a clock: that of integrators keeps the feed; that of others makes the whole curve last as long as the feed asks. */
function clockOf({ conventions, clocks }: Recording, blu: number, feed: number, length: number): number {
  const { clocksPerBlu } = conventions;
  return clocksPerBlu > 0 ? blu / (clocksPerBlu * feed) : length / (feed * Math.max(1, clocks));
}

function wordsOf(recording: Recording, blu: number, clock: number, over: number, cost: number): PulseWords {
  const { columns, rows, figures } = recording;
  const count = recording.clocks + 1;
  const [x, y] = [columns.indexOf("X"), columns.indexOf("Y")];
  const position = new Float64Array(3 * count);
  const pulses = new Float64Array(count);
  const width = figures.length / count;
  for (let i = 0; i < count; ++i) {
    position[3 * i] = blu * (rows[i * columns.length + x] ?? 0);
    position[3 * i + 1] = blu * (rows[i * columns.length + y] ?? 0);
    pulses[i] = figures[i * width] ?? 0;
  }
  const window = Math.max(1, Math.round(over / clock));
  const steady = Uint8Array.from({ length: count }, (_, i) => (i >= window ? 1 : 0));
  return { period: clock, count, position, steady, window, cost, slides: undefined, pulses };
}

/** Every clock along the curve, with speeds over `over` seconds; undefined where errors say why not. */
export async function pulseWords(
  engine: Engine,
  task: Task,
  state: State,
  lane: Lane,
  curve: Curve,
  over: number,
  most: number,
  errors: FieldErrors,
): Promise<PulseWords | undefined> {
  const began = performance.now();
  const problems = await engine.problems(task);
  const recording = problems.length > 0 ? undefined : await engine.load(task, most);
  if (recording !== undefined && "code" in recording) problems.push(recording);
  for (const { field, message, hint } of problems) {
    const key = /^(start|end|semi)/.test(fieldOf(field)) ? "blu" : "method";
    errors.set(key, hint === "" ? message : `${message}: ${hint}`);
  }
  if (recording === undefined || "code" in recording) return undefined;
  const cost = ((performance.now() - began) * 1e6) / (recording.clocks + 1);
  const [blu, feed] = [number("blu", lane.blu, errors), number("feed", state.feed, errors)];
  if (errors.size > 0) return undefined;
  return wordsOf(recording, blu, clockOf(recording, blu, feed, lengthOf(curve)), over, cost);
}

/** That prints the same pulses. */
export function pulseCommandOf(task: Task): string {
  return commandOf(task).replace("--table", "--json");
}
