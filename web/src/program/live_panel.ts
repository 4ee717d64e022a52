// Where the running machine is, at which feed, in which state; and, for whoever has the token, hold, feed and stop.

import type { LiveMachine, LiveSample, LiveState, Wish } from "../engine/live_types";
import { fixed, html } from "../ui/dom";
import { put } from "./figures";
import { liveAddress, liveText, watch, wish } from "./live";

const stateNames: Readonly<Record<LiveState, string>> = {
  starting: "starting",
  moving: "moving",
  resting: "at rest",
  held: "held",
  hold_waits: "hold waits: in step with the spindle",
  hold_refused: "hold not obeyed (M53 P0)",
  paused: "paused",
  waiting: "waits for an input",
  stopping: "stopping",
};

/** Of what is driven; the program is empty where it cannot be read. */
export interface LiveTexts {
  readonly program: string;
  /** A machine file; empty for the built-in mill. */
  readonly machine: string;
  /** A tool table. */
  readonly tools: string;
}

export interface LivePanelCalls {
  began(machine: LiveMachine, texts: LiveTexts): void;
  moved(machine: LiveMachine, sample: LiveSample): void;
}

export class LivePanel {
  readonly element: HTMLElement;
  private machine: LiveMachine | undefined;
  private missed = 0;
  private held = false;
  private readonly said = html("p", { class: "note", id: "live-said", role: "status" }, "Looking for the machine");
  private readonly numbers = html("dl", { class: "numbers", id: "live", "aria-label": "The machine now" });
  private readonly follow = html("input", { type: "checkbox", id: "live-follow", checked: true });
  private readonly token = html("input", { type: "password", id: "live-token", autocomplete: "off" });
  private readonly hold = html("button", { type: "button", id: "live-hold" }, "Hold");
  private readonly feed = html("input", { type: "number", id: "live-feed", min: 10, max: 200, step: 10, value: 100 });
  private readonly error = html("p", { class: "error", id: "live-error", role: "alert" });
  private readonly controls: HTMLElement;

  /** Undefined where no machine is driven. */
  static ofPage(calls: LivePanelCalls): LivePanel | undefined {
    const address = liveAddress();
    return address === undefined ? undefined : new LivePanel(address, calls);
  }

  private constructor(
    private readonly address: string,
    private readonly calls: LivePanelCalls,
  ) {
    this.controls = this.controlPanel();
    this.element = html(
      "section",
      { class: "panel live", "aria-label": "Live" },
      html(
        "div",
        { class: "panel-head" },
        html("h2", {}, "Live"),
        html("label", { class: "choice", for: "live-follow" }, this.follow, "Follow it on the path and in the text"),
      ),
      this.numbers,
      this.said,
      this.controls,
      this.error,
    );
    watch(address, {
      began: (machine) => void this.begin(machine),
      moved: (sample) => this.move(sample),
      missed: (count) => (this.missed += count),
      lost: () => this.tell("lost", "The machine is not heard; looking for it"),
      ended: () => this.tell("ended", "It has ended"),
    });
  }

  private controlPanel(): HTMLElement {
    const button = (id: string, text: string, wanted: Wish): HTMLElement =>
      html("button", { type: "button", id, click: () => void this.ask(wanted) }, text);
    this.hold.addEventListener("click", () => void this.ask({ hold: !this.held }));
    this.feed.addEventListener("change", () => void this.ask({ override: Number(this.feed.value) / 100 }));
    return html(
      "div",
      { class: "tools", hidden: true },
      html("label", { class: "choice", for: "live-token" }, "Token", this.token),
      html("label", { class: "choice", for: "live-feed" }, "Feed, %", this.feed),
      html(
        "div",
        { class: "buttons" },
        this.hold,
        button("live-go-on", "Go on", { go_on: true }),
        button("live-stop", "Stop", { stop: true }),
      ),
    );
  }

  private async begin(machine: LiveMachine): Promise<void> {
    const isNew = this.machine === undefined;
    this.machine = machine;
    this.controls.hidden = !machine.may_control;
    this.tell("live", `${machine.program} on ${machine.machine}`);
    if (!isNew) return;
    try {
      const [program, file, tools] = await Promise.all([
        machine.has_text ? liveText(this.address, "program") : "",
        liveText(this.address, "machine"),
        liveText(this.address, "tools"),
      ]);
      this.calls.began(machine, { program, machine: file.trim(), tools: tools.trim() });
    } catch {
      // it is shown without its path
    }
  }

  private move(sample: LiveSample): void {
    const { machine } = this;
    if (machine === undefined) return;
    this.held = ["held", "hold_waits", "hold_refused"].includes(sample.state);
    this.hold.textContent = this.held ? "Resume" : "Hold";
    const state = stateNames[sample.state];
    put(this.numbers, [
      ["State", sample.pause_line === null ? state : `${state}, line ${sample.pause_line}`],
      ["Line", String(sample.line)],
      ...machine.axes.map(({ name }, i): [string, string] => [name, fixed(sample.actual[i] ?? 0, 3)]),
      ["Feed, /min", fixed(sample.feed * 60, 0)],
      ["Measured", fixed(sample.measured_feed * 60, 0)],
      ["Behind", fixed(sample.following_error, 4)],
      ["Override", `${fixed(sample.override * 100, 0)} %`],
      ["Missed", String(this.missed)],
    ]);
    this.element.dataset["machine"] = sample.state;
    if (this.follow.checked) this.calls.moved(machine, sample);
  }

  private tell(state: string, text: string): void {
    this.element.dataset["state"] = state;
    this.said.textContent = text;
  }

  private async ask(wanted: Wish): Promise<void> {
    const refusal = await wish(this.address, this.token.value.trim(), wanted);
    this.error.textContent = refusal === "" ? "" : `Not obeyed: ${refusal}`;
  }
}
