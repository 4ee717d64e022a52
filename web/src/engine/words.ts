// Every word of a program, by a rule that steps along curves; and what loops make of them.

import * as layout from "./layout";
import { slidesOf } from "./loops";
import type { MotionModule } from "./motion_module";
import { circleRules, stepRules, type CircleTask, type Diagnostic, type Words, type WordTask } from "./motion_types";
import { axesOf } from "./sampling";

const wordsACall = 512;

/** Of a machine with the limits of the task. */
export function wordsOf(module: MotionModule, machine: number, task: WordTask): Words | Diagnostic {
  const began = performance.now();
  const made = madeWords(module, machine, task);
  if ("code" in made) return made;
  const { positions, steady } = made;
  const count = steady.length;
  const cost = ((performance.now() - began) * 1e6) / count;
  const period = module.calls.leadscrew_machine_period(machine);
  const slides =
    task.loops === undefined
      ? undefined
      : slidesOf(module, machine, axesOf(task.limits), task.loops, count, (word, to) =>
          to.set(positions.subarray(word * layout.axes, (word + 1) * layout.axes)),
        );
  if (slides !== undefined && "code" in slides) return slides;
  const position = new Float64Array(3 * count);
  for (let i = 0; i < count; ++i) position.set(positions.subarray(i * layout.axes, i * layout.axes + 3), 3 * i);
  return { period, count, position, steady, cost, slides };
}

/** Once around, as far as whole steps lead. */
export function circleWords(module: MotionModule, task: CircleTask): Words | Diagnostic {
  const { rule, radius, feed, period, most } = task;
  const angle = (feed * period) / radius;
  const count = Math.floor((2 * Math.PI) / angle) + 1;
  if (count > most) return tooManyWords(most);
  const began = performance.now();
  const position = new Float64Array(3 * count);
  module.with(16, (start) =>
    module.with(16 * count, (places) => {
      module.view.setFloat64(start, radius, true);
      module.calls.leadscrew_circle_places(circleRules.indexOf(rule), angle, start, places, count, 0);
      const { view } = module;
      for (let i = 0; i < count; ++i)
        for (let k = 0; k < 2; ++k) position[3 * i + k] = view.getFloat64(places + 16 * i + 8 * k, true);
    }),
  );
  const cost = ((performance.now() - began) * 1e6) / count;
  return { period, count, position, steady: new Uint8Array(count).fill(1), cost, slides: undefined };
}

interface Made {
  /** Nine numbers a word. */
  readonly positions: Float64Array;
  readonly steady: Uint8Array;
}

const constantSpeed = 2; // state of a word

function madeWords(module: MotionModule, machine: number, task: WordTask): Made | Diagnostic {
  const motion = module.withProgram(task, (text, length, options) => {
    module.view.setInt32(options + layout.options.stepRule, stepRules.indexOf(task.rule), true);
    return module.made((to, error) =>
      module.calls.leadscrew_motion_of_program(machine, text, length, options, to, error),
    );
  });
  if (typeof motion !== "number") return motion;
  try {
    return allWords(module, motion, task.most);
  } finally {
    module.calls.leadscrew_motion_free(motion);
  }
}

function allWords(module: MotionModule, motion: number, most: number): Made | Diagnostic {
  const steady: number[] = [];
  let words = new Float64Array(4096 * layout.axes);
  let count = 0;
  return module.with(wordsACall * layout.word.size, (at) =>
    module.with(4, (made) => {
      for (let some = 1; some > 0; ) {
        const failure = module.failed((error) =>
          module.calls.leadscrew_motion_next(motion, at, layout.word.size, wordsACall, made, error),
        );
        if (failure !== undefined) return failure;
        some = module.view.getUint32(made, true);
        if (count + some > most) return tooManyWords(most);
        if ((count + some) * layout.axes > words.length) {
          const more = new Float64Array(2 * words.length);
          more.set(words);
          words = more;
        }
        for (let i = 0; i < some; ++i, ++count) {
          const from = at + i * layout.word.size + layout.word.position;
          steady.push(module.view.getUint8(from - layout.word.position + layout.word.state) === constantSpeed ? 1 : 0);
          words.set(new Float64Array(module.calls.memory.buffer, from, layout.axes), count * layout.axes);
        }
      }
      return { positions: words.slice(0, count * layout.axes), steady: Uint8Array.from(steady) };
    }),
  );
}

function tooManyWords(most: number): Diagnostic {
  return {
    severity: 2,
    line: 0,
    column: 0,
    code: "many-words",
    message: `more than ${most} words`,
    hint: "a shorter curve, a higher feed or a longer period",
    field: "period",
  };
}
