// The path in space with what it is coloured by, from where it is seen, and what its colours mean.

import { holds, parts, type Plan } from "../engine/motion_types";
import { fixed, html } from "../ui/dom";
import { views, type View } from "./camera";
import { css, holdColour, partColour, rangeOf, scaleColour } from "./colours";
import { colourings, type Colouring, type Settings } from "./settings";
import { PathView } from "./view";

const names: Readonly<Record<Colouring, string>> = {
  speed: "Feed",
  acceleration: "Acceleration",
  jerk: "Jerk",
  deviation: "Distance to tolerance",
  limit: "What holds it",
  part: "Pass and link",
  line: "Line",
};
const units: Readonly<Record<Colouring, string>> = {
  speed: "mm/min",
  acceleration: "mm/s²",
  jerk: "mm/s³",
  deviation: "% of the tolerance",
  limit: "",
  part: "",
  line: "",
};
const holdNames: Readonly<Record<(typeof holds)[number], string>> = {
  feed: "feed word",
  velocity: "velocity",
  acceleration: "acceleration",
  jerk: "jerk",
  rest: "rest",
  shape: "what comes",
  chord: "chord error",
};

const partNames: Readonly<Record<(typeof parts)[number], string>> = {
  none: "no surface",
  approach: "approach",
  pass: "pass",
  link: "link",
  retract: "away",
};

export interface PathCalls {
  picked(sample: number): void;
  coloured(colouring: Colouring): void;
  /** How far the plan is from its program is to be shown, and has not been judged yet. */
  unjudged(): void;
  /** The programmed contour is to be shown, or no more. */
  contoured(isShown: boolean): void;
  /** It is seen from elsewhere, as `view.seen` says. */
  moved(): void;
}

function keyOf(background: string, name: string): HTMLElement {
  const chip = html("span", { class: "chip" });
  chip.style.background = background;
  return html("span", { class: "key" }, chip, name);
}

/** 0.0123 mm as 12.3 µm. */
export function micrometres(mm: number): string {
  return `${Number((mm * 1000).toPrecision(3))} µm`;
}

/** The tolerance that is 100 %, and how near motion comes to it. */
function deviationText({ deviations: of, samples, blocks }: Plan): string {
  if (of === undefined) return "is being judged";
  const [least, greatest] = of.tolerances.map(micrometres);
  const tolerance = least === greatest ? least : `${least} to ${greatest}`;
  const line = blocks.line[samples.block[of.worst] ?? 0] ?? 0;
  const far = micrometres(of.distance[of.worst] ?? 0);
  return `100 % is ${tolerance}; nearest to it ${far}, ${fixed(of.share * 100, 0)} %, line ${line}`;
}

export class PathPanel {
  readonly view: PathView;
  private plan: Plan | undefined;
  private readonly choice = html("select", { id: "colouring", change: () => this.colour() });
  private readonly contour = html("input", { type: "checkbox", id: "contour", change: () => this.showContour() });
  private readonly contourChoice = html(
    "label",
    { class: "inline", for: "contour" },
    this.contour,
    " Programmed contour",
  );
  private readonly legend = html("div", { class: "legend", id: "legend" });

  constructor(private readonly calls: PathCalls) {
    this.view = new PathView(
      (sample) => calls.picked(sample),
      () => calls.moved(),
    );
    for (const each of colourings) this.choice.append(new Option(names[each], each));
  }

  element(now: HTMLElement, ...below: readonly HTMLElement[]): HTMLElement {
    const seen = (Object.keys(views) as View[]).map((view) =>
      html("button", { type: "button", id: `view-${view}`, click: () => this.view.look(view) }, views[view].name),
    );
    return html(
      "section",
      { class: "panel", "aria-label": "Path" },
      html(
        "div",
        { class: "panel-head" },
        html("h2", {}, "Path"),
        html(
          "div",
          { class: "tools" },
          html("label", { class: "inline", for: "colouring" }, "Coloured by"),
          this.choice,
          this.contourChoice,
          html(
            "div",
            { class: "buttons", role: "group", "aria-label": "Seen from" },
            ...seen,
            html("button", { type: "button", id: "view-fit", click: () => this.view.fit() }, "Fit"),
          ),
        ),
      ),
      html("div", { class: "stage" }, this.view.element, now),
      this.legend,
      ...below,
    );
  }

  show({ colouring, hasContour }: Pick<Settings, "colouring" | "hasContour">): void {
    this.choice.value = colouring;
    this.contour.checked = hasContour;
    this.view.showContour(hasContour);
  }

  load(plan: Plan, colouring: Colouring, seen: string | undefined): void {
    this.plan = plan;
    this.contourChoice.hidden = plan.contour.length === 0;
    this.view.load(plan, colouring, seen);
    this.showLegend(plan);
  }

  showLegend(plan: Plan | undefined): void {
    if (plan === undefined) return;
    const colouring = this.choice.value as Colouring;
    const isDark = getComputedStyle(document.documentElement).colorScheme === "dark";
    const hasContour = plan.contour.length > 0 && this.contour.checked;
    const dashed = [
      html("span", { class: "key rapid" }, "rapid"),
      ...(hasContour ? [html("span", { class: "key contour" }, "programmed contour")] : []),
    ];
    if (colouring === "limit" || colouring === "part") {
      const keys =
        colouring === "limit"
          ? holds.map((hold, i) => keyOf(css(holdColour(i, isDark)), holdNames[hold]))
          : parts.map((part, i) => keyOf(css(partColour(i, isDark)), partNames[part]));
      this.legend.replaceChildren(...keys, ...dashed);
      return;
    }
    const ramp = html("span", { class: "ramp" });
    const stops = [...Array(11).keys()].map((i) => css(scaleColour(i / 10, isDark)));
    ramp.style.background = `linear-gradient(90deg, ${stops.join(", ")})`;
    const scale = colouring === "speed" ? 60 : colouring === "deviation" ? 100 : 1;
    const [least, greatest] = rangeOf(plan, colouring);
    this.legend.replaceChildren(
      html("span", { class: "number" }, fixed(least * scale, 0)),
      ramp,
      html("span", { class: "number" }, `${fixed(greatest * scale, 0)} ${units[colouring]}`),
      ...(colouring === "deviation" ? [html("span", { id: "deviation" }, deviationText(plan))] : []),
      ...dashed,
    );
  }

  /** Of the plan that is shown. */
  judge(plan: Plan): void {
    this.view.judge(plan);
    this.showLegend(plan);
  }

  private askForJudgement(): void {
    const { plan } = this;
    if (plan !== undefined && plan.deviations === undefined && this.choice.value === "deviation") this.calls.unjudged();
  }

  private showContour(): void {
    this.view.showContour(this.contour.checked);
    this.showLegend(this.plan);
    this.calls.contoured(this.contour.checked);
  }

  private colour(): void {
    const colouring = this.choice.value as Colouring;
    this.view.paint(colouring);
    this.showLegend(this.plan);
    this.calls.coloured(colouring);
    this.askForJudgement();
  }
}
