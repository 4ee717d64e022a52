// What the page asks the planner for, and what it is told.

import type { Deviations, Judged } from "./judging";
import type { ModesData } from "./modes";

export const axisLetters = "XYZABCUVW";

/** Of a machine; a number an axis, those that it lacks 0. Lengths mm or degrees, times s. */
export interface Limits {
  least: number[];
  greatest: number[];
  velocity: number[];
  acceleration: number[];
  jerk: number[];
  tolerance: number;
  chordError: number;
  /** Bits, 1 for X and so on. */
  axes: number;
  /** Of the servo, s. */
  period: number;
}

export interface Diagnostic {
  /** 0 note, 1 warning, 2 error. */
  readonly severity: number;
  /** From 1; 0: none. */
  readonly line: number;
  /** In bytes, from 1; 0: none. */
  readonly column: number;
  readonly code: string;
  readonly message: string;
  readonly hint: string;
  readonly field: string;
}

export interface Checked {
  readonly diagnostics: readonly Diagnostic[];
  readonly blocks: number;
  readonly moves: number;
  readonly isSound: boolean;
}

export interface Figures {
  readonly time: number;
  readonly bound: number;
  readonly dwell: number;
  readonly length: number;
  readonly feedProgrammed: number;
  readonly tolerance: number;
  /** Greatest over limit, a number an axis. */
  readonly velocity: number[];
  readonly acceleration: number[];
  readonly jerk: number[];
  readonly words: number;
  readonly blocks: number;
  readonly moves: number;
}

/** Moves of the program in their order, an entry each. */
export interface Blocks {
  readonly count: number;
  readonly line: Int32Array;
  readonly begin: Float64Array;
  readonly seconds: Float64Array;
  readonly leastSeconds: Float64Array;
  readonly length: Float64Array;
  /** mm/s; infinite of a rapid, 0 of a dwell. */
  readonly feedAsked: Float64Array;
  readonly feedReached: Float64Array;
  /** An entry of `parts`, and the number of the pass. */
  readonly part: Uint8Array;
  readonly pass: Int32Array;
  /** An entry of `causes`. */
  readonly cause: Uint8Array;
  readonly causes: readonly string[];
}

/** What holds motion at a sample, in the order of leadscrew.h. */
export const holds = ["feed", "velocity", "acceleration", "jerk", "rest", "shape", "chord"] as const;

/** What a move has to do with a surface that is machined. */
export const parts = ["none", "approach", "pass", "link", "retract"] as const;

/** Motion at equal steps of time: every word, or every so many. */
export interface Samples {
  readonly count: number;
  /** s between two of them: a whole number of periods. */
  readonly step: number;
  /** Axes that the machine has; arrays of axes hold a number each, sample after sample. */
  readonly axes: readonly number[];
  readonly position: Float64Array;
  readonly velocity: Float32Array;
  readonly acceleration: Float32Array;
  readonly jerk: Float32Array;
  readonly feed: Float32Array;
  /** The tip in the workpiece and the direction from it to the spindle, three numbers each. */
  readonly tip: Float64Array;
  readonly direction: Float32Array;
  /** Degrees to the nearest pole of the machine; infinite where it has none. */
  readonly poleAngle: Float32Array;
  /** Number of the tool in the spindle; 0: none told. */
  readonly tool: Int32Array;
  readonly line: Int32Array;
  /** An entry of Blocks. */
  readonly block: Int32Array;
  /** An entry of `holds`, and which axis, of the samples' axes. */
  readonly hold: Uint8Array;
  readonly holdAxis: Uint8Array;
}

/** The path as lines to draw: feed moves with their samples, rapids apart. */
export interface PathData {
  /** Places, three numbers a vertex; of the tip in the workpiece, mm. */
  readonly places: Float32Array;
  /** Which sample a vertex is. */
  readonly samples: Int32Array;
  /** Vertex i and the one before are the way of a rapid. */
  readonly isRapid: Uint8Array;
  /** Nothing leads from the vertex before to this one: another length of the tool is in force. */
  readonly isApart: Uint8Array;
  /** An entry of `parts` a vertex. */
  readonly part: Uint8Array;
  /** A number a vertex. */
  readonly values: Readonly<Record<Measure, Float32Array>>;
  /** An entry of `holds` a vertex. */
  readonly hold: Uint8Array;
  /** How far a vertex is from the program, of its tolerance; empty until it has been judged. */
  share: Float32Array;
  readonly least: readonly number[];
  readonly greatest: readonly number[];
}

/** A number of each sample; speed, acceleration and jerk of X, Y and Z together. */
export type Measure = "speed" | "acceleration" | "jerk" | "line";

/** Somebody turns the feed override, or holds feed: from `time` on, s of the motion as it is with the changes before. */
export interface FeedChange {
  readonly time: number;
  /** 0 … 2; 0 holds. */
  readonly factor: number;
}

/** Time beyond what feed words ask. */
export interface Lost {
  readonly seconds: number;
  /** How many moves lose some. */
  readonly moves: number;
  /** Entries of Blocks. */
  readonly dearest: readonly number[];
}

/** A tool of the table, mm. */
export interface ToolShape {
  readonly number: number;
  readonly diameter: number;
  /** -1: nothing is told of its shape. */
  readonly cornerRadius: number;
  /** From the tip to the holder; 0: not told. */
  readonly length: number;
  /** 0: there is no holder. */
  readonly holderDiameter: number;
  readonly holderLength: number;
}

/** A surface as quadrilaterals, in the workpiece. */
export interface SurfaceMesh {
  /** D of the program. */
  readonly number: number;
  /** Twelve numbers each: four corners, mm, and the normals there. */
  readonly corners: Float32Array;
  readonly normals: Float32Array;
}

/** Where a tool cuts too deep into a surface. */
export interface Gouge {
  readonly line: number;
  /** Entries of `parts` and of `toolParts`. */
  readonly part: number;
  readonly toolPart: number;
  readonly pass: number;
  readonly surface: number;
  /** mm; 0: the tool bends less than the surface that it touches. */
  readonly depth: number;
  readonly u: number;
  readonly v: number;
  readonly place: readonly number[];
  /** Of the tool. */
  readonly tip: readonly number[];
}
export const toolParts = ["cutter", "shank", "holder"] as const;

/** A place of the path at which the tool comes near to a pole, nearer than before and behind. */
export interface PoleVisit {
  readonly sample: number;
  /** Degrees. */
  readonly angle: number;
}

export interface Plan {
  readonly period: number;
  readonly figures: Figures;
  readonly blocks: Blocks;
  readonly samples: Samples;
  readonly path: PathData;
  /** The same, to be handed on to the worker that draws it: large arrays are not copied by the page. */
  readonly drawn: PathData;
  /** Least and greatest of feed moves. */
  readonly ranges: Readonly<Record<Measure, readonly [number, number]>>;
  readonly lost: Lost;
  readonly tools: readonly ToolShape[];
  /** Of those that the program machines. */
  readonly surfaces: readonly SurfaceMesh[];
  /** What the program tells where cutter compensation leads the tool beside it, as lines: places of both ends, six numbers each. */
  readonly contour: Float32Array;
  readonly modes: ModesData;
  readonly poles: readonly PoleVisit[];
  /** None until somebody asks for them. */
  deviations: Deviations | undefined;
}

/** What of a plan depends on how many samples there are. */
export type Sampling = Pick<Plan, "blocks" | "samples" | "path" | "drawn" | "ranges" | "poles">;

/** What a program is machined with, what it is to become and what it has in force, without its motion. */
export type Equipment = Pick<Plan, "tools" | "surfaces" | "contour" | "modes">;

/** In place of what a program and its machine say. */
export interface Asked {
  /** Of the servo, s. */
  readonly period?: number;
  /** How moves are joined; an entry of `pathModes`. */
  readonly mode: PathMode;
  /** In place of P of G64, mm. */
  readonly tolerance?: number;
  /** In place of the machine's. */
  readonly smoothing?: Smoothing;
  /** By which words stepped along curves; what is planned here is by arc length. */
  readonly interpolator?: StepRule;
  /** Where the program begins; a number an axis. */
  readonly start: readonly number[];
}
/** How corners and short lines are led under G64: `smoothing` of a machine file. */
export type Smoothing = "splines" | "least-time";
/** In the order of leadscrew.h. */
export const pathModes = ["programmed", "exact-stop", "blend"] as const;
export type PathMode = (typeof pathModes)[number];

export interface Task {
  readonly text: string;
  /** A machine file; empty for the built-in mill. */
  readonly machine: string;
  /** In place of those of the machine; of the same axes. */
  readonly limits: Limits;
  /** A tool table, as LinuxCNC writes it. */
  readonly tools: string;
  /** Of the feed, above 0, at most 2. */
  readonly override: number;
  /** In the order of time. */
  readonly changes: readonly FeedChange[];
  readonly asked?: Asked | undefined;
}

/** What closes the loops of simulated axes, in the order of leadscrew.h; `own`: what the machine's file says. */
export const controllers = ["own", "cascade", "pid", "pulses"] as const;
export type Controller = (typeof controllers)[number];
/** Where a loop measures position: `own` as the machine's file says, at the screw, or on the slide. */
export const encoders = ["own", "rotary", "linear"] as const;
export type Encoder = (typeof encoders)[number];

/** Numbers of the loops, in the order of leadscrew.h; which of them count is up to the controller. */
export const gainNames = [
  "proportional",
  "integral",
  "derivative",
  "driveGain",
  "timeConstant",
  "positionGain",
  "velocityGain",
  "velocityIntegral",
  "forward",
  "backlash",
] as const;
export type GainName = (typeof gainNames)[number];

/** Of all axes; a gain that is left out is the machine's, or 0. */
export interface LoopOptions {
  readonly controller: Controller;
  readonly encoder: Encoder;
  readonly gains: Partial<Readonly<Record<GainName, number>>>;
}

/** Rules by which words step along curves, in the order of leadscrew.h. */
export const stepRules = ["arc-length", "taylor1", "taylor2", "newton", "uniform"] as const;
export type StepRule = (typeof stepRules)[number];

/** As `leadscrew simulate` measures them; a number an axis, mm or degrees. */
export interface LoopFigures {
  readonly greatest: number[];
  readonly rms: number[];
  readonly overshoot: number[];
  /** mm/s, by tachometers. */
  readonly feedGreatest: number;
  readonly feedMean: number;
  /** mm; -1 of rotary axes. */
  readonly contour: number;
  readonly contourRms: number;
}

/** Where simulated axes were; arrays of axes hold a number each, word after word, on until they stand. */
export interface Slides {
  readonly count: number;
  /** Axes that the machine has. */
  readonly axes: readonly number[];
  readonly position: Float64Array;
  /** Of the screws, as tachometers tell it; of the controllers; of the motors. */
  readonly velocity: Float32Array;
  readonly control: Float32Array;
  readonly current: Float32Array;
  readonly figures: LoopFigures;
}

/** Words of a program, and what loops made of them. */
export interface WordTask extends Task {
  readonly rule: StepRule;
  readonly loops?: LoopOptions | undefined;
  /** More words are a problem. */
  readonly most: number;
}

/** Rules that integrate a circle a step a period, in the order of leadscrew.h. */
export const circleRules = ["euler", "heun", "tustin", "x-first", "runge-kutta", "state-transition"] as const;
export type CircleRule = (typeof circleRules)[number];

/** Words of a whole circle around (0, 0) from (radius, 0), counterclockwise, at constant feed. */
export interface CircleTask {
  readonly rule: CircleRule;
  /** mm, mm/s, s. */
  readonly radius: number;
  readonly feed: number;
  readonly period: number;
  /** More words are a problem. */
  readonly most: number;
}

export interface Words {
  /** s */
  readonly period: number;
  /** Words, the first at rest at time 0. */
  readonly count: number;
  /** Speeds and their changes are taken over so many periods; without it over one. */
  readonly window?: number;
  /** X, Y and Z, word after word, mm. */
  readonly position: Float64Array;
  /** 1 of a word at which the speed along the path is constant. */
  readonly steady: Uint8Array;
  /** Of planning and interpolation together, of a word, ns; as the clock here tells it. */
  readonly cost: number;
  readonly slides: Slides | undefined;
}

export interface PlannerCalls {
  /** Of a machine file; of the built-in mill where it is empty. */
  limits(machine: string): Promise<Limits | Diagnostic>;
  check(task: Task): Promise<Checked>;
  /** Of a sound program; at most so many samples. */
  plan(task: Task, most: number): Promise<Plan | Diagnostic>;
  /** What was planned last, at most so many samples of it. */
  sampled(most: number): Promise<Sampling | Diagnostic>;
  /** What plan() tells of tools, surfaces and contours, without a plan. */
  equipment(task: Task): Promise<Equipment>;
  /** Where a program gouges the surfaces that it machines by more than its machine's tolerance. */
  gouges(task: Task): Promise<readonly Gouge[] | Diagnostic>;
  /** Every word of a program, by a rule; through loops where they are given. */
  words(task: WordTask): Promise<Words | Diagnostic>;
  /** Every word of a circle by integration. */
  circle(task: CircleTask): Promise<Words | Diagnostic>;
  /** What loops make of the words of what was planned last. */
  slides(task: Task, loops: LoopOptions): Promise<Slides | Diagnostic>;
  /** How far samples of what was planned last, so many at most, are from its program. */
  judged(most: number): Promise<Judged | Diagnostic>;
  /** All words of what was planned last, as `leadscrew run --trace` writes them. */
  trace(): Promise<Blob>;
  /** Step and direction of all axes along what was planned last, as `leadscrew run --pulses FILE.vcd` writes them; Hz. */
  steps(clock: number): Promise<Blob | Diagnostic>;
  /** What a code or a block means; empty where nothing is known. */
  explain(block: string): Promise<string>;
}

export type PlannerMethod = keyof PlannerCalls;
export type Phase = "reading" | "planning" | "looking" | "judging";
