// Colours of a path: a scale from slow to fast, and one each for what holds motion.

import { holds, parts, type PathData, type Plan } from "../engine/motion_types";
import type { Colouring } from "./settings";

type Rgb = readonly [number, number, number];

function channel(linear: number): number {
  const value = Math.min(Math.max(linear, 0), 1);
  return value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055;
}

/** Oklch to sRGB, 0 ... 1. */
function oklch(lightness: number, chroma: number, degrees: number): Rgb {
  const angle = (degrees * Math.PI) / 180;
  const [a, b] = [chroma * Math.cos(angle), chroma * Math.sin(angle)];
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    channel(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** As reports have it: dark and violet is slow, bright and green is fast; on dark pages all of it is lighter. */
export function scaleColour(place: number, isDark: boolean): Rgb {
  const [slow, fast] = isDark ? [0.52, 0.93] : [0.34, 0.74];
  return oklch(slow + (fast - slow) * place, 0.15, 300 - 200 * place);
}

/** What holds motion, told apart by lightness as well. */
const holdHues: Readonly<Record<(typeof holds)[number], readonly [number, number, number]>> = {
  feed: [0.62, 0.13, 150],
  velocity: [0.55, 0.16, 255],
  acceleration: [0.7, 0.15, 65],
  jerk: [0.52, 0.2, 25],
  rest: [0.5, 0, 0],
  shape: [0.6, 0.15, 320],
  chord: [0.66, 0.12, 200],
};

export function holdColour(hold: number, isDark: boolean): Rgb {
  const [lightness, chroma, hue] = holdHues[holds[hold] ?? "shape"];
  return oklch(lightness + (isDark ? 0.14 : 0), chroma, hue);
}

const partHues: Readonly<Record<(typeof parts)[number], readonly [number, number, number]>> = {
  none: [0.6, 0, 0],
  approach: [0.7, 0.15, 65],
  pass: [0.55, 0.16, 255],
  link: [0.58, 0.19, 25],
  retract: [0.6, 0.15, 320],
};

export function partColour(part: number, isDark: boolean): Rgb {
  const [lightness, chroma, hue] = partHues[parts[part] ?? "none"];
  return oklch(lightness + (isDark ? 0.14 : 0), chroma, hue);
}

export function css([red, green, blue]: Rgb): string {
  return `rgb(${Math.round(red * 255)} ${Math.round(green * 255)} ${Math.round(blue * 255)})`;
}

const shades = 256;

/** What the colours of a path tell. */
export interface Look {
  readonly colouring: Colouring;
  /** Values of the scale's ends. */
  readonly range: readonly [number, number];
  readonly isDark: boolean;
}

/** Values of the ends of a plan's scale: a tolerance is all of it, unless it is not kept. */
export function rangeOf(plan: Plan, colouring: Colouring): readonly [number, number] {
  if (colouring === "limit" || colouring === "part") return [0, 1];
  if (colouring === "deviation") return [0, Math.max(1, plan.deviations?.share ?? 0)];
  return plan.ranges[colouring];
}

/** A colour for each shade of a scale, for each way in which motion is held, or for each part of machining a surface. */
function tableOf({ colouring, isDark }: Look): Rgb[] {
  if (colouring === "limit") return holds.map((_, hold) => holdColour(hold, isDark));
  if (colouring === "part") return parts.map((_, part) => partColour(part, isDark));
  return [...Array(shades).keys()].map((i) => scaleColour(i / (shades - 1), isDark));
}

function valuesOf(path: PathData, colouring: Colouring): Uint8Array | Float32Array {
  if (colouring === "limit") return path.hold;
  if (colouring === "part") return path.part;
  return colouring === "deviation" ? path.share : path.values[colouring];
}

/** Of the vertices, three numbers each. */
export function coloursOf(path: PathData, look: Look): Float32Array {
  const table = Float32Array.from(tableOf(look).flat());
  const colours = new Float32Array(path.samples.length * 3);
  const { colouring } = look;
  const values = valuesOf(path, colouring);
  const isKind = colouring === "limit" || colouring === "part";
  const [least, greatest] = isKind ? [0, table.length / 3 - 1] : look.range;
  const scale = (table.length / 3 - 1) / (greatest - least);
  for (let v = 0; v < path.samples.length; ++v) {
    const entry = Math.round(Math.min(Math.max((values[v] ?? 0) - least, 0), greatest - least) * scale);
    for (let i = 0; i < 3; ++i) colours[v * 3 + i] = table[entry * 3 + i] ?? 0;
  }
  return colours;
}
