// The XY graph: the true curve, the steps until now, where it stands; and the directions of feed as waveforms.

import type { Picture } from "../draw/picture";
import type { Task } from "../engine/types";
import { fixed, signed } from "../ui/dom";
import { colour } from "../ui/theme";
import type { Session } from "./session";

export interface Frame {
  /** Pixels of a BLU. */
  readonly scale: number;
  x(blu: number): number;
  y(blu: number): number;
}

const margin = 36;
const nearReach = 8; // BLU around the place, in the near view

export interface Box {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

/** What the whole curve needs: its steps keep within 2 BLU of it. */
export function boxOf(task: Task, session: Session): Box {
  const box: Box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  const take = (x: number, y: number): void => {
    box.left = Math.min(box.left, x);
    box.right = Math.max(box.right, x);
    box.bottom = Math.min(box.bottom, y);
    box.top = Math.max(box.top, y);
  };
  take(...task.start);
  take(...task.end);
  if (task.shape === "arc") take(...task.center);
  const every = Math.max(1, Math.floor(session.last / 4000));
  for (let clock = 0; clock <= session.last; clock += every) {
    take(session.value(clock, "X"), session.value(clock, "Y"));
  }
  return box;
}

export function frameOf(box: Box, picture: Picture): Frame {
  const wide = Math.max(4, box.right - box.left + 2);
  const high = Math.max(4, box.top - box.bottom + 2);
  const scale = Math.min((picture.width - 2 * margin) / wide, (picture.height - 2 * margin) / high);
  const middleX = (box.left + box.right) / 2;
  const middleY = (box.bottom + box.top) / 2;
  return {
    scale,
    x: (blu) => picture.width / 2 + (blu - middleX) * scale,
    y: (blu) => picture.height / 2 - (blu - middleY) * scale,
  };
}

/** 1, 2, 5, 10, 20 … BLU between two lines of the grid. */
function gridStep(scale: number, least: number): number {
  for (let ten = 1; ; ten *= 10) for (const digit of [1, 2, 5]) if (digit * ten * scale >= least) return digit * ten;
}

export function drawGrid(picture: Picture, frame: Frame): void {
  const fine = gridStep(frame.scale, 12);
  const coarse = gridStep(frame.scale, 48);
  const bluX = (pixel: number): number => (pixel - frame.x(0)) / frame.scale;
  const bluY = (pixel: number): number => (frame.y(0) - pixel) / frame.scale;
  const grid = colour("grid");
  const quiet = colour("quiet");
  for (let x = Math.ceil(bluX(0) / fine) * fine; x <= bluX(picture.width); x += fine)
    picture.line([frame.x(x), 0, frame.x(x), picture.height], { colour: x === 0 ? colour("axis") : grid });
  for (let y = Math.ceil(bluY(picture.height) / fine) * fine; y <= bluY(0); y += fine)
    picture.line([0, frame.y(y), picture.width, frame.y(y)], { colour: y === 0 ? colour("axis") : grid });
  for (let x = Math.ceil(bluX(24) / coarse) * coarse; x <= bluX(picture.width - 24); x += coarse)
    picture.text(signed(x), frame.x(x), picture.height - 8, { colour: quiet, align: "center", size: 11 });
  for (let y = Math.ceil(bluY(picture.height - 24) / coarse) * coarse; y <= bluY(16); y += coarse)
    picture.text(signed(y), 8, frame.y(y) + 4, { colour: quiet, size: 11 });
}

/** The true line or arc, as points; of an ellipse by its parameter. */
export function truth(task: Task, frame: Frame): number[] {
  if (task.shape === "line") return [...ends(task.start, frame), ...ends(task.end, frame)];
  const [cx, cy] = task.center;
  const radius = Math.hypot(task.start[0] - cx, task.start[1] - cy);
  const [a, b] = task.semiAxes ?? [radius, radius];
  const from = Math.atan2((task.start[1] - cy) / b, (task.start[0] - cx) / a);
  let sweep = Math.atan2((task.end[1] - cy) / b, (task.end[0] - cx) / a) - from;
  const turn = task.clockwise ? -1 : 1;
  while (sweep * turn <= 1e-9) sweep += turn * 2 * Math.PI;
  const count = Math.max(32, Math.min(2000, Math.round(Math.max(a, b) * frame.scale)));
  const points: number[] = [];
  for (let i = 0; i <= count; ++i) {
    const angle = from + (sweep * i) / count;
    points.push(frame.x(cx + a * Math.cos(angle)), frame.y(cy + b * Math.sin(angle)));
  }
  return points;
}

export function ends([x, y]: readonly [number, number], frame: Frame): [number, number] {
  return [frame.x(x), frame.y(y)];
}

/** The places until now; where several fall on one pixel, one of them. */
export function staircase(session: Session, frame: Frame, from: number, to: number): number[] {
  const points: number[] = [];
  let lastX = NaN;
  let lastY = NaN;
  for (let clock = from; clock <= to; ++clock) {
    const x = frame.x(session.value(clock, "X"));
    const y = frame.y(session.value(clock, "Y"));
    if (Math.abs(x - lastX) < 0.5 && Math.abs(y - lastY) < 0.5 && clock !== to) continue;
    points.push((lastX = x), (lastY = y));
  }
  return points;
}

export interface GraphStyle {
  readonly view: "whole" | "near";
}

export function drawGraph(picture: Picture, task: Task, session: Session, style: GraphStyle): void {
  const row = session.row(session.clock);
  const [x, y] = [row.value("X"), row.value("Y")];
  const near: Box = { left: x - nearReach, right: x + nearReach, bottom: y - nearReach, top: y + nearReach };
  const frame = frameOf(style.view === "near" ? near : boxOf(task, session), picture);
  picture.rectangle(0, 0, picture.width, picture.height, colour("paper"));
  drawGrid(picture, frame);
  picture.line(truth(task, frame), { colour: colour("truth"), width: 2 });
  if (task.shape === "arc") {
    const [cx, cy] = ends(task.center, frame);
    picture.line([cx - 5, cy, cx + 5, cy], { colour: colour("quiet"), width: 1.5 });
    picture.line([cx, cy - 5, cx, cy + 5], { colour: colour("quiet"), width: 1.5 });
  }
  picture.line(staircase(session, frame, 0, session.clock), { colour: colour("accent"), width: 2 });
  if (frame.scale > 7) {
    for (let clock = 0; clock <= session.clock; ++clock) {
      picture.circle(frame.x(session.value(clock, "X")), frame.y(session.value(clock, "Y")), 2.5, {
        fill: colour("accent"),
      });
    }
  }
  drawMarks(picture, task, session, frame);
}

function drawMarks(picture: Picture, task: Task, session: Session, frame: Frame): void {
  const ink = colour("ink");
  const label = (text: string, at: readonly [number, number]): void => {
    const [x, y] = ends(at, frame);
    picture.circle(x, y, 5, { colour: ink, width: 1.5 });
    picture.text(text, Math.min(picture.width - 30, x + 9), Math.max(14, y - 8), {
      colour: ink,
      size: 12,
      weight: 600,
    });
  };
  const isRound = task.start[0] === task.end[0] && task.start[1] === task.end[1];
  label(isRound ? "start, end" : "start", task.start);
  if (!isRound) label("end", task.end);
  const { clock } = session;
  if (session.figure(clock, "maxError") > 0) {
    const worst = ends([session.figure(clock, "worstX"), session.figure(clock, "worstY")], frame);
    picture.circle(...worst, 9, { colour: colour("warm"), width: 2 });
  }
  const row = session.row(clock);
  const here = ends([row.value("X"), row.value("Y")], frame);
  picture.circle(...here, 7, { fill: colour("paper") });
  picture.circle(...here, 5.5, { fill: colour("accent-strong") });
}

/** X and Y feed direction, a cycle a slot, the last one at the right: −1, 0 or +1 each. */
export function drawWaves(picture: Picture, session: Session): void {
  picture.rectangle(0, 0, picture.width, picture.height, colour("paper"));
  const left = 84;
  const slots = Math.min(Math.max(16, session.last), Math.max(8, Math.floor((picture.width - left - 12) / 10)));
  const slot = (picture.width - left - 12) / slots;
  const first = Math.max(0, session.clock - slots);
  const lane = picture.height / 2;
  for (const [i, column] of (["dx", "dy"] as const).entries()) {
    const middle = lane * (i + 0.5);
    const rise = lane * 0.3;
    picture.text(i === 0 ? "X feed" : "Y feed", 8, middle + 4, { colour: colour("ink"), size: 12, weight: 600 });
    for (const level of [1, 0, -1]) {
      const y = middle - level * rise;
      picture.line([left, y, picture.width - 8, y], { colour: colour("grid") });
      const text = level > 0 ? "+1" : signed(level);
      picture.text(text, left - 8, y + 4, { colour: colour("quiet"), size: 11, align: "right" });
    }
    const points: number[] = [];
    for (let clock = first + 1; clock <= session.clock; ++clock) {
      const x = left + (clock - first - 1) * slot;
      const y = middle - session.value(clock, column) * rise;
      points.push(x, y, x + slot, y);
    }
    picture.line(points, { colour: colour(i === 0 ? "x" : "y"), width: 2 });
  }
}

/** What the graph shows, in words. */
export function graphText(task: Task, session: Session): string {
  const row = session.row(session.clock);
  const of = task.semiAxes === undefined ? "" : ` of the ellipse with the semi-axes ${task.semiAxes.join(" and ")}`;
  const what = task.shape === "line" ? "line" : `${task.clockwise ? "clockwise" : "counterclockwise"} arc${of}`;
  return (
    `The true ${what} from (${task.start.join(", ")}) to (${task.end.join(", ")}) and the steps of ${session.clock} of ` +
    `${session.last} cycles; it stands at (${row.value("X")}, ${row.value("Y")}), ` +
    `${fixed(session.figure(session.clock, "error"), 3)} BLU off.`
  );
}
