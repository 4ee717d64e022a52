// One recording and the clock that is looked at: steps, runs on time, stops where it was asked to.

import type { Figure, Recording } from "../engine/types";
import { figureColumns } from "../engine/types";

export interface Row {
  readonly clock: number;
  value(column: string): number;
  has(column: string): boolean;
}

export type State = "empty" | "waiting" | "running" | "stopped" | "breakpoint" | "done";

export interface Stops {
  readonly atPulse: boolean;
  readonly atBorder: boolean;
}

export class Session {
  recording: Recording | undefined;
  clock = 0;
  state: State = "empty";
  /** Time that cycles took until here, s: by the interval for each that ran or was stepped. */
  elapsed = 0;
  private columns = new Map<string, number>();

  constructor(private readonly onChange: () => void) {}

  load(recording: Recording, clock: number): void {
    this.recording = recording;
    this.columns = new Map(recording.columns.map((name, i) => [name, i]));
    this.elapsed = 0;
    this.clock = Math.min(clock, recording.clocks);
    this.state = this.clock === recording.clocks ? "done" : "stopped";
    this.onChange();
  }

  unload(): void {
    this.recording = undefined;
    this.state = "empty";
    this.clock = 0;
    this.onChange();
  }

  get last(): number {
    return this.recording?.clocks ?? 0;
  }

  /** 0 where there is no such column. */
  value(clock: number, column: string): number {
    const at = clock * this.columns.size + (this.columns.get(column) ?? NaN);
    return this.recording?.rows[at] ?? 0;
  }

  row(clock: number): Row {
    return { clock, value: (column) => this.value(clock, column), has: (column) => this.columns.has(column) };
  }

  figure(clock: number, figure: Figure): number {
    return this.recording?.figures[clock * figureColumns.length + figureColumns.indexOf(figure)] ?? 0;
  }

  /** One cycle on, or back. */
  step(by: 1 | -1): void {
    this.seek(this.clock + by);
  }

  seek(clock: number): void {
    if (this.recording === undefined) return;
    this.clock = Math.max(0, Math.min(clock, this.last));
    if (this.state !== "running" && this.state !== "waiting") this.rest();
    else if (this.clock === this.last) this.state = "done";
    this.onChange();
  }

  rest(): void {
    if (this.recording !== undefined) this.state = this.clock === this.last ? "done" : "stopped";
  }

  /** So many cycles on, each looked at: ends at a breakpoint or at the end. */
  advance(cycles: number, interval: number, stops: Stops): void {
    for (let i = 0; i < cycles && this.state === "running"; ++i) {
      if (this.clock === this.last) break;
      if (this.stopsBefore(this.clock, stops)) {
        this.state = "breakpoint";
        break;
      }
      ++this.clock;
      this.elapsed += interval;
      if (stops.atBorder && this.isBorder(this.clock)) this.state = "breakpoint";
    }
    if (this.clock === this.last) this.state = "done";
    this.onChange();
  }

  /** On from a breakpoint: the pulse that it stopped before is made. */
  passBreakpoint(interval: number): void {
    if (this.clock === this.last) return;
    ++this.clock;
    this.elapsed += interval;
  }

  isPulse(clock: number): boolean {
    return this.value(clock, "dx") !== 0 || this.value(clock, "dy") !== 0;
  }

  /** Does another quadrant begin here? */
  isBorder(clock: number): boolean {
    if (clock === 0 || !this.columns.has("quadrant")) return false;
    return this.value(clock, "quadrant") !== this.value(clock - 1, "quadrant");
  }

  /** The next clock of a kind, or the end. */
  next(is: (clock: number) => boolean): number {
    for (let clock = this.clock + 1; clock < this.last; ++clock) if (is(clock)) return clock;
    return this.last;
  }

  private stopsBefore(clock: number, stops: Stops): boolean {
    return stops.atPulse && clock < this.last && this.isPulse(clock + 1);
  }
}
