// Samples over a stretch of time as few enough points to draw: least and greatest of each part of it.

import type { Samples } from "../engine/motion_types";

const mostPoints = 1600;

/** A number a sample: values[sample * stride + offset]. */
export interface Channel {
  readonly values: Float32Array;
  readonly stride: number;
  readonly offset: number;
}

/** Least and greatest of each `part` samples of a channel: what a long stretch is looked up in. */
interface Summary {
  readonly least: Float32Array;
  readonly greatest: Float32Array;
}

const part = 64;
const known = new WeakMap<Float32Array, Map<number, Summary>>();

/** Of samples begin ... end - 1, each looked at. */
function scanned({ values, stride, offset }: Channel, begin: number, end: number): [number, number] {
  let [least, greatest] = [Infinity, -Infinity];
  for (let i = begin * stride + offset; i < end * stride; i += stride) {
    const value = values[i] ?? 0;
    if (value < least) least = value;
    if (value > greatest) greatest = value;
  }
  return [least, greatest];
}

function summaryOf(channel: Channel): Summary {
  const { values, stride, offset } = channel;
  const ofValues = known.get(values) ?? new Map<number, Summary>();
  known.set(values, ofValues);
  let summary = ofValues.get(offset);
  if (summary === undefined) {
    const parts = Math.floor(values.length / stride / part);
    summary = { least: new Float32Array(parts), greatest: new Float32Array(parts) };
    for (let i = 0; i < parts; ++i)
      [summary.least[i], summary.greatest[i]] = scanned(channel, i * part, (i + 1) * part) as [number, number];
    ofValues.set(offset, summary);
  }
  return summary;
}

/** Of samples begin ... end - 1. */
function leastAndGreatest(channel: Channel, begin: number, end: number): [number, number] {
  const [first, last] = [Math.ceil(begin / part), Math.floor(end / part)];
  if (first >= last) return scanned(channel, begin, end);
  const parts = summaryOf(channel);
  let [least, greatest] = scanned(channel, begin, first * part);
  const [leastBehind, greatestBehind] = scanned(channel, last * part, end);
  least = Math.min(least, leastBehind);
  greatest = Math.max(greatest, greatestBehind);
  for (let i = first; i < last; ++i) {
    least = Math.min(least, parts.least[i] ?? Infinity);
    greatest = Math.max(greatest, parts.greatest[i] ?? -Infinity);
  }
  return [least, greatest];
}

/** Of samples `first` to `last`: times, then a list of numbers for each channel. */
export function envelopeOf(samples: Samples, channels: readonly Channel[], first: number, last: number): number[][] {
  const count = last - first + 1;
  if (count <= mostPoints) {
    const kept = [...Array(count).keys()].map((i) => first + i);
    return [
      kept.map((i) => i * samples.step),
      ...channels.map(({ values, stride, offset }) => kept.map((i) => values[i * stride + offset] ?? 0)),
    ];
  }
  const bins = mostPoints / 2;
  const border = (bin: number): number => first + Math.floor((bin * count) / bins);
  const all = [...Array(bins).keys()];
  return [
    all.flatMap((bin) => [border(bin) * samples.step, ((border(bin) + border(bin + 1)) / 2) * samples.step]),
    ...channels.map((channel) => all.flatMap((bin) => leastAndGreatest(channel, border(bin), border(bin + 1)))),
  ];
}
