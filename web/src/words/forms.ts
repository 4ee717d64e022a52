// What is compared: the curve with feed, period and limits, each by a slider as well, and the lanes with their loops.

import { Fields } from "../compare/fields";
import { mark } from "../compare/lane_forms";
import { mostLanes } from "../compare/state";
import { Slid } from "../compare/slid";
import type { FieldErrors } from "../lesson/settings";
import { html } from "../ui/dom";
import { curveKinds, type CurveKind } from "./curves";
import {
  comparisons,
  hasLoops,
  laneNumbers,
  laneOf,
  loopKinds,
  magnifications,
  methods,
  rangeOf,
  usesOf,
  type Comparison,
  type CurveNumber,
  type Lane,
  type LaneNumber,
  type LoopKind,
  type Method,
  type State,
} from "./state";

export interface FormEvents {
  choose(comparison: Comparison): void;
  change(change: Partial<State>): void;
  lanes(lanes: Lane[]): void;
  magnify(times: number): void;
}

export const methodTitles: Readonly<Record<Method, string>> = {
  "arc-length": "By arc length",
  taylor1: "Taylor, first order",
  taylor2: "Taylor, second order",
  newton: "Newton, chords of VT",
  uniform: "Equal steps of the parameter",
  stops: "Lines, a stop at each",
  blend: "Lines, blended (G64)",
  euler: "Circle by Euler",
  heun: "Circle by improved Euler (Heun)",
  tustin: "Circle by Tustin",
  "x-first": "Circle, x first (Koren's)",
  "runge-kutta": "Circle by Runge-Kutta",
  "state-transition": "Circle by state transition",
  dda: "Pulses: DDA in hardware",
  koren: "Pulses: Koren's program",
  "point-comparison": "Pulses: point by point",
  "min-error": "Pulses: minimum error",
  "improved-min-error": "Pulses: improved minimum error",
  bresenham: "Pulses: Bresenham",
};
export const loopTitles: Readonly<Record<LoopKind, string>> = {
  none: "Words alone",
  pid: "PID",
  cascade: "Cascade",
  pulses: "Pulse loop",
};
const curveTitles: Readonly<Record<CurveKind, string>> = {
  cubic: "The real-time paper's cubic",
  circle: "A circle",
  ellipse: "An ellipse",
  corner: "A corner",
  line: "A line",
};
const curveLabels: Readonly<Record<CurveNumber, string>> = {
  a: "a, mm",
  b: "b, mm",
  feed: "Feed V, mm/s",
  period: "Period T, ms",
  acceleration: "Acceleration, mm/s²",
  jerk: "Jerk, mm/s³",
  tolerance: "Tolerance of blends, mm",
};
const laneLabels: Readonly<Record<LaneNumber, string>> = {
  period: "Period of its own, ms",
  lines: "How many lines",
  p: "P, units/mm",
  i: "I, units/(mm·s)",
  d: "D, units/mm",
  kv: "Kv, 1/s",
  forward: "Fed forward, 0 to 1",
  blu: "A pulse (BLU), mm",
};

interface Keyed<Key> {
  readonly key: Key;
  readonly slid: Slid;
}

export class WordForms {
  readonly curve: HTMLElement;
  readonly lanes: HTMLElement;
  private readonly fields = new Fields();
  private readonly numbers: Keyed<CurveNumber>[];
  private readonly groups: { readonly element: HTMLElement; readonly numbers: readonly Keyed<LaneNumber>[] }[] = [];
  private readonly removes: HTMLButtonElement[] = [];
  private readonly add = html("button", { type: "button", id: "add-lane", click: () => this.append() }, "Add a lane");
  private state: State | undefined;

  constructor(private readonly events: FormEvents) {
    const { fields } = this;
    this.numbers = (["a", "b", "feed", "period", "acceleration", "jerk", "tolerance"] as const).map((key) => ({
      key,
      slid: new Slid(fields, key, curveLabels[key], rangeOf(key), (text) => events.change({ [key]: text })),
    }));
    const ready: (readonly [string, string])[] = [
      ["", "Choose a comparison"],
      ...comparisons.map(({ id, title }) => [id, title] as const),
    ];
    this.curve = html(
      "section",
      { class: "panel", "aria-labelledby": "curve-title" },
      html("h2", { id: "curve-title" }, "Curve, feed, period"),
      fields.select("comparison", "Comparison", ready, (id) => {
        const chosen = comparisons.find((each) => each.id === id);
        if (chosen !== undefined) events.choose(chosen);
      }),
      fields.select(
        "curve",
        "Curve",
        curveKinds.map((kind) => [kind, curveTitles[kind]] as const),
        (kind) => events.change({ curve: kind as CurveKind, camera: undefined }),
      ),
      ...this.numbers.map(({ slid }) => slid.element),
      fields.select(
        "magnified",
        "Errors drawn",
        magnifications.map((times) => [String(times), times === 1 ? "as they are" : `${times} times`] as const),
        (times) => events.magnify(Number(times)),
      ),
    );
    for (let number = 0; number < mostLanes; ++number) this.group(number);
    this.lanes = html(
      "section",
      { class: "panel lanes", "aria-labelledby": "lanes-title" },
      html("h2", { id: "lanes-title" }, "Methods and loops"),
      ...this.groups.map(({ element }) => element),
      html("div", { class: "buttons" }, this.add),
    );
  }

  private group(number: number): void {
    const remove = html(
      "button",
      { type: "button", id: `remove-${number + 1}`, "aria-label": `Remove lane ${number + 1}` },
      "×",
    );
    remove.addEventListener("click", () => this.events.lanes(this.all.filter((_, i) => i !== number)));
    this.removes.push(remove);
    const name = (label: string): string => `${label}, lane ${number + 1}`;
    const select = (
      key: "method" | "loops",
      label: string,
      options: readonly (readonly [string, string])[],
    ): HTMLElement =>
      this.fields.select(`${key}-${number + 1}`, label, options, (value) => this.set(number, key, value), name(label));
    const numbers = laneNumbers.map((key) => {
      const change = (text: string): void => this.set(number, key, text);
      const label = laneLabels[key];
      return {
        key,
        slid: new Slid(this.fields, `${key}-${number + 1}`, label, rangeOf(key), change, name(label)),
      };
    });
    const element = html(
      "fieldset",
      { class: "lane" },
      html("legend", { class: "hidden" }, `Lane ${number + 1}`),
      html(
        "div",
        { class: "lane-head" },
        mark(number),
        select(
          "method",
          "Method",
          methods.map((each) => [each, methodTitles[each]] as const),
        ),
        remove,
      ),
      select(
        "loops",
        "Followed by",
        loopKinds.map((each) => [each, loopTitles[each]] as const),
      ),
      ...numbers.map(({ slid }) => slid.element),
    );
    this.groups.push({ element, numbers });
  }

  private get all(): readonly Lane[] {
    return this.state?.lanes ?? [];
  }

  private set(number: number, key: keyof Lane, value: string): void {
    this.events.lanes(this.all.map((lane, i) => (i === number ? { ...lane, [key]: value } : lane)));
  }

  private append(): void {
    const used = new Set(this.all.map(({ method }) => method));
    const next = methods.find((each) => !used.has(each)) ?? methods[0];
    this.events.lanes([...this.all, laneOf(next)]);
  }

  update(state: State, chosen: Comparison | undefined, curve: FieldErrors, lanes: readonly FieldErrors[]): void {
    this.state = state;
    this.fields.show("comparison", chosen?.id ?? "", true);
    this.fields.show("curve", state.curve, true);
    this.fields.show("magnified", String(state.magnified), true);
    for (const { key, slid } of this.numbers) {
      const isShown =
        key === "a"
          ? state.curve !== "cubic"
          : key === "b"
            ? state.curve !== "cubic" && state.curve !== "circle"
            : key !== "tolerance" || state.lanes.some(({ method }) => method === "blend");
      slid.show(state[key], isShown, "", curve.get(key));
    }
    this.groups.forEach(({ element, numbers }, number) => {
      const lane = state.lanes[number];
      element.hidden = lane === undefined;
      if (lane === undefined) return;
      const errors = lanes[number];
      const uses = usesOf(lane, state);
      this.fields.show(`method-${number + 1}`, lane.method, true, errors?.get("method"));
      this.fields.show(`loops-${number + 1}`, lane.loops, hasLoops(lane), errors?.get("loops"));
      for (const { key, slid } of numbers) {
        slid.show(lane[key], uses[key], state.period, errors?.get(key));
      }
    });
    for (const remove of this.removes) remove.disabled = state.lanes.length === 1;
    this.add.disabled = state.lanes.length === mostLanes;
  }
}
