// The panel of display: graph, feed directions, numbers of this cycle, why it stepped so, data flow, process data.

import { CanvasPicture } from "../draw/picture";
import type { Task } from "../engine/types";
import { fixed, html, signed, stepText } from "../ui/dom";
import { csvText, download, pngBlob, svgText, vcdText } from "./files";
import { Flow } from "./flow";
import { drawGraph, drawWaves, graphText } from "./graph";
import type { Session } from "./session";
import type { Settings } from "./settings";
import { Table } from "./table";

export interface DisplayEvents {
  change(change: Partial<Settings>): void;
  seek(clock: number): void;
}

export class Display {
  readonly element: HTMLElement;
  private readonly graph = html("canvas", { role: "img", id: "graph" });
  private readonly waves = html("canvas", { role: "img", id: "waves" });
  private readonly numbers = html("dl", { class: "numbers", "aria-label": "This cycle" });
  private readonly why = html("div", { class: "why", id: "why", "aria-live": "polite" });
  private readonly probe = html("output", { class: "probe", id: "probe" });
  private readonly command = html("code", { id: "command", tabindex: 0 });
  private readonly compare = html("a", { id: "to-compare", href: "./compare.html" }, "Compare with other methods");
  private readonly views: HTMLSelectElement;
  private readonly predict: HTMLInputElement;
  private draws = 0;
  private readonly sizes = new Map<Element | null, readonly [number, number]>();
  private readonly flow = new Flow((text) => (this.probe.textContent = text));
  private readonly table: Table;
  private shown: { task: Task; session: Session; settings: Settings; command: string } | undefined;

  constructor(events: DisplayEvents) {
    this.table = new Table((clock) => events.seek(clock));
    this.views = html("select", {
      id: "view",
      "aria-label": "What the graph shows",
      change: () => events.change({ view: this.views.value as Settings["view"] }),
    });
    this.views.append(new Option("Whole curve", "whole"), new Option("Around the tool", "near"));
    this.predict = html("input", {
      type: "checkbox",
      id: "predict",
      change: () => events.change({ predict: this.predict.checked }),
    });
    this.element = html("div", { class: "display" }, ...this.content());
    const sizes = new ResizeObserver((entries) => {
      for (const { target, contentRect } of entries) this.sizes.set(target, [contentRect.width, contentRect.height]);
      this.draw();
    });
    for (const canvas of [this.graph, this.waves])
      if (canvas.parentElement !== null) sizes.observe(canvas.parentElement);
  }

  private content(): HTMLElement[] {
    return [
      html(
        "section",
        { class: "panel graph-panel", "aria-labelledby": "graph-title" },
        html(
          "div",
          { class: "panel-head" },
          html("h2", { id: "graph-title" }, "Path"),
          html(
            "div",
            { class: "tools" },
            this.views,
            html("label", { class: "choice", for: "predict" }, this.predict, "Predict"),
          ),
        ),
        html("div", { class: "stage" }, html("div", { class: "frame" }, this.graph), this.numbers),
        this.why,
      ),
      html(
        "section",
        { class: "panel", "aria-labelledby": "waves-title" },
        html("h2", { id: "waves-title" }, "Feed direction"),
        html("div", { class: "frame waves" }, this.waves),
      ),
      html(
        "section",
        { class: "panel", "aria-labelledby": "flow-title" },
        html("div", { class: "panel-head" }, html("h2", { id: "flow-title" }, "From register to pulse"), this.probe),
        html("div", { class: "flow-frame" }, this.flow.element),
      ),
      html(
        "section",
        { class: "panel", "aria-labelledby": "table-title" },
        html("h2", { id: "table-title" }, "Process data"),
        this.table.element,
        this.exports(),
      ),
    ];
  }

  private exports(): HTMLElement {
    const button = (id: string, text: string, press: () => void): HTMLElement =>
      html("button", { type: "button", id, click: press }, text);
    return html(
      "div",
      { class: "exports" },
      html(
        "div",
        { class: "buttons" },
        button("save-svg", "SVG", () => this.save("svg")),
        button("save-png", "PNG", () => this.save("png")),
        button("save-csv", "CSV", () => this.save("csv")),
        button("save-vcd", "VCD", () => this.save("vcd")),
        button("copy-link", "Copy link", () => void navigator.clipboard?.writeText(location.href)),
        button("copy-command", "Copy command", () => void navigator.clipboard?.writeText(this.shown?.command ?? "")),
        this.compare,
      ),
      html("p", { class: "command" }, this.command),
    );
  }

  /** `comparison`: the link of the page that lays it beside others. */
  update(task: Task | undefined, session: Session, settings: Settings, command: string, comparison: string): void {
    this.element.classList.toggle("stale", task === undefined);
    if (task === undefined || session.recording === undefined) return;
    this.shown = { task, session, settings, command };
    this.views.value = settings.view;
    this.predict.checked = settings.predict;
    this.command.textContent = command;
    this.compare.href = `./compare.html${comparison}`;
    this.flow.update(session, task.shape === "arc");
    this.table.update(session);
    this.showNumbers(session);
    if (this.draws === 0) this.draws = requestAnimationFrame(() => this.draw());
  }

  showWhy(text: string): void {
    const lines =
      text === ""
        ? ["The registers are loaded. The next cycle makes the first additions or comparisons."]
        : text.split("\n");
    this.why.replaceChildren(...lines.map((line) => html("p", {}, line)));
  }

  /** At most once a frame, unless the page's look has changed. */
  draw(): void {
    this.draws = 0;
    if (this.shown === undefined) return;
    const { task, session, settings } = this.shown;
    drawGraph(new CanvasPicture(this.graph, ...this.sizeOf(this.graph)), task, session, settings);
    drawWaves(new CanvasPicture(this.waves, ...this.sizeOf(this.waves)), session);
    this.graph.setAttribute("aria-label", graphText(task, session));
    const [x, y] = [session.value(session.clock, "dx"), session.value(session.clock, "dy")];
    this.waves.setAttribute(
      "aria-label",
      `Feed directions of X and Y until cycle ${session.clock}: now ${stepText(x)} and ${stepText(y)}`,
    );
  }

  /** Of the frame around a canvas, as it was last told. */
  private sizeOf(canvas: HTMLCanvasElement): [number, number] {
    const [width, height] = this.sizes.get(canvas.parentElement) ?? [640, 320];
    return [Math.max(200, Math.round(width)), Math.max(100, Math.round(height))];
  }

  private showNumbers(session: Session): void {
    const { clock } = session;
    const row = session.row(clock);
    const items: [string, string][] = [
      ["Cycle", `${clock}`],
      ["Pulses", `${session.figure(clock, "pulses")}`],
      ["X", signed(row.value("X"))],
      ["Y", signed(row.value("Y"))],
      ["Error now", fixed(session.figure(clock, "error"), 3)],
      ["Greatest", fixed(session.figure(clock, "maxError"), 3)],
      ["RMS", fixed(session.figure(clock, "rmsError"), 3)],
    ];
    const quadrant = row.value("quadrant"); // in parentheses as the table has it, and the command
    if (row.has("quadrant")) items.push(["Quadrant", `${["I", "II", "III", "IV"][quadrant] ?? ""} (${quadrant})`]);
    if (row.has("n") && row.has("Sx")) items.push(["Clocks left", `${row.value("n")}`]);
    if (row.has("nx")) items.push(["Left x, y", `${row.value("nx")}, ${row.value("ny")}`]);
    this.numbers.replaceChildren(
      ...items.map(([name, value]) => html("div", { "data-name": name }, html("dt", {}, name), html("dd", {}, value))),
    );
  }

  private save(kind: "svg" | "png" | "csv" | "vcd"): void {
    if (this.shown === undefined) return;
    const { task, session, settings } = this.shown;
    const name = `leadscrew-${task.method}-${session.clock}.${kind}`;
    if (kind === "svg") download(name, svgText(task, session, settings), "image/svg+xml");
    if (kind === "csv") download(name, csvText(session), "text/csv");
    if (kind === "vcd") download(name, vcdText([{ name: task.method, session }], session.clock), "text/plain");
    if (kind === "png") void pngBlob(task, session, settings).then((blob) => download(name, blob, "image/png"));
  }
}
