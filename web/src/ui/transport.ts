// What moves along a recording: steps forward and back, run and pause, the scrub bar, the interval between cycles.

import { html } from "./dom";

export interface TransportEvents {
  seek(clock: number): void;
  step(by: 1 | -1): void;
  toggle(): void;
  interval(text: string): void;
}

export interface TransportState {
  readonly clock: number;
  readonly last: number;
  readonly isRunning: boolean;
  readonly mayRun: boolean;
  /** As it was typed, s; and what is wrong with it. */
  readonly interval: string;
  readonly error?: string | undefined;
}

export class Transport {
  /** Buttons and the scrub bar. */
  readonly bar: HTMLElement;
  readonly interval: HTMLElement;
  readonly error = html("p", { class: "error", id: "interval-error", role: "alert" });
  private readonly scrub: HTMLInputElement;
  private readonly position = html("output", { class: "number", id: "position" });
  private readonly runs: HTMLButtonElement;
  private readonly field: HTMLInputElement;

  /** `unit`: what is counted. */
  constructor(
    private readonly unit: "Clock" | "Cycle",
    events: TransportEvents,
  ) {
    const button = (id: string, text: string, press: () => void, className = ""): HTMLButtonElement =>
      html("button", { type: "button", id, class: className, click: press }, text);
    this.scrub = html("input", {
      id: "scrub",
      type: "range",
      min: 0,
      max: 0,
      step: 1,
      value: 0,
      input: () => events.seek(Number(this.scrub.value)),
    });
    this.runs = button("run", "Run", () => events.toggle(), "primary");
    this.field = html("input", {
      id: "interval",
      type: "text",
      inputmode: "decimal",
      autocomplete: "off",
      maxlength: 10,
      "aria-describedby": "interval-error",
      input: () => events.interval(this.field.value),
    });
    this.interval = html("label", { class: "inline", for: "interval" }, "Interval, s", this.field);
    this.bar = html(
      "div",
      { class: "transport" },
      html(
        "div",
        { class: "buttons" },
        button("first", "First", () => events.seek(0)),
        button("back", "Back", () => events.step(-1)),
        this.runs,
        button("step", "Step", () => events.step(1)),
        button("last", "Last", () => events.seek(Number.MAX_SAFE_INTEGER)),
      ),
      html("label", { class: "scrub", for: "scrub" }, html("span", {}, unit), this.scrub, this.position),
    );
  }

  update(state: TransportState): void {
    const { clock, last } = state;
    this.scrub.max = String(last);
    this.scrub.value = String(clock);
    this.scrub.setAttribute("aria-valuetext", `${this.unit.toLowerCase()} ${clock} of ${last}`);
    this.position.textContent = `${clock} of ${last}`;
    this.runs.textContent = state.isRunning ? "Pause" : "Run";
    this.runs.disabled = !state.mayRun;
    if (document.activeElement !== this.field) this.field.value = state.interval;
    this.error.textContent = state.error ?? "";
    if (state.error) this.field.setAttribute("aria-invalid", "true");
    else this.field.removeAttribute("aria-invalid");
  }
}
