// Feed while motion plays: held and resumed, or turned to another share, from the instant at which the tool stands. The engine
// plans what becomes of it: braking, rest, and the way on.

import type { FeedChange } from "../engine/motion_types";
import { fixed, html } from "../ui/dom";
import type { Instant } from "./playback";
import type { Settings } from "./settings";

export interface FeedCalls {
  /** In the order of time. */
  changed(changes: readonly FeedChange[]): void;
  now(): Instant;
}

const mostShown = 4;

export class FeedPanel {
  readonly element: HTMLElement;
  private changes: readonly FeedChange[] = [];
  /** Of the beginning. */
  private override = 1;
  private time = 0;
  private readonly hold = html("button", { type: "button", id: "feed-hold", click: () => this.toggle() }, "Hold");
  private readonly factor = html("input", {
    type: "number",
    id: "feed-now",
    min: 1,
    max: 200,
    step: 10,
    value: 100,
    "aria-describedby": "feed-said",
    change: () => this.turn(),
  });
  private readonly clear = html(
    "button",
    { type: "button", id: "feed-clear", click: () => this.calls.changed([]) },
    "Undo",
  );
  private readonly said = html("span", { class: "note", id: "feed-said", role: "status" });

  constructor(private readonly calls: FeedCalls) {
    this.element = html(
      "div",
      { class: "feed-now", role: "group", "aria-label": "Feed while it plays" },
      this.hold,
      html("label", { class: "inline", for: "feed-now" }, "Feed from here, %", this.factor),
      this.clear,
      this.said,
    );
  }

  show({ changes, override }: Pick<Settings, "changes" | "override">): void {
    this.changes = changes;
    this.override = override / 100;
    this.clear.hidden = changes.length === 0;
    this.said.textContent = this.told();
    this.stand(this.time);
  }

  /** The clock has moved. */
  stand(time: number): void {
    this.time = time;
    this.hold.textContent = this.isHeld ? "Resume" : "Hold";
    this.hold.setAttribute("aria-pressed", String(this.isHeld));
    if (document.activeElement !== this.factor) this.factor.value = String(Math.round(this.turned * 100));
  }

  /** Those that have happened. */
  private get past(): readonly FeedChange[] {
    return this.changes.filter(({ time }) => time <= this.time);
  }

  private get isHeld(): boolean {
    return this.past.at(-1)?.factor === 0;
  }

  /** By which feed is multiplied here, or will be where it is held. */
  private get turned(): number {
    return this.past.filter(({ factor }) => factor > 0).at(-1)?.factor ?? this.override;
  }

  private toggle(): void {
    const { time, waited } = this.calls.now();
    if (this.isHeld) this.add({ time: time + waited, factor: this.turned });
    else this.add({ time, factor: 0 });
  }

  private turn(): void {
    const factor = Number(this.factor.value) / 100;
    if (!(factor >= 0.01 && factor <= 2)) {
      this.said.textContent = "A share of 1 to 200 %";
      return;
    }
    const { time, waited } = this.calls.now();
    this.add({ time: this.isHeld ? time + waited : time, factor });
  }

  /** What was to come after it is no more. */
  private add(change: FeedChange): void {
    this.calls.changed([...this.changes.filter(({ time }) => time < change.time), change]);
  }

  private told(): string {
    const told = this.changes
      .slice(-mostShown)
      .map(({ time, factor }) => `${factor === 0 ? "held" : `${fixed(factor * 100, 0)} %`} from ${fixed(time, 3)} s`);
    return `${this.changes.length > mostShown ? "… " : ""}${told.join(", ")}`;
  }
}
