// Words beside one another: one curve, up to four lanes, one clock, one camera. Each lane is what the engine makes of it.

import type { Camera, Layout } from "../compare/scene";
import { Stage } from "../compare/stage";
import { type PlannerClient, unlessCancelled } from "../engine/planner_client";
import type { Diagnostic, Limits, WordTask } from "../engine/motion_types";
import { download } from "../lesson/files";
import { quantity, type FieldErrors } from "../lesson/settings";
import { html } from "../ui/dom";
import { Player } from "../ui/player";
import type { Mode } from "../ui/shell";
import { Transport } from "../ui/transport";
import { curveOf, type Curve } from "./curves";
import { commandOf, scriptOf } from "./files";
import { loopTitles, methodTitles, WordForms } from "./forms";
import { trackOf } from "./measure";
import { TrackScene, type DrawnTrack } from "./pictures";
import {
  comparisonOf,
  curveIn,
  fromLink,
  laneNumbers,
  number,
  stateOf,
  taskOf,
  toLink,
  type Lane,
  type State,
} from "./state";
import { WordTable } from "./table";

const mostWords = 20_000;
const typingPause = 120; // ms

interface Made extends DrawnTrack {
  readonly task: WordTask;
  readonly cost: number;
}

const strips = [
  { id: "errors", title: "Error over the clock, µm", label: "Errors of all lanes over the clock" },
  { id: "speeds", title: "Speed over the clock, mm/s", label: "Speeds of all lanes over the clock" },
] as const;

export class WordCompare implements Mode {
  readonly element: HTMLElement;
  private state: State = fromLink(location.hash);
  private readonly player = new Player({
    changed: () => this.show(),
    pace: () => quantity(this.state.interval),
  });
  private readonly forms: WordForms;
  private readonly transport: Transport;
  private readonly stage: Stage;
  private readonly table = new WordTable();
  private readonly commands = html("pre", { id: "commands", tabindex: 0 });
  private made: readonly Made[] = [];
  private curve: Curve = curveOf("cubic", 1, 1);
  private curveErrors: FieldErrors = new Map();
  private laneErrors: FieldErrors[] = [];
  private loads = 0;
  private typing = 0;
  private linkTimer = 0;

  static async open(planner: PlannerClient): Promise<WordCompare> {
    const mill = await planner.limits("");
    if ("code" in mill) throw new Error(mill.message);
    return new WordCompare(planner, mill);
  }

  private constructor(
    private readonly planner: PlannerClient,
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
    const seek = (clock: number): void => this.player.seek(clock);
    this.transport = new Transport("Clock", {
      seek,
      step: (by) => this.player.step(by),
      toggle: () => this.player.toggle(),
      interval: (text) => {
        this.state.interval = text;
        this.show();
      },
    });
    const look = (camera: Camera | undefined): void => {
      this.state.camera = camera;
      this.show();
    };
    const layout = (layout: Layout): void => {
      this.state.layout = layout;
      this.show();
    };
    this.stage = new Stage({ seek, look, layout }, strips, 1e-3);
    this.element = html("div", { class: "lesson compare words" }, ...this.content());
    addEventListener("hashchange", () => this.restore());
    document.addEventListener("keydown", (event) =>
      this.player.key(event, "input, select, textarea, .path-frame, .figures"),
    );
    void this.load(this.state.clock);
  }

  private content(): HTMLElement[] {
    const button = (id: string, text: string, press: () => void): HTMLElement =>
      html("button", { type: "button", id, click: press }, text);
    const copy = (text: () => string) => () => void navigator.clipboard?.writeText(text());
    const savePicture = async (): Promise<void> => download("leadscrew-words.png", await this.stage.png(), "image/png");
    const figures = html(
      "section",
      { class: "panel", "aria-labelledby": "figures-title" },
      html("h2", { id: "figures-title" }, "Figures until this clock"),
      this.table.element,
      html(
        "div",
        { class: "buttons" },
        button("save-svg", "SVG", () => download("leadscrew-words.svg", this.stage.svg(), "image/svg+xml")),
        button("save-png", "PNG", () => void savePicture()),
        button("save-csv", "CSV", () => download("leadscrew-words.csv", this.table.csv(), "text/csv")),
        button("save-words", "Words, CSV", () => download("leadscrew-tracks.csv", this.tracks(), "text/csv")),
        button("save-script", "Script", () => download("leadscrew-words.sh", scriptOf(this.tasks), "text/x-sh")),
        button(
          "copy-link",
          "Copy link",
          copy(() => location.href),
        ),
        button(
          "copy-commands",
          "Copy commands",
          copy(() => this.commands.textContent ?? ""),
        ),
      ),
      this.commands,
    );
    this.transport.bar.append(this.transport.interval);
    return [
      html("div", { class: "side" }, this.forms.curve, this.forms.lanes),
      html(
        "div",
        { class: "main" },
        html("section", { class: "panel", "aria-label": "Clock" }, this.transport.bar, this.transport.error),
        html("div", { class: "display" }, this.stage.element, figures),
      ),
    ];
  }

  /** After the colours have changed. */
  redraw(): void {
    this.stage.draw();
  }

  private get tasks(): readonly (readonly [number, WordTask])[] {
    return this.made.map(({ task, number: lane }) => [lane + 1, task]);
  }

  /** Every entry of every lane until the clock. */
  private tracks(): string {
    const lines = ["lane,t,X,Y,error_mm,speed_mm_s"];
    const scene = this.scene();
    for (const { number: lane, track } of this.made) {
      const until = scene.entry(track, this.player.clock);
      for (let i = 0; i <= until; ++i) {
        const row = [track.period * i, track.x[i], track.y[i], track.error[i], track.speed[i]];
        lines.push([lane + 1, ...row].join(","));
      }
    }
    return `${lines.join("\n")}\n`;
  }

  private restore(): void {
    if (location.hash === this.link()) return;
    this.state = fromLink(location.hash);
    void this.load(this.state.clock);
  }

  private link(): string {
    return toLink({ ...this.state, clock: this.player.clock });
  }

  /** Typing and sliding come faster than plans are made. */
  private loadSoon(): void {
    this.element.dataset["loading"] = String(++this.loads);
    this.showForms();
    clearTimeout(this.typing);
    this.typing = window.setTimeout(() => void this.load(this.player.clock), typingPause);
  }

  private async load(clock: number): Promise<void> {
    clearTimeout(this.typing);
    const load = ++this.loads;
    const wasAtEnd = clock > 0 && clock === this.player.last;
    this.player.pause();
    this.planner.cancel();
    this.element.dataset["loading"] = String(load);
    const [curveErrors, laneErrors, made]: [FieldErrors, FieldErrors[], Made[]] = [new Map(), [], []];
    const curve = curveIn(this.state, curveErrors);
    for (const [number, lane] of this.state.lanes.entries()) {
      const errors: FieldErrors = new Map();
      const one = await this.make(number, lane, curve, errors);
      if (load !== this.loads) return;
      if (one !== undefined) made.push(one);
      this.sort(lane, errors, curveErrors);
      laneErrors.push(errors);
    }
    [this.made, this.curve, this.curveErrors, this.laneErrors] = [made, curve, curveErrors, laneErrors];
    const { last } = this.scene();
    this.player.load(last, wasAtEnd ? last : clock);
    this.element.dataset["loaded"] = String(load);
    this.show();
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
    const task = taskOf(this.mill, this.state, of, mostWords, errors);
    if (errors.size > 0) return undefined;
    const words = await unlessCancelled(this.planner.words(task));
    if (words === undefined) return undefined;
    if ("code" in words) {
      errors.set(fieldOf(words), words.hint === "" ? words.message : `${words.message}: ${words.hint}`);
      return undefined;
    }
    const feed = quantity(this.state.feed);
    const period = Number((words.period * 1000).toPrecision(6));
    const gains = task.loops === undefined ? "" : `, ${loopTitles[of.loops]} ${gainsText(of)}`;
    return {
      title: methodTitles[of.method],
      detail: `T ${period} ms${gains}`,
      number: lane,
      track: trackOf(curve, words, feed),
      task,
      cost: words.cost,
    };
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
    const { state, made, player } = this;
    const { clock, last, isRunning } = player;
    this.element.dataset["clock"] = String(clock);
    this.element.dataset["state"] = isRunning ? "running" : "stopped";
    this.element.dataset["lanes"] = String(made.length);
    this.showForms();
    const pace = quantity(state.interval);
    const error = pace >= 0 && pace <= 60 ? "" : "the interval is 0 (as fast as can be) to 60 s, such as 0.02";
    this.transport.update({ clock, last, isRunning, mayRun: last > 0, interval: state.interval, error });
    const scene = this.scene();
    this.stage.update(scene, state, clock, this.text());
    const published = comparisonOf(state)?.published ?? [];
    this.table.update(
      made.map((each) => ({
        ...each,
        entry: scene.entry(each.track, clock),
        published: published[each.number] ?? "",
      })),
    );
    this.commands.textContent = this.tasks.map(([lane, task]) => commandOf(task, lane)).join("\n");
    this.keepLink();
  }

  /** What the picture shows, in words. */
  private text(): string {
    if (this.made.length === 0) return "Nothing can be drawn yet";
    const lanes = this.made.map(({ title, detail }) => `${title}, ${detail}`).join("; ");
    const times = this.state.magnified === 1 ? "" : `, errors drawn ${this.state.magnified} times`;
    return `The curve and what is made of it until clock ${this.player.clock}${times}: ${lanes}`;
  }

  private keepLink(): void {
    if (this.linkTimer !== 0) return;
    this.linkTimer = window.setTimeout(() => {
      this.linkTimer = 0;
      history.replaceState(null, "", this.link());
    }, 300);
  }
}

function gainsText(lane: Lane): string {
  if (lane.loops === "pid") return `(${lane.p}, ${lane.i}, ${lane.d})`;
  return `Kv ${lane.kv}/s`;
}

/** The field that a problem of the engine is about. */
function fieldOf({ code, field }: Diagnostic): string {
  if (code.startsWith("servo")) return "loops";
  if (field === "period" || code === "machine-period") return "period";
  return "method";
}
