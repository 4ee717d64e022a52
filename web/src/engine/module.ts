// The calls of leadscrew.h for reference pulses.

import * as layout from "./layout";
import type { Task } from "./types";
import { WasmModule, type CommonExports } from "./wasm";

interface Exports extends CommonExports {
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

export class EngineModule extends WasmModule<Exports> {
  static async of(bytes: ArrayBuffer | Uint8Array): Promise<EngineModule> {
    return new EngineModule(await this.started<Exports>(await WebAssembly.compile(bytes as BufferSource)));
  }

  names(list: number): string[] {
    const names: string[] = [];
    for (let at; (at = this.calls.leadscrew_pulse_name(list, names.length)) !== 0; ) names.push(this.text(at));
    return names;
  }

  /** A task as leadscrew.h has it. */
  withTask<T>(task: Task, use: (at: number) => T): T {
    return this.with(layout.task.size, (at) =>
      this.withText(task.method, (method) =>
        this.withText(task.preload, (preload) =>
          this.withText(task.order, (order) =>
            this.withText(task.tie, (tie) =>
              this.withText(task.accumulation, (accumulation) => {
                this.writeTask(at, task);
                const view = this.view;
                view.setUint32(at + layout.task.method, method, true);
                view.setUint32(at + layout.task.preload, preload, true);
                view.setUint32(at + layout.task.order, order, true);
                view.setUint32(at + layout.task.tie, tie, true);
                view.setUint32(at + layout.task.accumulation, accumulation, true);
                return use(at);
              }),
            ),
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
    (task.semiAxes ?? []).forEach((each, i) => view.setBigInt64(at + layout.task.semiAxes + 8 * i, BigInt(each), true));
    view.setInt32(at + layout.task.isFree, task.isFree === true ? 1 : 0, true);
    view.setInt32(at + layout.task.places, task.places, true);
  }
}
