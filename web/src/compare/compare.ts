// Methods beside one another: one curve, up to four lanes, one clock, one camera. Each lane is a recording of the engine.

import type { Catalogue, Engine, Method, Task } from "../engine/types";
import { download, vcdText } from "../lesson/files";
import { methodTitles } from "../lesson/form";
import { graphText } from "../lesson/graph";
import { Session } from "../lesson/session";
import { commandOf, fieldOf, quantity, taskOf, type FieldErrors } from "../lesson/settings";
import { html } from "../ui/dom";
import { Player } from "../ui/player";
import { Transport } from "../ui/transport";
import { CurveForm } from "./curve_form";
import { FigureTable, type Compared } from "./figure_table";
import { conventionsText } from "./figures";
import { LaneForms } from "./lane_forms";
import { PulseScene, type Drawn } from "./pictures";
import type { Camera, Layout } from "./scene";
import { Stage } from "./stage";
import { comparisonOf, figureOf, fromLink, laneKeys, settingsOfLane, stateOf, toLink, type State } from "./state";

const mostClocks = 131_072;

export class Compare {
  readonly element: HTMLElement;
  private state: State = fromLink(location.hash);
  private readonly curveForm: CurveForm;
  private readonly laneForms: LaneForms;
  private readonly transport: Transport;
  private readonly stage: Stage;
  private readonly table = new FigureTable();
  private readonly commands = html("pre", { id: "commands", tabindex: 0 });
  private compared: readonly Compared[] = [];
  private curveErrors: FieldErrors = new Map();
  private laneErrors: FieldErrors[] = [];
  private readonly player = new Player({
    changed: () => this.show(),
    pace: () => quantity(this.state.curve.interval),
  });
  private loads = 0;
  private linkTimer = 0;

  constructor(
    private readonly engine: Engine,
    private readonly catalogue: Catalogue,
  ) {
    this.curveForm = new CurveForm({
      choose: (comparison) => this.reset(stateOf(comparison)),
      change: (change) => {
        Object.assign(this.state.curve, change);
        this.state.camera = undefined;
        void this.load(0);
      },
      feed: (feed) => {
        this.state.curve.feed = feed;
        this.show();
      },
    });
    this.laneForms = new LaneForms(catalogue, {
      change: (lanes) => {
        this.state.lanes = lanes;
        void this.load(this.player.clock);
      },
    });
    const seek = (clock: number): void => this.player.seek(clock);
    this.transport = new Transport("Clock", {
      seek,
      step: (by) => this.player.step(by),
      toggle: () => this.player.toggle(),
      interval: (text) => {
        this.state.curve.interval = text;
        this.show();
      },
    });
    const stage = {
      seek,
      look: (camera: Camera | undefined) => {
        this.state.camera = camera;
        this.show();
      },
      layout: (layout: Layout) => {
        this.state.layout = layout;
        this.show();
      },
    };
    const label = "Errors of all methods over the clock";
    this.stage = new Stage(stage, [{ id: "errors", title: "Error over the clock, BLU", label }]);
    this.element = html("div", { class: "lesson compare" }, ...this.content());
    addEventListener("hashchange", () => this.restore());
    document.addEventListener("keydown", (event) =>
      this.player.key(event, "input, select, textarea, .path-frame, .figures"),
    );
    void this.load(this.state.curve.clock);
  }

  private content(): HTMLElement[] {
    const button = (id: string, text: string, press: () => void): HTMLElement =>
      html("button", { type: "button", id, click: press }, text);
    const figures = html(
      "section",
      { class: "panel", "aria-labelledby": "figures-title" },
      html("h2", { id: "figures-title" }, "Figures until this clock"),
      this.table.element,
      html(
        "div",
        { class: "buttons" },
        button("save-svg", "SVG", () => download("leadscrew-compare.svg", this.stage.svg(), "image/svg+xml")),
        button("save-png", "PNG", () => void this.savePicture()),
        button("save-csv", "CSV", () => download("leadscrew-compare.csv", this.table.csv(), "text/csv")),
        button("save-vcd", "VCD", () => this.saveDump()),
        button("copy-link", "Copy link", () => void navigator.clipboard?.writeText(location.href)),
        button(
          "copy-commands",
          "Copy commands",
          () => void navigator.clipboard?.writeText(this.commands.textContent ?? ""),
        ),
      ),
      this.commands,
    );
    this.transport.bar.append(this.transport.interval);
    return [
      html("div", { class: "side" }, this.curveForm.element, this.laneForms.element),
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

  private async savePicture(): Promise<void> {
    download("leadscrew-compare.png", await this.stage.png(), "image/png");
  }

  /** A scope for each lane, by its number, since two of them may have one method. */
  private saveDump(): void {
    const scopes = this.compared.map(({ drawn }) => ({
      name: `${drawn.task.method}-${drawn.number + 1}`,
      session: drawn.session,
    }));
    download("leadscrew-compare.vcd", vcdText(scopes, this.player.clock), "text/plain");
  }

  private reset(state: State): void {
    const { interval, feed } = this.state.curve;
    this.state = { ...state, curve: { ...state.curve, interval, feed }, layout: this.state.layout };
    void this.load(0);
  }

  private restore(): void {
    if (location.hash === this.link()) return;
    this.state = fromLink(location.hash);
    void this.load(this.state.curve.clock);
  }

  private link(): string {
    return toLink({ ...this.state, curve: { ...this.state.curve, clock: this.player.clock } });
  }

  private methodOf(name: string): Method | undefined {
    return this.catalogue.methods.find((each) => each.name === name);
  }

  /** Of a lane; errors of the curve are the same in each. */
  private taskOfLane(number: number, errors: FieldErrors): Task | undefined {
    const lane = this.state.lanes[number];
    const method = this.methodOf(lane?.method ?? "");
    if (lane === undefined) return undefined;
    if (method === undefined) errors.set("method", `there is no method ${lane.method}`);
    const task = taskOf(settingsOfLane(this.state, lane), method, errors);
    errors.delete("interval");
    errors.delete("polling");
    errors.delete("feed");
    return errors.size > 0 ? undefined : task;
  }

  private async load(clock: number): Promise<void> {
    const load = ++this.loads;
    this.player.pause();
    this.element.dataset["loading"] = String(load);
    const [curveErrors, laneErrors, compared]: [FieldErrors, FieldErrors[], Compared[]] = [new Map(), [], []];
    for (const number of this.state.lanes.keys()) {
      const errors: FieldErrors = new Map();
      const task = this.taskOfLane(number, errors);
      const drawn = task === undefined ? undefined : await this.record(number, task, errors);
      if (load !== this.loads) return;
      if (drawn !== undefined) compared.push(drawn);
      for (const [key, message] of errors)
        if (!(laneKeys as readonly string[]).includes(key)) curveErrors.set(key, message);
      laneErrors.push(errors);
    }
    this.compared = compared;
    this.curveErrors = curveErrors;
    this.laneErrors = laneErrors;
    this.player.load(Math.max(0, ...compared.map(({ drawn }) => drawn.session.last)), clock);
    this.element.dataset["loaded"] = String(load);
    this.show();
  }

  private async record(number: number, task: Task, errors: FieldErrors): Promise<Compared | undefined> {
    const problems = await this.engine.problems(task);
    const recording = problems.length > 0 ? undefined : await this.engine.load(task, mostClocks);
    if (recording !== undefined && "code" in recording) problems.push(recording);
    for (const { field, message, hint } of problems)
      errors.set(fieldOf(field), hint === "" ? message : `${message}: ${hint}`);
    if (recording === undefined || "code" in recording) return undefined;
    const session = new Session(() => {});
    session.load(recording, 0);
    const lane = this.state.lanes[number];
    const figure = lane === undefined ? undefined : figureOf(this.state, lane);
    const detail = conventionsText(recording.conventions);
    return {
      drawn: { title: methodTitles[task.method] ?? task.method, detail, number, task, session },
      conventions: detail,
      source: figure?.source ?? "",
      published: figure?.published ?? "",
      clocksPerBlu: recording.conventions.clocksPerBlu,
      command: commandOf(task).replace("--table", "--json"),
    };
  }

  private show(): void {
    const { state, compared } = this;
    const { clock, last, isRunning } = this.player;
    const drawn: Drawn[] = compared.map((each) => each.drawn);
    this.element.dataset["clock"] = String(clock);
    this.element.dataset["state"] = isRunning ? "running" : "stopped";
    this.element.dataset["lanes"] = String(compared.length);
    const feed = quantity(state.curve.feed);
    this.curveForm.update(state, comparisonOf(state), this.curveErrors, feed > 0);
    const methods = state.lanes.map(({ method }) => this.methodOf(method));
    this.laneForms.update(state, methods, this.laneErrors);
    const pace = quantity(state.curve.interval);
    const wrong = pace >= 0 && pace <= 60 ? "" : "the interval is 0 (as fast as can be) to 60 s, such as 0.1";
    this.transport.update({
      clock,
      last,
      isRunning,
      mayRun: last > 0,
      interval: state.curve.interval,
      error: wrong,
    });
    this.stage.update(new PulseScene(drawn), state, clock, this.text());
    this.table.update(compared, clock, feed);
    this.commands.textContent = compared.map(({ command }) => command).join("\n");
    this.keepLink();
  }

  /** What the picture shows, in words. */
  private text(): string {
    const one = this.compared[0]?.drawn;
    if (one === undefined) return "Nothing can be drawn yet";
    const [curve] = graphText(one.task, one.session).split(" and the steps");
    return `${curve} and the steps of ${this.compared.map(({ drawn }) => drawn.title).join(", ")} until clock ${this.player.clock}`;
  }

  private keepLink(): void {
    if (this.linkTimer !== 0) return;
    this.linkTimer = window.setTimeout(() => {
      this.linkTimer = 0;
      history.replaceState(null, "", this.link());
    }, 300);
  }
}
