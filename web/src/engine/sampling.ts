// A trajectory at equal steps of time, and its blocks, as arrays that a page may draw from.

import * as layout from "./layout";
import type { Blocks, Figures, Limits, Samples, Task } from "./motion_types";
import type { MotionModule } from "./motion_module";
import { type States, withStates } from "./states";

/** Takes blocks as they come. */
export class BlockList {
  private readonly columns: Record<
    "begin" | "seconds" | "leastSeconds" | "length" | "feedAsked" | "feedReached",
    number[]
  > = { begin: [], seconds: [], leastSeconds: [], length: [], feedAsked: [], feedReached: [] };
  private readonly line: number[] = [];
  private readonly part: number[] = [];
  private readonly pass: number[] = [];
  private readonly cause: number[] = [];
  private readonly causes: string[] = [];

  take(module: MotionModule, at: number): void {
    const of = layout.block;
    this.line.push(module.integer(at + of.line));
    for (const name of Object.keys(this.columns) as (keyof typeof this.columns)[])
      this.columns[name].push(module.number(at + of[name]));
    this.part.push(module.view.getInt32(at + of.part, true));
    this.pass.push(module.view.getInt32(at + of.pass, true));
    const cause = module.text(at + of.cause);
    let entry = this.causes.indexOf(cause);
    if (entry < 0) entry = this.causes.push(cause) - 1;
    this.cause.push(entry);
  }

  done(): Blocks {
    const { begin, seconds, leastSeconds, length, feedAsked, feedReached } = this.columns;
    settleBegins(begin, seconds);
    return {
      count: this.line.length,
      line: Int32Array.from(this.line),
      begin: Float64Array.from(begin),
      seconds: Float64Array.from(seconds),
      leastSeconds: Float64Array.from(leastSeconds),
      length: Float64Array.from(length),
      feedAsked: Float64Array.from(feedAsked),
      feedReached: Float64Array.from(feedReached),
      part: Uint8Array.from(this.part),
      pass: Int32Array.from(this.pass),
      cause: Uint8Array.from(this.cause),
      causes: this.causes,
    };
  }
}

export function axesOf(limits: Limits): number[] {
  return [...Array(layout.axes).keys()].filter((axis) => (limits.axes >> axis) & 1);
}

export interface Sampled {
  readonly module: MotionModule;
  readonly trajectory: number;
  readonly period: number;
  readonly figures: Figures;
  readonly blocks: Blocks;
  readonly limits: Limits;
  /** By which feed is multiplied there, asked for in the order of time; 0 holds. */
  readonly factorAt: (time: number) => number;
}

export function factorsOf({ override, changes }: Pick<Task, "override" | "changes">): (time: number) => number {
  let [next, factor] = [0, override];
  return (time) => {
    for (; (changes[next]?.time ?? Infinity) < time; ++next) factor = changes[next]?.factor ?? factor;
    return factor;
  };
}

/** Of a word, s: the double nearest to so many periods, which are whole nanoseconds; as the command writes it. */
export function timeOfWord(tick: number, period: number): number {
  return (tick * Math.round(period * 1e9)) / 1e9;
}

/** The block of each time, asked for in their order: a word belongs to the way that leads to it. */
export function blockFinder(blocks: Pick<Blocks, "count" | "begin">, period: number): (time: number) => number {
  let block = 0;
  return (time) => {
    while (block + 1 < blocks.count && (blocks.begin[block + 1] ?? 0) < time - period / 2) ++block;
    return block;
  };
}

/** A move that no word falls on has no time of its own: it begins where the one before ended. */
export function settleBegins(begin: number[] | Float64Array, seconds: ArrayLike<number>): void {
  for (let i = 1; i < begin.length; ++i) if (seconds[i] === 0) begin[i] = (begin[i - 1] ?? 0) + (seconds[i - 1] ?? 0);
}

/** A sample is every so many-th word, and how many there are with the last: at most `most` and one. */
export function spacingOf(words: number, most: number): readonly [every: number, count: number] {
  const every = Math.max(1, Math.ceil(words / most));
  return [every, Math.ceil(words / every) + 1];
}

/** At most `most` of them; `progress` hears the share done. */
export function samplesOf(of: Sampled, most: number, progress: (share: number) => void): Samples {
  const { module, trajectory, blocks, limits } = of;
  const [every, count] = spacingOf(of.figures.words, most);
  const axes = axesOf(limits);
  const samples = {
    count,
    step: every * of.period,
    axes,
    position: new Float64Array(count * axes.length),
    velocity: new Float32Array(count * axes.length),
    acceleration: new Float32Array(count * axes.length),
    jerk: new Float32Array(count * axes.length),
    feed: new Float32Array(count),
    tip: new Float64Array(count * 3),
    direction: new Float32Array(count * 3),
    poleAngle: new Float32Array(count),
    tool: new Int32Array(count),
    line: new Int32Array(count),
    block: new Int32Array(count),
    hold: new Uint8Array(count),
    holdAxis: new Uint8Array(count),
  };
  const blockAt = blockFinder(blocks, of.period);
  const takeState = (i: number, view: DataView, at: number): void => {
    const of = layout.state;
    for (let k = 0; k < axes.length; ++k) {
      const to = i * axes.length + k;
      const axis = axes[k] ?? 0;
      samples.position[to] = view.getFloat64(at + of.position + 8 * axis, true);
      samples.velocity[to] = view.getFloat64(at + of.velocity + 8 * axis, true);
      samples.acceleration[to] = view.getFloat64(at + of.acceleration + 8 * axis, true);
      samples.jerk[to] = view.getFloat64(at + of.jerk + 8 * axis, true);
    }
    samples.feed[i] = view.getFloat64(at + of.feed, true);
    samples.line[i] = view.getInt32(at + of.line, true); // numbers of lines need no more of its 64 bits
  };
  const takePose = (i: number, view: DataView, at: number): void => {
    const of = layout.pose;
    for (let k = 0; k < 3; ++k) {
      samples.tip[i * 3 + k] = view.getFloat64(at + of.tip + 8 * k, true);
      samples.direction[i * 3 + k] = view.getFloat64(at + of.direction + 8 * k, true);
    }
    samples.poleAngle[i] = view.getFloat64(at + of.poleAngle, true);
    samples.tool[i] = view.getInt32(at + of.tool, true);
  };
  const takeHold = (i: number, view: DataView, at: number): void => {
    const axis = axes.indexOf(view.getInt32(at + layout.hold.axis, true));
    samples.hold[i] = view.getInt32(at + layout.hold.kind, true);
    samples.holdAxis[i] = Math.max(axis, 0);
  };
  const timeOf = (i: number): number => timeOfWord(Math.min(i * every, of.figures.words), of.period);
  const takeAll = (states: States, hold: number): void => {
    for (let i = 0; i < count; ++i) {
      if (i % 8192 === 0) progress(i / count);
      const time = timeOf(i);
      const block = blockAt(time);
      const asked = (blocks.feedAsked[block] ?? 0) * of.factorAt(time) || Infinity; // in a dwell, and held, nothing is asked
      const at = states.at(i);
      module.calls.leadscrew_trajectory_hold(trajectory, at, asked, hold, 0);
      const { view } = module;
      samples.block[i] = block;
      takeState(i, view, at);
      takeHold(i, view, hold);
      takePose(i, view, states.poseAt(i));
    }
  };
  withStates({ module, trajectory, count, timeOf, hasPoses: true }, (states) =>
    module.withSized(layout.hold.size, (hold) => takeAll(states, hold)),
  );
  return samples;
}

/** All words, as `leadscrew run --trace` writes them. */
export function traceOf(of: Pick<Sampled, "module" | "trajectory" | "period" | "figures" | "limits">): Blob {
  const { module, trajectory } = of;
  const axes = axesOf(of.limits);
  const parts: string[] = [`t,line,s,feed,${axes.map((axis) => "XYZABCUVW"[axis]).join(",")}\n`];
  const count = of.figures.words + 1;
  const timeOf = (tick: number): number => timeOfWord(tick, of.period);
  withStates({ module, trajectory, count, timeOf }, (states) => {
    for (let tick = 0; tick < count; ++tick) {
      const at = states.at(tick);
      const view = module.view;
      const numbers = [
        timeOf(tick),
        module.integer(at + layout.state.line),
        view.getFloat64(at + layout.state.pathLength, true),
        view.getFloat64(at + layout.state.feed, true),
        ...axes.map((axis) => view.getFloat64(at + layout.state.position + 8 * axis, true)),
      ];
      parts.push(`${numbers.join(",")}\n`);
    }
  });
  return new Blob(parts, { type: "text/csv" });
}
