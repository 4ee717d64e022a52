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
const lecture = "Lecture on linear interpolators";
const halfTurn = arc([10000, 0, -10000, 0], "ccw", { ...own, method: "koren", order: "", ending: "free" });

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
  {
    id: "koren-half-turn",
    title: "Koren's program, half a turn, R = 10 000",
    source: `${koren}: eq. 27 for ⌊π · 10 000⌋ clocks, without counters`,
    published: "radius 10001 BLU at the end",
    settings: { ...halfTurn, preload: "zero" },
  },
  {
    id: "koren-half-turn-strict",
    title: "The same, overflow where r > q",
    source: `${koren}, eqs. (1)–(5): remainders that begin at −1 overflow at r ≥ q where empty ones do at r > q`,
    published: "radius 10001 BLU at the end",
    settings: { ...halfTurn, preload: "minus-one" },
  },
  {
    id: "koren-hardware",
    title: "A line of 2 in, in registers for 12 in",
    source: `${koren}, eq. (18): steps of 0.0001 in`,
    published: "q = 120000",
    settings: line([0, 0, 20000, 0], { bits: "", capacity: "120000", method: "koren", preload: "zero" }),
  },
  {
    id: "lecture-axes",
    title: "X and Y at 60 and 80 mm/min, BLU 0.02 mm",
    source: `${lecture}: pulses of both axes`,
    published: "1500 and 2000 pulses in 30 s",
    settings: line([0, 0, 1500, 2000], { ...own, method: "koren", feed: "83.3333333" }),
  },
  {
    id: "lecture-line",
    title: "100 mm by 50 mm at 3 m/min, 16 bits",
    source: `${lecture}: feed word and axis rates`,
    published: "clock 29309.43 Hz, 4472 and 2236 pulses/s",
    settings: line([0, 0, 10000, 5000], { bits: "16", method: "dda", preload: "zero", feed: "5000" }),
  },
  {
    id: "lecture-delays",
    title: "Loads 4 and 2 in 13 bits, at 1024 Hz",
    source: `${lecture}: 2¹³ − 1, the least register for these delays`,
    published: "first overflows after 2 s and 4 s",
    settings: line([0, 0, 4, 2], { bits: "13", method: "dda", preload: "zero", feed: "0.5590170" }),
  },
  {
    id: "lecture-delay",
    title: "Load 1 in 13 bits, at 1024 Hz",
    source: `${lecture}: 2¹³ − 1, the least register for these delays`,
    published: "first overflow after 8 s",
    settings: line([0, 0, 1, 0], { bits: "13", method: "dda", preload: "zero", feed: "0.125" }),
  },
  {
    id: "ellipse",
    title: "An ellipse, 12 by 7",
    source: `${lab}: ellipses by the same DDA, integrands (a/b)·y and (b/a)·x`,
    published: "",
    settings: arc([12, 0, 12, 0], "ccw", { ...own, method: "koren", curve: "ellipse", semiX: "12", semiY: "7" }),
  },
  {
    id: "ellipse-hardware",
    title: "An arc of an ellipse across quadrants, 6 bits",
    source: `${lab}: ellipses by the same DDA, registers as for its circles`,
    published: "",
    settings: arc([0, 20, -40, 0], "cw", { ...teaching, bits: "6", curve: "ellipse", semiX: "40", semiY: "20" }),
  },
];

/** A preset changes the curve and the method; times, breakpoints and view stay the reader's. */
export function withPreset(settings: Settings, preset: Preset): Settings {
  const kept = { feed: settings.feed, polling: settings.polling, interval: settings.interval, run: settings.run };
  const marks = { stopAtPulse: settings.stopAtPulse, stopAtBorder: settings.stopAtBorder, predict: settings.predict };
  return {
    ...initial,
    capacity: "",
    order: "",
    tie: "",
    accumulation: "",
    places: "",
    ...kept,
    ...marks,
    ...preset.settings,
    clock: 0,
  };
}

/** The preset whose curve and method these are, if there is one. */
export function presetOf(settings: Settings): Preset | undefined {
  return presets.find((preset) => {
    const whole = { ...withPreset(settings, preset), view: settings.view, clock: settings.clock };
    const isLine = whole.module === "line";
    const isLeftOut = (key: string): boolean =>
      (isLine && /^(center[XY]|direction|order|tie|curve|ending|semi[XY]|accumulation|places)$/.test(key)) ||
      (whole.curve === "circle" && /^semi[XY]$/.test(key));
    return (Object.keys(whole) as (keyof Settings)[]).every((key) => whole[key] === settings[key] || isLeftOut(key));
  });
}
