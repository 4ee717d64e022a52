// The figures of all lanes beside one another, and what a paper prints of the same.

import { fixed, html } from "../ui/dom";
import { figuresOf, rippleClocks, type LaneFigures } from "./figures";
import { mark } from "./lane_forms";
import type { Drawn } from "./pictures";

export interface Compared {
  readonly drawn: Drawn;
  readonly conventions: string;
  /** Of the paper whose figure this is; empty where there is none. */
  readonly source: string;
  readonly published: string;
  readonly command: string;
  /** Of integrators; 0 of methods whose rate depends on the course. */
  readonly clocksPerBlu: number;
}

/** Figures of a lane, and its time at the feed: NaN where the clock does not set that. */
type Told = LaneFigures & { readonly time: number };

const columns: readonly (readonly [string, string, (figures: Told) => string])[] = [
  ["Clocks", "until here", ({ clocks }) => String(clocks)],
  ["Pulses", "clocks with a step", ({ pulses }) => String(pulses)],
  ["Clocks a pulse", "what a step costs", ({ clocks, pulses }) => (pulses > 0 ? fixed(clocks / pulses, 3) : "")],
  ["Time", "at the feed, s; of integrators, whose clock sets it", ({ time }) => (time >= 0 ? fixed(time, 2) : "")],
  ["Greatest error", "distance from the curve, BLU", ({ maxError }) => fixed(maxError, 3)],
  ["RMS error", "over the places after each pulse, BLU", ({ rmsError }) => fixed(rmsError, 3)],
  ["Length", "of the steps, BLU", ({ length }) => fixed(length, 2)],
  [
    "Ripple",
    `greatest departure of the way in ${rippleClocks} clocks from its mean`,
    ({ ripple }) => (Number.isNaN(ripple) ? "" : `${fixed(100 * ripple, 1)} %`),
  ],
  [
    "Acceleration",
    `greatest second difference of X or Y over steps of ${rippleClocks} clocks, BLU`,
    ({ acceleration }) => (Number.isNaN(acceleration) ? "" : String(acceleration)),
  ],
  [
    "Jerk",
    `greatest third difference of X or Y over steps of ${rippleClocks} clocks, BLU`,
    ({ jerk }) => (Number.isNaN(jerk) ? "" : String(jerk)),
  ],
  ["End", "where it stands, BLU", ({ end }) => `(${end.join(", ")})`.replaceAll("-", "−")],
];

export class FigureTable {
  private readonly body = html("tbody");
  readonly element = html(
    "div",
    { class: "figures", tabindex: 0, role: "region", "aria-label": "Figures of all methods" },
    html(
      "table",
      {},
      html("caption", { class: "hidden" }, "A row a method: its figures until this clock"),
      html(
        "thead",
        {},
        html(
          "tr",
          {},
          html("th", { scope: "col" }, "Method"),
          ...columns.map(([name, what]) => html("th", { scope: "col", title: what }, name)),
        ),
      ),
      this.body,
    ),
  );
  private rows: readonly string[][] = [];

  update(all: readonly Compared[], clock: number, feed: number): void {
    this.rows = all.map(({ drawn, conventions, source, published, clocksPerBlu }) => {
      const until = figuresOf(drawn.session, clock);
      const figures = { ...until, time: clocksPerBlu > 0 && feed > 0 ? until.clocks / (clocksPerBlu * feed) : NaN };
      const paper = published === "" ? "" : `${published} (${source})`;
      return [drawn.title, conventions, ...columns.map(([, , of]) => of(figures)), paper];
    });
    this.body.replaceChildren(...this.rows.flatMap((row, i) => this.rowsOf(row, all[i]?.drawn.number ?? i)));
  }

  /** Of a lane, and below it the paper's. */
  private rowsOf([title = "", conventions = "", ...cells]: readonly string[], number: number): HTMLElement[] {
    const paper = cells.pop() ?? "";
    const own = html(
      "tr",
      { "data-lane": number + 1 },
      html(
        "th",
        { scope: "row" },
        html("span", { class: "name" }, mark(number), title),
        html("span", { class: "conventions" }, conventions),
      ),
      ...cells.map((cell) => html("td", {}, cell)),
    );
    if (paper === "") return [own];
    const published = html("td", { colspan: columns.length }, paper);
    return [own, html("tr", { class: "paper" }, html("th", { scope: "row" }, "Published"), published)];
  }

  csv(): string {
    const quoted = (cell: string): string => (/[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);
    const head = ["method", "conventions", ...columns.map(([name]) => name.toLowerCase()), "published"];
    const plain = this.rows.map((row) => row.map((cell) => quoted(cell.replaceAll("−", "-"))));
    return `${[head, ...plain].map((row) => row.join(",")).join("\n")}\n`;
  }
}
