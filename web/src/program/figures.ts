// What the motion comes to, what the tool does now, and where time is lost.

import type { LiveMachine, LiveSample } from "../engine/live_types";
import { axisLetters, holds, type Plan } from "../engine/motion_types";
import { isRapid } from "../engine/path";
import { fixed, html } from "../ui/dom";

function seconds(value: number): string {
  if (value < 100) return `${fixed(value, 3)} s`;
  return `${Math.floor(value / 60)} min ${fixed(value % 60, 1)} s`;
}

function percent(ratio: number): string {
  return `${fixed(ratio * 100, 1)} %`;
}

function list(name: string, label: string): HTMLElement {
  return html("dl", { class: "numbers", id: name, "aria-label": label });
}

/** Names and values; elements that are there already are kept. */
export function put(into: HTMLElement, rows: readonly (readonly [string, string])[]): void {
  const known = [...into.children] as HTMLElement[];
  if (known.length === rows.length && rows.every(([name], i) => known[i]?.dataset["name"] === name)) {
    rows.forEach(([, value], i) => (known[i]!.lastElementChild!.textContent = value));
    return;
  }
  into.replaceChildren(
    ...rows.map(([name, value]) => html("div", { "data-name": name }, html("dt", {}, name), html("dd", {}, value))),
  );
}

function heldBy(hold: (typeof holds)[number], axis: string): string {
  if (hold === "shape") return "what comes";
  if (hold === "chord") return "chord error";
  return hold === "feed" || hold === "rest" ? hold : `${hold} ${axis}`;
}

/** Where it has been judged. */
function offPath({ deviations: of }: Plan, sample: number): [string, string][] {
  if (of === undefined) return [];
  const [distance, tolerance] = [of.distance[sample] ?? 0, of.tolerance[sample] ?? 0];
  return [["Off the program, µm", `${fixed(distance * 1000, 2)} of ${fixed(tolerance * 1000, 1)}`]];
}

export class FiguresPanel {
  readonly figures = list("figures", "Figures of the motion");
  readonly now = list("now", "Now");

  load(plan: Plan): void {
    const { figures, path } = plan;
    const greatest = (values: readonly number[]): string => {
      const most = Math.max(...values);
      return `${percent(most)} ${axisLetters[values.indexOf(most)] ?? ""}`;
    };
    put(this.figures, [
      ["Time", seconds(figures.time)],
      ["No controller under", seconds(figures.bound)],
      ["Velocity of limit", greatest(figures.velocity)],
      ["Acceleration of limit", greatest(figures.acceleration)],
      ["Jerk of limit", greatest(figures.jerk)],
      ["Path", `${fixed(figures.length, 2)} mm`],
      ["Words", figures.words.toLocaleString("en")],
      ["Blocks", figures.blocks.toLocaleString("en")],
      ...[0, 1, 2].map((i): [string, string] => [
        `Extent ${axisLetters[i]}`,
        `${fixed(path.least[i] ?? 0, 2)} … ${fixed(path.greatest[i] ?? 0, 2)}`,
      ]),
    ]);
  }

  /** Of a machine that is driven: where its slides are. */
  follow(machine: LiveMachine, sample: LiveSample): void {
    put(this.now, [
      ["Line", String(sample.line)],
      ...machine.axes.map(({ name }, i): [string, string] => [name, fixed(sample.actual[i] ?? 0, 3)]),
      ["Feed, mm/min", fixed(sample.measured_feed * 60, 0)],
    ]);
  }

  stand(plan: Plan, sample: number): void {
    const { samples, blocks } = plan;
    const block = samples.block[sample] ?? 0;
    const hold = holds[samples.hold[sample] ?? 0] ?? "shape";
    const axis = axisLetters[samples.axes[samples.holdAxis[sample] ?? 0] ?? 0] ?? "";
    const asked = blocks.feedAsked[block] ?? 0;
    put(this.now, [
      ["Line", String(blocks.line[block] ?? 0)],
      ...samples.axes.map((each, k): [string, string] => [
        axisLetters[each] ?? "",
        fixed(samples.position[sample * samples.axes.length + k] ?? 0, 3),
      ]),
      ["Feed, mm/min", fixed((samples.feed[sample] ?? 0) * 60, 0)],
      ["Asked", isRapid(samples, blocks, sample) ? "rapid" : fixed(asked * 60, 0)],
      ["Held by", heldBy(hold, axis)],
      ...offPath(plan, sample),
    ]);
  }
}

export class LossTable {
  readonly element: HTMLElement;
  private readonly rows = html("tbody", {});
  private readonly note = html("p", { class: "note" });

  constructor(private readonly chosen: (line: number, time: number) => void) {
    this.element = html(
      "section",
      { class: "panel losses", "aria-label": "Where time is lost" },
      html("h2", {}, "Where time is lost"),
      this.note,
      html(
        "div",
        { class: "table", tabindex: 0, role: "group", "aria-label": "Lines by lost time" },
        html(
          "table",
          {},
          html(
            "thead",
            {},
            html(
              "tr",
              {},
              ...["Line", "Lost, s", "Took, s", "Feed, mm/min", "Reached", "Mostly by"].map((name) =>
                html("th", { scope: "col" }, name),
              ),
            ),
          ),
          this.rows,
        ),
      ),
    );
  }

  load(plan: Plan): void {
    const { blocks } = plan;
    const { moves, dearest } = plan.lost;
    const lost = (i: number): number => (blocks.seconds[i] ?? 0) - (blocks.leastSeconds[i] ?? 0);
    const most = Math.max(lost(dearest[0] ?? 0), 1e-9);
    this.note.textContent =
      moves === 0
        ? "Nowhere: feed is kept throughout"
        : `${fixed(plan.lost.seconds, 2)} s beyond what feed words ask, in ${moves.toLocaleString("en")} moves` +
          (moves > dearest.length ? `; the ${dearest.length} dearest` : "");
    this.rows.replaceChildren(
      ...dearest.map((i) => {
        const line = blocks.line[i] ?? 0;
        const asked = blocks.feedAsked[i] ?? 0;
        const bar = html("span", { class: "bar" });
        bar.style.width = `${(100 * lost(i)) / most}%`;
        return html(
          "tr",
          { "data-line": line },
          html(
            "td",
            {},
            html(
              "button",
              { type: "button", class: "link", click: () => this.chosen(line, blocks.begin[i] ?? 0) },
              String(line),
            ),
          ),
          html("td", { class: "with-bar" }, bar, fixed(lost(i), 3)),
          html("td", {}, fixed(blocks.seconds[i] ?? 0, 3)),
          html("td", {}, asked === Infinity ? "rapid" : asked === 0 ? "dwell" : fixed(asked * 60, 0)),
          html("td", {}, fixed((blocks.feedReached[i] ?? 0) * 60, 0)),
          html("td", {}, blocks.causes[blocks.cause[i] ?? 0] ?? ""),
        );
      }),
    );
  }
}
