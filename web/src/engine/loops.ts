// Simulated loops that follow words: where the slides of a machine are.

import * as layout from "./layout";
import type { MotionModule } from "./motion_module";
import { controllers, encoders, gainNames, type Diagnostic, type LoopOptions, type Slides } from "./motion_types";

const longestRest = 2; // s behind the last word, until slides are taken as they are
const quietTime = 0.05; // s that count as rest
const atRest = 1e-4; // mm or degrees

/** X, Y … of a word by its number: into nine numbers. */
export type WordAt = (word: number, position: Float64Array) => void;

/** A column of followed words that grows. */
class Column {
  private values = new Float64Array(4096);
  private length = 0;

  push(value: number): void {
    if (this.length === this.values.length) {
      const more = new Float64Array(2 * this.length);
      more.set(this.values);
      this.values = more;
    }
    this.values[this.length++] = value;
  }

  at(index: number): number {
    return this.values[index] ?? 0;
  }

  done(): Float64Array {
    return this.values.slice(0, this.length);
  }
}

function writeOptions(module: MotionModule, at: number, options: LoopOptions): void {
  const { view } = module;
  view.setInt32(at + layout.loopOptions.controller, controllers.indexOf(options.controller), true);
  view.setInt32(at + layout.loopOptions.encoder, encoders.indexOf(options.encoder), true);
  gainNames.forEach((name, i) =>
    view.setFloat64(at + layout.loopOptions.gains + 8 * i, options.gains[name] ?? 0, true),
  );
}

/** One machine's loops, from the first word until the slides stand. */
class Run {
  private readonly columns = {
    position: new Column(),
    velocity: new Column(),
    control: new Column(),
    current: new Column(),
  };
  private readonly positions = new Float64Array(layout.axes);
  private count = 0;

  constructor(
    private readonly module: MotionModule,
    private readonly loops: number,
    private readonly axes: readonly number[],
    private readonly wordAt: WordAt,
  ) {}

  all(words: number, period: number): Slides | Diagnostic {
    const { module } = this;
    return module.with(layout.word.size, (word) =>
      module.withSized(layout.followed.size, (followed) => {
        for (let tick = 0; tick < words; ++tick) {
          this.wordAt(tick, this.positions);
          const failure = this.follow(word, followed, tick);
          if (failure !== undefined) return failure;
        }
        const most = words + Math.ceil(longestRest / period);
        for (let tick = words; tick < most && !this.stands(words, Math.ceil(quietTime / period)); ++tick) {
          const failure = this.follow(word, followed, tick);
          if (failure !== undefined) return failure;
        }
        return this.done();
      }),
    );
  }

  private follow(word: number, followed: number, tick: number): Diagnostic | undefined {
    const { module, columns } = this;
    const of = layout.followed;
    module.view.setBigInt64(word + layout.word.tick, BigInt(tick), true);
    new Float64Array(module.calls.memory.buffer, word + layout.word.position, layout.axes).set(this.positions);
    const failure = module.failed((error) =>
      module.calls.leadscrew_loops_follow(this.loops, word, layout.word.size, followed, error),
    );
    if (failure !== undefined || module.integer(followed + of.tick) < 0) return failure;
    ++this.count;
    for (const axis of this.axes)
      for (const name of ["position", "velocity", "control", "current"] as const)
        columns[name].push(module.number(followed + of[name] + 8 * axis));
    return undefined;
  }

  /** Have all slides stood for so many periods behind the last word? */
  private stands(words: number, quiet: number): boolean {
    if (this.count < words + quiet) return false;
    const { position } = this.columns;
    const width = this.axes.length;
    return this.axes.every((_, i) => {
      const now = position.at((this.count - 1) * width + i);
      return Math.abs(now - position.at((this.count - 1 - quiet) * width + i)) < atRest;
    });
  }

  private done(): Slides {
    const { module, columns } = this;
    const of = layout.loopFigures;
    const figures = module.withSized(of.size, (at) => {
      module.calls.leadscrew_loops_figures(this.loops, at, 0);
      return {
        greatest: module.numbers(at + of.greatest),
        rms: module.numbers(at + of.rms),
        overshoot: module.numbers(at + of.overshoot),
        feedGreatest: module.number(at + of.feedGreatest),
        feedMean: module.number(at + of.feedMean),
        contour: module.number(at + of.contour),
        contourRms: module.number(at + of.contourRms),
      };
    });
    return {
      count: this.count,
      axes: this.axes,
      position: columns.position.done(),
      velocity: Float32Array.from(columns.velocity.done()),
      control: Float32Array.from(columns.control.done()),
      current: Float32Array.from(columns.current.done()),
      figures,
    };
  }
}

/** Of a machine with these axes, along so many words a period apart. */
export function slidesOf(
  module: MotionModule,
  machine: number,
  axes: readonly number[],
  options: LoopOptions,
  words: number,
  wordAt: WordAt,
): Slides | Diagnostic {
  const loops = module.withSized(layout.loopOptions.size, (at) => {
    writeOptions(module, at, options);
    return module.made((to, error) => module.calls.leadscrew_loops_begin(machine, at, to, error));
  });
  if (typeof loops !== "number") return loops;
  try {
    return new Run(module, loops, axes, wordAt).all(words, module.calls.leadscrew_machine_period(machine));
  } finally {
    module.calls.leadscrew_loops_free(loops);
  }
}
