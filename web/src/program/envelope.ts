// Samples over a stretch of time as few enough points to draw: least and greatest of each part of it.

import type { Samples } from "../engine/motion_types";

const mostPoints = 1600;

/** A number a sample: values[sample * stride + offset]. */
export interface Channel {
  readonly values: Float32Array;
  readonly stride: number;
  readonly offset: number;
}

/** Of samples begin ... end - 1. */
function leastAndGreatest({ values, stride, offset }: Channel, begin: number, end: number): [number, number] {
  let [least, greatest] = [Infinity, -Infinity];
  for (let i = begin * stride + offset; i < end * stride; i += stride) {
    const value = values[i] ?? 0;
    if (value < least) least = value;
    if (value > greatest) greatest = value;
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
