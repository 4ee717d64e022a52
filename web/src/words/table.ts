// The figures of all lanes beside one another, and what a paper prints of the same.

import { mark } from "../compare/lane_forms";
import type { Figure, Track } from "./measure";
import { fixed, html } from "../ui/dom";

export interface Told {
  readonly number: number;
  readonly title: string;
  readonly detail: string;
  readonly track: Track;
  /** Of the track that is in force. */
  readonly entry: number;
  /** Of a word, ns. */
  readonly cost: number;
  /** Of a paper; empty where there is none. */
  readonly published: string;
}

/** Three or four digits, and none that a million needs not. */
function digits(value: number): string {
  return Number(value.toPrecision(4)).toLocaleString("en", { maximumFractionDigits: 6, useGrouping: false });
}

const of = (figure: Figure, times = 1): ((told: Told) => string) => {
  return ({ track, entry }) => digits((track.until[figure][entry] ?? 0) * times);
};

const columns: readonly (readonly [string, string, (told: Told) => string])[] = [
  ["Words", "periods until here", ({ entry }) => String(entry)],
  ["Time, s", "until here, to rest at the end", ({ track, entry }) => fixed(track.period * entry, 3)],
  ["Greatest speed, mm/s", "over a period", of("maxSpeed")],
  ["Feed error, %", "greatest departure from V of a period, where the plan says constant speed", of("feedError", 100)],
  ["Chord error, µm", "greatest distance of the middle between two words from the curve", of("chordError", 1000)],
  ["Greatest error, µm", "distance of words, or of slides where loops follow, from the curve", of("maxError", 1000)],
  ["RMS error, µm", "over all words or places", of("rmsError", 1000)],
  ["Acceleration, mm/s²", "greatest second difference of X or Y over T²", of("acceleration")],
  ["Jerk, mm/s³", "greatest third difference of X or Y over T³", of("jerk")],
  ["Cost a word, µs", "of reading, planning and interpolation, on this machine", ({ cost }) => digits(cost / 1000)],
];

export class WordTable {
  private readonly body = html("tbody");
  private rows: readonly string[][] = [];
  readonly element = html(
    "div",
    { class: "figures", tabindex: 0, role: "region", "aria-label": "Figures of all lanes" },
    html(
      "table",
      {},
      html("caption", { class: "hidden" }, "A row a lane: its figures until this clock"),
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

  update(all: readonly Told[]): void {
    this.rows = all.map((told) => [
      told.title,
      told.detail,
      ...columns.map(([, , cell]) => cell(told)),
      told.published,
    ]);
    this.body.replaceChildren(...this.rows.flatMap((row, i) => this.rowsOf(row, all[i]?.number ?? i)));
  }

  /** Of a lane, and below it the paper's. */
  private rowsOf([title = "", detail = "", ...cells]: readonly string[], number: number): HTMLElement[] {
    const paper = cells.pop() ?? "";
    const own = html(
      "tr",
      { "data-lane": number + 1 },
      html(
        "th",
        { scope: "row" },
        html("span", { class: "name" }, mark(number), title),
        html("span", { class: "conventions" }, detail),
      ),
      ...cells.map((cell) => html("td", {}, cell)),
    );
    if (paper === "") return [own];
    const published = html("td", { colspan: columns.length }, paper);
    return [own, html("tr", { class: "paper" }, html("th", { scope: "row" }, "Published"), published)];
  }

  csv(): string {
    const quoted = (cell: string): string => (/[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);
    const head = ["method", "loops", ...columns.map(([name]) => name.toLowerCase()), "published"];
    return `${[head, ...this.rows].map((row) => row.map(quoted).join(",")).join("\n")}\n`;
  }
}
