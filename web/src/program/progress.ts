// How far the engine is, and the way to end it.

import type { Phase } from "../engine/motion_types";
import { html } from "../ui/dom";

const names: Readonly<Record<Phase, string>> = {
  reading: "Reading",
  planning: "Planning",
  looking: "Looking at each period",
  judging: "Judging each word",
};
const patience = 300; // ms before anything is shown

export class Progress {
  readonly element: HTMLElement;
  private readonly bar = html("progress", { id: "progress", max: 1, value: 0, "aria-label": "Planning" });
  private readonly text = html("span", { class: "note" });
  private readonly work: HTMLElement;
  private readonly said = html("p", { class: "said", id: "said", role: "status" });
  private begun = 0;

  constructor(cancel: () => void) {
    this.work = html(
      "div",
      { class: "work", hidden: true },
      this.text,
      this.bar,
      html("button", { type: "button", id: "cancel", click: cancel }, "Cancel"),
    );
    this.element = html("div", { class: "progress" }, this.work, this.said);
  }

  show(phase: Phase, share: number): void {
    const now = performance.now();
    if (this.begun === 0) this.begun = now;
    if (now - this.begun < patience) return;
    this.work.hidden = false;
    this.said.textContent = "";
    this.text.textContent = names[phase];
    this.bar.value = share;
    this.element.dataset["seen"] = String(Number(this.element.dataset["seen"] ?? 0) + 1);
  }

  rest(said: string): void {
    this.begun = 0;
    this.work.hidden = true;
    this.said.textContent = said;
  }
}
