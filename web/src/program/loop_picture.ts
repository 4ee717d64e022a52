// The part, drawn from position feedback over the geometry that is known, and one sensor over time.

import type { Picture } from "../draw/picture";
import { axisLetters, type Plan, type Slides } from "../engine/motion_types";
import { drawGrid, type Frame } from "../lesson/graph";
import { fixed, signed } from "../ui/dom";
import { colour } from "../ui/theme";

export const signals = {
  lag: "Following error, by the encoder, mm",
  velocity: "Tachometer, mm/s",
  current: "Motor current, as mm/s²",
  control: "Output of the controller",
} as const;
export type Signal = keyof typeof signals;
export const views = { whole: "Whole part", wide: "2 mm around the tool", near: "0.2 mm around the tool" } as const;
const reach = { wide: 1, near: 0.1 } as const; // mm to each side
const mostPoints = 4000;
const axisColours = ["x", "y", "warm"] as const;

export type View = keyof typeof views;

/** What is looked at, and when, s. */
export interface Look {
  readonly time: number;
  readonly view: View;
  readonly signal: Signal;
}

export class FollowedPicture {
  constructor(
    private readonly plan: Plan,
    private readonly slides: Slides,
    private readonly look: Look,
  ) {}

  /** Of the first three axes of the plan, the two that travel farthest. */
  plane(): readonly [number, number] {
    const { path } = this.plan;
    const travel = [0, 1, 2].map((i) => (path.greatest[i] ?? 0) - (path.least[i] ?? 0));
    const least = travel.indexOf(Math.min(...travel));
    const [one = 0, other = 1] = [0, 1, 2].filter((i) => i !== least);
    return least === 0 ? [1, 2] : [one, other];
  }

  /** Slides have an entry a word, samples every so many. */
  private entry(): number {
    return Math.max(0, Math.min(this.slides.count - 1, Math.round(this.look.time / this.plan.period)));
  }

  private frame(picture: Picture): Frame {
    const { plan, slides } = this;
    const [u, v] = this.plane();
    const width = slides.axes.length;
    const at = (axis: number): number => slides.position[this.entry() * width + axis] ?? 0;
    const [least, greatest] = [plan.path.least, plan.path.greatest];
    const box = [u, v].map((axis): [number, number] =>
      this.look.view === "whole"
        ? [least[axis] ?? 0, greatest[axis] ?? 1]
        : [at(axis) - reach[this.look.view], at(axis) + reach[this.look.view]],
    );
    const [[left, right], [bottom, top]] = box as [[number, number], [number, number]];
    const edge = this.look.view === "whole" ? 30 : 0;
    const scale = Math.min(
      (picture.width - 2 * edge) / Math.max(right - left, 1e-3),
      (picture.height - 2 * edge) / Math.max(top - bottom, 1e-3),
    );
    return {
      scale,
      x: (mm) => picture.width / 2 + (mm - (left + right) / 2) * scale,
      y: (mm) => picture.height / 2 - (mm - (bottom + top) / 2) * scale,
    };
  }

  /** Places of an array of axes, as a line; where many fall together, some of them. */
  private line(from: Float64Array, width: number, count: number, frame: Frame, until: number): number[] {
    const [u, v] = this.plane();
    const every = this.look.view === "whole" ? Math.max(1, Math.floor(count / mostPoints)) : 1;
    const first = this.look.view === "whole" ? 0 : Math.max(0, until - mostPoints);
    const last =
      this.look.view === "whole"
        ? until
        : Math.min(count - 1, until + (from === this.slides.position ? 0 : mostPoints));
    const points: number[] = [];
    for (let i = first; i <= last; i += every)
      points.push(frame.x(from[i * width + u] ?? 0), frame.y(from[i * width + v] ?? 0));
    return points;
  }

  drawPart(picture: Picture): void {
    const { plan, slides } = this;
    picture.rectangle(0, 0, picture.width, picture.height, colour("paper"));
    const frame = this.frame(picture);
    drawGrid(picture, frame);
    const { samples } = plan;
    const now = Math.min(samples.count - 1, Math.round(this.look.time / samples.step));
    const known = this.line(
      samples.position,
      samples.axes.length,
      samples.count,
      frame,
      this.look.view === "whole" ? samples.count - 1 : now,
    );
    picture.line(known, { colour: colour("truth"), width: 4 });
    const entry = this.entry();
    const made = this.line(slides.position, slides.axes.length, slides.count, frame, entry);
    picture.line(made, { colour: colour("accent"), width: 1.8 });
    const [u, v] = this.plane();
    const at = (axis: number): number => slides.position[entry * slides.axes.length + axis] ?? 0;
    picture.circle(frame.x(at(u)), frame.y(at(v)), 5, { fill: colour("accent-strong") });
  }

  private value(entry: number, axis: number): number {
    const { slides, plan } = this;
    const at = entry * slides.axes.length + axis;
    if (this.look.signal !== "lag") return slides[this.look.signal][at] ?? 0;
    const { samples } = plan;
    const sample = Math.min(samples.count - 1, Math.floor((entry * plan.period) / samples.step + 1e-6));
    return (samples.position[sample * samples.axes.length + axis] ?? 0) - (slides.position[at] ?? 0);
  }

  drawSignal(picture: Picture): void {
    const { slides, plan } = this;
    picture.rectangle(0, 0, picture.width, picture.height, colour("paper"));
    const [left, right] = [64, 12];
    const [wide, high] = [picture.width - left - right, picture.height - 40];
    // Where only every so many words are sampled, the error is told at these.
    const words = Math.round(plan.samples.step / plan.period);
    const every = Math.max(words, Math.floor(slides.count / Math.max(1, 2 * wide) / words) * words, 1);
    const axes = slides.axes.filter((axis) => axis < 3);
    let most = 1e-9;
    for (let entry = 0; entry < slides.count; entry += every)
      for (const axis of axes) most = Math.max(most, Math.abs(this.value(entry, slides.axes.indexOf(axis))));
    const x = (entry: number): number => left + (entry / Math.max(1, slides.count - 1)) * wide;
    const y = (value: number): number => 12 + high / 2 - (value / most) * (high / 2 - 2);
    const quiet = { colour: colour("quiet"), size: 11, align: "right" } as const;
    for (const level of [-1, 0, 1]) {
      picture.line([left, y(level * most), picture.width - right, y(level * most)], {
        colour: colour(level ? "grid" : "axis"),
      });
      picture.text(signed(Number((level * most).toPrecision(3))), left - 6, y(level * most) + 4, quiet);
    }
    picture.text(`${fixed((slides.count - 1) * plan.period, 2)} s`, picture.width - right, picture.height - 10, quiet);
    axes.forEach((axis, i) => {
      const tone = colour(axisColours[axis] ?? "accent");
      const line: number[] = [];
      for (let entry = 0; entry < slides.count; entry += every)
        line.push(x(entry), y(this.value(entry, slides.axes.indexOf(axis))));
      picture.line(line, { colour: tone, width: 1.5 });
      picture.text(axisLetters[axis] ?? "", left + 8 + 18 * i, picture.height - 10, {
        colour: tone,
        size: 12,
        weight: 600,
      });
    });
    picture.line([x(this.entry()), 8, x(this.entry()), 16 + high], { colour: colour("ink"), width: 1 });
  }

  /** As the trace of `leadscrew simulate` has them. */
  csvText(): string {
    const { slides, plan } = this;
    const columns = ["actual", "velocity", "control", "current"] as const;
    const names = slides.axes.map((axis) => axisLetters[axis] ?? "");
    const lines = [["t", ...columns.flatMap((column) => names.map((name) => `${column}_${name}`))].join(",")];
    const width = slides.axes.length;
    for (let i = 0; i < slides.count; ++i) {
      const row = [slides.position, slides.velocity, slides.control, slides.current].flatMap((from) => [
        ...from.subarray(i * width, (i + 1) * width),
      ]);
      lines.push([Number((i * plan.period).toPrecision(12)), ...row].join(","));
    }
    return `${lines.join("\n")}\n`;
  }
}
