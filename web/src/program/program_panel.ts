// The text of the program, where it comes from, and what is wrong with it.

import type { Diagnostic } from "../engine/motion_types";
import { html } from "../ui/dom";
import type { Editor } from "./editor";
import { exampleOf, examples, type Example } from "./examples";
import type { Settings } from "./settings";

const largestFile = 64 * 2 ** 20; // bytes
const mostListed = 100;

export interface ProgramCalls {
  open(name: string, text: string): void;
  example(example: Example): void;
  save(): void;
}

export class ProgramPanel {
  readonly element: HTMLElement;
  private readonly choice = html("select", { id: "example", "aria-label": "Example", change: () => this.choose() });
  private readonly file = html("input", {
    type: "file",
    id: "file",
    class: "hidden",
    tabindex: -1,
    "aria-label": "Part program",
    accept: ".ngc,.nc,.tap,.gcode,.cnc,.txt",
    change: () => void this.take(this.file.files?.[0]),
  });
  private readonly found = html("ul", { class: "found", id: "found", "aria-label": "What is wrong" });
  private readonly count = html("p", { class: "note", id: "found-count", role: "status" });

  constructor(
    private readonly editor: Editor,
    private readonly calls: ProgramCalls,
  ) {
    this.choice.append(new Option("Own program", ""));
    for (const { name, title } of examples) this.choice.append(new Option(title, name));
    this.element = html(
      "section",
      { class: "panel source", "aria-label": "Program" },
      html(
        "div",
        { class: "panel-head" },
        html("h2", {}, "Program"),
        html(
          "div",
          { class: "buttons" },
          html("button", { type: "button", id: "open", click: () => this.file.click() }, "Open"),
          html("button", { type: "button", id: "save", click: () => calls.save() }, "Save"),
        ),
      ),
      this.choice,
      this.file,
      editor.element,
      this.count,
      this.found,
    );
    this.listen();
  }

  show(settings: Settings): void {
    this.choice.value = exampleOf(settings.text)?.name ?? "";
    const own = this.choice.options[0];
    if (own !== undefined) own.textContent = this.choice.value === "" ? settings.name : "Own program";
  }

  list(diagnostics: readonly Diagnostic[]): void {
    const of = (severity: number): number => diagnostics.filter((each) => each.severity === severity).length;
    const [errors, warnings] = [of(2), of(1)];
    this.count.textContent =
      diagnostics.length === 0
        ? "Nothing is wrong with it"
        : `${errors} ${errors === 1 ? "error" : "errors"}, ${warnings} ${warnings === 1 ? "warning" : "warnings"}`;
    this.found.replaceChildren(
      ...diagnostics
        .slice(0, mostListed)
        .map(({ severity, line, column, code, message, hint }) =>
          html(
            "li",
            { "data-severity": severity, "data-code": code },
            html(
              "button",
              { type: "button", class: "link", click: () => this.editor.goTo(line, column) },
              line === 0 ? "program" : `${line}:${column}`,
            ),
            html("span", {}, ` ${message}${hint === "" ? "" : `: ${hint}`}`),
          ),
        ),
    );
  }

  private choose(): void {
    const example = examples.find(({ name }) => name === this.choice.value);
    if (example !== undefined) this.calls.example(example);
  }

  private async take(file: File | undefined): Promise<void> {
    if (file === undefined) return;
    this.file.value = "";
    if (file.size > largestFile) {
      this.count.textContent = `${file.name} is larger than 64 MiB; the command has no such limit`;
      return;
    }
    this.calls.open(file.name, await file.text());
  }

  private listen(): void {
    this.element.addEventListener("dragover", (event) => {
      event.preventDefault();
      this.element.classList.add("over");
    });
    this.element.addEventListener("dragleave", () => this.element.classList.remove("over"));
    this.element.addEventListener(
      "drop",
      (event) => {
        this.element.classList.remove("over");
        const file = event.dataTransfer?.files[0];
        if (file === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        void this.take(file);
      },
      { capture: true },
    );
  }
}
