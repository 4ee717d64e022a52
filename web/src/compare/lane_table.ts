// The figures of all lanes beside one another, a row each, and below each what a paper prints of the same.

import { html } from "../ui/dom";
import { mark } from "./lane_forms";

/** A column: its head, what it means, and how wide its cells are of one lane. */
export type Column<Told> = readonly [name: string, what: string, cell: (told: Told) => string];

export interface LaneRow<Told> {
  /** Of all lanes, from 0: its colour. */
  readonly number: number;
  readonly title: string;
  /** What is in force. */
  readonly detail: string;
  readonly told: Told;
  /** Of a paper; empty where there is none. */
  readonly published: string;
}

export class LaneTable<Told> {
  private readonly body = html("tbody");
  private rows: readonly string[][] = [];
  readonly element: HTMLElement;

  /** `detail`: what a lane's detail is called in a file. */
  constructor(
    label: string,
    private readonly detail: string,
    private readonly columns: readonly Column<Told>[],
  ) {
    const heads = columns.map(([name, what]) => html("th", { scope: "col", title: what }, name));
    this.element = html(
      "div",
      { class: "figures", tabindex: 0, role: "region", "aria-label": label },
      html(
        "table",
        {},
        html("caption", { class: "hidden" }, "A row a lane: its figures until this clock"),
        html("thead", {}, html("tr", {}, html("th", { scope: "col" }, "Method"), ...heads)),
        this.body,
      ),
    );
  }

  update(all: readonly LaneRow<Told>[]): void {
    this.rows = all.map(({ title, detail, told, published }) => [
      title,
      detail,
      ...this.columns.map(([, , cell]) => cell(told)),
      published,
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
    const published = html("td", { colspan: this.columns.length }, paper);
    return [own, html("tr", { class: "paper" }, html("th", { scope: "row" }, "Published"), published)];
  }

  csv(): string {
    const quoted = (cell: string): string => (/[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell);
    const head = ["method", this.detail, ...this.columns.map(([name]) => name.toLowerCase()), "published"];
    const plain = this.rows.map((row) => row.map((cell) => quoted(cell.replaceAll("−", "-"))));
    return `${[head, ...plain].map((row) => row.join(",")).join("\n")}\n`;
  }
}
