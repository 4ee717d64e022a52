// The calls of leadscrew.h for programs.

import * as layout from "./layout";
import { pathModes, type Asked, type Diagnostic, type Figures, type Limits, type Task } from "./motion_types";
import { WasmModule, type CommonExports, type PageCalls } from "./wasm";

interface Exports extends CommonExports {
  leadscrew_machine_builtin(name: number, machine: number, error: number): number;
  leadscrew_machine_of_text(text: number, length: number, machine: number, error: number): number;
  leadscrew_machine_limits(machine: number, limits: number, error: number): number;
  leadscrew_machine_limited(machine: number, limits: number, limited: number, error: number): number;
  leadscrew_machine_period(machine: number): number;
  leadscrew_machine_free(machine: number): void;
  leadscrew_program_check(
    machine: number,
    text: number,
    length: number,
    options: number,
    checked: number,
    error: number,
  ): number;
  leadscrew_tools(options: number, onTool: number, user: number, error: number): number;
  leadscrew_program_surfaces(
    machine: number,
    text: number,
    length: number,
    options: number,
    sag: number,
    onSurface: number,
    user: number,
    error: number,
  ): number;
  leadscrew_program_gouges(
    machine: number,
    text: number,
    length: number,
    options: number,
    tolerance: number,
    onGouge: number,
    user: number,
    error: number,
  ): number;
  leadscrew_program_contours(
    machine: number,
    text: number,
    length: number,
    options: number,
    sag: number,
    onContour: number,
    user: number,
    error: number,
  ): number;
  leadscrew_program_modes(
    machine: number,
    text: number,
    length: number,
    options: number,
    onModes: number,
    user: number,
    error: number,
  ): number;
  leadscrew_explain(machine: number, block: number, text: number, length: number): number;
  leadscrew_motion_of_program(
    machine: number,
    text: number,
    length: number,
    options: number,
    motion: number,
    error: number,
  ): number;
  leadscrew_motion_override(motion: number, factor: number, error: number): number;
  leadscrew_motion_plan_changed(
    motion: number,
    times: number,
    factors: number,
    count: number,
    trajectory: number,
    error: number,
  ): number;
  leadscrew_motion_free(motion: number): void;
  leadscrew_motion_next(
    motion: number,
    words: number,
    wordSize: number,
    capacity: number,
    count: number,
    error: number,
  ): number;
  leadscrew_loops_begin(machine: number, options: number, loops: number, error: number): number;
  leadscrew_loops_follow(loops: number, word: number, wordSize: number, followed: number, error: number): number;
  leadscrew_loops_figures(loops: number, figures: number, error: number): number;
  leadscrew_circle_places(
    rule: number,
    angle: number,
    start: number,
    places: number,
    count: number,
    error: number,
  ): number;
  leadscrew_loops_free(loops: number): void;
  leadscrew_referee_begin(
    machine: number,
    text: number,
    length: number,
    options: number,
    referee: number,
    error: number,
  ): number;
  leadscrew_referee_observe(referee: number, word: number, wordSize: number, judged: number, error: number): number;
  leadscrew_referee_free(referee: number): void;
  leadscrew_trajectory_figures(trajectory: number, figures: number, error: number): number;
  leadscrew_trajectory_blocks(trajectory: number, onBlock: number, user: number, error: number): number;
  leadscrew_trajectory_sample(
    trajectory: number,
    times: number,
    count: number,
    states: number,
    stateSize: number,
    poses: number,
    poseSize: number,
    error: number,
  ): number;
  leadscrew_trajectory_hold(trajectory: number, state: number, feedAsked: number, hold: number, error: number): number;
  leadscrew_trajectory_steps(trajectory: number, clock: bigint, onText: number, user: number, error: number): number;
  leadscrew_trajectory_free(trajectory: number): void;
  leadscrew_page_on_diagnostic(): number;
  leadscrew_page_on_block(): number;
  leadscrew_page_on_modes(): number;
  leadscrew_page_on_tool(): number;
  leadscrew_page_on_surface(): number;
  leadscrew_page_on_gouge(): number;
  leadscrew_page_on_contour(): number;
  leadscrew_page_on_progress(): number;
  leadscrew_page_on_text(): number;
}

const ofAxes = ["least", "greatest", "velocity", "acceleration", "jerk"] as const;

export class MotionModule extends WasmModule<Exports> {
  static async of(module: WebAssembly.Module, page: PageCalls): Promise<MotionModule> {
    return new MotionModule(await this.started<Exports>(module, page));
  }

  diagnostic(at: number): Diagnostic {
    const of = layout.error;
    return {
      severity: this.view.getInt32(at + of.severity, true),
      line: this.integer(at + of.line),
      column: this.integer(at + of.column),
      ...this.problem(at),
    };
  }

  numbers(at: number, count = layout.axes): number[] {
    return [...new Float64Array(this.calls.memory.buffer, at, count)];
  }

  /** Doubles, one behind the other; 0 where there are none. */
  withNumbers<T>(numbers: readonly number[], use: (at: number) => T): T {
    if (numbers.length === 0) return use(0);
    return this.with(8 * numbers.length, (at) => {
      numbers.forEach((each, i) => this.view.setFloat64(at + 8 * i, each, true));
      return use(at);
    });
  }

  number(at: number): number {
    return this.view.getFloat64(at, true);
  }

  /** Zeroed but for its size, which it begins with. */
  withSized<T>(size: number, use: (at: number) => T): T {
    return this.with(size, (at) => {
      this.view.setUint32(at, size, true);
      return use(at);
    });
  }

  /** A handle that `make` puts at its first argument, or what is wrong. */
  made(make: (to: number, error: number) => number): number | Diagnostic {
    return this.with(4, (to) =>
      this.withError((error) =>
        make(to, error) === layout.code.ok ? this.view.getUint32(to, true) : this.diagnostic(error),
      ),
    );
  }

  /** What is wrong, where the call fails. */
  failed(call: (error: number) => number): Diagnostic | undefined {
    return this.withError((error) => (call(error) === layout.code.ok ? undefined : this.diagnostic(error)));
  }

  /** The text in UTF-8, and its length in bytes. */
  private withBytes<T>(text: string, use: (at: number, length: number) => T): T {
    const bytes = new TextEncoder().encode(text);
    return this.with(bytes.length + 1, (at) => {
      new Uint8Array(this.calls.memory.buffer, at, bytes.length).set(bytes);
      return use(at, bytes.length);
    });
  }

  /** With what is found and how far it is told to the page. */
  withOptions<T>(use: (at: number) => T): T {
    return this.withSized(layout.options.size, (at) => {
      this.view.setUint32(at + layout.options.onDiagnostic, this.calls.leadscrew_page_on_diagnostic(), true);
      this.view.setUint32(at + layout.options.onProgress, this.calls.leadscrew_page_on_progress(), true);
      return use(at);
    });
  }

  /** Of a machine file; the built-in mill of none. */
  machineOf(text: string): number | Diagnostic {
    if (text === "")
      return this.withText("mill3", (name) =>
        this.made((to, error) => this.calls.leadscrew_machine_builtin(name, to, error)),
      );
    return this.withBytes(text, (at, length) =>
      this.made((to, error) => this.calls.leadscrew_machine_of_text(at, length, to, error)),
    );
  }

  limitsOf(machine: number): Limits {
    const of = layout.limits;
    return this.withSized(of.size, (at) => {
      this.calls.leadscrew_machine_limits(machine, at, 0);
      const limits: Limits = {
        least: [],
        greatest: [],
        velocity: [],
        acceleration: [],
        jerk: [],
        tolerance: this.number(at + of.tolerance),
        chordError: this.number(at + of.chordError),
        axes: this.view.getInt32(at + of.axes, true),
        period: this.number(at + of.period),
      };
      for (const name of ofAxes) limits[name] = this.numbers(at + of[name]);
      return limits;
    });
  }

  limited(machine: number, limits: Limits): number | Diagnostic {
    const of = layout.limits;
    return this.withSized(of.size, (at) => {
      const view = this.view;
      for (const name of ofAxes) limits[name].forEach((each, i) => view.setFloat64(at + of[name] + 8 * i, each, true));
      view.setFloat64(at + of.tolerance, limits.tolerance, true);
      view.setFloat64(at + of.chordError, limits.chordError, true);
      view.setInt32(at + of.axes, limits.axes, true);
      view.setFloat64(at + of.period, limits.period, true);
      return this.made((to, error) => this.calls.leadscrew_machine_limited(machine, at, to, error));
    });
  }

  /** The text of a task, its length in bytes, and options. */
  withProgram<T>(task: Task, use: (text: number, length: number, options: number) => T): T {
    return this.withBytes(task.text, (text, length) =>
      this.withBytes(task.tools, (tools, toolsLength) =>
        this.withOptions((options) => {
          if (toolsLength > 0) {
            this.view.setUint32(options + layout.options.tools, tools, true);
            this.view.setUint32(options + layout.options.toolsLength, toolsLength, true);
          }
          if (task.asked !== undefined) this.writeAsked(options, task.asked);
          return use(text, length, options);
        }),
      ),
    );
  }

  /** All but the period, which is the machine's. */
  private writeAsked(options: number, { mode, tolerance, start }: Asked): void {
    const { view } = this;
    start.forEach((each, i) => view.setFloat64(options + layout.options.start + 8 * i, each, true));
    view.setInt32(options + layout.options.pathMode, pathModes.indexOf(mode), true);
    if (tolerance === undefined) return;
    view.setInt32(options + layout.options.hasTolerance, 1, true);
    view.setFloat64(options + layout.options.tolerance, tolerance, true);
  }

  figuresOf(trajectory: number): Figures {
    const of = layout.motionFigures;
    return this.withSized(of.size, (at) => {
      this.calls.leadscrew_trajectory_figures(trajectory, at, 0);
      return {
        time: this.number(at + of.time),
        bound: this.number(at + of.bound),
        dwell: this.number(at + of.dwell),
        length: this.number(at + of.length),
        feedProgrammed: this.number(at + of.feedProgrammed),
        tolerance: this.number(at + of.tolerance),
        velocity: this.numbers(at + of.velocity),
        acceleration: this.numbers(at + of.acceleration),
        jerk: this.numbers(at + of.jerk),
        words: this.integer(at + of.words),
        blocks: this.integer(at + of.blocks),
        moves: this.integer(at + of.moves),
      };
    });
  }
}
