// What the reader has set, and the link that brings it back.

import { axisLetters, type Asked, type Diagnostic, type FeedChange, type Limits } from "../engine/motion_types";
import { exampleOf, examples } from "./examples";
import { packed, unpacked } from "../ui/packing";
import { loopsOf, textOf as textOfLoops, type LoopSettings } from "./loops";

export const colourings = ["speed", "acceleration", "jerk", "deviation", "limit", "part", "line"] as const;
export type Colouring = (typeof colourings)[number];

export interface Settings {
  text: string;
  /** Of the file, or the example's. */
  name: string;
  /** A machine file; empty for the built-in mill. */
  machine: string;
  /** Of the machine, where they were changed. */
  limits: Limits;
  /** A tool table. */
  tools: string;
  /** Of the feed, %. */
  override: number;
  /** Of the feed, while motion is under way. */
  changes: readonly FeedChange[];
  colouring: Colouring;
  /** The contour that is programmed is drawn where cutter compensation leads the tool beside it. */
  hasContour: boolean;
  /** Where the cursor is, s. */
  time: number;
  /** From where the path is seen, as PathView says; empty: all of it, as at first. */
  seen: string;
  /** Of the time that plots show, s; none: all of it. */
  stretch: readonly [number, number] | undefined;
  /** That follow; none: only words are looked at. */
  loops: LoopSettings | undefined;
  /** Of all that a report plans: what its run was asked for. */
  asked: Asked | undefined;
}

/** What a page begins with, where no link says otherwise: the file name is its own. */
export type Origin = Pick<Settings, "text" | "name" | "machine" | "tools"> & Partial<Pick<Settings, "asked">>;

const longestLink = 8000; // characters; longer ones mail and chat programs cut off

/** Limits of a machine file, or what is wrong with it. */
export type LimitsOf = (machine: string) => Promise<Limits | Diagnostic>;

export function copied(limits: Limits): Limits {
  return structuredClone(limits);
}

/** A machine with the period that was asked for. */
export function asAsked(limits: Limits, asked: Asked | undefined): Limits {
  return asked?.period === undefined ? limits : { ...limits, period: asked.period };
}

async function limitsOrMill(settings: Settings, limitsOf: LimitsOf): Promise<Limits> {
  const limits = await limitsOf(settings.machine);
  if (!("code" in limits)) return limits;
  settings.machine = "";
  const built = await limitsOf("");
  if ("code" in built) throw new Error(built.message);
  return built;
}

const limitNames = { velocity: "v", acceleration: "a", jerk: "j" } as const;

async function putText(link: URLSearchParams, key: string, text: string): Promise<void> {
  if (text.length === 0 || text.length >= 100_000) return;
  const short = await packed(new TextEncoder().encode(text));
  if (short.length <= longestLink) link.set(key, short);
}

async function textOf(link: URLSearchParams, key: string, otherwise: string): Promise<string> {
  try {
    const text = link.get(key);
    return text === null ? otherwise : new TextDecoder().decode(await unpacked(text));
  } catch {
    return otherwise; // half a link
  }
}

/** A text that no link can hold is left out, and what the page begins with. */
export async function toLink(settings: Settings, machine: Limits, origin?: Origin): Promise<string> {
  const link = new URLSearchParams();
  link.set("program", "1");
  const isOrigin = settings.text === origin?.text;
  const example = isOrigin ? undefined : exampleOf(settings.text);
  if (example !== undefined) link.set("ex", example.name);
  else if (!isOrigin) await putText(link, "z", settings.text);
  if (link.has("z")) link.set("name", settings.name);
  const base = isOrigin ? origin : example;
  if (settings.machine !== (base?.machine ?? "")) await putText(link, "m", settings.machine || " ");
  if (settings.tools !== (base?.tools ?? "")) await putText(link, "tools", settings.tools || " ");
  for (const [name, short] of Object.entries(limitNames) as ["velocity" | "acceleration" | "jerk", string][])
    if (settings.limits[name].join() !== machine[name].join()) link.set(short, settings.limits[name].join("_"));
  if (settings.limits.tolerance !== machine.tolerance) link.set("tol", String(settings.limits.tolerance));
  if (settings.override !== 100) link.set("o", String(settings.override));
  if (settings.changes.length > 0) link.set("feed", settings.changes.map(textOfChange).join("_"));
  if (settings.loops !== undefined) link.set("loops", textOfLoops(settings.loops));
  if (settings.seen !== "") link.set("v3", settings.seen);
  if (settings.stretch !== undefined)
    link.set("s", settings.stretch.map((each) => Number(each.toPrecision(7))).join("_"));
  link.set("c", settings.colouring);
  if (!settings.hasContour) link.set("g41", "0");
  link.set("t", settings.time.toFixed(3));
  return `#${link.toString()}`;
}

function textOfChange({ time, factor }: FeedChange): string {
  return `${Number(time.toFixed(6))}:${Number(factor.toFixed(4))}`;
}

/** None where one of them is none. */
function changesOf(text: string): FeedChange[] {
  if (text === "") return [];
  const changes = text.split("_").map((each) => {
    const [time = NaN, factor = NaN] = each.split(":").map(Number);
    return { time, factor };
  });
  const isOne = ({ time, factor }: FeedChange, i: number): boolean =>
    time >= (changes[i - 1]?.time ?? 0) && time < Infinity && factor >= 0 && factor <= 2;
  return changes.every(isOne) ? changes : [];
}

function stretchOf(text: string): readonly [number, number] | undefined {
  const [from = NaN, to = NaN] = text.split("_").map(Number);
  return from >= 0 && to > from ? [from, to] : undefined;
}

function beginningOf(link: URLSearchParams, origin?: Origin): Origin {
  const named = examples.find(({ name }) => name === link.get("ex"));
  if (named === undefined && origin !== undefined) return origin;
  const example = named ?? examples[0];
  if (example === undefined) throw new Error("there are no examples");
  const { name, text, machine = "", tools = "" } = example;
  return { name: `${name}.ngc`, text, machine, tools };
}

/** What a link lacks, or has wrong, is as it is without one; with the machine's own limits. */
export async function fromLink(
  hash: string,
  limitsOf: LimitsOf,
  origin?: Origin,
): Promise<readonly [Settings, Limits]> {
  const link = new URLSearchParams(hash.replace(/^#/, ""));
  const begin = beginningOf(link, origin);
  const settings: Settings = {
    text: await textOf(link, "z", begin.text),
    name: begin.name,
    machine: (await textOf(link, "m", begin.machine)).trim(),
    limits: {} as Limits,
    tools: (await textOf(link, "tools", begin.tools)).trim(),
    override: 100,
    changes: changesOf(link.get("feed") ?? ""),
    colouring: "speed",
    hasContour: link.get("g41") !== "0",
    time: 0,
    seen: (link.get("v3") ?? "").slice(0, 100),
    stretch: stretchOf(link.get("s") ?? ""),
    loops: loopsOf(link.get("loops") ?? ""),
    asked: origin?.asked,
  };
  if (settings.text !== begin.text) settings.name = link.get("name") ?? "program.ngc";
  const machine = asAsked(await limitsOrMill(settings, limitsOf), settings.asked);
  settings.limits = copied(machine);
  for (const [name, short] of Object.entries(limitNames) as ["velocity" | "acceleration" | "jerk", string][]) {
    const numbers = (link.get(short) ?? "").split("_").map(Number);
    if (numbers.length === machine[name].length && numbers.every((each, i) => each > 0 || machine[name][i] === 0))
      settings.limits[name] = numbers;
  }
  const tolerance = Number(link.get("tol") ?? NaN);
  if (tolerance >= 0) settings.limits.tolerance = tolerance;
  const override = Number(link.get("o") ?? NaN);
  if (override > 0 && override <= 200) settings.override = override;
  const colouring = colourings.find((each) => each === link.get("c"));
  if (colouring !== undefined) settings.colouring = colouring;
  const time = Number(link.get("t") ?? NaN);
  if (time >= 0) settings.time = time;
  return [settings, machine];
}

/** Is nothing changed of what the page began with? */
export function isAsBegun(settings: Settings, machine: Limits, origin: Origin): boolean {
  return (
    settings.text === origin.text &&
    settings.machine === origin.machine &&
    settings.tools === origin.tools &&
    settings.override === 100 &&
    settings.changes.length === 0 &&
    isMachine(settings.limits, machine)
  );
}

function isMachine(limits: Limits, machine: Limits): boolean {
  return JSON.stringify(limits) === JSON.stringify(machine);
}

/** That gives the same words; `isRecorded`: of what was recorded, and not of what the engine has planned. */
export function commandOf(settings: Settings, machine: Limits, isRecorded: boolean): string {
  return `leadscrew run ${programOf(settings, machine, isRecorded)} --trace words.csv`;
}

/** As commands name it, with all options that its words depend on; `hasFile`: the machine has one, whatever is set. */
export function programOf(settings: Settings, machine: Limits, isRecorded = false, hasFile = false): string {
  const name = /^[\w./-]+$/.test(settings.name) ? settings.name : `'${settings.name.replaceAll("'", "'\\''")}'`;
  const isBuiltIn = !hasFile && settings.machine === "" && isMachine(settings.limits, machine);
  const file = isBuiltIn ? "" : " --machine machine.toml";
  const tools = settings.tools === "" ? "" : " --tools tools.tbl";
  return `${name}${file}${tools}${askedText(settings.asked, isRecorded)}`;
}

/** What was asked for, as options of the command. */
function askedText(asked: Asked | undefined, isRecorded: boolean): string {
  if (asked === undefined) return "";
  const { period, mode, tolerance, smoothing, interpolator = "arc-length", start } = asked;
  const from = start.map((each, i) => (each === 0 ? "" : `${axisLetters[i]}${each}`)).filter((each) => each !== "");
  return [
    period === undefined ? "" : ` --period ${Number((period * 1e6).toFixed(3))}us`,
    mode === "programmed" ? "" : ` --mode ${mode}`,
    tolerance === undefined ? "" : ` --tolerance ${tolerance}`,
    smoothing === undefined ? "" : ` --smoothing ${smoothing}`,
    isRecorded && interpolator !== "arc-length" ? ` --interpolator ${interpolator}` : "",
    from.length === 0 ? "" : ` --start ${from.join(",")}`,
  ].join("");
}

/** The machine that the engine plans for: its file, with the smoothing that was asked for. */
export function plannedMachine(settings: Settings): string {
  const smoothing = settings.asked?.smoothing;
  if (smoothing === undefined) return settings.machine;
  const file = settings.machine === "" ? machineFile(settings) : settings.machine;
  return `smoothing = "${smoothing}"\n${file.replace(/^\s*smoothing\s*=.*$/gm, "")}`;
}

/** The machine as a file of the command: as it was opened, with the limits that were changed. */
export function machineFile({ machine, limits }: Pick<Settings, "machine" | "limits">): string {
  if (machine === "") return millFile(limits);
  let axis = -1;
  const lines = machine.split("\n").map((line) => {
    const section = /^\s*\[\s*(?:axis\s*\.\s*([A-Z])\s*)?[^\]]*\]/.exec(line);
    if (section !== null)
      axis = section[1] === undefined || /\.[A-Z]\s*\./.test(line) ? -2 : axisLetters.indexOf(section[1]);
    const [, key] = /^\s*(\w+)\s*=/.exec(line) ?? [];
    const name = /^max_(velocity|acceleration|jerk)_/.exec(key ?? "")?.[1] as "velocity" | undefined;
    const value =
      axis === -1 && key === "tolerance_mm" ? limits.tolerance : name && axis >= 0 ? limits[name][axis] : undefined;
    return value === undefined ? line : line.replace(/=\s*[-+.\w]+/, `= ${real(value)}`);
  });
  const hasTolerance = /^\s*tolerance_mm\s*=/m.test(machine);
  return `${hasTolerance ? "" : `tolerance_mm = ${real(limits.tolerance)}\n`}${lines.join("\n")}\n`;
}

function millFile(limits: Limits): string {
  const lines = [
    'name = "mill3"',
    `tolerance_mm = ${real(limits.tolerance)}`,
    `chord_error_mm = ${real(limits.chordError)}`,
  ];
  for (const [i, letter] of [..."XYZ"].entries())
    lines.push(
      "",
      `[axis.${letter}]`,
      `travel_mm = [${real(limits.least[i] ?? 0)}, ${real(limits.greatest[i] ?? 0)}]`,
      `max_velocity_mm_s = ${real(limits.velocity[i] ?? 0)}`,
      `max_acceleration_mm_s2 = ${real(limits.acceleration[i] ?? 0)}`,
      `max_jerk_mm_s3 = ${real(limits.jerk[i] ?? 0)}`,
      "blu_mm = 0.001",
    );
  return `${lines.join("\n")}\n`;
}

/** As TOML writes it. */
function real(value: number): string {
  const text = String(value);
  return /^-?\d+$/.test(text) ? `${text}.0` : text;
}
