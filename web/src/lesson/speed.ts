// The panel of speed: the interval between cycles, single steps forward and back, the scrub bar, breakpoints.

import { fixed, html } from "../ui/dom";
import type { Session } from "./session";
import type { FieldErrors, Settings } from "./settings";

export interface SpeedEvents {
  change(change: Partial<Settings>): void;
  seek(clock: number): void;
  step(by: 1 | -1): void;
  toggle(): void;
  nextPulse(): void;
  nextBorder(): void;
}

export class Speed {
  readonly element: HTMLElement;
  private readonly interval: HTMLInputElement;
  private readonly error = html("p", { class: "error", id: "interval-error", role: "alert" });
  private readonly time = html("output", { class: "number", id: "interpolation-time" });
  private readonly position = html("output", { class: "number", id: "position" });
  private readonly scrub: HTMLInputElement;
  private readonly runs: HTMLButtonElement;
  private readonly modes: HTMLInputElement[];
  private readonly atPulse: HTMLInputElement;
  private readonly atBorder: HTMLInputElement;
  private readonly borderRow: HTMLElement;
  private readonly borderButton: HTMLButtonElement;

  constructor(private readonly events: SpeedEvents) {
    this.interval = html("input", {
      id: "interval",
      type: "text",
      inputmode: "decimal",
      autocomplete: "off",
      maxlength: 10,
      "aria-describedby": "interval-error",
      input: () => events.change({ interval: this.interval.value }),
    });
    this.scrub = html("input", {
      id: "scrub",
      type: "range",
      min: 0,
      max: 0,
      step: 1,
      value: 0,
      input: () => events.seek(Number(this.scrub.value)),
    });
    this.runs = this.button("run", "Run", () => events.toggle(), "primary");
    this.borderButton = this.button("next-border", "To the next border", () => events.nextBorder());
    this.modes = (["automatic", "single"] as const).map((value) =>
      html("input", {
        type: "radio",
        name: "run-mode",
        id: `mode-${value}`,
        value,
        change: () => events.change({ run: value }),
      }),
    );
    this.atPulse = this.check("stop-pulse", (on) => events.change({ stopAtPulse: on }));
    this.atBorder = this.check("stop-border", (on) => events.change({ stopAtBorder: on }));
    this.borderRow = html(
      "label",
      { class: "choice", for: "stop-border" },
      this.atBorder,
      "Stop at a quadrant's border",
    );
    this.element = html("section", { class: "panel speed", "aria-labelledby": "speed" }, ...this.content());
  }

  private content(): HTMLElement[] {
    const [automatic, single] = this.modes;
    return [
      html(
        "div",
        { class: "panel-head" },
        html("h2", { id: "speed" }, "Speed"),
        html("p", { class: "clock" }, html("span", {}, "Interpolation time"), this.time),
      ),
      html(
        "div",
        { class: "transport" },
        html(
          "div",
          { class: "buttons" },
          this.button("first", "First", () => this.events.seek(0)),
          this.button("back", "Back", () => this.events.step(-1)),
          this.runs,
          this.button("step", "Step", () => this.events.step(1)),
          this.button("last", "Last", () => this.events.seek(Number.MAX_SAFE_INTEGER)),
        ),
        html("label", { class: "scrub", for: "scrub" }, html("span", {}, "Cycle"), this.scrub, this.position),
      ),
      html(
        "div",
        { class: "pace" },
        html(
          "div",
          { class: "choices", role: "radiogroup", "aria-label": "How cycles are triggered" },
          html("label", { class: "choice", for: "mode-automatic" }, automatic, "Automatic"),
          html("label", { class: "choice", for: "mode-single" }, single, "Single step"),
        ),
        html("label", { class: "inline", for: "interval" }, "Interval, s", this.interval),
        html("label", { class: "choice", for: "stop-pulse" }, this.atPulse, "Stop before a pulse"),
        this.borderRow,
      ),
      this.error,
      html(
        "div",
        { class: "buttons" },
        this.button("next-pulse", "To the next pulse", () => this.events.nextPulse()),
        this.borderButton,
      ),
    ];
  }

  update(settings: Settings, session: Session, errors: FieldErrors): void {
    if (document.activeElement !== this.interval) this.interval.value = settings.interval;
    const error = errors.get("interval");
    this.error.textContent = error ?? "";
    if (error === undefined) this.interval.removeAttribute("aria-invalid");
    else this.interval.setAttribute("aria-invalid", "true");
    for (const mode of this.modes) mode.checked = mode.value === settings.run;
    this.atPulse.checked = settings.stopAtPulse;
    this.atBorder.checked = settings.stopAtBorder;
    const isArc = settings.module === "arc";
    this.borderRow.hidden = !isArc;
    this.borderButton.hidden = !isArc;
    this.scrub.max = String(session.last);
    this.scrub.value = String(session.clock);
    this.scrub.setAttribute("aria-valuetext", `cycle ${session.clock} of ${session.last}`);
    this.position.textContent = `${session.clock} of ${session.last}`;
    this.time.textContent = `${fixed(session.elapsed, 2)} s`;
    const isBusy = session.state === "running" || session.state === "waiting";
    this.runs.textContent = isBusy ? "Pause" : "Run";
    this.runs.disabled = session.state === "empty" || settings.run === "single";
  }

  private button(id: string, text: string, press: () => void, className = ""): HTMLButtonElement {
    return html("button", { type: "button", id, class: className, click: press }, text);
  }

  private check(id: string, change: (on: boolean) => void): HTMLInputElement {
    const input = html("input", { type: "checkbox", id, change: () => change(input.checked) });
    return input;
  }
}
