// A page of lanes, whatever they are of: forms on one side; on the other one clock, one camera, figures, files and commands. It
// keeps the link that brings all of it back.

import { download } from "../lesson/files";
import { quantity } from "../lesson/settings";
import { html } from "../ui/dom";
import { Player } from "../ui/player";
import { Transport } from "../ui/transport";
import type { Camera, Layout, Scene, View } from "./scene";
import { Stage, type Strip } from "./stage";

/** What a state has of every page of lanes. */
export interface LaneView {
  layout: Layout;
  /** Undefined: the whole curve. */
  camera: Camera | undefined;
}

export interface LanePageParts {
  /** Of its element, beside those of every page of lanes. */
  readonly kind: string;
  /** Of files: leadscrew-NAME.svg. */
  readonly name: string;
  readonly forms: readonly HTMLElement[];
  readonly strips: readonly Strip[];
  /** So many units across at the nearest. */
  readonly least: number;
  readonly table: { readonly element: HTMLElement; csv(): string };
  /** Beside pictures and figures: id, text, what writes it. */
  readonly files: readonly (readonly [id: string, text: string, save: () => void])[];
  /** s between two clocks, such as "0.1". */
  readonly exampleInterval: string;
}

export interface LanePageEvents {
  /** What is set now, with the clock where it stands. */
  link(): string;
  /** The address has another link. */
  restore(): void;
  /** s between two clocks, as it was typed. */
  interval(): string;
  setInterval(text: string): void;
  view(): LaneView;
  /** The clock, the camera or the layout has changed. */
  show(): void;
}

/** What the lanes are at the clock. */
export interface LanesShown {
  readonly scene: Scene;
  readonly count: number;
  /** What the picture shows, in words. */
  readonly text: string;
  readonly commands: readonly string[];
}

const linkPause = 300; // ms; the browser takes a few changes of the address a second

export class LanePage {
  readonly element: HTMLElement;
  readonly player: Player;
  private readonly transport: Transport;
  private readonly stage: Stage;
  private readonly commands = html("pre", { id: "commands", tabindex: 0 });
  private loads = 0;
  private linkTimer = 0;

  constructor(
    private readonly parts: LanePageParts,
    private readonly events: LanePageEvents,
  ) {
    this.player = new Player({ changed: () => events.show(), pace: () => quantity(events.interval()) });
    const seek = (clock: number): void => this.player.seek(clock);
    this.transport = new Transport("Clock", {
      seek,
      step: (by) => this.player.step(by),
      toggle: () => this.player.toggle(),
      interval: (text) => {
        events.setInterval(text);
        events.show();
      },
    });
    const set = (view: Partial<LaneView>): void => {
      Object.assign(events.view(), view);
      events.show();
    };
    const look = { look: (camera: Camera | undefined) => set({ camera }), layout: (layout: Layout) => set({ layout }) };
    this.stage = new Stage({ seek, ...look }, parts.strips, parts.least);
    this.element = html("div", { class: `lesson compare ${parts.kind}` }, ...this.content());
    addEventListener("hashchange", () => location.hash === events.link() || events.restore());
    document.addEventListener("keydown", (event) =>
      this.player.key(event, "input, select, textarea, .path-frame, .figures"),
    );
  }

  private content(): HTMLElement[] {
    this.transport.bar.append(this.transport.interval);
    return [
      html("div", { class: "side" }, ...this.parts.forms),
      html(
        "div",
        { class: "main" },
        html("section", { class: "panel", "aria-label": "Clock" }, this.transport.bar, this.transport.error),
        html("div", { class: "display" }, this.stage.element, this.figures()),
      ),
    ];
  }

  private figures(): HTMLElement {
    const { table, files, name } = this.parts;
    const button = (id: string, text: string, press: () => void): HTMLElement =>
      html("button", { type: "button", id, click: press }, text);
    const copy = (id: string, text: string, what: () => string): HTMLElement =>
      button(id, text, () => void navigator.clipboard?.writeText(what()));
    const savePicture = async (): Promise<void> =>
      download(`leadscrew-${name}.png`, await this.stage.png(), "image/png");
    return html(
      "section",
      { class: "panel", "aria-labelledby": "figures-title" },
      html("h2", { id: "figures-title" }, "Figures until this clock"),
      table.element,
      html(
        "div",
        { class: "buttons" },
        button("save-svg", "SVG", () => download(`leadscrew-${name}.svg`, this.stage.svg(), "image/svg+xml")),
        button("save-png", "PNG", () => void savePicture()),
        button("save-csv", "CSV", () => download(`leadscrew-${name}.csv`, table.csv(), "text/csv")),
        ...files.map(([id, text, save]) => button(id, text, save)),
        copy("copy-link", "Copy link", () => location.href),
        copy("copy-commands", "Copy commands", () => this.commands.textContent ?? ""),
      ),
      this.commands,
    );
  }

  /** After the colours have changed. */
  redraw(): void {
    this.stage.draw();
  }

  /** Lanes are being made anew: the number by which this making is known. */
  begin(): number {
    this.element.dataset["loading"] = String(++this.loads);
    return this.loads;
  }

  /** False where another making has begun since. */
  isCurrent(load: number): boolean {
    return load === this.loads;
  }

  /** Lanes are made, the longest of so many clocks. */
  loaded(load: number, last: number, clock: number): void {
    this.player.load(last, clock);
    this.element.dataset["loaded"] = String(load);
    this.events.show();
  }

  show({ scene, count, text, commands }: LanesShown): void {
    const { clock, last, isRunning } = this.player;
    this.element.dataset["clock"] = String(clock);
    this.element.dataset["state"] = isRunning ? "running" : "stopped";
    this.element.dataset["lanes"] = String(count);
    const interval = this.events.interval();
    const pace = quantity(interval);
    const example = this.parts.exampleInterval;
    const error = pace >= 0 && pace <= 60 ? "" : `the interval is 0 (as fast as can be) to 60 s, such as ${example}`;
    this.transport.update({ clock, last, isRunning, mayRun: last > 0, interval, error });
    const view: View = this.events.view();
    this.stage.update(scene, view, clock, text);
    this.commands.textContent = commands.join("\n");
    this.keepLink();
  }

  private keepLink(): void {
    if (this.linkTimer !== 0) return;
    this.linkTimer = window.setTimeout(() => {
      this.linkTimer = 0;
      history.replaceState(null, "", this.events.link());
    }, linkPause);
  }
}
