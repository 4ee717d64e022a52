// What the machine can do, to be changed: each axis' limits, the tolerance, the feed override.

import { axisLetters, type Limits } from "../engine/motion_types";
import { html } from "../ui/dom";

const columns = [
  ["velocity", "Velocity", "mm/s"],
  ["acceleration", "Acceleration", "mm/s²"],
  ["jerk", "Jerk", "mm/s³"],
] as const;

export interface MachineCalls {
  changed(limits: Limits, override: number): void;
  saved(): void;
}

function parsed(text: string): number {
  return text.trim() === "" ? NaN : Number(text.trim().replace(",", "."));
}

export class MachineForm {
  readonly element: HTMLElement;
  private readonly fields = new Map<string, HTMLInputElement>();
  private readonly error = html("p", { class: "error", id: "machine-error", role: "alert" });
  private readonly override = html("input", {
    type: "range",
    id: "override",
    min: 1,
    max: 200,
    step: 1,
    "aria-label": "Feed override, %",
    input: () => this.told(),
    change: () => this.read(),
  });
  private readonly overrideText = html("output", { class: "number", for: "override" });
  private readonly axes: number[];

  constructor(
    private readonly machine: Limits,
    private readonly calls: MachineCalls,
  ) {
    this.axes = [...axisLetters].map((_, i) => i).filter((i) => (machine.axes >> i) & 1);
    this.element = html(
      "section",
      { class: "panel machine", "aria-label": "Machine" },
      html(
        "div",
        { class: "panel-head" },
        html("h2", {}, "Machine"),
        html(
          "div",
          { class: "buttons" },
          html("button", { type: "button", id: "machine-reset", click: () => this.reset() }, "As built in"),
          html("button", { type: "button", id: "machine-save", click: () => calls.saved() }, "Save"),
        ),
      ),
      this.table(),
      html(
        "div",
        { class: "machine-more" },
        html("label", { for: "limit-tolerance" }, "Tolerance, mm"),
        this.field("tolerance", "Tolerance, mm", "limit-tolerance"),
        html("label", { for: "override" }, "Feed override"),
        html("div", { class: "scrub" }, this.override, this.overrideText),
      ),
      this.error,
    );
  }

  show(limits: Limits, override: number): void {
    for (const axis of this.axes)
      for (const [name] of columns) this.put(`${name}-${axisLetters[axis]}`, limits[name][axis] ?? 0);
    this.put("tolerance", limits.tolerance);
    this.override.value = String(override);
    this.told();
    this.complain("", "");
  }

  /** What the engine has against it. */
  complain(field: string, message: string): void {
    this.error.textContent = message;
    const [name, axis] = field.split(".");
    for (const [key, input] of this.fields) {
      const isIt = message !== "" && key === (axis === undefined ? name : `${name}-${axis.toUpperCase()}`);
      if (isIt) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
    }
  }

  private table(): HTMLElement {
    return html(
      "table",
      { class: "limits" },
      html(
        "thead",
        {},
        html(
          "tr",
          {},
          html("th", { scope: "col" }, "Axis"),
          ...columns.map(([, title, unit]) => html("th", { scope: "col" }, title, html("br"), unit)),
        ),
      ),
      html(
        "tbody",
        {},
        ...this.axes.map((axis) =>
          html(
            "tr",
            {},
            html("th", { scope: "row" }, axisLetters[axis]),
            ...columns.map(([name, title, unit]) => {
              const key = `${name}-${axisLetters[axis]}`;
              return html("td", {}, this.field(key, `${title} of ${axisLetters[axis]}, ${unit}`, `limit-${key}`));
            }),
          ),
        ),
      ),
    );
  }

  private field(key: string, label: string, id: string): HTMLInputElement {
    const input = html("input", {
      type: "text",
      inputmode: "decimal",
      id,
      "aria-label": label,
      "aria-describedby": "machine-error",
      change: () => this.read(),
    });
    this.fields.set(key, input);
    return input;
  }

  private put(key: string, value: number): void {
    const input = this.fields.get(key);
    if (input !== undefined) input.value = String(value);
  }

  private told(): void {
    this.overrideText.value = `${this.override.value} %`;
  }

  private reset(): void {
    this.show(this.machine, 100);
    this.read();
  }

  /** All of it, unless something is no number. */
  private read(): void {
    const limits: Limits = {
      ...this.machine,
      velocity: [...this.machine.velocity],
      acceleration: [...this.machine.acceleration],
      jerk: [...this.machine.jerk],
    };
    for (const [key, input] of this.fields) {
      const value = parsed(input.value);
      const [name, letter] = key.split("-");
      if (!(value > 0) && !(key === "tolerance" && value === 0)) {
        const field = letter === undefined ? key : `${name}.${letter.toLowerCase()}`;
        return this.complain(field, `${input.getAttribute("aria-label")}: a number above 0, such as 200`);
      }
      if (letter === undefined) limits.tolerance = value;
      else limits[name as "jerk"][axisLetters.indexOf(letter)] = value;
    }
    this.complain("", "");
    this.calls.changed(limits, Number(this.override.value));
  }
}
