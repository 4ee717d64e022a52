// The data flow of one cycle: registers, what is worked out from them, pulses. A wire lights up when the cycle sent
// something along it, and shows its value to whoever points at it or tabs to it.

import { signed, stepText, svg } from "../ui/dom";
import type { Row, Session } from "./session";

interface Block {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly title: string;
  /** Of the register, or nothing. */
  readonly value: (now: Moment) => string;
  readonly isLit?: (now: Moment) => boolean;
  readonly kind: "register" | "sum" | "choice" | "pulse";
}

interface Wire {
  readonly path: string;
  readonly name: string;
  /** Where its value is shown. */
  readonly at: readonly [number, number];
  readonly value: (now: Moment) => string;
  readonly isLit: (now: Moment) => boolean;
  readonly isBack?: boolean;
}

/** The cycle that led here. */
interface Moment {
  readonly before: Row;
  readonly after: Row;
  readonly isFirst: boolean;
}

interface Diagram {
  readonly height: number;
  readonly blocks: readonly Block[];
  readonly wires: readonly Wire[];
}

const width = 660;

/** One integrator: J and r are added; what overflows is a pulse, what is left goes back. */
function lane(axis: "x" | "y", top: number, isFree: boolean): Diagram {
  const capital = axis.toUpperCase();
  const n = isFree ? "n" : `n${axis}`; // of one that runs freely the clocks that are left
  const [J, r, S, o, d] = [`J${axis}`, `r${axis}`, `S${axis}`, `o${axis}`, `d${axis}`] as const;
  const isClocked = (now: Moment): boolean => !now.isFirst && now.before.value(n) > 0;
  const steps = (now: Moment): boolean => now.after.value(d) !== 0;
  const of = (column: string) => (now: Moment) => signed(now.after.value(column));
  const had = (column: string) => (now: Moment) => signed(now.before.value(column));
  const y = top + 18;
  return {
    height: 124,
    blocks: [
      { x: 8, y, width: 92, title: `${J} integrand`, value: of(J), kind: "register", isLit: isClocked },
      { x: 168, y, width: 92, title: `${S} sum`, value: of(S), kind: "sum", isLit: isClocked },
      { x: 328, y, width: 92, title: `${S} ≥ q?`, value: of("q"), kind: "choice", isLit: isClocked },
      {
        x: 488,
        y,
        width: 72,
        title: `${capital} pulse`,
        value: (now) => stepText(now.after.value(d)),
        kind: "pulse",
        isLit: steps,
      },
      { x: 592, y, width: 60, title: `${n} left`, value: of(n), kind: "register", isLit: steps },
      { x: 168, y: y + 62, width: 92, title: `${r} remainder`, value: of(r), kind: "register", isLit: isClocked },
    ],
    wires: [
      { path: `M100 ${y + 20}H166`, name: `${J} into the sum`, at: [133, y + 12], value: of(J), isLit: isClocked },
      {
        path: `M214 ${y + 62}V${y + 42}`,
        name: `${r} into the sum`,
        at: [240, y + 56],
        value: had(r),
        isLit: isClocked,
      },
      {
        path: `M260 ${y + 20}H326`,
        name: `${S} to the comparison with q`,
        at: [293, y + 12],
        value: of(S),
        isLit: isClocked,
      },
      {
        path: `M420 ${y + 20}H486`,
        name: `overflow of ${axis}`,
        at: [453, y + 12],
        value: of(o),
        isLit: (now) => now.after.value(o) !== 0,
      },
      {
        path: `M560 ${y + 20}H590`,
        name: `${capital} pulse to its counter`,
        at: [575, y + 12],
        value: (now) => stepText(now.after.value(d)),
        isLit: steps,
      },
      {
        path: `M374 ${y + 40}V${y + 82}H262`,
        name: `rest of ${axis} back to its register`,
        at: [318, y + 74],
        value: of(r),
        isLit: isClocked,
        isBack: true,
      },
    ],
  };
}

/** Of an arc each axis' pulse changes the other one's integrand. */
function crossing(): Wire[] {
  const wire = (from: "x" | "y", path: string, at: readonly [number, number]): Wire => {
    const other = from === "x" ? "y" : "x";
    return {
      path,
      name: `${from.toUpperCase()} pulse to the integrand J${other}`,
      at,
      value: (now) => stepText(now.after.value(`d${from}`)),
      isLit: (now) => now.after.value(`d${from}`) !== 0,
      isBack: true,
    };
  };
  return [wire("x", "M524 58V124H64V140", [300, 118]), wire("y", "M540 142V132H54V60", [420, 142])];
}

function ofIntegrators(isArc: boolean, isFree: boolean): Diagram {
  const x = lane("x", 0, isFree);
  const y = lane("y", 124, isFree);
  return {
    height: 252,
    blocks: [...x.blocks, ...y.blocks],
    wires: [...x.wires, ...y.wires, ...(isArc ? crossing() : [])],
  };
}

/** A search: F, or the candidates, are looked at; the steps change F. */
function ofSearch(row: Row): Diagram {
  const candidates = ["n1", "n2", "n3", "d"].filter((name) => row.has(name));
  const looked = candidates.length > 0 ? candidates : ["F"];
  const wasMade = (now: Moment): boolean => !now.isFirst;
  const of = (column: string) => (now: Moment) => signed(now.after.value(column));
  const had = (column: string) => (now: Moment) => signed(now.before.value(column));
  const titles: Readonly<Record<string, string>> = {
    n1: "n1 both",
    n2: "n2 y alone",
    n3: "n3 x alone",
    d: "d middle",
    F: "F before",
  };
  const spacing = 54;
  const middle = 18 + (Math.max(2, looked.length) * spacing - 14) / 2 - 20;
  const height = Math.max(2, looked.length) * spacing + 68;
  const blocks: Block[] = looked.map((name, i) => ({
    x: 150,
    y: 18 + i * spacing,
    width: 100,
    title: titles[name] ?? name,
    value: had(name),
    kind: name === "F" ? "register" : "sum",
    isLit: wasMade,
  }));
  const wires: Wire[] = looked.map((name, i) => ({
    path: `M250 ${38 + i * spacing}H290V${middle + 20}H318`,
    name: `${name} to the choice`,
    at: [270, 31 + i * spacing],
    value: had(name),
    isLit: wasMade,
  }));
  if (candidates.length > 0) {
    blocks.push({ x: 8, y: middle, width: 84, title: "F before", value: had("F"), kind: "register", isLit: wasMade });
    looked.forEach((name, i) =>
      wires.push({
        path: `M92 ${middle + 20}H120V${38 + i * spacing}H148`,
        name: `F to ${name}`,
        at: [128, 31 + i * spacing],
        value: had("F"),
        isLit: wasMade,
      }),
    );
  }
  blocks.push({ x: 320, y: middle, width: 96, title: "choice", value: () => "", kind: "choice", isLit: wasMade });
  for (const [i, axis] of (["x", "y"] as const).entries()) {
    const y = middle + (i === 0 ? -30 : 30);
    const steps = (now: Moment): boolean => now.after.value(`d${axis}`) !== 0;
    const value = (now: Moment): string => stepText(now.after.value(`d${axis}`));
    blocks.push({ x: 500, y, width: 84, title: `${axis.toUpperCase()} pulse`, value, kind: "pulse", isLit: steps });
    wires.push({
      path: `M416 ${middle + 20}H450V${y + 20}H498`,
      name: `${axis.toUpperCase()} step`,
      at: [474, y + 12],
      value,
      isLit: steps,
    });
  }
  const low = height - 50;
  blocks.push({ x: 150, y: low, width: 100, title: "F after", value: of("F"), kind: "register", isLit: wasMade });
  wires.push({
    path: `M368 ${middle + 40}V${low + 20}H252`,
    name: "what the steps add to F",
    at: [310, low + 12],
    value: (now) => signed(now.after.value("F") - now.before.value("F")),
    isLit: wasMade,
    isBack: true,
  });
  return { height, blocks, wires };
}

export class Flow {
  readonly element = svg("svg", {
    class: "flow",
    viewBox: `0 0 ${width} 240`,
    role: "group",
    "aria-label": "Data flow of this cycle",
  });
  private drawn = "";
  private refresh: ((now: Moment) => void)[] = [];

  constructor(private readonly probe: (text: string) => void) {}

  update(session: Session, isArc: boolean): void {
    const after = session.row(session.clock);
    const before = session.row(Math.max(0, session.clock - 1));
    const isFree = !after.has("nx");
    const kind = after.has("Sx") ? `integrators ${isArc} ${isFree}` : `search ${session.recording?.columns.join()}`;
    if (kind !== this.drawn) this.build(after.has("Sx") ? ofIntegrators(isArc, isFree) : ofSearch(after));
    this.drawn = kind;
    const now = { before, after, isFirst: session.clock === 0 };
    for (const each of this.refresh) each(now);
  }

  private build(diagram: Diagram): void {
    this.refresh = [];
    this.element.setAttribute("viewBox", `0 0 ${width} ${diagram.height}`);
    const arrow = svg(
      "marker",
      {
        id: "arrow",
        viewBox: "0 0 8 8",
        refX: 7,
        refY: 4,
        markerUnits: "userSpaceOnUse",
        markerWidth: 9,
        markerHeight: 9,
        orient: "auto",
      },
      svg("path", { d: "M0 0L8 4L0 8Z" }),
    );
    this.element.replaceChildren(
      svg("defs", {}, arrow),
      ...diagram.wires.map((wire) => this.wire(wire)),
      ...diagram.blocks.map((block) => this.block(block)),
    );
  }

  private wire(wire: Wire): SVGElement {
    const label = svg("text", { class: "wire-value", x: wire.at[0], y: wire.at[1], "text-anchor": "middle" });
    const group = svg(
      "g",
      { class: wire.isBack === true ? "wire back" : "wire", tabindex: 0, role: "img" },
      svg("path", { class: "wire-hit", d: wire.path }),
      svg("path", { class: "wire-line", d: wire.path, "marker-end": "url(#arrow)" }),
      label,
    );
    const show = (): void => this.probe(group.getAttribute("aria-label") ?? "");
    group.addEventListener("pointerenter", show);
    group.addEventListener("focus", show);
    this.refresh.push((now) => {
      const value = wire.value(now);
      label.textContent = value;
      group.setAttribute("aria-label", `${wire.name}: ${value}`);
      group.classList.toggle("lit", wire.isLit(now));
      if (group.matches(":hover, :focus")) show();
    });
    return group;
  }

  private block(block: Block): SVGElement {
    const value = svg("text", {
      class: "block-value",
      x: block.x + block.width / 2,
      y: block.y + 32,
      "text-anchor": "middle",
    });
    const title = svg(
      "text",
      { class: "block-title", x: block.x + block.width / 2, y: block.y + 13, "text-anchor": "middle" },
      block.title,
    );
    const box = svg("rect", { x: block.x, y: block.y, width: block.width, height: 40, rx: 6 });
    const group = svg("g", { class: `block ${block.kind}` }, box, title, value);
    this.refresh.push((now) => {
      value.textContent = block.value(now);
      group.classList.toggle("lit", block.isLit?.(now) === true);
    });
    return group;
  }
}
