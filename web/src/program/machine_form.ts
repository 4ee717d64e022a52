// The machine: the built-in mill, or that of a file; what it can do, to be changed; its tools.

import { axisLetters, type Limits } from "../engine/motion_types";
import { html } from "../ui/dom";
import type { Settings } from "./settings";

const columns = [
  ["velocity", "Velocity", "mm/s"],
  ["acceleration", "Acceleration", "mm/s²"],
  ["jerk", "Jerk", "mm/s³"],
] as const;

const largestFile = 512 * 2 ** 10; // bytes, as the engine has it

export interface MachineCalls {
  changed(limits: Limits, override: number): void;
  /** A machine file; empty for the built-in mill. */
  opened(machine: string): void;
  /** A tool table. */
  equipped(tools: string): void;
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
  private readonly rows = html("tbody", {});
  private readonly refused = html("p", { class: "error", id: "machine-file-error", role: "alert" });
  private readonly name = html("p", { class: "note", id: "machine-name" });
  private readonly file = this.fileInput("machine-file", "Machine file", ".toml", (text) => this.calls.opened(text));
  private readonly toolFile = this.fileInput("tool-file", "Tool table", ".tbl,.txt", (text) =>
    this.calls.equipped(text),
  );
  private readonly tools = html("textarea", {
    id: "tools",
    rows: 3,
    spellcheck: "false",
    "aria-label": "Tool table, a line a tool: T4 P4 D10 R5 Z0",
    placeholder: "T4 P4 D10 R5 Z0",
    change: () => this.calls.equipped(this.tools.value),
  });
  private machine: Limits | undefined;
  private axes: number[] = [];

  constructor(private readonly calls: MachineCalls) {
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
          html("button", { type: "button", id: "machine-open", click: () => this.file.click() }, "Open"),
          html("button", { type: "button", id: "machine-reset", click: () => this.reset() }, "As built in"),
          html("button", { type: "button", id: "machine-save", click: () => calls.saved() }, "Save"),
        ),
      ),
      this.name,
      this.refused,
      this.file,
      this.toolFile,
      this.table(),
      html(
        "div",
        { class: "machine-more" },
        html("label", { for: "limit-tolerance" }, "Tolerance, mm"),
        this.field("tolerance", "Tolerance, mm", "limit-tolerance"),
        html("label", { for: "override" }, "Feed override"),
        html("div", { class: "scrub" }, this.override, this.overrideText),
        html("label", { for: "tools" }, "Tools"),
        html(
          "div",
          { class: "tool-table" },
          this.tools,
          html("button", { type: "button", id: "tools-open", click: () => this.toolFile.click() }, "Open"),
        ),
      ),
      this.error,
    );
  }

  /** Of this machine, with what was changed of it. */
  show(machine: Limits, { machine: file, limits, tools, override }: Settings): void {
    if (this.machine?.axes !== machine.axes) this.fill(machine.axes);
    this.machine = machine;
    this.refuse("");
    this.name.textContent = file === "" ? "" : (/^\s*name\s*=\s*"([^"]*)"/m.exec(file)?.[1] ?? "A machine of a file");
    for (const axis of this.axes)
      for (const [name] of columns) this.put(`${name}-${axisLetters[axis]}`, limits[name][axis] ?? 0);
    this.put("tolerance", limits.tolerance);
    this.tools.value = tools;
    this.override.value = String(override);
    this.told();
    this.complain("", "");
  }

  /** What is wrong with a file that was opened: the machine stays. */
  refuse(message: string): void {
    this.refused.textContent = message;
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
      this.rows,
    );
  }

  /** A row an axis. */
  private fill(axes: number): void {
    for (const axis of this.axes) for (const [name] of columns) this.fields.delete(`${name}-${axisLetters[axis]}`);
    this.axes = [...axisLetters].map((_, i) => i).filter((i) => (axes >> i) & 1);
    this.rows.replaceChildren(
      ...this.axes.map((axis) => {
        const letter = axisLetters[axis] ?? "";
        const isRotary = "ABC".includes(letter);
        return html(
          "tr",
          {},
          html("th", { scope: "row" }, isRotary ? `${letter}, °` : letter),
          ...columns.map(([name, title, unit]) => {
            const key = `${name}-${letter}`;
            const label = `${title} of ${letter}, ${isRotary ? unit.replace("mm", "°") : unit}`;
            return html("td", {}, this.field(key, label, `limit-${key}`));
          }),
        );
      }),
    );
  }

  private fileInput(id: string, label: string, accept: string, taken: (text: string) => void): HTMLInputElement {
    const input: HTMLInputElement = html("input", {
      type: "file",
      id,
      class: "hidden",
      tabindex: -1,
      "aria-label": label,
      accept,
      change: () => {
        const file = input.files?.[0];
        if (file !== undefined && file.size <= largestFile) void file.text().then(taken);
        else if (file !== undefined) this.refuse(`${file.name} is larger than 512 KiB`);
        input.value = "";
      },
    });
    return input;
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
    this.override.value = "100";
    this.told();
    this.calls.opened("");
  }

  /** All of it, unless something is no number. */
  private read(): void {
    if (this.machine === undefined) return;
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
