// The lesson: what the reader sets becomes a task, the task a recording, and the clock walks along it.

import type { Catalogue, Engine, Method, Task } from "../engine/types";
import { linkFromLesson } from "../compare/state";
import { html } from "../ui/dom";
import { Display } from "./display";
import { Form } from "./form";
import { Predict } from "./predict";
import { presetOf, presets, withPreset, type Preset } from "./presets";
import { Session } from "./session";
import { Speed } from "./speed";
import { commandOf, fieldOf, fromLink, quantity, taskOf, toLink, type FieldErrors, type Settings } from "./settings";

const mostClocks = 131_072;
const mostCyclesAFrame = 256; // at interval 0, and where the page was hidden

export class Lesson {
  readonly element: HTMLElement;
  private settings: Settings = fromLink(location.hash);
  private errors: FieldErrors = new Map();
  private task: Task | undefined;
  private loads = 0;
  private whyOf = -1;
  private readonly session: Session = new Session(() => this.show());
  private readonly form: Form;
  private readonly speed: Speed;
  private readonly display: Display;
  private readonly predict: Predict;
  private readonly tabs: HTMLButtonElement[];
  private timer = 0;
  private frame = 0;
  private linkTimer = 0;

  constructor(
    private readonly engine: Engine,
    private readonly catalogue: Catalogue,
  ) {
    const change = (change: Partial<Settings>): void => this.change(change);
    const seek = (clock: number): void => this.session.seek(clock);
    this.form = new Form(catalogue, {
      change,
      preset: (preset) => this.choose(preset),
      start: (isOn) => (isOn ? this.wait() : this.pause()),
    });
    this.speed = new Speed({
      change,
      seek,
      step: (by) => this.step(by),
      toggle: () => this.toggle(),
      nextPulse: () => seek(this.session.next((clock) => this.session.isPulse(clock))),
      nextBorder: () => seek(this.session.next((clock) => this.session.isBorder(clock))),
    });
    this.display = new Display({ change, seek });
    this.predict = new Predict(this.session, () => this.step(1));
    this.tabs = (["line", "arc"] as const).map((module) =>
      html(
        "button",
        {
          type: "button",
          role: "tab",
          id: `module-${module}`,
          "data-module": module,
          click: () => this.module(module),
        },
        module === "line" ? "Linear" : "Circular",
      ),
    );
    this.element = html(
      "div",
      { class: "lesson" },
      html("div", { class: "modules", role: "tablist", "aria-label": "Module" }, ...this.tabs),
      html("div", { class: "side", role: "tabpanel", "aria-label": "Settings" }, this.form.element),
      html("div", { class: "main" }, this.speed.element, this.predict.element, this.display.element),
    );
    this.tabs.forEach((tab) => tab.addEventListener("keydown", (event) => this.tabKey(event)));
    addEventListener("hashchange", () => this.restore());
    document.addEventListener("keydown", (event) => this.key(event));
    void this.load(this.settings.clock);
  }

  /** After the colours have changed. */
  redraw(): void {
    this.display.draw();
  }

  private method(): Method | undefined {
    return this.catalogue.methods.find(({ name }) => name === this.settings.method);
  }

  private change(change: Partial<Settings>): void {
    const isLook = Object.keys(change).every((key) =>
      ["view", "predict", "stopAtPulse", "stopAtBorder", "run", "interval", "polling", "feed"].includes(key),
    );
    Object.assign(this.settings, change);
    if (change.predict !== undefined) this.predict.reset();
    if (!isLook) {
      void this.load(0);
      return;
    }
    if (change.run === "single") this.pause();
    this.check();
    this.show();
  }

  private choose(preset: Preset): void {
    this.settings = withPreset(this.settings, preset);
    void this.load(0);
  }

  private module(module: Settings["module"]): void {
    if (module === this.settings.module) return;
    const first = presets.find(({ settings }) => settings.module === module);
    if (first !== undefined) this.choose(first);
  }

  private restore(): void {
    if (location.hash === toLink({ ...this.settings, clock: this.session.clock })) return;
    this.settings = fromLink(location.hash);
    void this.load(this.settings.clock);
  }

  /** The task of what is set; undefined while something is wrong. */
  private check(): Task | undefined {
    this.errors = new Map();
    const method = this.method();
    if (method === undefined) this.errors.set("method", `there is no method ${this.settings.method}`);
    const task = taskOf(this.settings, method, this.errors);
    return this.isSound() ? task : undefined;
  }

  /** Times may be wrong, and the curve still be shown. */
  private isSound(): boolean {
    return [...this.errors.keys()].every((key) => key === "interval" || key === "polling" || key === "feed");
  }

  private async load(clock: number): Promise<void> {
    this.pause();
    const load = ++this.loads;
    this.element.dataset["loading"] = String(load);
    delete this.element.dataset["told"];
    const task = this.check();
    if (task === undefined) return this.refuse(load);
    const problems = await this.engine.problems(task);
    if (load !== this.loads) return;
    const recording = problems.length > 0 ? undefined : await this.engine.load(task, mostClocks);
    if (load !== this.loads) return;
    if (recording !== undefined && "code" in recording) problems.push(recording);
    for (const { field, message, hint } of problems) {
      const key = fieldOf(field);
      if (!this.errors.has(key)) this.errors.set(key, hint === "" ? message : `${message}: ${hint}`);
    }
    if (recording === undefined || "code" in recording) return this.refuse(load);
    this.task = task;
    this.whyOf = -1;
    this.element.dataset["loaded"] = String(load);
    this.session.load(recording, clock);
  }

  private refuse(load: number): void {
    this.task = undefined;
    this.element.dataset["loaded"] = String(load);
    this.session.unload();
  }

  private toggle(): void {
    if (this.session.state === "running" || this.session.state === "waiting") this.pause();
    else this.run();
  }

  private step(by: 1 | -1): void {
    if (this.session.state === "running" || this.session.state === "waiting") this.pause();
    this.session.step(by);
    const interval = quantity(this.settings.interval) || 0;
    this.session.elapsed = Math.max(0, this.session.elapsed + by * interval);
    this.show();
  }

  /** The switch is on: the module's waiting loop sees it at its next look. */
  private wait(): void {
    if (this.session.recording === undefined || this.settings.run === "single") return;
    this.session.state = "waiting";
    this.show();
    const polling = quantity(this.settings.polling);
    this.timer = window.setTimeout(() => this.run(), 1000 * (polling > 0 ? polling : 0.5));
  }

  private run(): void {
    const { session, settings } = this;
    if (session.recording === undefined || settings.run === "single") return;
    const interval = quantity(settings.interval);
    if (!(interval >= 0)) return;
    if (session.clock === session.last) session.seek(0);
    if (session.clock === 0) session.elapsed = 0;
    if (session.state === "breakpoint") session.passBreakpoint(interval);
    session.state = "running";
    let last = performance.now();
    let owed = 0;
    const go = (now: number): void => {
      if (session.state !== "running") return;
      const pace = quantity(this.settings.interval);
      owed = pace > 0 ? owed + (now - last) / 1000 / pace : mostCyclesAFrame;
      last = now;
      const cycles = Math.min(Math.floor(owed), mostCyclesAFrame);
      owed = pace > 0 ? Math.min(owed - cycles, mostCyclesAFrame) : 0;
      if (cycles > 0)
        session.advance(cycles, pace > 0 ? pace : 0, {
          atPulse: this.settings.stopAtPulse,
          atBorder: this.settings.stopAtBorder,
        });
      if (session.state === "running") this.frame = requestAnimationFrame(go);
    };
    this.frame = requestAnimationFrame(go);
    this.show();
  }

  private pause(): void {
    clearTimeout(this.timer);
    cancelAnimationFrame(this.frame);
    this.session.rest();
    this.show();
  }

  private show(): void {
    const { session, settings } = this;
    settings.clock = session.clock;
    this.element.dataset["clock"] = String(session.clock);
    this.element.dataset["state"] = session.state;
    this.element.dataset["module"] = settings.module;
    for (const tab of this.tabs) {
      const isOn = tab.dataset["module"] === settings.module;
      tab.setAttribute("aria-selected", String(isOn));
      tab.tabIndex = isOn ? 0 : -1;
    }
    this.form.update(settings, this.method(), this.errors, session.recording?.conventions);
    this.form.showPreset(presetOf(settings));
    this.form.showStart(session.state === "running" || session.state === "waiting", this.statusText());
    this.speed.update(settings, session, this.errors);
    this.predict.update(settings.predict && this.task !== undefined);
    const command = this.task === undefined ? "" : commandOf(this.task);
    this.display.update(this.task, session, settings, command, linkFromLesson(settings, this.catalogue.methods));
    if (this.task !== undefined && this.whyOf !== session.clock) void this.tellWhy(session.clock);
    this.keepLink();
  }

  private async tellWhy(clock: number): Promise<void> {
    this.whyOf = clock;
    const text = await this.engine.why(clock);
    if (this.whyOf === clock) {
      this.display.showWhy(text);
      this.element.dataset["told"] = String(clock);
    }
  }

  private statusText(): string {
    const texts: Readonly<Record<Session["state"], string>> = {
      empty: "Something above is not right yet",
      waiting: `Waiting for the switch, polled every ${this.settings.polling} s`,
      running: "Running",
      stopped: this.settings.run === "single" ? "Each step is a cycle" : "Off",
      breakpoint: "Stopped at a breakpoint",
      done: this.task?.isFree === true ? "Done: the clocks of the angle are over" : "Done: both counters are 0",
    };
    return texts[this.session.state];
  }

  /** The browser takes a few changes of the address a second. */
  private keepLink(): void {
    if (this.linkTimer !== 0) return;
    this.linkTimer = window.setTimeout(() => {
      this.linkTimer = 0;
      history.replaceState(null, "", toLink({ ...this.settings, clock: this.session.clock }));
    }, 300);
  }

  private tabKey(event: KeyboardEvent): void {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    event.preventDefault();
    event.stopPropagation();
    this.module(this.settings.module === "line" ? "arc" : "line");
    this.tabs.find((tab) => tab.dataset["module"] === this.settings.module)?.focus();
  }

  /** Where no control has these keys. */
  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches("input, select, textarea, [role=tab], .table"))
      return;
    const isButton = target.matches("button");
    const actions: Readonly<Record<string, () => void>> = {
      ArrowRight: () => this.step(1),
      ArrowLeft: () => this.step(-1),
      Home: () => this.session.seek(0),
      End: () => this.session.seek(this.session.last),
      ...(isButton ? {} : { " ": () => this.toggle() }),
    };
    const action = actions[event.key];
    if (action === undefined) return;
    event.preventDefault();
    action();
  }
}
