// States of a trajectory at times that rise, asked for many at once: one call of the engine for hundreds of them.

import * as layout from "./layout";
import type { MotionModule } from "./motion_module";

const together = 512;

/** Where in the engine's memory a state lies, until another is asked for. */
export class States {
  private first = 0;
  private end = 0;

  constructor(
    private readonly of: StatesAsked,
    private readonly times: number,
    private readonly states: number,
    private readonly poses: number,
  ) {}

  at(index: number): number {
    if (index < this.first || index >= this.end) this.take(index);
    return this.states + layout.state.size * (index - this.first);
  }

  /** Of the same time as the state that was asked for last. */
  poseAt(index: number): number {
    return this.poses + layout.pose.size * (index - this.first);
  }

  private take(first: number): void {
    const { module, trajectory, count, timeOf } = this.of;
    const some = Math.min(together, count - first);
    const times = new Float64Array(module.calls.memory.buffer, this.times, some);
    for (let i = 0; i < some; ++i) times[i] = timeOf(first + i);
    const { state, pose } = layout;
    const { times: at, states, poses } = this;
    module.calls.leadscrew_trajectory_sample(trajectory, at, some, states, state.size, poses, pose.size, 0);
    [this.first, this.end] = [first, first + some];
  }
}

export interface StatesAsked {
  readonly module: MotionModule;
  readonly trajectory: number;
  readonly count: number;
  /** s, of 0 … count − 1; rising. */
  readonly timeOf: (index: number) => number;
  readonly hasPoses?: boolean;
}

export function withStates<T>(of: StatesAsked, use: (states: States) => T): T {
  const { module, hasPoses = false } = of;
  return module.with(8 * together, (times) =>
    module.with(layout.state.size * together, (states) =>
      hasPoses
        ? module.with(layout.pose.size * together, (poses) => use(new States(of, times, states, poses)))
        : use(new States(of, times, states, 0)),
    ),
  );
}
