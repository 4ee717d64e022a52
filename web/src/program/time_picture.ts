// Velocity, acceleration and jerk over a stretch of time: what plots show, as a picture and as a table.

import type { Picture } from "../draw/picture";
import { axisLetters, type Plan, type Samples } from "../engine/motion_types";
import { timeOf } from "../engine/path";
import { signed } from "../ui/dom";
import { colour } from "../ui/theme";
import { envelopeOf, type Channel } from "./envelope";

export const timeRows = [
  { name: "velocity", unit: "mm/s" },
  { name: "acceleration", unit: "mm/s²" },
  { name: "jerk", unit: "mm/s³" },
] as const;
/** Of X, Y, Z, and of those that turn. */
const axisColours = ["x", "y", "good", "warm", "quiet", "accent-strong"] as const;
export const timePicture = { width: 960, height: 640 } as const;

/** Of the axis that has this place among those of the machine. */
export function axisColour(place: number): string {
  return colour(axisColours[place % axisColours.length] ?? "x");
}

/** s, from and to. */
export type Stretch = readonly [number, number];

function samplesIn(samples: Samples, [from, to]: Stretch): readonly [first: number, last: number] {
  const first = Math.max(0, Math.floor(from / samples.step));
  return [first, Math.min(samples.count - 1, Math.ceil(to / samples.step))];
}

/** Times, then values of each axis, few enough to draw; behind velocities the feed. */
export function pointsOf({ samples }: Plan, row: number, stretch: Stretch): number[][] {
  const values = samples[timeRows[row]?.name ?? "jerk"];
  const channels: Channel[] = samples.axes.map((_, k) => ({ values, stride: samples.axes.length, offset: k }));
  if (row === 0) channels.push({ values: samples.feed, stride: 1, offset: 0 });
  return envelopeOf(samples, channels, ...samplesIn(samples, stretch));
}

/** A step of 1, 2 or 5 times a power of ten, of which at most so many lie in a range. */
function stepOf(range: number, most: number): number {
  const least = range / most;
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5].find((each) => each * power >= least) ?? 10);
}

function ticksOf(from: number, to: number, most: number): number[] {
  const step = stepOf(to - from, most);
  const first = Math.ceil(from / step - 1e-9);
  return [...Array(Math.max(0, Math.floor(to / step + 1e-9) - first + 1)).keys()].map((i) =>
    Number(((first + i) * step).toPrecision(12)),
  );
}

/** All three, one above the other, and where the tool stands. */
export function drawTimes(to: Picture, plan: Plan, stretch: Stretch, time: number): void {
  to.rectangle(0, 0, to.width, to.height, colour("paper"));
  const [left, right, head, foot] = [76, 16, 30, 26];
  const tall = (to.height - head - foot) / timeRows.length;
  const [from, until] = stretch;
  const x = (at: number): number => left + ((at - from) / (until - from)) * (to.width - left - right);
  drawKeys(to, plan, left);
  timeRows.forEach((_, row) => drawRow(to, plan, row, stretch, x, head + row * tall, tall - 12));
  for (const tick of ticksOf(from, until, 8))
    to.text(`${tick} s`, x(tick), to.height - 8, { colour: colour("quiet"), align: "center" });
  if (time < from || time > until) return;
  to.line([x(time), head, x(time), to.height - foot], { colour: colour("warm"), width: 1.5 });
}

function drawKeys(to: Picture, { samples }: Plan, left: number): void {
  const names = [...samples.axes.map((axis) => axisLetters[axis] ?? ""), "feed"];
  names.forEach((name, k) => {
    const at = left + k * 48;
    const isFeed = k === samples.axes.length;
    to.line([at, 14, at + 14, 14], {
      colour: isFeed ? colour("quiet") : axisColour(k),
      width: 2,
      ...(isFeed ? { dash: [4, 3] } : {}),
    });
    to.text(name, at + 18, 18, { colour: colour("ink") });
  });
}

function drawRow(
  to: Picture,
  plan: Plan,
  row: number,
  stretch: Stretch,
  x: (at: number) => number,
  top: number,
  tall: number,
): void {
  const [times = [], ...channels] = pointsOf(plan, row, stretch);
  let [least, greatest] = [0, 0];
  for (const values of channels)
    for (const value of values) [least, greatest] = [Math.min(least, value), Math.max(greatest, value)];
  if (least === greatest) greatest = least + 1;
  const y = (value: number): number => top + 18 + ((greatest - value) / (greatest - least)) * (tall - 24);
  const [begin, end] = [x(stretch[0]), x(stretch[1])];
  for (const tick of ticksOf(least, greatest, 5)) {
    to.line([begin, y(tick), end, y(tick)], { colour: colour(tick === 0 ? "axis" : "grid") });
    to.text(signed(tick), begin - 6, y(tick) + 4, { colour: colour("quiet"), size: 11, align: "right" });
  }
  channels.forEach((values, k) => {
    const isFeed = k === plan.samples.axes.length;
    const points: number[] = [];
    values.forEach((value, i) => {
      const at = Math.min(Math.max(times[i] ?? 0, stretch[0]), stretch[1]);
      points.push(x(at), y(value));
    });
    to.line(points, {
      colour: isFeed ? colour("quiet") : axisColour(k),
      width: isFeed ? 1 : 1.5,
      ...(isFeed ? { dash: [4, 3] } : {}),
    });
  });
  const { name, unit } = timeRows[row] ?? timeRows[0];
  to.text(`${name}, ${unit}`, begin + 4, top + 6, { colour: colour("ink"), size: 12, weight: 600 });
}

/** A row a sample of the stretch: its time, line and feed, mm/s, and of each axis position, velocity, acceleration and jerk. */
export function timesCsv(plan: Plan, stretch: Stretch): Blob {
  const { samples } = plan;
  const axes = samples.axes.map((axis) => axisLetters[axis] ?? "");
  const columns = ["", "v", "a", "j"].flatMap((letter) => axes.map((axis) => `${letter}${axis}`));
  const parts = [`t,line,feed,${columns.join(",")}\n`];
  const [first, last] = samplesIn(samples, stretch);
  for (let i = first; i <= last; ++i) {
    const [begin, end] = [i * axes.length, (i + 1) * axes.length];
    const values = [samples.position, samples.velocity, samples.acceleration, samples.jerk].flatMap((each) => [
      ...each.subarray(begin, end),
    ]);
    const time = Number(timeOf(plan, i).toFixed(9));
    parts.push(`${[time, samples.line[i], samples.feed[i], ...values].join(",")}\n`);
  }
  return new Blob(parts, { type: "text/csv" });
}
