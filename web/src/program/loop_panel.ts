// The menu of the real-time paper: which loops follow the program, with their gains and encoder, and what is shown of them: the
// part, drawn from position feedback over the geometry that is known, and one signal over time.

import { Fields } from "../compare/fields";
import { Slid } from "../compare/slid";
import { CanvasPicture, SvgPicture } from "../draw/picture";
import {
  axisLetters,
  controllers,
  encoders,
  type Controller,
  type Diagnostic,
  type Encoder,
  type LoopOptions,
  type Plan,
  type Slides,
} from "../engine/motion_types";
import { download } from "../lesson/files";
import type { FieldErrors } from "../lesson/settings";
import { fixed, html } from "../ui/dom";
import { put } from "./figures";
import { FollowedPicture, signals, views, type Look, type Signal, type View } from "./loop_picture";
import {
  commandOf,
  initialLoops,
  loopNumbers,
  loopRanges,
  optionsOf,
  usesOf,
  type LoopNumber,
  type LoopSettings,
} from "./loops";

export interface LoopCalls {
  /** Undefined where something else has been asked for meanwhile. */
  follow(options: LoopOptions): Promise<Slides | Diagnostic | undefined>;
  changed(settings: LoopSettings): void;
}

const controllerTitles: Readonly<Record<Controller, string>> = {
  own: "The machine's own",
  pid: "PID",
  cascade: "Cascade",
  pulses: "Pulse loop",
};
const encoderTitles: Readonly<Record<Encoder, string>> = {
  own: "The machine's own",
  rotary: "Rotary encoder, at the screw",
  linear: "Linear encoder, on the slide",
};
const labels: Readonly<Record<LoopNumber, string>> = {
  proportional: "P, units/mm",
  integral: "I, units/(mm·s)",
  derivative: "D, units/mm",
  positionGain: "Kv, 1/s",
  forward: "Fed forward, 0 to 1",
  backlash: "Play of the screws, mm",
};
export class LoopPanel {
  readonly element: HTMLElement;
  private readonly fields = new Fields();
  private readonly numbers: readonly (readonly [LoopNumber, Slid])[];
  private readonly button = html(
    "button",
    { type: "button", id: "loops-follow", click: () => this.toggle() },
    "Follow",
  );
  private readonly note = html("p", { class: "note", id: "loops-note", role: "status" });
  private program = (_hasFile: boolean): string => "PROGRAM";
  private readonly command = html("code", {
    class: "command",
    id: "loops-command",
    tabindex: 0,
    "aria-label": "Command",
  });
  private readonly figures = html("dl", {
    class: "numbers",
    id: "loops-figures",
    "aria-label": "Figures of the loops",
  });
  private readonly part = html("canvas", { role: "img", id: "loops-part" });
  private readonly strip = html("canvas", { role: "img", id: "loops-signal" });
  private readonly shown = html("div", { class: "loops-shown" });
  private settings: LoopSettings = { ...initialLoops };
  private isOn = false;
  private plan: Plan | undefined;
  private slides: Slides | undefined;
  private time = 0;
  private signal: Signal = "lag";
  private view: View = "whole";
  private runs = 0;
  private typing = 0;

  constructor(private readonly calls: LoopCalls) {
    const { fields } = this;
    this.numbers = loopNumbers.map((name) => {
      const change = (text: string): void => this.change({ [name]: text });
      return [name, new Slid(fields, `loops-${name}`, labels[name], loopRanges[name], change)] as const;
    });
    const titled = <Key extends string>(titles: Readonly<Record<Key, string>>): [string, string][] =>
      Object.entries<string>(titles);
    this.shown.append(
      html("div", { class: "frame loops-part" }, this.part),
      html("div", { class: "frame waves" }, this.strip),
      this.figures,
      html(
        "div",
        { class: "buttons" },
        this.saver("loops-svg", "Part, SVG", () => download("leadscrew-part.svg", this.svgText(), "image/svg+xml")),
        this.saver("loops-csv", "Slides, CSV", () =>
          download("leadscrew-slides.csv", this.picture?.csvText() ?? "", "text/csv"),
        ),
      ),
    );
    this.element = html(
      "section",
      { class: "panel loops", "aria-label": "Loops" },
      html("div", { class: "panel-head" }, html("h2", {}, "Loops"), this.button),
      html(
        "div",
        { class: "loops-fields" },
        fields.select(
          "loops-controller",
          "Controller",
          controllers.map((each) => [each, controllerTitles[each]]),
          (value) => this.change({ controller: value as Controller }),
        ),
        fields.select(
          "loops-encoder",
          "Position is measured by",
          encoders.map((each) => [each, encoderTitles[each]]),
          (value) => this.change({ encoder: value as Encoder }),
        ),
        ...this.numbers.map(([, slid]) => slid.element),
        fields.select("loops-view", "Part", titled(views), (value) => {
          this.view = value as View;
          this.draw();
        }),
        fields.select("loops-shows", "Sensor over time", titled(signals), (value) => {
          this.signal = value as Signal;
          this.draw();
        }),
      ),
      this.note,
      this.shown,
      this.command,
    );
    const sizes = new ResizeObserver(() => this.draw());
    for (const canvas of [this.part, this.strip])
      if (canvas.parentElement !== null) sizes.observe(canvas.parentElement);
    this.show();
  }

  private saver(id: string, text: string, press: () => void): HTMLElement {
    return html("button", { type: "button", id, click: press }, text);
  }

  /** What a link asks for; nothing is followed without. */
  restore(settings: LoopSettings | undefined): void {
    this.settings = { ...(settings ?? initialLoops) };
    this.isOn = settings !== undefined;
    this.show();
  }

  /** What is followed, as commands name it; `hasFile`: the machine file has something to say of the loops. */
  name(program: (hasFile: boolean) => string): void {
    this.program = program;
    this.showCommand();
  }

  get asked(): LoopSettings | undefined {
    return this.isOn ? this.settings : undefined;
  }

  load(plan: Plan): void {
    this.plan = plan;
    this.slides = undefined;
    this.show();
  }

  /** Once the page has nothing else to ask of the engine. */
  planned(): void {
    if (this.isOn) void this.follow();
  }

  stand(time: number): void {
    this.time = time;
    if (this.slides !== undefined) this.draw();
  }

  private toggle(): void {
    this.isOn = !this.isOn;
    this.slides = undefined;
    this.calls.changed(this.settings);
    this.show();
    if (this.isOn) void this.follow();
  }

  private change(change: Partial<LoopSettings>): void {
    Object.assign(this.settings, change);
    this.calls.changed(this.settings);
    this.show();
    clearTimeout(this.typing);
    if (this.isOn) this.typing = window.setTimeout(() => void this.follow(), 200);
  }

  private async follow(): Promise<void> {
    const run = ++this.runs;
    const errors: FieldErrors = new Map();
    const options = optionsOf(this.settings, errors);
    if (errors.size > 0 || this.plan === undefined) return;
    this.element.dataset["state"] = "following";
    const found = await this.calls.follow(options);
    if (run !== this.runs || found === undefined) return;
    this.slides = "code" in found ? undefined : found;
    this.element.dataset["state"] = "code" in found ? "refused" : "followed";
    this.show();
    if ("code" in found) this.note.textContent = `${found.message}${found.hint === "" ? "" : `: ${found.hint}`}`;
  }

  private showCommand(): void {
    const { options, keys } = commandOf(this.settings);
    this.command.textContent = `leadscrew simulate ${this.program(keys !== "")}${options} --json`;
  }

  private show(): void {
    const { settings, slides } = this;
    const errors: FieldErrors = new Map();
    optionsOf(settings, errors);
    const uses = usesOf(settings);
    this.button.textContent = this.isOn ? "Leave" : "Follow";
    this.fields.show("loops-controller", settings.controller, true);
    this.fields.show("loops-encoder", settings.encoder, settings.controller !== "pulses");
    for (const [name, slid] of this.numbers) slid.show(settings[name], uses[name], "", errors.get(name));
    this.fields.show("loops-view", this.view, slides !== undefined);
    this.fields.show("loops-shows", this.signal, slides !== undefined);
    this.shown.hidden = slides === undefined;
    const { keys } = commandOf(settings);
    this.showCommand();
    this.note.textContent = this.isOn
      ? keys === ""
        ? ""
        : `The command has the same with ${keys} of the machine file, which Save gives under Machine.`
      : "Follow lets simulated drives follow the words, as leadscrew simulate does.";
    if (slides !== undefined) this.showFigures(slides);
    this.draw();
  }

  private showFigures({ figures, axes }: Slides): void {
    const micrometres = (value: number): string => `${fixed(value * 1000, 1)} µm`;
    put(this.figures, [
      ["Contour error", figures.contour < 0 ? "not told of rotary axes" : micrometres(figures.contour)],
      ["RMS contour error", figures.contour < 0 ? "" : micrometres(figures.contourRms)],
      ["Greatest feed", `${fixed(figures.feedGreatest, 2)} mm/s`],
      ...axes.flatMap((axis): [string, string][] => [
        [`${axisLetters[axis]} lags`, `${fixed(figures.greatest[axis] ?? 0, 4)} mm`],
        [`${axisLetters[axis]} overshoots`, `${fixed(figures.overshoot[axis] ?? 0, 4)} mm`],
      ]),
    ]);
  }

  redraw(): void {
    this.draw();
  }

  private get picture(): FollowedPicture | undefined {
    const { plan, slides, time, view, signal } = this;
    const look: Look = { time, view, signal };
    return plan === undefined || slides === undefined ? undefined : new FollowedPicture(plan, slides, look);
  }

  private draw(): void {
    const { picture } = this;
    if (picture === undefined || !this.element.isConnected) return;
    const sized = (canvas: HTMLCanvasElement): CanvasPicture => {
      const frame = canvas.parentElement;
      return new CanvasPicture(canvas, Math.max(160, frame?.clientWidth ?? 0), Math.max(120, frame?.clientHeight ?? 0));
    };
    picture.drawPart(sized(this.part));
    this.part.setAttribute("aria-label", this.text());
    picture.drawSignal(sized(this.strip));
    this.strip.setAttribute("aria-label", `${signals[this.signal]}, over time`);
  }

  /** What the part's picture shows. */
  private text(): string {
    const [u, v] = this.picture?.plane() ?? [0, 1];
    const plane = `${axisLetters[u]}${axisLetters[v]}`;
    return `The part in ${plane}, from position feedback over what was programmed, until ${fixed(this.time, 3)} s`;
  }

  private svgText(): string {
    const picture = new SvgPicture(800, 600, this.text());
    this.picture?.drawPart(picture);
    return picture.toString();
  }
}
