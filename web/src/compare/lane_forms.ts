// The methods that are compared, each with its options: up to four.

import type { Catalogue, Method } from "../engine/types";
import { methodTitles } from "../lesson/form";
import type { FieldErrors } from "../lesson/settings";
import { html } from "../ui/dom";
import { Fields } from "./fields";
import { laneKeys, laneOf, mostLanes, type Lane, type LaneKey, type State } from "./state";

export interface LaneEvents {
  change(lanes: Lane[]): void;
}

const labels: Readonly<Record<LaneKey, string>> = {
  method: "Method",
  bits: "Register bits n",
  capacity: "Capacity q",
  preload: "Remainders begin",
  order: "Order of integrators",
  tie: "On the circle",
  ending: "Ends",
  accumulation: "Negative integrands",
  places: "Places of the radius",
};

/** The mark by which a lane is told from the others: its number and its colour. */
export function mark(number: number): HTMLElement {
  return html("span", { class: `mark lane-${number + 1}` }, String(number + 1));
}

export class LaneForms {
  readonly element: HTMLElement;
  private readonly fields = new Fields();
  private readonly groups: HTMLElement[] = [];
  private readonly removes: HTMLButtonElement[] = [];
  private readonly add = html("button", { type: "button", id: "add-lane", click: () => this.append() }, "Add a method");
  private lanes: Lane[] = [];

  constructor(
    private readonly catalogue: Catalogue,
    private readonly events: LaneEvents,
  ) {
    for (let number = 0; number < mostLanes; ++number) this.groups.push(this.group(number));
    this.element = html(
      "section",
      { class: "panel lanes", "aria-labelledby": "lanes-title" },
      html("h2", { id: "lanes-title" }, "Methods"),
      ...this.groups,
      html("div", { class: "buttons" }, this.add),
    );
  }

  private group(number: number): HTMLElement {
    const remove = html(
      "button",
      { type: "button", id: `remove-${number + 1}`, "aria-label": `Remove method ${number + 1}` },
      "×",
    );
    remove.addEventListener("click", () => this.events.change(this.lanes.filter((_, i) => i !== number)));
    this.removes.push(remove);
    const own = ["", "Its own"] as const;
    const named = (names: readonly string[]): (readonly [string, string])[] => [
      own,
      ...names.map((name) => [name, name] as const),
    ];
    const { methods, preloads, orders, ties, accumulations } = this.catalogue;
    const choices: Partial<Record<LaneKey, readonly (readonly [string, string])[]>> = {
      method: methods.map(({ name }) => [name, methodTitles[name] ?? name]),
      preload: named(preloads),
      order: named(orders),
      tie: named(ties),
      accumulation: named(accumulations),
      ending: [
        ["counters", "By counters"],
        ["free", "By its angle's clocks"],
      ],
    };
    const field = (key: LaneKey): HTMLElement => {
      const id = `${key}-${number + 1}`;
      const change = (value: string): void => this.set(number, key, value);
      const name = `${labels[key]}, method ${number + 1}`;
      const options = choices[key];
      return options === undefined
        ? this.fields.text(id, labels[key], change, name)
        : this.fields.select(id, labels[key], options, change, name);
    };
    return html(
      "fieldset",
      { class: "lane" },
      html("legend", { class: "hidden" }, `Method ${number + 1}`),
      html("div", { class: "lane-head" }, mark(number), field("method"), remove),
      html("div", { class: "lane-fields" }, ...laneKeys.filter((key) => key !== "method").map(field)),
    );
  }

  private set(number: number, key: LaneKey, value: string): void {
    this.events.change(this.lanes.map((lane, i) => (i === number ? { ...lane, [key]: value } : lane)));
  }

  private append(): void {
    const used = new Set(this.lanes.map(({ method }) => method));
    const next = this.catalogue.methods.find(({ name }) => !used.has(name)) ?? this.catalogue.methods[0];
    if (next !== undefined) this.events.change([...this.lanes, laneOf(next.name)]);
  }

  update(state: State, methods: readonly (Method | undefined)[], errors: readonly FieldErrors[]): void {
    this.lanes = state.lanes;
    const isArc = state.curve.module === "arc";
    const isCircle = isArc && state.curve.curve === "circle";
    for (const [number, group] of this.groups.entries()) {
      const lane = state.lanes[number];
      group.hidden = lane === undefined;
      if (lane === undefined) continue;
      const has = methods[number];
      const isShown: Readonly<Record<LaneKey, boolean>> = {
        method: true,
        bits: true,
        capacity: has?.hasCapacity === true,
        preload: has?.hasPreload === true,
        order: has?.hasOrder === true && isArc,
        tie: has?.hasTie === true && isCircle,
        ending: has?.hasFree === true && isCircle,
        accumulation: has?.hasAccumulation === true && isCircle && lane.ending === "free",
        places: has?.hasPlaces === true && isCircle && lane.ending !== "free",
      };
      for (const key of laneKeys)
        this.fields.show(`${key}-${number + 1}`, lane[key], isShown[key], errors[number]?.get(key));
    }
    for (const remove of this.removes) remove.disabled = state.lanes.length === 1;
    this.add.disabled = state.lanes.length === mostLanes;
  }
}
