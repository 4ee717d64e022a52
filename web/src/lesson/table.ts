// The process data: a row a cycle until now. Only rows in sight are in the page.

import { html, signed } from "../ui/dom";
import type { Session } from "./session";

const rowHeight = 26;
const headHeight = 32;
const spare = 4;

/** The columns in the order of `leadscrew pulse --table`, then what the cycle added. */
export class Table {
  private readonly head = html("thead");
  private readonly body = html("tbody");
  private readonly table = html(
    "table",
    {},
    html("caption", { class: "hidden" }, "Process data, a row a cycle"),
    this.head,
    this.body,
  );
  readonly element = html(
    "div",
    { class: "table", tabindex: 0, role: "region", "aria-label": "Process data", scroll: () => this.scroll() },
    this.table,
  );
  private session: Session | undefined;
  private columns: readonly string[] = [];
  private shown = -1;
  // As they were last told: to ask for them would lay the whole page out anew.
  private top = 0;
  private follows = 0;
  private height = 320;

  constructor(private readonly onChoose: (clock: number) => void) {
    new ResizeObserver(([entry]) => (this.height = entry?.contentRect.height ?? this.height)).observe(this.element);
  }

  private scroll(): void {
    // What follow() scrolled is drawn already, and is not the reader's wish.
    if (this.follows !== 0 || Math.abs(this.element.scrollTop - this.top) < 2) return;
    this.top = this.element.scrollTop;
    this.draw();
  }

  update(session: Session): void {
    this.session = session;
    const columns = session.recording?.columns ?? [];
    if (columns !== this.columns) {
      this.columns = columns;
      this.head.replaceChildren(
        html(
          "tr",
          {},
          ...columns.map((name) => html("th", { scope: "col", class: name.length > 5 ? "long" : undefined }, name)),
        ),
      );
    }
    this.table.setAttribute("aria-rowcount", String(session.clock + 2));
    if (session.clock !== this.shown) {
      this.shown = session.clock;
      this.top = Math.max(0, (session.clock + 1) * rowHeight + headHeight - this.height);
      this.draw();
      if (this.follows === 0) this.follows = requestAnimationFrame(() => this.follow());
      return;
    }
    this.draw();
  }

  /** Once a frame: scrolling lays the page out. */
  private follow(): void {
    this.follows = 0;
    this.element.scrollTop = this.top;
  }

  private draw(): void {
    const { session, body } = this;
    if (session === undefined) return;
    const first = Math.max(0, Math.floor(this.top / rowHeight) - spare);
    const count = Math.ceil(this.height / rowHeight) + 2 * spare;
    const last = Math.min(session.clock, first + count);
    const rows: HTMLElement[] = [];
    if (first > 0) rows.push(this.space(first));
    for (let clock = first; clock <= last; ++clock) rows.push(this.row(session, clock));
    if (last < session.clock) rows.push(this.space(session.clock - last));
    body.replaceChildren(...rows);
  }

  private space(rows: number): HTMLElement {
    const cell = html("td", { colspan: this.columns.length });
    cell.style.height = `${rows * rowHeight}px`;
    return html("tr", { "aria-hidden": "true", class: "space" }, cell);
  }

  private row(session: Session, clock: number): HTMLElement {
    const isNow = clock === session.clock;
    const border = session.isBorder(clock) ? " border" : "";
    const cells = this.columns.map((name) =>
      html("td", this.look(name, session.value(clock, name)), signed(session.value(clock, name))),
    );
    return html(
      "tr",
      {
        class: `${isNow ? "now" : ""}${border}`,
        "aria-rowindex": clock + 2,
        "aria-current": isNow ? "step" : undefined,
        "data-clock": clock,
        click: () => this.onChoose(clock),
      },
      ...cells,
    );
  }

  private look(name: string, value: number): Record<string, string> {
    if ((name === "dx" || name === "ox") && value !== 0) return { class: "on-x" };
    if ((name === "dy" || name === "oy") && value !== 0) return { class: "on-y" };
    return {};
  }
}
