// What is shown as files, and the command that gives the same words.

import { download } from "../lesson/files";
import type { Diagnostic, Limits } from "../engine/motion_types";
import { html } from "../ui/dom";
import { commandOf, type Settings } from "./settings";

export interface TimesEvents {
  svgText(): string;
  pngBlob(): Promise<Blob>;
  /** A row a sample; undefined where there is no motion. */
  csv(): Blob | undefined;
}

export interface FilesEvents {
  /** Every word; undefined where there is no motion. */
  trace(): Promise<Blob | undefined>;
  /** Step and direction of every axis, a value-change dump, or why drives cannot have them. */
  steps(): Promise<Blob | Diagnostic | undefined>;
  /** The path as it is seen. */
  svg(): string;
  png(): Promise<Blob>;
  /** What is shown over time. */
  times: TimesEvents;
}

export class FilesPanel {
  readonly element: HTMLElement;
  private readonly command = html("code", { class: "command", id: "command", tabindex: 0, "aria-label": "Command" });
  private readonly note = html("p", { class: "note" });
  private readonly refusal = html("p", { class: "error", id: "steps-error", role: "alert" });
  private name = "program";

  constructor(events: FilesEvents) {
    const save = (id: string, text: string, ending: string, type: string, made: () => FileContent): HTMLElement =>
      html(
        "button",
        {
          type: "button",
          id,
          click: () =>
            void Promise.resolve(made()).then((content) => {
              if (content !== undefined) download(`${this.name}.${ending}`, content, type);
            }),
        },
        text,
      );
    const buttons = [
      save("export-csv", "Words, CSV", "csv", "text/csv", () => events.trace()),
      save("export-vcd", "Pulses, VCD", "vcd", "text/plain", () => this.sound(events.steps())),
      save("export-svg", "Path, SVG", "svg", "image/svg+xml", () => events.svg()),
      save("export-png", "Path, PNG", "png", "image/png", () => events.png()),
      save("times-svg", "Over time, SVG", "time.svg", "image/svg+xml", () => events.times.svgText()),
      save("times-png", "Over time, PNG", "time.png", "image/png", () => events.times.pngBlob()),
      save("times-csv", "Over time, CSV", "time.csv", "text/csv", () => events.times.csv()),
      html(
        "button",
        { type: "button", id: "copy-link", click: () => void navigator.clipboard?.writeText(location.href) },
        "Copy link",
      ),
    ];
    this.element = html(
      "section",
      { class: "panel exports", "aria-label": "Files" },
      html("h2", {}, "Files and the command"),
      html("div", { class: "buttons" }, ...buttons),
      this.command,
      this.note,
      this.refusal,
    );
  }

  /** What is wrong is told. */
  private async sound(made: Promise<Blob | Diagnostic | undefined>): Promise<Blob | undefined> {
    const steps = await made;
    const isWrong = steps !== undefined && "code" in steps;
    this.refusal.textContent = isWrong ? `No pulses: ${steps.message}: ${steps.hint}` : "";
    return isWrong ? undefined : steps;
  }

  /** Of these settings, whose machine is `machine` without changes; as they were recorded, or planned here. */
  show(settings: Settings, machine: Limits, isRecorded: boolean): void {
    this.refusal.textContent = "";
    this.name = settings.name.replace(/\.\w+$/, "");
    const command = commandOf(settings, machine, isRecorded);
    this.command.textContent = command;
    this.note.textContent = [
      command.includes("--machine") ? "machine.toml is what Save gives under Machine." : "",
      command.includes("--tools") ? "tools.tbl is the table of tools there." : "",
      settings.override === 100 ? "" : "The command runs at a feed override of 100 %.",
      settings.changes.length === 0 ? "" : "It knows nothing of feed that is held or turned on the way.",
    ]
      .join(" ")
      .trim();
  }
}

type FileContent = Blob | string | undefined | Promise<Blob | string | undefined>;
