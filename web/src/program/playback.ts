// The clock of the motion: forward and back at any speed, to any time.

import { fixed, html } from "../ui/dom";
import { icon, redrawIcon } from "../ui/icons";

const speeds = ["0.01", "0.1", "0.25", "0.5", "1", "2", "5", "10", "50"] as const;

/** Where playback is, s; how long it has stood at the end though it would play on, s; and whether it plays, or would. */
export interface Instant {
  readonly time: number;
  readonly waited: number;
  readonly plays: boolean;
}

export class Playback {
  readonly element: HTMLElement;
  time = 0;
  private duration = 0;
  private period = 0.001;
  private direction = 0;
  /** When it played to the end, where it still stands there; ms of the browser's clock. */
  private ended: number | undefined;
  private frame = 0;
  private readonly scrub = html("input", {
    type: "range",
    id: "time",
    min: 0,
    max: 1,
    step: 0.001,
    "aria-label": "Time, s",
    input: () => this.seek(Number(this.scrub.value)),
  });
  private readonly told = html("output", { class: "number", for: "time" });
  private readonly speed = html("select", { id: "speed", "aria-label": "Speed of playback" });
  private readonly buttons = (
    [
      ["begin", "Begin", "begin", () => this.seek(0)],
      ["play-back", "Play backwards", "back", () => this.toggle(-1)],
      ["play", "Play", "play", () => this.toggle(1)],
      ["end", "End", "end", () => this.seek(this.duration)],
    ] as const
  ).map(([id, label, sign, click]) =>
    html("button", { type: "button", id, "aria-label": label, title: label, click }, icon(sign)),
  );

  constructor(private readonly moved: (time: number) => void) {
    for (const each of speeds) this.speed.append(new Option(`${each}×`, each, each === "1", each === "1"));
    this.element = html(
      "div",
      { class: "playback" },
      html("div", { class: "buttons" }, ...this.buttons),
      this.scrub,
      this.told,
      this.speed,
    );
    this.show();
  }

  load(duration: number, period: number, time: number): void {
    this.stop();
    this.duration = duration;
    this.period = period;
    this.scrub.max = String(duration);
    this.scrub.step = String(period);
    this.seek(time);
  }

  seek(time: number): void {
    this.time = Math.min(Math.max(time, 0), this.duration);
    this.ended = undefined;
    this.show();
    this.moved(this.time);
  }

  /** By so many periods. */
  step(by: number): void {
    this.stop();
    this.seek((Math.round(this.time / this.period) + by) * this.period);
  }

  toggle(direction: 1 | -1): void {
    const isSame = this.direction === direction;
    this.stop();
    if (!isSame) this.play(direction);
  }

  get now(): Instant {
    const passed = this.ended === undefined ? 0 : (performance.now() - this.ended) / 1000;
    const waited = passed * Number(this.speed.value);
    return { time: this.time, waited, plays: this.isPlaying || this.ended !== undefined };
  }

  get isPlaying(): boolean {
    return this.direction !== 0;
  }

  /** Where no control has these keys. */
  key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches("input, select, textarea, .space, .table"))
      return;
    if (target.closest(".cm-editor") !== null) return;
    const many = event.shiftKey ? 100 : 1;
    const actions: Readonly<Record<string, () => void>> = {
      ArrowRight: () => this.step(many),
      ArrowLeft: () => this.step(-many),
      Home: () => this.seek(0),
      End: () => this.seek(Infinity),
      ...(target.matches("button, a, summary") ? {} : { " ": () => this.toggle(1) }),
    };
    const action = actions[event.key];
    if (action === undefined) return;
    event.preventDefault();
    action();
  }

  stop(): void {
    cancelAnimationFrame(this.frame);
    this.direction = 0;
    this.ended = undefined;
    this.show();
  }

  private play(direction: 1 | -1): void {
    if (this.duration === 0) return;
    if (direction > 0 && this.time >= this.duration) this.time = 0;
    if (direction < 0 && this.time <= 0) this.time = this.duration;
    this.direction = direction;
    let last = performance.now();
    const go = (now: number): void => {
      const passed = Math.max(now - last, 0); // a frame may have begun before the button was pressed
      this.seek(this.time + (direction * Number(this.speed.value) * passed) / 1000);
      last = now;
      if (direction < 0 ? this.time <= 0 : this.time >= this.duration) {
        this.stop();
        if (direction > 0) this.ended = now;
        return;
      }
      this.frame = requestAnimationFrame(go);
    };
    this.frame = requestAnimationFrame(go);
    this.show();
  }

  private show(): void {
    this.scrub.value = String(this.time);
    this.told.value = `${fixed(this.time, 3)} / ${fixed(this.duration, 3)} s`;
    for (const button of this.buttons) {
      const direction = button.id === "play" ? 1 : button.id === "play-back" ? -1 : 0;
      if (direction === 0) continue;
      const isOn = this.direction === direction;
      redrawIcon(button, isOn ? "pause" : direction > 0 ? "play" : "back");
      button.setAttribute("aria-pressed", String(isOn));
    }
  }
}
