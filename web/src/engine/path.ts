// What a page draws of a plan at once: the path as lines, the range of what it is coloured by, and where time is lost.

import { shareOf, type Deviations, type Judged } from "./judging";
import type { Blocks, Gouge, Lost, Measure, PathData, Plan, PoleVisit, Samples } from "./motion_types";

const mostVertices = 200_000;
const leastLoss = 5e-4; // s
const samplesAPiece = 65_536;

export function isRapid(samples: Samples, blocks: Blocks, i: number): boolean {
  return blocks.feedAsked[samples.block[i] ?? 0] === Infinity;
}

function place(samples: Samples, i: number, axis: number): number {
  return samples.tip[i * 3 + axis] ?? 0;
}

/** Is the tip elsewhere than at the sample before though no axis has moved? */
function isApart(samples: Samples, i: number): boolean {
  const axes = samples.axes.length;
  for (let k = 0; k < axes; ++k)
    if (samples.position[i * axes + k] !== samples.position[(i - 1) * axes + k]) return false;
  return !isSame(samples, i);
}

/** Does the sample stand where the one before does? */
function isSame({ tip }: Samples, i: number): boolean {
  const [at, before] = [3 * i, 3 * i - 3];
  return tip[at] === tip[before] && tip[at + 1] === tip[before + 1] && tip[at + 2] === tip[before + 2];
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
function keptOf(samples: Samples): Int32Array {
  const { count, block } = samples;
  const every = Math.max(1, Math.ceil(count / mostVertices));
  const kept = new Int32Array(count);
  let length = 0;
  let isApartHere = false; // the first is kept in any case
  for (let i = 0; i < count; ++i) {
    const isApartNext = i + 1 < count && isApart(samples, i + 1);
    const isBorder = i === 0 || i === count - 1 || block[i] !== block[i + 1];
    if (isBorder || isApartHere || isApartNext || (i % every === 0 && !isSame(samples, i))) kept[length++] = i;
    isApartHere = isApartNext;
  }
  return kept.slice(0, length);
}

/** The box around the tip's way, mm. */
function extentsOf({ count, tip }: Samples): readonly [least: number[], greatest: number[]] {
  const [least, greatest] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  for (let axis = 0; axis < 3; ++axis) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = axis; i < 3 * count; i += 3) {
      const value = tip[i] ?? 0;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    [least[axis], greatest[axis]] = [low, high];
  }
  return [least, greatest];
}

/** Of the samples that are kept. */
export function pathOf(samples: Samples, blocks: Blocks): PathData {
  const kept = keptOf(samples);
  const [least, greatest] = extentsOf(samples);
  const [places, jumps] = [new Float32Array(kept.length * 3), new Uint8Array(kept.length)];
  kept.forEach((sample, v) => {
    for (let axis = 0; axis < 3; ++axis) places[v * 3 + axis] = place(samples, sample, axis);
    jumps[v] = sample > 0 && isApart(samples, sample) ? 1 : 0;
  });
  const rapid = new Uint8Array(kept.length).map((_, v) => (isRapid(samples, blocks, kept[v] ?? 0) ? 1 : 0));
  const part = new Uint8Array(kept.length).map((_, v) => blocks.part[samples.block[kept[v] ?? 0] ?? 0] ?? 0);
  const of = (measure: Measure): Float32Array =>
    new Float32Array(kept.length).map((_, v) => valueAt(samples, measure, kept[v] ?? 0));
  const values = { speed: of("speed"), acceleration: of("acceleration"), jerk: of("jerk"), line: of("line") };
  const hold = new Uint8Array(kept.length).map((_, v) => samples.hold[kept[v] ?? 0] ?? 0);
  return {
    places,
    samples: kept,
    isRapid: rapid,
    isApart: jumps,
    part,
    values,
    hold,
    share: new Float32Array(),
    least,
    greatest,
  };
}

/** Work that stops between its pieces. */
type InPieces<Result> = Generator<undefined, Result>;

function allOf<Result>(work: InPieces<Result>): Result {
  for (;;) {
    const { done, value } = work.next();
    if (done === true) return value;
  }
}

/** Between two pieces the page is free. */
async function bitByBit<Result>(work: InPieces<Result>): Promise<Result> {
  for (;;) {
    const { done, value } = work.next();
    if (done === true) return value;
    await new Promise((resume) => setTimeout(resume));
  }
}

function* deviations(samples: Samples, blocks: Blocks, judged: Judged): InPieces<Deviations> {
  let [share, worst, least, greatest] = [0, 0, Infinity, 0];
  for (let i = 0; i < samples.count; ++i) {
    if (i % samplesAPiece === samplesAPiece - 1) yield;
    if (isRapid(samples, blocks, i)) continue;
    const [distance, tolerance] = [judged.distance[i] ?? 0, judged.tolerance[i] ?? 0];
    least = Math.min(least, tolerance);
    greatest = Math.max(greatest, tolerance);
    if (shareOf(distance, tolerance) > share) [share, worst] = [shareOf(distance, tolerance), i];
  }
  return { ...judged, share, worst, tolerances: [Math.min(least, greatest), greatest] };
}

export function deviationsOf(samples: Samples, blocks: Blocks, judged: Judged): Deviations {
  return allOf(deviations(samples, blocks, judged));
}

function* shares({ samples }: Pick<PathData, "samples">, judged: Judged): InPieces<Float32Array> {
  const all = new Float32Array(samples.length);
  let sample = 0;
  for (let v = 0; v < samples.length; ++v) {
    for (const last = samples[v] ?? 0; sample <= last; ++sample) {
      if (sample % samplesAPiece === samplesAPiece - 1) yield;
      const share = shareOf(judged.distance[sample] ?? 0, judged.tolerance[sample] ?? 0);
      all[v] = Math.max(all[v] ?? 0, share);
    }
  }
  return all;
}

/** Of vertices, in one of which all samples since the one before are told. */
export function sharesOf(path: Pick<PathData, "samples">, judged: Judged): Float32Array {
  return allOf(shares(path, judged));
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

/** The plan has been judged: what is told of it is found a piece at a time, and between two the page is free. */
export async function takeJudged(plan: Plan, judged: Judged): Promise<void> {
  const found = await bitByBit(deviations(plan.samples, plan.blocks, judged));
  plan.path.share = await bitByBit(shares(plan.path, judged));
  plan.deviations = found;
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

/** A tool in the spindle: its number, 0 where none was told, and its offset along X, Y and Z, of axes that do not turn. */
export interface ToolAt {
  readonly number: number;
  readonly offset: readonly number[];
  /** The block that is in motion. */
  readonly block: number;
}

/** While the line is in motion, by the plan. */
function toolOfLine(plan: Plan, line: number): ToolAt {
  const { samples } = plan;
  const i = sampleAt(plan, (timeOfLine(plan, line) ?? 0) + 1.5 * samples.step);
  const offset = [0, 1, 2].map((axis) => {
    const k = samples.axes.indexOf(axis);
    return k < 0 ? 0 : (samples.position[i * samples.axes.length + k] ?? 0) - place(samples, i, axis);
  });
  return { number: samples.tool[i] ?? 0, offset, block: samples.block[i] ?? 0 };
}

/** Tools of lines; that of the last line that was asked for is found once. */
export class ToolsOfLines {
  private last: { readonly plan: Plan; readonly line: number; readonly tool: ToolAt } | undefined;

  at(plan: Plan, line: number): ToolAt {
    if (this.last?.plan !== plan || this.last.line !== line) this.last = { plan, line, tool: toolOfLine(plan, line) };
    return this.last.tool;
  }
}

const nearPole = 5; // degrees
const mostVisits = 100;

/** Where the tool comes near to a pole of the machine: of each stay within a few degrees the nearest place. */
export function polesOf(samples: Samples): PoleVisit[] {
  const visits: PoleVisit[] = [];
  let nearest: PoleVisit | undefined;
  let [was, isMoving] = [Infinity, false];
  const end = (): void => {
    if (nearest !== undefined && isMoving) visits.push(nearest);
    [nearest, isMoving] = [undefined, false];
  };
  for (let i = 0; i < samples.count; ++i) {
    const angle = samples.poleAngle[i] ?? Infinity;
    if (angle > nearPole) end();
    else if (nearest === undefined || angle < nearest.angle) nearest = { sample: i, angle };
    if (nearest !== undefined && was !== Infinity && angle !== was) isMoving = true;
    was = angle;
  }
  end();
  return visits.sort((a, b) => a.angle - b.angle).slice(0, mostVisits);
}

/** The sample of that line and pass whose tip is nearest. */
export function sampleOfGouge(plan: Plan, gouge: Gouge): number {
  const { samples, blocks } = plan;
  let [nearest, distance] = [0, Infinity];
  for (let i = 0; i < samples.count; ++i) {
    const block = samples.block[i] ?? 0;
    if (blocks.line[block] !== gouge.line || blocks.part[block] !== gouge.part || blocks.pass[block] !== gouge.pass)
      continue;
    const here = Math.hypot(...[0, 1, 2].map((k) => place(samples, i, k) - (gouge.tip[k] ?? 0)));
    if (here < distance) [nearest, distance] = [i, here];
  }
  return nearest;
}
