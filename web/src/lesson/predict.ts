// Predict: say which pulse the next cycle gives, then see why it does.

import { html, stepText } from "../ui/dom";
import type { Session } from "./session";

export class Predict {
  readonly element: HTMLElement;
  private readonly verdict = html("p", { class: "verdict", role: "status", id: "verdict" });
  private readonly buttons: HTMLButtonElement[] = [];
  private right = 0;
  private asked = 0;

  constructor(
    private readonly session: Session,
    private readonly step: () => void,
  ) {
    for (const y of [1, 0, -1])
      for (const x of [-1, 0, 1])
        this.buttons.push(
          html(
            "button",
            {
              type: "button",
              "data-x": x,
              "data-y": y,
              "aria-label": `X ${stepText(x)}, Y ${stepText(y)}`,
              click: () => this.guess(x, y),
            },
            this.arrow(x, y),
          ),
        );
    this.element = html(
      "section",
      { class: "panel predict", "aria-labelledby": "predict-title" },
      html("h2", { id: "predict-title" }, "Predict the next pulse"),
      html("p", { class: "note" }, "The registers show what the next cycle begins with. Which way does it step?"),
      html("div", { class: "pad", role: "group", "aria-label": "The next pulse" }, ...this.buttons),
      this.verdict,
    );
  }

  reset(): void {
    this.right = this.asked = 0;
    this.verdict.textContent = "";
  }

  update(isOn: boolean): void {
    this.element.hidden = !isOn;
    for (const button of this.buttons) button.disabled = this.session.clock === this.session.last;
  }

  private guess(x: number, y: number): void {
    const next = this.session.clock + 1;
    const dx = this.session.value(next, "dx");
    const dy = this.session.value(next, "dy");
    const isRight = dx === x && dy === y;
    ++this.asked;
    this.right += isRight ? 1 : 0;
    this.step();
    const was = dx === 0 && dy === 0 ? "no pulse" : `X ${stepText(dx)}, Y ${stepText(dy)}`;
    this.verdict.textContent = `${isRight ? "Right" : "Not so"}: ${was}. ${this.right} of ${this.asked} right.`;
    this.verdict.dataset["right"] = String(isRight);
  }

  private arrow(x: number, y: number): string {
    return (["↖", "↑", "↗", "←", "·", "→", "↙", "↓", "↘"] as const)[(1 - y) * 3 + x + 1] ?? "·";
  }
}
