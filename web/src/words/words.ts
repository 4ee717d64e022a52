// Words beside one another: each lane is what the engine makes of the curve.

import { LanePage } from "../compare/lane_page";
import { type PlannerClient, unlessCancelled } from "../engine/planner_client";
import type { Diagnostic, Limits, Words, WordTask } from "../engine/motion_types";
import type { Engine } from "../engine/types";
import { download } from "../lesson/files";
import { quantity, type FieldErrors } from "../lesson/settings";
import type { Mode } from "../ui/shell";
import { curveOf, type Curve } from "./curves";
import { circleCommandOf, commandOf, scriptOf, type LaneCommand } from "./files";
import { loopTitles, methodTitles, WordForms } from "./forms";
import { fromLink, toLink } from "./link";
import { trackOf } from "./measure";
import { pulseCommandOf, pulseTaskOf, pulseWords } from "./pulses";
import { TrackScene, type DrawnTrack } from "./pictures";
import {
  circleTaskOf,
  comparisonOf,
  curveIn,
  isCircleRule,
  isPulseMethod,
  laneNumbers,
  number,
  stateOf,
  taskOf,
  type Lane,
  type PulseMethod,
  type State,
} from "./state";
import { wordTable } from "./table";

const mostWords = 20_000;
const typingPause = 120; // ms
const nearest = 1e-3; // mm across

interface Made extends DrawnTrack, LaneCommand {
  readonly cost: number;
  readonly pulses: Float64Array | undefined;
}

/** What the engine makes of a lane. */
interface Worked extends Pick<Made, "command" | "task"> {
  readonly words: Words;
  readonly pulses?: Float64Array;
  /** Beside its period. */
  readonly detail?: string;
}

const strips = [
  { id: "errors", title: "Error over the clock, µm", label: "Errors of all lanes over the clock" },
  { id: "speeds", title: "Speed over the clock, mm/s", label: "Speeds of all lanes over the clock" },
] as const;

export class WordCompare implements Mode {
  readonly element: HTMLElement;
  private state: State = fromLink(location.hash);
  private readonly forms: WordForms;
  private readonly page: LanePage;
  private readonly table = wordTable();
  private made: readonly Made[] = [];
  private curve: Curve = curveOf("cubic", 1, 1);
  private curveErrors: FieldErrors = new Map();
  private laneErrors: FieldErrors[] = [];
  private typing = 0;

  static async open(planner: PlannerClient, engine: Engine): Promise<WordCompare> {
    const mill = await planner.limits("");
    if ("code" in mill) throw new Error(mill.message);
    return new WordCompare(planner, engine, mill);
  }

  private constructor(
    private readonly planner: PlannerClient,
    /** Of reference pulses. */
    private readonly engine: Engine,
    private readonly mill: Limits,
  ) {
    this.forms = new WordForms({
      choose: (comparison) => {
        const { layout, interval } = this.state;
        this.state = { ...stateOf(comparison), layout, interval };
        void this.load(0);
      },
      change: (change) => {
        Object.assign(this.state, change);
        this.loadSoon();
      },
      lanes: (lanes) => {
        this.state.lanes = lanes;
        this.loadSoon();
      },
      magnify: (times) => {
        this.state.magnified = times;
        this.show();
      },
    });
    this.page = this.pageOfLanes();
    this.element = this.page.element;
    void this.load(this.state.clock);
  }

  private pageOfLanes(): LanePage {
    return new LanePage(
      {
        kind: "words",
        name: "words",
        forms: [this.forms.curve, this.forms.lanes],
        strips,
        least: nearest,
        table: this.table,
        files: [
          ["save-words", "Words, CSV", () => download("leadscrew-tracks.csv", this.tracks(), "text/csv")],
          ["save-script", "Script", () => download("leadscrew-words.sh", scriptOf(this.made), "text/x-sh")],
        ],
        exampleInterval: "0.02",
      },
      {
        link: () => toLink({ ...this.state, clock: this.page.player.clock }),
        restore: () => {
          this.state = fromLink(location.hash);
          void this.load(this.state.clock);
        },
        interval: () => this.state.interval,
        setInterval: (text) => (this.state.interval = text),
        view: () => this.state,
        show: () => this.show(),
      },
    );
  }

  redraw(): void {
    this.page.redraw();
  }

  /** Every entry of every lane until the clock. */
  private tracks(): string {
    const lines = ["lane,t,X,Y,error_mm,speed_mm_s"];
    const scene = this.scene();
    for (const { number: lane, track } of this.made) {
      const until = scene.entry(track, this.page.player.clock);
      for (let i = 0; i <= until; ++i) {
        const row = [track.period * i, track.x[i], track.y[i], track.error[i], track.speed[i]];
        lines.push([lane + 1, ...row].join(","));
      }
    }
    return `${lines.join("\n")}\n`;
  }

  /** Typing and sliding come faster than plans are made. */
  private loadSoon(): void {
    this.page.begin();
    this.showForms();
    clearTimeout(this.typing);
    this.typing = window.setTimeout(() => void this.load(this.page.player.clock), typingPause);
  }

  private async load(clock: number): Promise<void> {
    clearTimeout(this.typing);
    const load = this.page.begin();
    const { player } = this.page;
    const wasAtEnd = clock > 0 && clock === player.last;
    player.pause();
    this.planner.cancel();
    const [curveErrors, laneErrors, made]: [FieldErrors, FieldErrors[], Made[]] = [new Map(), [], []];
    const curve = curveIn(this.state, curveErrors);
    for (const [number, lane] of this.state.lanes.entries()) {
      const errors: FieldErrors = new Map();
      const one = await this.make(number, lane, curve, errors);
      if (!this.page.isCurrent(load)) return;
      if (one !== undefined) made.push(one);
      this.sort(lane, errors, curveErrors);
      laneErrors.push(errors);
    }
    [this.made, this.curve, this.curveErrors, this.laneErrors] = [made, curve, curveErrors, laneErrors];
    const { last } = this.scene();
    this.page.loaded(load, last, wasAtEnd ? last : clock);
  }

  /** Errors of a lane's own numbers stay with it; all others are of the curve. */
  private sort(lane: Lane, errors: FieldErrors, curve: FieldErrors): void {
    const own = new Set<string>(["method", "loops", ...laneNumbers]);
    if (lane.period.trim() === "") own.delete("period");
    for (const [key, message] of [...errors]) {
      if (own.has(key)) continue;
      curve.set(key, message);
      errors.delete(key);
    }
  }

  private async make(lane: number, of: Lane, curve: Curve, errors: FieldErrors): Promise<Made | undefined> {
    const worked = await this.work(lane, of, curve, errors);
    if (worked === undefined) return undefined;
    const { words, task, command, pulses, detail } = worked;
    const period = Number((words.period * 1000).toPrecision(4));
    return {
      title: methodTitles[of.method],
      detail: detail ?? `T ${period} ms${loopsText(of, task)}`,
      number: lane,
      lane: lane + 1,
      track: trackOf(curve, words, quantity(this.state.feed)),
      task,
      command,
      cost: words.cost,
      pulses,
    };
  }

  /** Undefined where errors say why not, or something else is asked for meanwhile. */
  private async work(lane: number, of: Lane, curve: Curve, errors: FieldErrors): Promise<Worked | undefined> {
    if (isPulseMethod(of.method)) return await this.workPulses(of, of.method, curve, errors);
    if (isCircleRule(of.method)) {
      const task = circleTaskOf(this.state, of, of.method, mostWords, errors);
      const words = errors.size > 0 ? undefined : this.sound(await unlessCancelled(this.planner.circle(task)), errors);
      return words === undefined ? undefined : { words, task: undefined, command: circleCommandOf(of.method) };
    }
    const task = taskOf(this.mill, this.state, of, mostWords, errors);
    const words = errors.size > 0 ? undefined : this.sound(await unlessCancelled(this.planner.words(task)), errors);
    return words === undefined ? undefined : { words, task, command: commandOf(task, lane + 1) };
  }

  private async workPulses(
    of: Lane,
    method: PulseMethod,
    curve: Curve,
    errors: FieldErrors,
  ): Promise<Worked | undefined> {
    const over = number("period", this.state.period, errors) / 1000;
    const task = pulseTaskOf(this.state, of, method, errors);
    if (task === undefined) return undefined;
    const words = await pulseWords(this.engine, task, this.state, of, curve, over, mostWords, errors);
    if (words === undefined) return undefined;
    const detail = `${Number(of.blu)} mm a pulse, ${digits(1e-3 / words.period)} kHz`;
    return { words, task: undefined, command: pulseCommandOf(task), pulses: words.pulses, detail };
  }

  /** What is wrong goes to its field. */
  private sound(words: Words | Diagnostic | undefined, errors: FieldErrors): Words | undefined {
    if (words === undefined || !("code" in words)) return words;
    errors.set(fieldOf(words), words.hint === "" ? words.message : `${words.message}: ${words.hint}`);
    return undefined;
  }

  private scene(): TrackScene {
    const { state, curve, made } = this;
    const period = number("period", state.period, new Map()) / 1000;
    return new TrackScene(curve, made, period > 0 ? period : 1e-3, state.magnified, quantity(state.feed));
  }

  private showForms(): void {
    this.forms.update(this.state, comparisonOf(this.state), this.curveErrors, this.laneErrors);
  }

  private show(): void {
    const { state, made, page } = this;
    this.showForms();
    const scene = this.scene();
    const commands = made.map(({ command }) => command);
    page.show({ scene, count: made.length, text: this.text(), commands });
    const published = comparisonOf(state)?.published ?? [];
    this.table.update(
      made.map(({ number: lane, title, detail, track, cost, pulses }) => ({
        number: lane,
        title,
        detail,
        told: { track, cost, pulses, entry: scene.entry(track, page.player.clock) },
        published: published[lane] ?? "",
      })),
    );
  }

  /** What the picture shows, in words. */
  private text(): string {
    if (this.made.length === 0) return "Nothing can be drawn yet";
    const lanes = this.made.map(({ title, detail }) => `${title}, ${detail}`).join("; ");
    const times = this.state.magnified === 1 ? "" : `, errors drawn ${this.state.magnified} times`;
    return `The curve and what is made of it until clock ${this.page.player.clock}${times}: ${lanes}`;
  }
}

function loopsText(lane: Lane, task: WordTask | undefined): string {
  if (task?.loops === undefined) return "";
  const gains = lane.loops === "pid" ? `(${lane.p}, ${lane.i}, ${lane.d})` : `Kv ${lane.kv}/s`;
  return `, ${loopTitles[lane.loops]} ${gains}`;
}

function digits(value: number): string {
  return String(Number(value.toPrecision(4)));
}

/** The field that a problem of the engine is about. */
function fieldOf({ code, field }: Diagnostic): string {
  if (code.startsWith("servo")) return "loops";
  if (field === "period" || code === "machine-period") return "period";
  return "method";
}
