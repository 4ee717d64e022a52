// How far words are from their program: the referee reads it once more beside them.

import * as layout from "./layout";
import type { MotionModule } from "./motion_module";
import type { Diagnostic, Figures, Task } from "./motion_types";
import { spacingOf, timeOfWord } from "./sampling";
import { withStates } from "./states";

const leastTolerance = 1e-6; // mm; the referee takes no less for a departure
const wordsBetweenTellings = 4096;

/** How far samples are from the program, by the referee, who reads the words alone; a number a sample, mm: of all words since
 * the sample before, that which comes nearest to its tolerance. */
export interface Judged {
  readonly distance: Float32Array;
  readonly tolerance: Float32Array;
}

/** The same, and what is told of feed moves. */
export interface Deviations extends Judged {
  /** The greatest share of a tolerance. */
  readonly share: number;
  /** The sample of it. */
  readonly worst: number;
  /** mm, the least and the greatest tolerance. */
  readonly tolerances: readonly [number, number];
}

/** Of a tolerance. */
export function shareOf(distance: number, tolerance: number): number {
  return distance / Math.max(tolerance, leastTolerance);
}

export interface Judgeable {
  readonly module: MotionModule;
  readonly machine: number;
  readonly task: Task;
  readonly trajectory: number;
  readonly period: number;
  readonly figures: Figures;
}

/** Of all words, the farthest of each sample. */
export function judgedOf(of: Judgeable, most: number, progress: (share: number) => void): Judged | Diagnostic {
  const { module } = of;
  const referee = module.withProgram(of.task, (text, length, options) =>
    module.made((to, error) =>
      module.calls.leadscrew_referee_begin(of.machine, text, length, withoutProgress(module, options), to, error),
    ),
  );
  if (typeof referee !== "number") return referee;
  try {
    return judgedBy(referee, of, most, progress);
  } finally {
    module.calls.leadscrew_referee_free(referee);
  }
}

/** How far it is, words tell: the program is read in their time. Nor is anything said of it again. */
function withoutProgress(module: MotionModule, options: number): number {
  module.view.setUint32(options + layout.options.onProgress, 0, true);
  module.view.setUint32(options + layout.options.onDiagnostic, 0, true);
  return options;
}

function judgedBy(
  referee: number,
  of: Judgeable,
  most: number,
  progress: (share: number) => void,
): Judged | Diagnostic {
  const { module, trajectory, period, figures } = of;
  const [every, count] = spacingOf(figures.words, most);
  const [distance, tolerance] = [new Float32Array(count), new Float32Array(count)];
  const { state, word, judged } = layout;
  const judge = (at: number, to: number, told: number): Diagnostic | undefined => {
    new Uint8Array(module.calls.memory.buffer).copyWithin(
      to + word.position,
      at + state.position,
      at + state.position + 8 * layout.axes,
    );
    module.view.setFloat64(to + word.feed, module.number(at + state.feed), true);
    return module.failed((error) => module.calls.leadscrew_referee_observe(referee, to, layout.word.size, told, error));
  };
  const take = (sample: number, told: number): void => {
    const [far, allowed] = [module.number(told + judged.distance), module.number(told + judged.tolerance)];
    const isFirst = tick === 0 || tick % every === 1 || every === 1;
    if (!isFirst && shareOf(far, allowed) <= shareOf(distance[sample] ?? 0, tolerance[sample] ?? 0)) return;
    distance[sample] = far;
    tolerance[sample] = allowed;
  };
  let tick = 0;
  const timeOf = (word: number): number => timeOfWord(word, period);
  return withStates({ module, trajectory, count: figures.words + 1, timeOf }, (states) =>
    module.with(word.size, (to) =>
      module.withSized(judged.size, (told) => {
        for (; tick <= figures.words; ++tick) {
          if (tick % wordsBetweenTellings === 0) progress(tick / (figures.words + 1));
          const failure = judge(states.at(tick), to, told);
          if (failure !== undefined) return failure;
          take(Math.ceil(tick / every), told);
        }
        return { distance, tolerance };
      }),
    ),
  );
}
