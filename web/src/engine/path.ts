// What a page draws of a plan at once: the path as lines, the range of what it is coloured by, and where time is lost.

import type { Blocks, Lost, Measure, PathData, Plan, Samples } from "./motion_types";

const mostVertices = 200_000;
const leastLoss = 5e-4; // s

export function isRapid(samples: Samples, blocks: Blocks, i: number): boolean {
  return blocks.feedAsked[samples.block[i] ?? 0] === Infinity;
}

function place(samples: Samples, i: number, axis: number): number {
  const k = samples.axes.indexOf(axis);
  return k < 0 ? 0 : (samples.position[i * samples.axes.length + k] ?? 0);
}

/** Does the sample stand where the one before does? */
function isSame(samples: Samples, i: number): boolean {
  return [0, 1, 2].every((axis) => place(samples, i, axis) === place(samples, i - 1, axis));
}

function lengthOf(values: Float32Array, i: number, axes: number): number {
  let sum = 0;
  for (let k = 0; k < Math.min(axes, 3); ++k) sum += (values[i * axes + k] ?? 0) ** 2;
  return Math.sqrt(sum);
}

function valueAt(samples: Samples, measure: Measure, i: number): number {
  if (measure === "speed") return samples.feed[i] ?? 0;
  if (measure === "line") return samples.line[i] ?? 0;
  return lengthOf(samples[measure], i, samples.axes.length);
}

/** Every sample that moves, or every so many; always where rapids begin and end, and where blocks meet. */
export function pathOf(samples: Samples, blocks: Blocks): PathData {
  const every = Math.max(1, Math.ceil(samples.count / mostVertices));
  const kept: number[] = [];
  const [least, greatest] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let i = 0; i < samples.count; ++i) {
    for (const axis of [0, 1, 2]) {
      least[axis] = Math.min(least[axis] ?? 0, place(samples, i, axis));
      greatest[axis] = Math.max(greatest[axis] ?? 0, place(samples, i, axis));
    }
    const isNew = i === 0 || i === samples.count - 1 || samples.block[i] !== samples.block[i + 1];
    if (isNew || (i % every === 0 && !isSame(samples, i))) kept.push(i);
  }
  const places = new Float32Array(kept.length * 3);
  kept.forEach((sample, v) => {
    for (const axis of [0, 1, 2]) places[v * 3 + axis] = place(samples, sample, axis);
  });
  const rapid = Uint8Array.from(kept, (sample) => (isRapid(samples, blocks, sample) ? 1 : 0));
  const of = (measure: Measure): Float32Array => Float32Array.from(kept, (sample) => valueAt(samples, measure, sample));
  const values = { speed: of("speed"), acceleration: of("acceleration"), jerk: of("jerk"), line: of("line") };
  const hold = Uint8Array.from(kept, (sample) => samples.hold[sample] ?? 0);
  return { places, samples: Int32Array.from(kept), isRapid: rapid, values, hold, least, greatest };
}

function rangeOf(samples: Samples, blocks: Blocks, measure: Measure): readonly [number, number] {
  let [least, greatest] = [Infinity, 0];
  for (let i = 0; i < samples.count; ++i) {
    if (isRapid(samples, blocks, i)) continue;
    const value = valueAt(samples, measure, i);
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
  }
  return measure === "line" && least < greatest ? [least, greatest] : [0, greatest > 0 ? greatest : 1];
}

/** Least and greatest of feed moves: rapids take no part. */
export function rangesOf(samples: Samples, blocks: Blocks): Plan["ranges"] {
  const of = (measure: Measure): readonly [number, number] => rangeOf(samples, blocks, measure);
  return { speed: of("speed"), acceleration: of("acceleration"), jerk: of("jerk"), line: of("line") };
}

/** At most `most` moves of those that lose time, the dearest first. */
export function lostOf(blocks: Blocks, most: number): Lost {
  const seconds = blocks.seconds.map((each, i) => each - (blocks.leastSeconds[i] ?? 0));
  const order = [...seconds.keys()].filter((i) => (seconds[i] ?? 0) > leastLoss);
  order.sort((a, b) => (seconds[b] ?? 0) - (seconds[a] ?? 0));
  const all = order.reduce((sum, i) => sum + (seconds[i] ?? 0), 0);
  return { seconds: all, moves: order.length, dearest: order.slice(0, most) };
}

/** The sample of this time. */
export function sampleAt(plan: Plan, time: number): number {
  return Math.min(Math.max(Math.round(time / plan.samples.step), 0), plan.samples.count - 1);
}

export function timeOf(plan: Plan, sample: number): number {
  return Math.min(sample * plan.samples.step, plan.figures.time);
}

/** When the line, or the first behind it that moves, begins; undefined where none does. */
export function timeOfLine(plan: Plan, line: number): number | undefined {
  const { blocks } = plan;
  let next: number | undefined;
  for (let i = 0; i < blocks.count; ++i) {
    if ((blocks.seconds[i] ?? 0) <= 0) continue;
    if (blocks.line[i] === line) return blocks.begin[i];
    if ((blocks.line[i] ?? 0) > line && (next === undefined || (blocks.line[i] ?? 0) < (blocks.line[next] ?? 0)))
      next = i;
  }
  return next === undefined ? undefined : blocks.begin[next];
}
