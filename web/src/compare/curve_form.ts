// The curve that all lanes have, and the comparisons that are ready.

import type { FieldErrors, Settings } from "../lesson/settings";
import { html } from "../ui/dom";
import { Fields } from "./fields";
import { comparisons, type Comparison, type State } from "./state";

export interface CurveEvents {
  choose(comparison: Comparison): void;
  change(change: Partial<Settings>): void;
  feed(text: string): void;
}

const pairs = [
  ["Start", "startX", "startY", ""],
  ["End", "endX", "endY", ""],
  ["Centre", "centerX", "centerY", "arc"],
  ["Semi-axes", "semiX", "semiY", "ellipse"],
] as const;

export class CurveForm {
  readonly element: HTMLElement;
  private readonly fields = new Fields();
  private readonly groups: (readonly [HTMLElement, string])[] = [];

  private readonly slider: HTMLInputElement;

  constructor(private readonly events: CurveEvents) {
    this.slider = html("input", {
      id: "feed-slider",
      type: "range",
      min: 1,
      max: 500,
      step: 1,
      "aria-label": "Feed, BLU/s",
      input: () => events.feed(this.slider.value),
    });
    this.element = html("section", { class: "panel", "aria-labelledby": "curve-title" }, ...this.content());
  }

  private content(): HTMLElement[] {
    const { fields, events } = this;
    const ready = [["", "Choose a comparison"], ...comparisons.map(({ id, title }) => [id, title])] as [
      string,
      string,
    ][];
    return [
      html("h2", { id: "curve-title" }, "Curve"),
      fields.select("comparison", "Comparison", ready, (id) => {
        const chosen = comparisons.find((each) => each.id === id);
        if (chosen !== undefined) events.choose(chosen);
      }),
      fields.select(
        "curve",
        "Curve",
        [
          ["line", "A line"],
          ["circle", "An arc of a circle"],
          ["ellipse", "An arc of an ellipse"],
        ],
        (value) => events.change(value === "line" ? { module: "line" } : { module: "arc", curve: value as "circle" }),
      ),
      ...pairs.map(([title, x, y, of]) => this.pair(title, x, y, of)),
      fields.select(
        "direction",
        "Direction",
        [
          ["ccw", "Counterclockwise"],
          ["cw", "Clockwise"],
        ],
        (direction) => events.change({ direction: direction as "cw" }),
      ),
      html(
        "div",
        { class: "feed" },
        fields.text("feed", "Feed v, BLU/s", (feed) => events.feed(feed)),
        this.slider,
      ),
    ];
  }

  private pair(title: string, x: keyof Settings, y: keyof Settings, of: string): HTMLElement {
    const [one, other] = of === "ellipse" ? ["a", "b"] : ["x", "y"];
    const text = (key: keyof Settings, label: string): HTMLElement =>
      this.fields.text(key, label, (value) => this.events.change({ [key]: value }), `${title} ${label}`);
    const group = html(
      "fieldset",
      {},
      html("legend", {}, title),
      html("div", { class: "columns" }, text(x, one ?? ""), text(y, other ?? "")),
    );
    this.groups.push([group, of]);
    return group;
  }

  update(state: State, chosen: Comparison | undefined, errors: FieldErrors, isFeed: boolean): void {
    const { curve } = state;
    const isArc = curve.module === "arc";
    const isEllipse = isArc && curve.curve === "ellipse";
    this.fields.show("comparison", chosen?.id ?? "", true);
    this.fields.show("curve", isArc ? curve.curve : "line", true);
    this.fields.show("direction", curve.direction, isArc);
    this.fields.show("feed", curve.feed, true, isFeed ? "" : "the feed is more than 0 BLU/s, such as 10");
    if (isFeed) this.slider.value = curve.feed;
    for (const [group, of] of this.groups) group.hidden = (of === "arc" && !isArc) || (of === "ellipse" && !isEllipse);
    for (const [, ...keys] of pairs)
      for (const key of keys.slice(0, 2) as (keyof Settings)[])
        this.fields.show(key, String(curve[key]), true, errors.get(key));
  }
}
