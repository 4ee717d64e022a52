// What runs the planner: a text and a machine become a plan, or what is wrong with them is told. One run at a time; what was
// recorded is not planned again as long as nothing of it is changed.

import { type PlannerClient, unlessCancelled } from "../engine/planner_client";
import type { Diagnostic, Gouge, Limits, LoopOptions, Plan, Slides, Task } from "../engine/motion_types";
import type { Judged } from "../engine/judging";
import { spacingOf } from "../engine/sampling";
import { askedOf, diagnosticsOf, gougesOf, planOf, traceOf, type Recording } from "../engine/recording";
import { asAsked, copied, fromLink, isAsBegun, plannedMachine, toLink, type Origin, type Settings } from "./settings";

const mostSamples = 1_000_000;
/** So many are soon made and drawn; all follow. */
const firstSamples = 16_384;
const typingPause = 250; // ms
const stepClock = 1_000_000; // Hz, as the command has it without --step-clock

/** Why there is no plan. */
export type End = "unsound" | "cancelled" | "failed";

export interface PlanningEvents {
  /** A run begins: of what was recorded, or of what is set now. */
  begun(isRecorded: boolean): void;
  diagnosed(diagnostics: readonly Diagnostic[]): void;
  /** Shows a plan, with all its samples or, before, with some of them; asks between two pieces of that whether it is still wanted. */
  planned(plan: Plan, hasAll: boolean, isCurrent: () => boolean): Promise<void>;
  /** Of a recording. */
  gouged(gouges: readonly Gouge[]): void;
  ended(why: End, said: string): void;
  /** Another machine is in force, as its file has it. */
  equipped(): void;
  /** A machine file is wrong. */
  refused(message: string): void;
}

function originOf(recording: Recording | undefined): Origin | undefined {
  return recording === undefined ? undefined : { ...recording, asked: askedOf(recording) };
}

export class Planning {
  private events: PlanningEvents | undefined;
  private listen: (events: PlanningEvents) => void = () => undefined;
  /** Nothing is told before somebody listens; the planner works meanwhile. */
  private readonly isHeard = new Promise<void>((resolve) => {
    this.listen = (events) => {
      this.events = events;
      resolve();
    };
  });
  private runs = 0;
  private typing = 0;

  /** With what the command has recorded, where it has. */
  static async open(planner: PlannerClient, recording?: Recording): Promise<Planning> {
    const [settings, machine] = await fromLink(location.hash, planner.limits, originOf(recording));
    return new Planning(planner, settings, machine, recording);
  }

  private constructor(
    private readonly planner: PlannerClient,
    public settings: Settings,
    /** The machine of the settings, as it is without changes. */
    public machine: Limits,
    readonly recording: Recording | undefined,
  ) {}

  /** Who hears of runs from now on, and of that which is under way. */
  tell(events: PlanningEvents): void {
    this.listen(events);
    events.begun(this.isRecorded);
  }

  /** Of the run that is in force. */
  get number(): number {
    return this.runs;
  }

  /** What is set, as the engine is asked for it. */
  private get task(): Task {
    const { text, limits, tools, override, changes, asked } = this.settings;
    return { text, machine: plannedMachine(this.settings), limits, tools, override: override / 100, changes, asked };
  }

  /** What is shown as it was recorded: nothing of it has been changed. */
  private get recorded(): Recording | undefined {
    const { recording, settings, machine } = this;
    const origin = originOf(recording);
    return origin !== undefined && isAsBegun(settings, machine, origin) ? recording : undefined;
  }

  get isRecorded(): boolean {
    return this.recorded !== undefined;
  }

  async link(): Promise<string> {
    return await toLink(this.settings, this.machine, originOf(this.recording));
  }

  /** Of a code, while the planner has nothing else to do. */
  async explain(code: string): Promise<string> {
    return this.planner.isBusy ? "" : ((await unlessCancelled(this.planner.explain(code))) ?? "");
  }

  /** Of the last plan. */
  async slides(options: LoopOptions): Promise<Slides | Diagnostic | undefined> {
    return await unlessCancelled(this.planner.slides(this.task, options));
  }

  async gouges(): Promise<readonly Gouge[] | Diagnostic | undefined> {
    return await unlessCancelled(this.planner.gouges(this.task));
  }

  /** How far the last plan is from its program. */
  async judged(): Promise<Judged | Diagnostic | undefined> {
    return await unlessCancelled(this.planner.judged(mostSamples));
  }

  /** Every word of the last plan, or of what was recorded. */
  async trace(): Promise<Blob | undefined> {
    if (this.planner.isBusy) return undefined;
    return this.recorded !== undefined ? traceOf(this.recorded) : await unlessCancelled(this.planner.trace());
  }

  /** Step and direction of what is shown; what is wrong where drives cannot have them. */
  async steps(): Promise<Blob | Diagnostic | undefined> {
    if (this.planner.isBusy) return undefined;
    if (this.recorded !== undefined) {
      const planned = await unlessCancelled(this.planner.plan(this.task, 2));
      if (planned === undefined || "code" in planned) return planned;
    }
    return await unlessCancelled(this.planner.steps(stepClock));
  }

  /** Plans soon: typing comes faster than plans are made. */
  typed(text: string): void {
    this.settings.text = text;
    clearTimeout(this.typing);
    this.typing = window.setTimeout(() => void this.run(), typingPause);
  }

  /** A machine file, or the built-in mill, as it is. False where the file is wrong, or something else is asked for meanwhile. */
  async takeMachine(file: string): Promise<boolean> {
    this.stop();
    this.events?.begun(false);
    const limits = await unlessCancelled(this.planner.limits(file));
    if (limits === undefined) return false;
    if ("code" in limits) {
      const place = limits.line > 0 ? `line ${limits.line}: ` : "";
      this.events?.refused(`${place}${limits.message}${limits.hint === "" ? "" : `: ${limits.hint}`}`);
      return false;
    }
    this.machine = asAsked(limits, this.settings.asked);
    this.settings.machine = file;
    this.settings.limits = copied(this.machine);
    this.events?.equipped();
    return true;
  }

  /** What the address says now; false where something else is asked for meanwhile. */
  async restore(): Promise<boolean> {
    clearTimeout(this.typing);
    this.planner.cancel();
    const restored = await unlessCancelled(fromLink(location.hash, this.planner.limits, originOf(this.recording)));
    if (restored === undefined) return false;
    [this.settings, this.machine] = restored;
    return true;
  }

  private stop(): number {
    clearTimeout(this.typing);
    this.planner.cancel();
    return ++this.runs;
  }

  cancel(): void {
    this.stop();
    this.events?.ended("cancelled", "Cancelled: change something, or open another program");
  }

  /** Checks what is set, and plans it. */
  async run(): Promise<void> {
    const run = this.stop();
    const { recorded } = this;
    this.events?.begun(recorded !== undefined);
    try {
      await (recorded === undefined ? this.plan(run) : this.showRecorded(recorded, run));
    } catch (failure) {
      await this.isHeard;
      if (run === this.runs) this.events?.ended("failed", `The engine failed: ${String(failure)}`);
    }
  }

  /** The planner goes on to plan while what it found is told, and is stopped where that is an error. */
  private async plan(run: number): Promise<void> {
    const { task } = this;
    const checking = unlessCancelled(this.planner.check(task));
    const planning = unlessCancelled(this.planner.plan(task, firstSamples));
    planning.catch(() => undefined); // a failure counts where the plan is waited for
    const checked = await checking;
    await this.isHeard;
    if (checked === undefined || run !== this.runs) return;
    this.events?.diagnosed(checked.diagnostics);
    if (!checked.isSound) {
      this.planner.cancel();
      return this.refuse();
    }
    const plan = await planning;
    if (plan === undefined || run !== this.runs) return;
    if ("code" in plan) {
      this.events?.diagnosed([...checked.diagnostics, plan]);
      return this.refuse();
    }
    const isCurrent = (): boolean => run === this.runs;
    const hasAll = spacingOf(plan.figures.words, firstSamples)[0] === spacingOf(plan.figures.words, mostSamples)[0];
    await this.events?.planned(plan, hasAll, isCurrent);
    if (hasAll || !isCurrent()) return;
    const sampled = await unlessCancelled(this.planner.sampled(mostSamples));
    if (sampled === undefined || "code" in sampled || !isCurrent()) return;
    await this.events?.planned({ ...plan, ...sampled }, true, isCurrent);
  }

  /** Nothing is planned: tools and surfaces alone are the engine's. */
  private async showRecorded(recording: Recording, run: number): Promise<void> {
    const equipment = await unlessCancelled(this.planner.equipment(this.task));
    await this.isHeard;
    if (equipment === undefined || run !== this.runs) return;
    this.events?.diagnosed(diagnosticsOf(recording.result));
    await this.events?.planned(planOf(recording, equipment), true, () => run === this.runs);
    const gouges = gougesOf(recording);
    if (gouges !== undefined && run === this.runs) this.events?.gouged(gouges);
  }

  private refuse(): void {
    this.events?.ended("unsound", "Nothing moves until what is marked is mended");
  }
}
