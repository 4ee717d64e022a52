// leadscrew.h in WebAssembly: memory, text and structures.

import * as layout from "./layout";
import type { Problem, Task } from "./types";

interface Exports {
  readonly memory: WebAssembly.Memory;
  _initialize(): void;
  malloc(size: number): number;
  free(at: number): void;
  leadscrew_pulse_name(list: number, number: number): number;
  leadscrew_pulse_uses(method: number): number;
  leadscrew_pulses_problem(task: number, number: number, problem: number): number;
  leadscrew_pulses_load(task: number, pulses: number, error: number): number;
  leadscrew_pulses_copy(pulses: number, copy: number, error: number): number;
  leadscrew_pulses_free(pulses: number): void;
  leadscrew_pulses_conventions(pulses: number, conventions: number, error: number): number;
  leadscrew_pulses_figures(pulses: number, figures: number, error: number): number;
  leadscrew_pulses_column(pulses: number, number: number): number;
  leadscrew_pulses_row(pulses: number, row: number, error: number): number;
  leadscrew_pulses_next(pulses: number, rows: number, capacity: number, count: number, error: number): number;
  leadscrew_pulses_why(pulses: number, text: number, length: number): number;
}

/** The C library asks for the system only where a program ends or prints, which the engine never does. */
function systemOf(module: WebAssembly.Module): WebAssembly.Imports {
  const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[name] = () => {
      throw new Error(`the engine called ${name}`);
    };
  }
  return imports;
}

export class EngineModule {
  private constructor(readonly calls: Exports) {}

  static async of(bytes: ArrayBuffer | Uint8Array): Promise<EngineModule> {
    const module = await WebAssembly.compile(bytes as BufferSource);
    const instance = await WebAssembly.instantiate(module, systemOf(module));
    const calls = instance.exports as unknown as Exports;
    calls._initialize();
    return new EngineModule(calls);
  }

  /** Memory may grow, and views of it end then. */
  get view(): DataView {
    return new DataView(this.calls.memory.buffer);
  }

  /** Zeroed; freed when `use` returns. */
  with<T>(size: number, use: (at: number) => T): T {
    const at = this.calls.malloc(size);
    new Uint8Array(this.calls.memory.buffer, at, size).fill(0);
    try {
      return use(at);
    } finally {
      this.calls.free(at);
    }
  }

  withText<T>(text: string, use: (at: number) => T): T {
    const bytes = new TextEncoder().encode(text);
    return this.with(bytes.length + 1, (at) => {
      new Uint8Array(this.calls.memory.buffer, at, bytes.length).set(bytes);
      return use(at);
    });
  }

  /** Up to its 0. */
  text(at: number): string {
    const bytes = new Uint8Array(this.calls.memory.buffer, at);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  names(list: number): string[] {
    const names: string[] = [];
    for (let at; (at = this.calls.leadscrew_pulse_name(list, names.length)) !== 0; ) names.push(this.text(at));
    return names;
  }

  integer(at: number): number {
    return Number(this.view.getBigInt64(at, true));
  }

  withError<T>(use: (at: number) => T): T {
    return this.with(layout.error.size, (at) => {
      this.view.setUint32(at, layout.error.size, true);
      return use(at);
    });
  }

  problem(at: number): Problem {
    return {
      code: this.text(at + layout.error.code),
      message: this.text(at + layout.error.message),
      hint: this.text(at + layout.error.hint),
      field: this.text(at + layout.error.field),
    };
  }

  /** A task as leadscrew.h has it. */
  withTask<T>(task: Task, use: (at: number) => T): T {
    return this.with(layout.task.size, (at) =>
      this.withText(task.method, (method) =>
        this.withText(task.preload, (preload) =>
          this.withText(task.order, (order) =>
            this.withText(task.tie, (tie) => {
              this.writeTask(at, task);
              const view = this.view;
              view.setUint32(at + layout.task.method, method, true);
              view.setUint32(at + layout.task.preload, preload, true);
              view.setUint32(at + layout.task.order, order, true);
              view.setUint32(at + layout.task.tie, tie, true);
              return use(at);
            }),
          ),
        ),
      ),
    );
  }

  private writeTask(at: number, task: Task): void {
    const view = this.view;
    view.setUint32(at, layout.task.size, true);
    view.setInt32(at + layout.task.kind, task.shape === "arc" ? layout.kind.arc : layout.kind.line, true);
    view.setInt32(at + layout.task.turns, task.clockwise ? -1 : 1, true);
    view.setInt32(at + layout.task.bits, task.bits, true);
    view.setBigInt64(at + layout.task.capacity, BigInt(task.capacity), true);
    for (const name of ["start", "end", "center"] as const) {
      task[name].forEach((each, i) => view.setBigInt64(at + layout.task[name] + 8 * i, BigInt(each), true));
    }
  }
}
