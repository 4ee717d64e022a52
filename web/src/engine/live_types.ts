// What `leadscrew drive --serve` tells: docs/formats.md, live.

export interface LiveAxis {
  readonly name: string;
  readonly rotary: boolean;
  readonly travel: readonly [number, number];
  readonly velocity: number;
  readonly acceleration: number;
  readonly jerk: number;
}

export interface LiveMachine {
  readonly program: string;
  readonly has_text: boolean;
  readonly may_control: boolean;
  readonly machine: string;
  readonly kinematics: string;
  readonly period_s: number;
  readonly tolerance_mm: number;
  readonly chord_error_mm: number;
  readonly axes: readonly LiveAxis[];
}

export type LiveState =
  | "starting"
  | "moving"
  | "resting"
  | "held"
  | "hold_waits"
  | "hold_refused"
  | "paused"
  | "waiting"
  | "stopping";

export interface LiveSample {
  readonly t: number;
  readonly line: number;
  readonly length_mm: number;
  readonly position: readonly number[];
  readonly actual: readonly number[];
  /** mm/s, as the next. */
  readonly feed: number;
  readonly measured_feed: number;
  readonly following_error: number;
  readonly state: LiveState;
  readonly override: number;
  readonly pause_line: number | null;
  readonly tip?: readonly number[];
  readonly direction?: readonly number[];
}

/** What whoever has the token asks for. */
export interface Wish {
  readonly hold?: boolean;
  readonly override?: number;
  readonly go_on?: true;
  readonly stop?: true;
}
