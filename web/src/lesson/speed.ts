// The panel of speed: the interval between cycles, single steps forward and back, the scrub bar, breakpoints.

import { fixed, html } from "../ui/dom";
import { Transport } from "../ui/transport";
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
  private readonly transport: Transport;
  private readonly time = html("output", { class: "number", id: "interpolation-time" });
  private readonly modes: HTMLInputElement[];
  private readonly atPulse: HTMLInputElement;
  private readonly atBorder: HTMLInputElement;
  private readonly borderRow: HTMLElement;
  private readonly borderButton: HTMLButtonElement;

  constructor(private readonly events: SpeedEvents) {
    this.transport = new Transport("Cycle", {
      seek: (clock) => events.seek(clock),
      step: (by) => events.step(by),
      toggle: () => events.toggle(),
      interval: (interval) => events.change({ interval }),
    });
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
      this.transport.bar,
      html(
        "div",
        { class: "pace" },
        html(
          "div",
          { class: "choices", role: "radiogroup", "aria-label": "How cycles are triggered" },
          html("label", { class: "choice", for: "mode-automatic" }, automatic, "Automatic"),
          html("label", { class: "choice", for: "mode-single" }, single, "Single step"),
        ),
        this.transport.interval,
        html("label", { class: "choice", for: "stop-pulse" }, this.atPulse, "Stop before a pulse"),
        this.borderRow,
      ),
      this.transport.error,
      html(
        "div",
        { class: "buttons" },
        this.button("next-pulse", "To the next pulse", () => this.events.nextPulse()),
        this.borderButton,
      ),
    ];
  }

  update(settings: Settings, session: Session, errors: FieldErrors): void {
    for (const mode of this.modes) mode.checked = mode.value === settings.run;
    this.atPulse.checked = settings.stopAtPulse;
    this.atBorder.checked = settings.stopAtBorder;
    const isArc = settings.module === "arc";
    this.borderRow.hidden = !isArc;
    this.borderButton.hidden = !isArc;
    this.time.textContent = `${fixed(session.elapsed, 2)} s`;
    this.transport.update({
      clock: session.clock,
      last: session.last,
      isRunning: session.state === "running" || session.state === "waiting",
      mayRun: session.state !== "empty" && settings.run !== "single",
      interval: settings.interval,
      error: errors.get("interval"),
    });
  }

  private button(id: string, text: string, press: () => void): HTMLButtonElement {
    return html("button", { type: "button", id, click: press }, text);
  }

  private check(id: string, change: (on: boolean) => void): HTMLInputElement {
    const input = html("input", { type: "checkbox", id, change: () => change(input.checked) });
    return input;
  }
}
