// Loops that follow the program's words, as they are set; in the link as one text.

import {
  controllers,
  encoders,
  type Controller,
  type Encoder,
  type GainName,
  type LoopOptions,
} from "../engine/motion_types";
import { quantity, type FieldErrors } from "../lesson/settings";

export const loopNumbers = ["proportional", "integral", "derivative", "positionGain", "forward", "backlash"] as const;
export type LoopNumber = (typeof loopNumbers)[number] & GainName;

export interface LoopSettings extends Record<LoopNumber, string> {
  controller: Controller;
  encoder: Encoder;
}

export const initialLoops: LoopSettings = {
  controller: "own",
  encoder: "own",
  proportional: "2",
  integral: "2",
  derivative: "15",
  positionGain: "40",
  forward: "0",
  backlash: "0",
};

export const loopRanges: Readonly<Record<LoopNumber, readonly [number, number, string]>> = {
  proportional: [0, 100, "units/mm"],
  integral: [0, 1000, "units/(mm·s)"],
  derivative: [0, 200, "units/mm"],
  positionGain: [0.1, 5000, "1/s"],
  forward: [0, 1, "of velocity and acceleration"],
  backlash: [0, 1, "mm"],
};

/** Which numbers count. */
export function usesOf({ controller }: LoopSettings): Readonly<Record<LoopNumber, boolean>> {
  const isPid = controller === "pid";
  return {
    proportional: isPid,
    integral: isPid,
    derivative: isPid,
    positionGain: controller === "cascade" || controller === "pulses",
    forward: isPid || controller === "cascade",
    backlash: controller !== "pulses",
  };
}

export function optionsOf(settings: LoopSettings, errors: FieldErrors): LoopOptions {
  const uses = usesOf(settings);
  const gains: Partial<Record<GainName, number>> = {};
  for (const name of loopNumbers) {
    if (!uses[name]) continue;
    const [least, most, unit] = loopRanges[name];
    const value = quantity(settings[name]);
    if (value >= least && value <= most) gains[name] = value;
    else errors.set(name, `“${settings[name]}” is none of ${least} to ${most} ${unit}`);
  }
  return { controller: settings.controller, encoder: settings.encoder, gains };
}

/** Empty where nothing was asked for. */
export function textOf(settings: LoopSettings | undefined): string {
  if (settings === undefined) return "";
  return [settings.controller, settings.encoder, ...loopNumbers.map((name) => settings[name])].join("_");
}

export function loopsOf(text: string): LoopSettings | undefined {
  if (text === "") return undefined;
  const [controller, encoder, ...numbers] = text.slice(0, 200).split("_");
  const settings = { ...initialLoops };
  settings.controller = controllers.find((each) => each === controller) ?? "own";
  settings.encoder = encoders.find((each) => each === encoder) ?? "own";
  loopNumbers.forEach((name, i) => (settings[name] = (numbers[i] ?? settings[name]).slice(0, 20)));
  return settings;
}

/** Behind `leadscrew simulate PROGRAM`; and what the machine file has to say beside, where no option does. */
export function commandOf(settings: LoopSettings): { readonly options: string; readonly keys: string } {
  const { controller, forward, proportional, integral, derivative, positionGain, encoder, backlash } = settings;
  const keys: string[] = [];
  if (encoder !== "own") keys.push(`encoder = "${encoder === "rotary" ? "screw" : "slide"}"`);
  let options = "";
  if (controller === "pid") {
    options = ` --gains ${[proportional, integral, derivative].join(",")}`;
    if (quantity(forward) === 1) options += " --feed-forward on";
    else if (quantity(forward) > 0) keys.push(`velocity_forward = ${forward}`, `acceleration_forward = ${forward}`);
  }
  if (controller === "pulses") options = " --pulses";
  if (controller === "cascade" || controller === "pulses") keys.push(`position_gain_per_s = ${positionGain}`);
  if (controller === "cascade") keys.push(`velocity_forward = ${forward}`, `acceleration_forward = ${forward}`);
  const play = controller !== "pulses" && quantity(backlash) > 0 ? ` and backlash_mm = ${backlash} in [axis.X]` : "";
  const drive = keys.length > 0 ? `${keys.join(", ")} in [axis.X.drive]` : "";
  return { options, keys: `${drive}${play}`.replace(/^ and /, "") };
}
