// One clock for all lanes: steps, runs, the scrub bar.

import { html } from "../ui/dom";

export interface TransportEvents {
  seek(clock: number): void;
  step(by: 1 | -1): void;
  toggle(): void;
  interval(text: string): void;
}

export class Transport {
  readonly element: HTMLElement;
  private readonly scrub: HTMLInputElement;
  private readonly position = html("output", { class: "number", id: "position" });
  private readonly runs: HTMLButtonElement;
  private readonly interval: HTMLInputElement;
  private readonly error = html("p", { class: "error", id: "interval-error", role: "alert" });

  constructor(events: TransportEvents) {
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
    this.interval = html("input", {
      id: "interval",
      type: "text",
      inputmode: "decimal",
      autocomplete: "off",
      maxlength: 10,
      "aria-describedby": "interval-error",
      input: () => events.interval(this.interval.value),
    });
    this.element = html(
      "section",
      { class: "panel", "aria-label": "Clock" },
      html(
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
        html("label", { class: "scrub", for: "scrub" }, html("span", {}, "Clock"), this.scrub, this.position),
        html("label", { class: "inline", for: "interval" }, "Interval, s", this.interval),
      ),
      this.error,
    );
  }

  update(clock: number, last: number, isRunning: boolean, interval: string, error: string): void {
    this.scrub.max = String(last);
    this.scrub.value = String(clock);
    this.scrub.setAttribute("aria-valuetext", `clock ${clock} of ${last}`);
    this.position.textContent = `${clock} of ${last}`;
    this.runs.textContent = isRunning ? "Pause" : "Run";
    this.runs.disabled = last === 0;
    if (document.activeElement !== this.interval) this.interval.value = interval;
    this.error.textContent = error;
    if (error === "") this.interval.removeAttribute("aria-invalid");
    else this.interval.setAttribute("aria-invalid", "true");
  }
}
