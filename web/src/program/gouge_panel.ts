// Where the tool gouges the surfaces that a program machines, and where it passes poles of the machine: each leads there.

import { parts, toolParts, type Diagnostic, type Gouge, type Plan } from "../engine/motion_types";
import { sampleOfGouge } from "../engine/path";
import { fixed, html } from "../ui/dom";

export interface GougeCalls {
  /** Undefined where something else has been asked for meanwhile. */
  look(): Promise<readonly Gouge[] | Diagnostic | undefined>;
  found(gouges: readonly Gouge[]): void;
  chosen(sample: number): void;
}

function whereOf(gouge: Gouge): string {
  const part = parts[gouge.part] ?? "none";
  return part === "pass" || part === "link" ? `${part} ${gouge.pass}` : part === "none" ? "" : part;
}

export class GougePanel {
  readonly element: HTMLElement;
  private plan: Plan | undefined;
  private readonly button = html(
    "button",
    { type: "button", id: "gouges-look", click: () => void this.look() },
    "Look",
  );
  private readonly note = html("p", { class: "note", id: "gouges-note", role: "status" });
  private readonly poles = html("ul", { class: "places", id: "poles" });
  private readonly rows = html("tbody", { id: "gouges" });
  private readonly table: HTMLElement;

  constructor(private readonly calls: GougeCalls) {
    const columns = ["Line", "Where", "Part of the tool", "Surface", "Depth, mm", "u", "v"];
    this.table = html(
      "div",
      { class: "table", tabindex: 0, role: "group", "aria-label": "Gouges" },
      html("table", {}, html("thead", {}, html("tr", {}, ...columns.map((each) => html("th", {}, each)))), this.rows),
    );
    this.element = html(
      "section",
      { class: "panel gouges", "aria-label": "Gouges and poles" },
      html("div", { class: "panel-head" }, html("h2", {}, "Gouges and poles"), this.button),
      this.note,
      this.table,
      this.poles,
    );
  }

  load(plan: Plan): void {
    this.plan = plan;
    this.rows.replaceChildren();
    this.table.hidden = true;
    this.button.hidden = plan.surfaces.length === 0;
    this.note.textContent = "Look checks every move against the surfaces, as leadscrew check --gouge does.";
    this.note.hidden = plan.surfaces.length === 0;
    this.poles.replaceChildren(...plan.poles.map(({ sample, angle }) => this.poleOf(sample, angle)));
    this.element.hidden = plan.surfaces.length === 0 && plan.poles.length === 0;
  }

  private poleOf(sample: number, angle: number): HTMLElement {
    const line = this.plan?.samples.line[sample] ?? 0;
    const text = `Line ${line}: ${fixed(angle, 3)}° from a pole, where the first rotary axis may stand anywhere`;
    return html("li", {}, html("button", { type: "button", click: () => this.calls.chosen(sample) }, text));
  }

  private async look(): Promise<void> {
    const { plan } = this;
    this.button.disabled = true;
    const found = await this.calls.look().finally(() => (this.button.disabled = false));
    if (found === undefined || plan === undefined || plan !== this.plan) return;
    if (!("length" in found)) {
      this.note.textContent = found.message;
      return;
    }
    this.show(found);
  }

  /** Of the plan that is loaded. */
  show(found: readonly Gouge[]): void {
    const { plan } = this;
    if (plan === undefined) return;
    this.note.textContent =
      found.length === 0
        ? "No tool of a told shape is deeper in a surface than the tolerance."
        : `${found.length} found.`;
    this.table.hidden = found.length === 0;
    this.rows.replaceChildren(...found.map((gouge) => this.rowOf(plan, gouge)));
    this.calls.found(found);
  }

  private rowOf(plan: Plan, gouge: Gouge): HTMLElement {
    const go = (): void => this.calls.chosen(sampleOfGouge(plan, gouge));
    const cells = [
      whereOf(gouge),
      toolParts[gouge.toolPart] ?? "",
      `D${gouge.surface}`,
      gouge.depth > 0 ? fixed(gouge.depth, 4) : "bends less",
      fixed(gouge.u, 4),
      fixed(gouge.v, 4),
    ];
    return html(
      "tr",
      {},
      html("td", {}, html("button", { type: "button", click: go }, String(gouge.line))),
      ...cells.map((cell) => html("td", {}, cell)),
    );
  }
}
