// Velocity, acceleration and jerk over time, one above the other, with one cursor and one stretch of time.

import uPlot from "uplot";
import { CanvasPicture, SvgPicture } from "../draw/picture";
import { axisLetters, type Plan } from "../engine/motion_types";
import { html } from "../ui/dom";
import { colour } from "../ui/theme";
import { axisColour, drawTimes, pointsOf, timePicture, timeRows, timesCsv } from "./time_picture";

const height = 132;
function short(value: number): string {
  return Math.abs(value) >= 10_000 ? `${value / 1000}k` : String(value);
}

export class Plots {
  /** What the colours of the lines mean. */
  readonly keys = html("div", { class: "time-keys" });
  readonly element = html("div", { class: "plots", id: "plots", role: "group", "aria-label": "Motion over time" });
  private readonly frames = timeRows.map(({ name, unit }) =>
    html(
      "figure",
      { class: "plot", "data-name": name, role: "img", "aria-label": `${name} of the axes over time` },
      html("figcaption", {}, name[0]?.toUpperCase() + name.slice(1), html("span", { class: "note" }, ` ${unit}`)),
      html("div", { class: "plot-area" }),
    ),
  );
  private plots: uPlot[] = [];
  private plan: Plan | undefined;
  private stretch: [number, number] = [0, 1];
  private time = 0;

  /** `stretched`: another stretch of time is shown; all of it without one. */
  constructor(
    private readonly seek: (time: number) => void,
    private readonly stretched: (stretch: readonly [number, number] | undefined) => void,
  ) {
    this.element.append(...this.frames);
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  panel(): HTMLElement {
    const near = (): void => {
      const reach = Math.max((this.plan?.figures.time ?? 1) / 40, 0.05);
      this.show(this.time - reach, this.time + reach);
    };
    const button = (id: string, text: string, click: () => void): HTMLElement =>
      html("button", { type: "button", id, click }, text);
    const all = button("time-all", "All", () => this.show(0, Infinity));
    const tools = html("div", { class: "tools" }, this.keys, all, button("time-near", "Around the tool", near));
    return html(
      "section",
      { class: "panel", "aria-label": "Over time" },
      html("div", { class: "panel-head" }, html("h2", {}, "Over time"), tools),
      this.element,
    );
  }

  /** All of it, or a stretch of time; rows() draw it. */
  load(plan: Plan, stretch: readonly [number, number] | undefined): void {
    this.plan = plan;
    this.stretch = [0, Math.max(plan.figures.time, plan.samples.step)];
    this.clear();
    if (stretch !== undefined) this.show(...stretch);
  }

  /** Steps that draw what is loaded, to be taken one after the other. */
  rows(): (() => void)[] {
    return timeRows.map((_, row) => () => this.add(row));
  }

  /** Colours and legends are the plots' own: made anew. */
  redraw(): void {
    if (this.plan === undefined) return;
    this.clear();
    timeRows.forEach((_, row) => this.add(row));
  }

  stand(time: number): void {
    this.time = time;
    for (const plot of this.plots) plot.redraw(false);
  }

  /** All of the motion, or the stretch from ... to, s. */
  show(from: number, to: number): void {
    if (this.plan === undefined) return;
    const end = Math.max(this.plan.figures.time, this.plan.samples.step);
    this.stretch = [Math.max(0, from), Math.min(end, to)];
    this.plots.forEach((_, row) => this.fill(row));
    const isAll = this.stretch[0] === 0 && this.stretch[1] === end;
    this.stretched(isAll ? undefined : this.stretch);
  }

  svgText(): string {
    const picture = new SvgPicture(timePicture.width, timePicture.height, "Motion over time");
    if (this.plan !== undefined) drawTimes(picture, this.plan, this.stretch, this.time);
    return picture.toString();
  }

  async pngBlob(): Promise<Blob> {
    const canvas = document.createElement("canvas");
    const picture = new CanvasPicture(canvas, timePicture.width, timePicture.height, 2);
    if (this.plan !== undefined) drawTimes(picture, this.plan, this.stretch, this.time);
    return await new Promise((resolve, reject) =>
      canvas.toBlob((blob) => (blob === null ? reject(new Error("no picture")) : resolve(blob)), "image/png"),
    );
  }

  /** What is shown, a row a sample. */
  csv(): Blob | undefined {
    return this.plan === undefined ? undefined : timesCsv(this.plan, this.stretch);
  }

  private clear(): void {
    this.showKeys();
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
  }

  private add(row: number): void {
    this.plots[row] = this.plotOf(row);
    this.fill(row);
  }

  private showKeys(): void {
    const axes = this.plan?.samples.axes ?? [];
    this.keys.replaceChildren(
      ...axes.map((axis, k) => {
        const chip = html("span", { class: "chip" });
        chip.style.background = axisColour(k);
        return html("span", { class: "key" }, chip, axisLetters[axis]);
      }),
      html("span", { class: "key feed" }, "feed"),
    );
  }

  private fill(row: number): void {
    const { plan } = this;
    const plot = this.plots[row];
    if (plan === undefined || plot === undefined) return;
    const [from, to] = this.stretch;
    plot.setData(pointsOf(plan, row, this.stretch) as uPlot.AlignedData, false);
    plot.setScale("x", { min: from, max: to });
  }

  private plotOf(row: number): uPlot {
    const { plan, frames } = this;
    const area = frames[row]?.lastElementChild as HTMLElement;
    const axisLook = {
      stroke: colour("quiet"),
      grid: { stroke: colour("grid"), width: 1 },
      ticks: { stroke: colour("axis"), width: 1 },
      font: "12px system-ui, sans-serif",
    };
    const series: uPlot.Series[] = (plan?.samples.axes ?? []).map((axis, k) => ({
      label: axisLetters[axis] ?? "",
      stroke: axisColour(k),
      width: 1.5,
      points: { show: false },
    }));
    if (row === 0)
      series.push({ label: "feed", stroke: colour("quiet"), width: 1, dash: [4, 3], points: { show: false } });
    const plot = new uPlot(
      {
        width: Math.max(area.clientWidth, 200),
        height,
        legend: { show: false },
        cursor: { sync: { key: "time" }, drag: { x: true, y: false, setScale: false }, points: { show: false } },
        select: { show: true, left: 0, top: 0, width: 0, height: 0 },
        scales: { x: { time: false } },
        axes: [
          { ...axisLook, size: 26, values: (_, ticks) => ticks.map((each) => `${each} s`) },
          { ...axisLook, size: 60, values: (_, ticks) => ticks.map(short) },
        ],
        series: [{}, ...series],
        hooks: {
          draw: [(of) => this.drawNow(of)],
          setSelect: [(of) => this.zoom(of)],
        },
      },
      [[0, 1], ...series.map(() => [0, 0])] as uPlot.AlignedData,
      area,
    );
    plot.over.addEventListener("click", () => {
      if ((plot.cursor.left ?? -1) >= 0 && plot.select.width < 3) this.seek(plot.posToVal(plot.cursor.left ?? 0, "x"));
    });
    plot.over.addEventListener("dblclick", () => this.show(0, Infinity));
    return plot;
  }

  private zoom(plot: uPlot): void {
    if (plot.select.width < 3) return;
    const from = plot.posToVal(plot.select.left, "x");
    const to = plot.posToVal(plot.select.left + plot.select.width, "x");
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.show(from, to);
  }

  /** The time at which the tool stands. */
  private drawNow(plot: uPlot): void {
    const x = Math.round(plot.valToPos(this.time, "x", true));
    const { left, top, width, height: tall } = plot.bbox;
    if (x < left || x > left + width) return;
    plot.ctx.save();
    plot.ctx.setLineDash([]);
    plot.ctx.strokeStyle = colour("warm");
    plot.ctx.lineWidth = 1.5 * (devicePixelRatio || 1);
    plot.ctx.beginPath();
    plot.ctx.moveTo(x, top);
    plot.ctx.lineTo(x, top + tall);
    plot.ctx.stroke();
    plot.ctx.restore();
  }

  private resize(): void {
    this.plots.forEach((plot, row) => {
      const area = this.frames[row]?.lastElementChild as HTMLElement;
      plot.setSize({ width: Math.max(area.clientWidth, 200), height });
    });
  }
}
