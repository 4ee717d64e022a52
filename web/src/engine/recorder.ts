// The engine of the page: records every clock of a task, and replays any of them from snapshots to say why it was so.

import * as layout from "./layout";
import type { EngineModule } from "./module";
import {
  figureColumns,
  type Catalogue,
  type Conventions,
  type Engine,
  type Problem,
  type Recording,
  type Task,
} from "./types";

const clocksBetweenSnapshots = 256;

export class Recorder implements Engine {
  /** One every so many clocks, from clock 0. */
  private snapshots: number[] = [];

  constructor(private readonly module: EngineModule) {}

  async catalogue(): Promise<Catalogue> {
    const { module } = this;
    const has = (uses: number, option: number): boolean => (uses & (1 << option)) !== 0;
    const methods = module.names(layout.list.methods).map((name) => {
      const uses = module.withText(name, (at) => module.calls.leadscrew_pulse_uses(at));
      return {
        name,
        hasPreload: has(uses, layout.list.preloads),
        hasOrder: has(uses, layout.list.orders),
        hasTie: has(uses, layout.list.ties),
        hasCapacity: has(uses, layout.list.capacity),
        hasEllipses: has(uses, layout.list.ellipses),
        hasFree: has(uses, layout.list.free),
        hasAccumulation: has(uses, layout.list.accumulations),
        hasPlaces: has(uses, layout.list.places),
      };
    });
    return {
      methods,
      preloads: module.names(layout.list.preloads),
      orders: module.names(layout.list.orders),
      ties: module.names(layout.list.ties),
      accumulations: module.names(layout.list.accumulations),
    };
  }

  async problems(task: Task): Promise<Problem[]> {
    const { module } = this;
    const found: Problem[] = [];
    module.withTask(task, (at) =>
      module.withError((error) => {
        while (module.calls.leadscrew_pulses_problem(at, found.length, error) !== layout.code.ok) {
          found.push(module.problem(error));
          if (found[found.length - 1]?.code === "misuse") break;
        }
      }),
    );
    return found;
  }

  async load(task: Task, most: number): Promise<Recording | Problem> {
    for (const each of this.snapshots) this.module.calls.leadscrew_pulses_free(each);
    this.snapshots = [];
    const pulses = this.made((to, error) =>
      this.module.withTask(task, (at) => this.module.calls.leadscrew_pulses_load(at, to, error)),
    );
    if (typeof pulses !== "number") return pulses;
    try {
      return this.record(pulses, most);
    } finally {
      this.module.calls.leadscrew_pulses_free(pulses);
    }
  }

  async why(clock: number): Promise<string> {
    const { module } = this;
    const nearest = this.snapshots[Math.floor(clock / clocksBetweenSnapshots)];
    if (nearest === undefined) return "";
    const pulses = this.copyOf(nearest);
    const text = module.with(512, (at) => {
      module.calls.leadscrew_pulses_next(pulses, 0, clock % clocksBetweenSnapshots, at, 0);
      module.calls.leadscrew_pulses_why(pulses, at, 512);
      return module.text(at);
    });
    module.calls.leadscrew_pulses_free(pulses);
    return text;
  }

  /** A handle that `make` puts at its first argument, or why there is none. */
  private made(make: (to: number, error: number) => number): number | Problem {
    const { module } = this;
    return module.with(4, (to) =>
      module.withError((error) =>
        make(to, error) === layout.code.ok ? module.view.getUint32(to, true) : module.problem(error),
      ),
    );
  }

  private copyOf(pulses: number): number {
    const copy = this.made((to, error) => this.module.calls.leadscrew_pulses_copy(pulses, to, error));
    if (typeof copy !== "number") throw new Error(copy.message);
    return copy;
  }

  private record(pulses: number, most: number): Recording | Problem {
    const { module } = this;
    const columns = this.columnsOf(pulses);
    const rows: number[] = [];
    const figures: number[] = [];
    return module.with(columns.length * 8, (row) =>
      module.with(layout.figures.size, (now) =>
        module.with(8, (count) => {
          module.view.setUint32(now, layout.figures.size, true);
          for (let clock = 0; ; ++clock) {
            if (clock % clocksBetweenSnapshots === 0) this.snapshots.push(this.copyOf(pulses));
            module.calls.leadscrew_pulses_row(pulses, row, 0);
            module.calls.leadscrew_pulses_figures(pulses, now, 0);
            this.takeRow(row, columns.length, rows);
            this.takeFigures(now, figures);
            if (module.view.getInt32(now + layout.figures.isDone, true) !== 0) {
              return {
                columns,
                conventions: this.conventionsOf(pulses),
                clocks: clock,
                rows: Float64Array.from(rows),
                figures: Float64Array.from(figures),
              };
            }
            if (clock >= most) return tooLong(most);
            module.calls.leadscrew_pulses_next(pulses, 0, 1, count, 0);
          }
        }),
      ),
    );
  }

  private columnsOf(pulses: number): string[] {
    const columns: string[] = [];
    for (let at; (at = this.module.calls.leadscrew_pulses_column(pulses, columns.length)) !== 0; )
      columns.push(this.module.text(at));
    return columns;
  }

  private takeRow(at: number, count: number, rows: number[]): void {
    const view = this.module.view;
    for (let i = 0; i < count; ++i)
      rows.push(view.getUint32(at + 8 * i, true) + view.getInt32(at + 8 * i + 4, true) * 2 ** 32);
  }

  private takeFigures(at: number, figures: number[]): void {
    const view = this.module.view;
    const of = layout.figures;
    const found: Record<(typeof figureColumns)[number], number> = {
      pulses: this.module.integer(at + of.pulses),
      error: view.getFloat64(at + of.error, true),
      maxError: view.getFloat64(at + of.maxError, true),
      rmsError: view.getFloat64(at + of.rmsError, true),
      worstX: this.module.integer(at + of.worst),
      worstY: this.module.integer(at + of.worst + 8),
      worstClock: this.module.integer(at + of.worstClock),
    };
    for (const name of figureColumns) figures.push(found[name]);
  }

  private conventionsOf(pulses: number): Conventions {
    const { module } = this;
    const of = layout.conventions;
    return module.with(of.size, (at) => {
      module.view.setUint32(at, of.size, true);
      module.calls.leadscrew_pulses_conventions(pulses, at, 0);
      return {
        bits: module.view.getInt32(at + of.bits, true),
        capacity: module.integer(at + of.capacity),
        clocksPerBlu: module.view.getFloat64(at + of.clocksPerBlu, true),
        preload: module.text(at + of.preload),
        order: module.text(at + of.order),
        tie: module.text(at + of.tie),
        end: module.text(at + of.end),
        scale: module.integer(at + of.scale),
        places: module.view.getInt32(at + of.places, true),
        accumulation: module.text(at + of.accumulation),
      };
    });
  }
}

function tooLong(most: number): Problem {
  return {
    code: "too-many-clocks",
    message: `it takes more than ${most.toLocaleString("en")} clocks, which is as far as this page walks`,
    hint: "a shorter curve or fewer bits; the command has no such limit",
    field: "end",
  };
}
