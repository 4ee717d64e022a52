// The planner of a page: checks programs and plans their motion, one at a time.

import * as layout from "./layout";
import { MotionModule } from "./motion_module";
import type {
  Checked,
  CircleTask,
  Diagnostic,
  Equipment,
  Figures,
  Gouge,
  Limits,
  LoopOptions,
  Phase,
  Plan,
  PlannerCalls,
  Sampling,
  Slides,
  SurfaceMesh,
  Task,
  ToolShape,
  Words,
  WordTask,
} from "./motion_types";
import { lostOf, pathOf, polesOf, rangesOf } from "./path";
import { gougeAt, surfaceAt, takeContour, toolAt } from "./surfaces";
import { ModesList } from "./modes";
import { slidesOf } from "./loops";
import { judgedOf, type Judged } from "./judging";
import { withStates } from "./states";
import { axesOf, BlockList, factorsOf, samplesOf, timeOfWord, traceOf } from "./sampling";
import { circleWords, wordsOf } from "./words";

const mostLosses = 50; // told one by one
const shownSag = 0.02; // mm, of surfaces and contours that are only looked at
const leastTolerance = 1e-3; // mm, of gouges

const nothingPlanned: Diagnostic = {
  severity: 2,
  line: 0,
  column: 0,
  code: "nothing-planned",
  message: "there is no motion yet",
  hint: "plan a sound program first",
  field: "",
};

export type Told = (phase: Phase, share: number) => void;

interface Planned {
  readonly task: Task;
  readonly trajectory: number;
  readonly figures: Figures;
  readonly limits: Limits;
  readonly period: number;
}

export class Planner implements PlannerCalls {
  private found: Diagnostic[] = [];
  private blocks = new BlockList();
  private modes = new ModesList();
  private tools: ToolShape[] = [];
  private surfaces: SurfaceMesh[] = [];
  private contour: number[] = [];
  private gouged: Gouge[] = [];
  private written: Uint8Array<ArrayBuffer>[] = [];
  private phase: Phase = "reading";
  private module!: MotionModule;
  private mill = 0;
  private planned: Planned | undefined;

  private constructor(private readonly told: Told) {}

  static async of(compiled: WebAssembly.Module, told: Told): Promise<Planner> {
    const planner = new Planner(told);
    const module = await MotionModule.of(compiled, {
      diagnostic: (at) => void planner.found.push(module.diagnostic(at)),
      block: (at) => planner.blocks.take(module, at),
      modes: (at) => planner.modes.take(module, at),
      tool: (at) => void planner.tools.push(toolAt(module, at)),
      surface: (at) => void planner.surfaces.push(surfaceAt(module, at)),
      contour: (at) => takeContour(module, at, planner.contour),
      gouge: (at) => void planner.gouged.push(gougeAt(module, at)),
      text: (at, length) => {
        planner.written.push(new Uint8Array(module.calls.memory.buffer, at, length).slice());
        return 0;
      },
      progress: (share) => (told(planner.phase, share), 0),
    });
    planner.module = module;
    const mill = module.machineOf("");
    if (typeof mill !== "number") throw new Error(mill.message);
    planner.mill = mill;
    return planner;
  }

  async limits(text: string): Promise<Limits | Diagnostic> {
    const { module } = this;
    const machine = module.machineOf(text);
    if (typeof machine !== "number") return machine;
    const limits = module.limitsOf(machine);
    module.calls.leadscrew_machine_free(machine);
    return limits;
  }

  async explain(block: string): Promise<string> {
    const { module } = this;
    const room = 16_384;
    return module.withText(block, (at) =>
      module.with(room, (text) =>
        module.calls.leadscrew_explain(this.mill, at, text, room) > 0 ? module.text(text) : "",
      ),
    );
  }

  async check(task: Task): Promise<Checked> {
    const { module } = this;
    this.begin("reading");
    const machine = this.machineOf(task);
    if (typeof machine !== "number") return { diagnostics: [machine], blocks: 0, moves: 0, isSound: false };
    const of = layout.checked;
    const checked = module.withProgram(task, (text, length, options) =>
      module.withSized(of.size, (at) => {
        const code = module.calls.leadscrew_program_check(machine, text, length, options, at, 0);
        const [blocks, moves] = [module.integer(at + of.blocks), module.integer(at + of.moves)];
        return { diagnostics: this.found, blocks, moves, isSound: code === layout.code.ok };
      }),
    );
    module.calls.leadscrew_machine_free(machine);
    return checked;
  }

  async plan(task: Task, most: number): Promise<Plan | Diagnostic> {
    const { module } = this;
    if (this.planned !== undefined) module.calls.leadscrew_trajectory_free(this.planned.trajectory);
    this.planned = undefined;
    const machine = this.machineOf(task);
    if (typeof machine !== "number") return machine;
    try {
      const trajectory = this.trajectoryOf(machine, task);
      if (typeof trajectory !== "number") return trajectory;
      this.takeEquipment(machine, task);
      return this.planOf(trajectory, task, module.calls.leadscrew_machine_period(machine), most);
    } finally {
      module.calls.leadscrew_machine_free(machine);
    }
  }

  /** Nobody waits for it: how far it is is not told. */
  async sampled(most: number): Promise<Sampling | Diagnostic> {
    const { planned } = this;
    return planned === undefined ? nothingPlanned : this.samplingOf(planned, most, () => undefined);
  }

  async equipment(task: Task): Promise<Equipment> {
    this.begin("reading");
    const machine = this.machineOf(task);
    if (typeof machine !== "number")
      return { tools: [], surfaces: [], contour: new Float32Array(), modes: new ModesList().done() };
    this.takeEquipment(machine, task);
    this.module.calls.leadscrew_machine_free(machine);
    return this.taken;
  }

  async gouges(task: Task): Promise<readonly Gouge[] | Diagnostic> {
    const { module } = this;
    this.begin("reading");
    this.gouged = [];
    const machine = this.machineOf(task);
    if (typeof machine !== "number") return machine;
    const failure = module.withProgram(task, (text, length, options) =>
      module.failed((error) =>
        module.calls.leadscrew_program_gouges(
          machine,
          text,
          length,
          options,
          Math.max(task.limits.tolerance, leastTolerance),
          module.calls.leadscrew_page_on_gouge(),
          0,
          error,
        ),
      ),
    );
    module.calls.leadscrew_machine_free(machine);
    return failure ?? this.gouged;
  }

  async words(task: WordTask): Promise<Words | Diagnostic> {
    this.begin("planning");
    const machine = this.machineOf(task);
    if (typeof machine !== "number") return machine;
    try {
      return wordsOf(this.module, machine, task);
    } finally {
      this.module.calls.leadscrew_machine_free(machine);
    }
  }

  async circle(task: CircleTask): Promise<Words | Diagnostic> {
    return circleWords(this.module, task);
  }

  async slides(task: Task, loops: LoopOptions): Promise<Slides | Diagnostic> {
    const { module, planned } = this;
    if (planned === undefined) return nothingPlanned;
    this.begin("looking");
    const machine = this.machineOf(task);
    if (typeof machine !== "number") return machine;
    const { trajectory, period, figures } = planned;
    try {
      const count = figures.words + 1;
      const timeOf = (word: number): number => timeOfWord(word, period);
      return withStates({ module, trajectory, count, timeOf }, (states) =>
        slidesOf(module, machine, axesOf(task.limits), loops, count, (word, to) => {
          if (word % 4096 === 0) this.told("looking", word / count);
          const at = states.at(word) + layout.state.position;
          to.set(new Float64Array(module.calls.memory.buffer, at, layout.axes));
        }),
      );
    } finally {
      module.calls.leadscrew_machine_free(machine);
    }
  }

  async judged(most: number): Promise<Judged | Diagnostic> {
    const { module, planned } = this;
    if (planned === undefined) return nothingPlanned;
    const machine = this.machineOf(planned.task);
    if (typeof machine !== "number") return machine;
    this.begin("judging");
    try {
      return judgedOf({ ...planned, module, machine }, most, (share) => this.told("judging", share));
    } finally {
      module.calls.leadscrew_machine_free(machine);
    }
  }

  async trace(): Promise<Blob> {
    if (this.planned === undefined) return new Blob([]);
    return traceOf({ module: this.module, ...this.planned });
  }

  async steps(clock: number): Promise<Blob | Diagnostic> {
    const { module, planned } = this;
    if (planned === undefined) return nothingPlanned;
    this.written = [];
    const failure = module.failed((error) =>
      module.calls.leadscrew_trajectory_steps(
        planned.trajectory,
        BigInt(clock),
        module.calls.leadscrew_page_on_text(),
        0,
        error,
      ),
    );
    const dump = new Blob(this.written, { type: "text/plain" });
    this.written = [];
    return failure ?? dump;
  }

  /** The machine of its file, with the limits of the task. */
  private machineOf(task: Task): number | Diagnostic {
    const { module } = this;
    const machine = module.machineOf(task.machine);
    if (typeof machine !== "number") return machine;
    const limited = module.limited(machine, task.limits);
    module.calls.leadscrew_machine_free(machine);
    return limited;
  }

  private begin(phase: Phase): void {
    this.found = [];
    this.blocks = new BlockList();
    this.phase = phase;
    this.told(phase, 0);
  }

  private get taken(): Equipment {
    return {
      tools: this.tools,
      surfaces: this.surfaces,
      contour: Float32Array.from(this.contour),
      modes: this.modes.done(),
    };
  }

  /** Tools of the table, surfaces that are machined, contours, and modes. */
  private takeEquipment(machine: number, task: Task): void {
    const { module } = this;
    [this.tools, this.surfaces, this.contour] = [[], [], []];
    this.modes = new ModesList();
    module.withProgram(task, (text, length, options) => {
      module.calls.leadscrew_tools(options, module.calls.leadscrew_page_on_tool(), 0, 0);
      module.calls.leadscrew_program_modes(
        machine,
        text,
        length,
        options,
        module.calls.leadscrew_page_on_modes(),
        0,
        0,
      );
      const onSurface = module.calls.leadscrew_page_on_surface();
      const onContour = module.calls.leadscrew_page_on_contour();
      if (/G0*6\.5/i.test(task.text))
        module.calls.leadscrew_program_surfaces(machine, text, length, options, shownSag, onSurface, 0, 0);
      if (/G\s*(0*4\s*[12]|[#[])/i.test(task.text))
        module.calls.leadscrew_program_contours(machine, text, length, options, shownSag, onContour, 0, 0);
    });
  }

  private trajectoryOf(machine: number, task: Task): number | Diagnostic {
    const { module } = this;
    this.begin("reading");
    const motion = module.withProgram(task, (text, length, options) =>
      module.made((to, error) => module.calls.leadscrew_motion_of_program(machine, text, length, options, to, error)),
    );
    if (typeof motion !== "number") return motion;
    this.phase = "planning";
    module.calls.leadscrew_motion_override(motion, task.override, 0);
    const { changes } = task;
    const trajectory = module.withNumbers(
      changes.map(({ time }) => time),
      (times) =>
        module.withNumbers(
          changes.map(({ factor }) => factor),
          (factors) =>
            module.made((to, error) =>
              module.calls.leadscrew_motion_plan_changed(motion, times, factors, changes.length, to, error),
            ),
        ),
    );
    module.calls.leadscrew_motion_free(motion);
    return trajectory;
  }

  private planOf(trajectory: number, task: Task, period: number, most: number): Plan {
    const { module } = this;
    this.begin("looking");
    const figures = module.figuresOf(trajectory);
    const limits = task.limits;
    const planned = { task, trajectory, figures, limits, period };
    this.planned = planned;
    const sampling = this.samplingOf(planned, most, (share) => this.told("looking", share));
    return {
      period,
      figures,
      ...sampling,
      lost: lostOf(sampling.blocks, mostLosses),
      ...this.taken,
      deviations: undefined,
    };
  }

  private samplingOf(planned: Planned, most: number, told: (share: number) => void): Sampling {
    const { module } = this;
    this.blocks = new BlockList();
    module.calls.leadscrew_trajectory_blocks(planned.trajectory, module.calls.leadscrew_page_on_block(), 0, 0);
    const blocks = this.blocks.done();
    const samples = samplesOf({ ...planned, module, blocks, factorAt: factorsOf(planned.task) }, most, told);
    const path = pathOf(samples, blocks);
    return {
      blocks,
      samples,
      path,
      drawn: structuredClone(path),
      ranges: rangesOf(samples, blocks),
      poles: polesOf(samples),
    };
  }
}
