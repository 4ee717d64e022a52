// Figures of the papers that pulse/ reproduces. `published`: what a paper prints, or what follows from it by arithmetic;
// nothing else stands there. The figures beside it come from the engine.

import { initial, type Settings } from "./settings";

export interface Preset {
  readonly id: string;
  readonly title: string;
  readonly source: string;
  readonly published: string;
  readonly settings: Partial<Settings>;
}

type Ends = readonly [number, number, number, number];

function line([startX, startY, endX, endY]: Ends, more: Partial<Settings> = {}): Partial<Settings> {
  return {
    module: "line",
    startX: `${startX}`,
    startY: `${startY}`,
    endX: `${endX}`,
    endY: `${endY}`,
    centerX: "0",
    centerY: "0",
    ...more,
  };
}

function arc(ends: Ends, direction: "cw" | "ccw", more: Partial<Settings> = {}): Partial<Settings> {
  return { ...line(ends), module: "arc", direction, ...more };
}

const teaching = { bits: "4", method: "dda", preload: "zero" };
const own = { bits: "", preload: "" };
const quarter: Ends = [5, 0, 0, 5];

const lab = "Teaching interpolator";
const fpga = "FPGA-based implementation of circular interpolation";
const koren = "Software interpolator";

export const presets: readonly Preset[] = [
  {
    id: "line-across",
    title: "A line through the origin's other side, 4 bits",
    source: `${lab}, Fig. 5: linear`,
    published: "2⁴ = 16 cycles",
    settings: line([3, 4, -9, -6], teaching),
  },
  {
    id: "one-quadrant",
    title: "An arc within one quadrant, 3 bits",
    source: `${lab}, Fig. 5: one quadrant`,
    published: "",
    settings: arc(quarter, "ccw", { ...teaching, bits: "3" }),
  },
  {
    id: "across-quadrants",
    title: "An arc across quadrants, clockwise, 4 bits",
    source: `${lab}, Fig. 5: across quadrants`,
    published: "",
    settings: arc([6, 8, -8, 6], "cw", teaching),
  },
  {
    id: "line-11-7",
    title: "The line to (11, 7), 4 bits",
    source: `${lab}: m = 2ⁿ, k = 1/2ⁿ`,
    published: "2⁴ = 16 cycles",
    settings: line([0, 0, 11, 7], teaching),
  },
  {
    id: "circle-10",
    title: "A whole circle, R = 10, 4 bits",
    source: `${lab}: stop by counters, quadrant by quadrant`,
    published: "",
    settings: arc([10, 0, 10, 0], "ccw", teaching),
  },
  {
    id: "fpga-point",
    title: "Point by point, R = 5",
    source: `${fpga}, Table 1`,
    published: "10 steps, error .877",
    settings: arc(quarter, "ccw", { ...own, method: "point-comparison", tie: "" }),
  },
  {
    id: "fpga-min",
    title: "Minimum error, R = 5",
    source: `${fpga}, Table 1`,
    published: "7 steps, error .385",
    settings: arc(quarter, "ccw", { ...own, method: "min-error" }),
  },
  {
    id: "fpga-improved",
    title: "Improved minimum error, R = 5",
    source: `${fpga}, Table 1`,
    published: "7 steps, error .385",
    settings: arc(quarter, "ccw", { ...own, method: "improved-min-error" }),
  },
  {
    id: "fpga-dda",
    title: "DDA, R = 5",
    source: `${fpga}, Table 1`,
    published: "8 steps (clocks), error .385",
    settings: arc(quarter, "ccw", { ...own, method: "dda", order: "" }),
  },
  {
    id: "koren-circle",
    title: "Koren's program, R = 10",
    source: `${koren}, eq. 27: y by the new x`,
    published: "",
    settings: arc([10, 0, 10, 0], "ccw", { ...own, method: "koren", preload: "zero", order: "" }),
  },
];

/** A preset changes the curve and the method; times, breakpoints and view stay the reader's. */
export function withPreset(settings: Settings, preset: Preset): Settings {
  const kept = { feed: settings.feed, polling: settings.polling, interval: settings.interval, run: settings.run };
  const marks = { stopAtPulse: settings.stopAtPulse, stopAtBorder: settings.stopAtBorder, predict: settings.predict };
  return { ...initial, capacity: "", order: "", tie: "", ...kept, ...marks, ...preset.settings, clock: 0 };
}

/** The preset whose curve and method these are, if there is one. */
export function presetOf(settings: Settings): Preset | undefined {
  return presets.find((preset) => {
    const whole = { ...withPreset(settings, preset), view: settings.view, clock: settings.clock };
    const isLine = whole.module === "line";
    return (Object.keys(whole) as (keyof Settings)[]).every(
      (key) => whole[key] === settings[key] || (isLine && /^(center[XY]|direction|order|tie)$/.test(key)),
    );
  });
}
