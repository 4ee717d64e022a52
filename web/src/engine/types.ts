// What the page asks the engine for, and what it is told.

export type Point = readonly [number, number];

/** One line or arc, of a circle or an ellipse, for one method; BLU. */
export interface Task {
  readonly shape: "line" | "arc";
  readonly start: Point;
  readonly end: Point;
  readonly center: Point;
  readonly clockwise: boolean;
  /** Of an arc of an ellipse, along X and Y. */
  readonly semiAxes?: Point;
  /** Of an arc of a circle by integrators: no counters, as many clocks as the angle takes. */
  readonly isFree?: boolean;
  /** Of an arc of a circle by integrators with counters: binary places of the radius in the capacity; 0: none. */
  readonly places: number;
  /** Of one that runs freely. Empty: the method's own. */
  readonly accumulation: string;
  /** Of the registers; 0: as the method has them by default. */
  readonly bits: number;
  /** Of integrators; 0: by the curve, or 2 to the bits. */
  readonly capacity: number;
  readonly method: string;
  /** Empty: the method's own. */
  readonly preload: string;
  readonly order: string;
  readonly tie: string;
}

/** What is wrong, and with which field. */
export interface Problem {
  readonly code: string;
  readonly message: string;
  readonly hint: string;
  readonly field: string;
}

export interface Method {
  readonly name: string;
  readonly hasPreload: boolean;
  readonly hasOrder: boolean;
  readonly hasTie: boolean;
  readonly hasCapacity: boolean;
  readonly hasEllipses: boolean;
  readonly hasFree: boolean;
  readonly hasAccumulation: boolean;
  readonly hasPlaces: boolean;
}

export interface Catalogue {
  readonly methods: readonly Method[];
  readonly preloads: readonly string[];
  readonly orders: readonly string[];
  readonly ties: readonly string[];
  readonly accumulations: readonly string[];
}

/** What is in force; 0 or empty where the method has no such choice. */
export interface Conventions {
  readonly bits: number;
  readonly capacity: number;
  readonly clocksPerBlu: number;
  readonly preload: string;
  readonly order: string;
  readonly tie: string;
  readonly end: string;
  /** Of an ellipse: what integrands and capacity are taken times in the registers. */
  readonly scale: number;
  /** Of the radius in the capacity; 0: none. */
  readonly places: number;
  readonly accumulation: string;
}

/** Columns of Recording.figures. */
export const figureColumns = ["pulses", "error", "maxError", "rmsError", "worstX", "worstY", "worstClock"] as const;
export type Figure = (typeof figureColumns)[number];

/** Every register at every clock, from the first to the end. */
export interface Recording {
  readonly columns: readonly string[];
  readonly conventions: Conventions;
  /** Clocks to the end; there is a row more, the registers as loaded. */
  readonly clocks: number;
  /** Row after row, a number a column. */
  readonly rows: Float64Array;
  /** Row after row, a number a figure: of the clocks until then. */
  readonly figures: Float64Array;
}

/** The engine, here or in a worker. One recording at a time. */
export interface Engine {
  catalogue(): Promise<Catalogue>;
  problems(task: Task): Promise<Problem[]>;
  /** Of a task without problems; more clocks than `most` are one. */
  load(task: Task, most: number): Promise<Recording | Problem>;
  /** Why the clock of what was loaded last gave what it did. */
  why(clock: number): Promise<string>;
}

export type EngineMethod = keyof Engine;
