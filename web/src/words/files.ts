// What gives the same words by the command: a program and a machine file of each lane, and the command itself.

import type { Limits, WordTask } from "../engine/motion_types";
import { machineFile } from "../program/settings";

/** As TOML writes a number. */
function real(value: number): string {
  return /^-?\d+$/.test(String(value)) ? `${value}.0` : String(value);
}

function driveKeys({ loops }: WordTask): readonly string[] {
  if (loops === undefined) return [];
  const { proportional, integral, derivative, positionGain, forward } = loops.gains;
  const keys = loops.controller === "pid" ? ['controller = "pid"'] : [];
  const add = (key: string, value: number | undefined): void => {
    if (value !== undefined) keys.push(`${key} = ${real(value)}`);
  };
  add("proportional_per_mm", proportional);
  add("integral_per_mm_s", integral);
  add("derivative_per_mm", derivative);
  add("position_gain_per_s", positionGain);
  add("velocity_forward", forward);
  add("acceleration_forward", forward);
  return keys;
}

/** The mill with the limits, the period and the drives of a lane. */
export function machineOf(task: WordTask): string {
  const limits: Limits = task.limits;
  const [name, ...rest] = machineFile({ machine: "", limits }).trimEnd().split("\n");
  const keys = driveKeys(task);
  const drives = keys.length === 0 ? [] : [..."XYZ"].flatMap((axis) => ["", `[axis.${axis}.drive]`, ...keys]);
  return [name, `period_us = ${real(Number((limits.period * 1e6).toFixed(3)))}`, ...rest, ...drives, ""].join("\n");
}

/** Of a lane, by its number from 1. */
export function commandOf(task: WordTask, number: number): string {
  const start = task.asked?.start ?? [];
  const at = start.map((each) => Number(each.toPrecision(15))).join(",");
  const words = [`lane-${number}.ngc`, "--machine", `lane-${number}.toml`];
  if (start.some((each) => each !== 0)) words.push("--start", at);
  const { loops, rule } = task;
  if (loops === undefined) {
    if (rule !== "arc-length") words.push("--interpolator", rule);
    return ["leadscrew run", ...words, "--json"].join(" ");
  }
  if (loops.controller === "pulses") words.push("--pulses");
  const note = rule === "arc-length" ? "" : `  # by arc length: the command steps under loops by no other rule`;
  return ["leadscrew simulate", ...words, "--json"].join(" ") + note;
}

/** A lane as the command makes it, by its number from 1; no task: it needs no files. */
export interface LaneCommand {
  readonly lane: number;
  readonly command: string;
  readonly task: WordTask | undefined;
}

/** Of a circle by integration, which no verb makes words of. */
export function circleCommandOf(rule: string): string {
  return `leadscrew study orders --json  # what ${rule} makes of a circle: its words are the page's alone`;
}

/** Writes the program and the machine file of each lane, and runs the commands. */
export function scriptOf(lanes: readonly LaneCommand[]): string {
  const lines = ["#!/bin/sh", "set -u"];
  for (const { lane, command, task } of lanes) {
    if (task === undefined) {
      lines.push(command);
      continue;
    }
    lines.push(`cat >lane-${lane}.ngc <<'END'`, task.text.trimEnd(), "END");
    lines.push(`cat >lane-${lane}.toml <<'END'`, machineOf(task).trimEnd(), "END");
    lines.push(command);
  }
  return `${lines.join("\n")}\n`;
}
