// A run that the command has recorded, inside the page: docs/formats.md, recording.

import {
  axisLetters,
  parts,
  toolParts,
  type Asked,
  type Blocks,
  type Diagnostic,
  type Equipment,
  type Figures,
  type Gouge,
  type Plan,
  type Samples,
  type Smoothing,
  type StepRule,
} from "./motion_types";
import { deviationsOf, lostOf, pathOf, polesOf, rangesOf, sharesOf } from "./path";
import { blockFinder, settleBegins, timeOfWord } from "./sampling";

interface Ratios {
  readonly name: string;
  readonly velocity_ratio?: number;
  readonly acceleration_ratio?: number;
  readonly jerk_ratio?: number;
}

/** What the page shows of `leadscrew run --json`. */
export interface RunResult {
  readonly machine: string;
  readonly period_s: number;
  readonly words: number;
  readonly blocks: number;
  readonly moves: number;
  readonly length_mm: number;
  readonly time_s: number;
  readonly dwell_s: number;
  readonly bound_s: number;
  readonly deviation_mm: number;
  readonly tolerance_mm: number;
  readonly feed: {
    readonly programmed_max_mm_s: number;
    readonly max_ratio: number;
    readonly ripple: number | null;
  };
  readonly axes: readonly Ratios[];
  readonly plan: readonly Ratios[];
  readonly losses: readonly { readonly cause: string; readonly s: number }[];
  readonly violation_count: number;
  readonly tip?: {
    readonly deviation_mm: number;
    readonly orientation_deviation_deg: number;
    readonly orientation_tolerance_deg: number;
  };
  readonly diagnostics: readonly {
    readonly line: number;
    readonly column: number;
    readonly code: string;
    readonly severity: string;
    readonly message: string;
    readonly hint: string;
  }[];
}

/** Arrays are base64 of numbers, least byte first. */
interface RecordedSamples {
  readonly count: number;
  readonly words_each: number;
  readonly axes: readonly string[];
  readonly position: string;
  /** None where every word is told: they are its differences. */
  readonly velocity?: string;
  readonly acceleration?: string;
  readonly jerk?: string;
  readonly feed: string;
  readonly s: string;
  readonly tip: string;
  readonly direction?: string;
  readonly pole_angle?: string;
  readonly tool: string;
  readonly line: string;
  readonly hold: string;
  readonly hold_axis: string;
  readonly distance: string;
  readonly tolerance: string;
}

interface RecordedBlocks {
  readonly count: number;
  readonly line: string;
  readonly begin: string;
  readonly seconds: string;
  readonly least_seconds: string;
  readonly length: string;
  readonly feed_asked: string;
  readonly feed_reached: string;
  readonly part: string;
  readonly pass: string;
  readonly cause: string;
  readonly causes: readonly string[];
}

interface RecordedGouge {
  readonly line: number;
  readonly depth_mm?: number;
  readonly part?: string;
  readonly of?: string;
  readonly pass?: number;
  readonly surface: number;
  readonly u: number;
  readonly v: number;
  readonly place: readonly number[];
  readonly tip?: readonly number[];
}

export interface Recording {
  readonly version: string;
  /** That recorded it. */
  readonly command: string;
  readonly name: string;
  readonly text: string;
  /** A machine file; empty for the built-in mill. */
  readonly machine: string;
  readonly tools: string;
  readonly asked: {
    readonly mode: "exact-stop" | "blend" | null;
    readonly tolerance_mm: number | null;
    readonly smoothing: Smoothing | null;
    readonly interpolator: StepRule;
    readonly start: readonly number[];
  };
  /** The first of them. */
  readonly events: readonly {
    readonly t: number;
    readonly line: number;
    readonly code: string;
    readonly output: number | null;
    readonly value: number | null;
    readonly q: number | null;
    readonly waits: boolean;
  }[];
  readonly event_count: number;
  readonly result: RunResult;
  readonly gouging?: {
    readonly blocks: readonly RecordedGouge[];
    readonly contacts: readonly RecordedGouge[];
  };
  readonly samples: RecordedSamples;
  readonly blocks: RecordedBlocks;
}

const mostLosses = 50; // told one by one

/** What the run was asked for. */
export function askedOf({ asked, result }: Recording): Asked {
  const { mode, tolerance_mm: tolerance, smoothing, interpolator, start } = asked;
  return {
    period: result.period_s,
    mode: mode ?? "programmed",
    ...(tolerance === null ? {} : { tolerance }),
    ...(smoothing === null ? {} : { smoothing }),
    interpolator,
    start,
  };
}

/** Of this page; undefined where there is none. */
export function recordingOfPage(): Recording | undefined {
  const text = document.getElementById("recording")?.textContent ?? "";
  if (text.trim() === "") return undefined;
  const recording = JSON.parse(text) as Recording;
  return { ...recording, machine: recording.machine.trim(), tools: recording.tools.trim() };
}

function bytesOf(base64: string): ArrayBuffer {
  const characters = atob(base64);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes.buffer;
}

const doubles = (base64: string): Float64Array => new Float64Array(bytesOf(base64));
const floats = (base64: string): Float32Array => new Float32Array(bytesOf(base64));
const integers = (base64: string): Int32Array => new Int32Array(bytesOf(base64));
const small = (base64: string): Uint8Array => new Uint8Array(bytesOf(base64));

/** Of a tool that does not turn, so many times. */
function upright(count: number): Float32Array {
  return Float32Array.from({ length: 3 * count }, (_, i) => (i % 3 === 2 ? 1 : 0));
}

function blocksOf(of: RecordedBlocks): Blocks {
  const [begin, seconds] = [doubles(of.begin), doubles(of.seconds)];
  settleBegins(begin, seconds);
  return {
    count: of.count,
    line: integers(of.line),
    begin,
    seconds,
    leastSeconds: doubles(of.least_seconds),
    length: doubles(of.length),
    feedAsked: doubles(of.feed_asked),
    feedReached: doubles(of.feed_reached),
    part: small(of.part),
    pass: integers(of.pass),
    cause: small(of.cause),
    causes: of.causes,
  };
}

/** Velocity, acceleration and jerk of every word: what the command has where it tells them, to the last bit. */
function derivativesOf(position: Float64Array, axes: number, period: number): readonly Float32Array[] {
  const derivatives = [1, 2, 3].map(() => new Float32Array(position.length));
  const before = new Float64Array(4 * axes);
  before.set(position.subarray(0, axes));
  for (let i = 0; i < position.length; ++i) {
    let [difference, perPeriod] = [position[i] ?? 0, 1];
    for (let k = 0, at = i % axes; k < 4; ++k, perPeriod /= period, at += axes) {
      const next = difference - (before[at] ?? 0);
      before[at] = difference;
      const derivative = derivatives[k - 1];
      if (derivative !== undefined) derivative[i] = difference * perPeriod;
      difference = next;
    }
  }
  return derivatives;
}

function samplesOf(of: RecordedSamples, blocks: Blocks, { period_s, words }: RunResult): Samples {
  const blockAt = blockFinder(blocks, period_s);
  const position = doubles(of.position);
  const differences = of.words_each > 1 ? [] : derivativesOf(position, of.axes.length, period_s);
  const derivative = (told: string | undefined, k: number): Float32Array =>
    told !== undefined ? floats(told) : (differences[k] ?? new Float32Array(position.length));
  return {
    count: of.count,
    step: of.words_each * period_s,
    axes: of.axes.map((letter) => axisLetters.indexOf(letter)),
    position,
    velocity: derivative(of.velocity, 0),
    acceleration: derivative(of.acceleration, 1),
    jerk: derivative(of.jerk, 2),
    feed: Float32Array.from(doubles(of.feed)),
    tip: Float64Array.from(floats(of.tip)),
    direction: of.direction === undefined ? upright(of.count) : floats(of.direction),
    poleAngle: of.pole_angle === undefined ? new Float32Array(of.count).fill(Infinity) : floats(of.pole_angle),
    tool: integers(of.tool),
    line: integers(of.line),
    block: Int32Array.from({ length: of.count }, (_, i) => blockAt(Math.min(i * of.words_each, words) * period_s)),
    hold: small(of.hold),
    holdAxis: small(of.hold_axis),
  };
}

function figuresOf(result: RunResult): Figures {
  const ofAxes = (name: "velocity_ratio" | "acceleration_ratio" | "jerk_ratio"): number[] =>
    [...axisLetters].map((letter) => result.plan.find((axis) => axis.name === letter)?.[name] ?? 0);
  return {
    time: result.time_s,
    bound: result.bound_s,
    dwell: result.dwell_s,
    length: result.length_mm,
    feedProgrammed: result.feed.programmed_max_mm_s,
    tolerance: result.tolerance_mm,
    velocity: ofAxes("velocity_ratio"),
    acceleration: ofAxes("acceleration_ratio"),
    jerk: ofAxes("jerk_ratio"),
    words: result.words,
    blocks: result.blocks,
    moves: result.moves,
  };
}

export function planOf(recording: Recording, equipment: Equipment): Plan {
  const { result } = recording;
  const blocks = blocksOf(recording.blocks);
  const samples = samplesOf(recording.samples, blocks, result);
  const path = pathOf(samples, blocks);
  const judged = { distance: floats(recording.samples.distance), tolerance: floats(recording.samples.tolerance) };
  path.share = sharesOf(path, judged);
  return {
    period: result.period_s,
    figures: figuresOf(result),
    blocks,
    samples,
    path,
    drawn: structuredClone(path),
    ranges: rangesOf(samples, blocks),
    lost: lostOf(blocks, mostLosses),
    ...equipment,
    poles: polesOf(samples),
    deviations: deviationsOf(samples, blocks, judged),
  };
}

export function diagnosticsOf({ diagnostics }: RunResult): Diagnostic[] {
  return diagnostics.map((each) => ({
    ...each,
    severity: ["note", "warning", "error"].indexOf(each.severity),
    field: "",
  }));
}

/** Undefined where the run did not look for them. */
export function gougesOf({ gouging }: Recording): readonly Gouge[] | undefined {
  if (gouging === undefined) return undefined;
  return [...gouging.blocks, ...gouging.contacts].map((each) => ({
    line: each.line,
    part:
      each.depth_mm === undefined
        ? parts.indexOf("pass")
        : Math.max(
            parts.findIndex((part) => part === each.of),
            0,
          ),
    toolPart: Math.max(
      toolParts.findIndex((part) => part === each.part),
      0,
    ),
    pass: (each.pass ?? 1) - 1,
    surface: each.surface,
    depth: each.depth_mm ?? 0,
    u: each.u,
    v: each.v,
    place: each.place,
    tip: each.tip ?? each.place,
  }));
}

/** The recorded words, all or every so many, as `leadscrew run --trace` writes them. */
export function traceOf({ samples: of, result }: Recording): Blob {
  const [position, feed, length, line] = [doubles(of.position), doubles(of.feed), doubles(of.s), integers(of.line)];
  const rows = [`t,line,s,feed,${of.axes.join(",")}\n`];
  for (let i = 0; i < of.count; ++i) {
    const tick = Math.min(i * of.words_each, result.words);
    const place = position.subarray(i * of.axes.length, (i + 1) * of.axes.length);
    rows.push(`${[timeOfWord(tick, result.period_s), line[i], length[i], feed[i], ...place].join(",")}\n`);
  }
  return new Blob(rows, { type: "text/csv" });
}
