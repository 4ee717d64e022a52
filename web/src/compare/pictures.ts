// The curve and what each lane makes of it, seen by one camera; and their errors over the clock.

import type { Picture, Stroke } from "../draw/picture";
import type { Task } from "../engine/types";
import { boxOf, drawGrid, ends, frameOf, staircase, truth, type Box, type Frame } from "../lesson/graph";
import type { Session } from "../lesson/session";
import { signed } from "../ui/dom";
import { colour } from "../ui/theme";
import { dashOf, stripMargin, type Camera, type Scene } from "./scene";

export interface Drawn {
  readonly title: string;
  /** What is in force. */
  readonly detail: string;
  /** Of all lanes, from 0: its colour and its dashes. */
  readonly number: number;
  readonly task: Task;
  readonly session: Session;
}

export function strokeOf(number: number, width = 2): Stroke {
  return { colour: colour(`lane-${number + 1}`), width, dash: dashOf(number) };
}

/** The box that all of them need. */
export function boxOfAll(lanes: readonly Drawn[]): Box {
  const boxes = lanes.map(({ task, session }) => boxOf(task, session));
  return {
    left: Math.min(...boxes.map(({ left }) => left)),
    right: Math.max(...boxes.map(({ right }) => right)),
    bottom: Math.min(...boxes.map(({ bottom }) => bottom)),
    top: Math.max(...boxes.map(({ top }) => top)),
  };
}

/** The camera that shows all of them, where none is chosen. */
export function wholeCamera(lanes: readonly Drawn[], picture: { width: number; height: number }): Camera {
  const box = boxOfAll(lanes);
  const [x, y] = [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
  const { scale } = frameOf(box, picture as Picture);
  return { x, y, across: picture.width / scale };
}

export function frameOfCamera(camera: Camera, picture: Picture): Frame {
  const scale = picture.width / camera.across;
  return {
    scale,
    x: (blu) => picture.width / 2 + (blu - camera.x) * scale,
    y: (blu) => picture.height / 2 - (blu - camera.y) * scale,
  };
}

/** Lanes of the same curve, over one another. */
export function drawLanes(picture: Picture, lanes: readonly Drawn[], camera: Camera | undefined, clock: number): void {
  picture.rectangle(0, 0, picture.width, picture.height, colour("paper"));
  const [one] = lanes;
  if (one === undefined) return;
  const frame = frameOfCamera(camera ?? wholeCamera(lanes, picture), picture);
  drawGrid(picture, frame);
  picture.line(truth(one.task, frame), { colour: colour("truth"), width: 2 });
  for (const [i, { number, session }] of lanes.entries()) {
    const until = Math.min(clock, session.last);
    // Where they coincide the ones below are seen beside those above.
    const dashed = strokeOf(number, 2 + 2.4 * (lanes.length - 1 - i));
    const stroke = lanes.length > 1 ? { ...dashed, dash: [] } : dashed;
    picture.line(staircase(session, frame, 0, until), stroke);
    if (frame.scale > 12) drawPlaces(picture, session, frame, until, stroke.colour, 2.2 + (lanes.length - 1 - i) * 1.2);
  }
  for (const { number, session } of lanes) {
    const until = Math.min(clock, session.last);
    const worst = ends([session.figure(until, "worstX"), session.figure(until, "worstY")], frame);
    const tone = strokeOf(number).colour;
    if (session.figure(until, "maxError") > 0) picture.circle(...worst, 8 + number * 3, { colour: tone, width: 1.5 });
    const here = ends([session.value(until, "X"), session.value(until, "Y")], frame);
    picture.circle(...here, 6.5, { fill: colour("paper") });
    picture.circle(...here, 5, { fill: tone });
  }
}

function drawPlaces(
  picture: Picture,
  session: Session,
  frame: Frame,
  until: number,
  tone: string,
  radius: number,
): void {
  for (let clock = 0; clock <= until; ++clock) {
    const [x, y] = [frame.x(session.value(clock, "X")), frame.y(session.value(clock, "Y"))];
    if (x < -9 || y < -9 || x > picture.width + 9 || y > picture.height + 9) continue;
    picture.circle(x, y, radius, { fill: tone });
  }
}

/** Lanes of pulses, as the stage shows them. */
export class PulseScene implements Scene {
  constructor(readonly lanes: readonly Drawn[]) {}

  get last(): number {
    return Math.max(0, ...this.lanes.map(({ session }) => session.last));
  }

  whole(size: { width: number; height: number }): Camera {
    return wholeCamera(this.lanes, size);
  }

  drawPaths(picture: Picture, lane: number | undefined, camera: Camera | undefined, clock: number): void {
    const some = lane === undefined ? this.lanes : this.lanes.slice(lane, lane + 1);
    drawLanes(picture, some, camera, clock);
  }

  drawStrip(_strip: number, picture: Picture, clock: number): void {
    drawErrors(picture, this.lanes, clock);
  }
}

/** The error of each lane over the clock, > 0 outside or to the left; a line where the clock stands. */
export function drawErrors(picture: Picture, lanes: readonly Drawn[], clock: number): void {
  picture.rectangle(0, 0, picture.width, picture.height, colour("paper"));
  const last = Math.max(1, ...lanes.map(({ session }) => session.last));
  let most = 0.1;
  for (const { session } of lanes) most = Math.max(most, session.figure(session.last, "maxError"));
  const { left } = stripMargin;
  const [wide, high] = [picture.width - left - stripMargin.right, picture.height - 40];
  const x = (at: number): number => left + (at / last) * wide;
  const y = (error: number): number => 12 + high / 2 - (error / most) * (high / 2 - 2);
  const quiet = { colour: colour("quiet"), size: 11, align: "right" } as const;
  for (const level of [-1, -0.5, 0, 0.5, 1]) {
    const at = y(level * most);
    picture.line([left, at, picture.width - 12, at], { colour: colour(level === 0 ? "axis" : "grid") });
    if (level !== 0.5 && level !== -0.5)
      picture.text(signed(Number((level * most).toPrecision(2))), left - 6, at + 4, quiet);
  }
  picture.text("0", left, picture.height - 10, { ...quiet, align: "left" });
  picture.text(`${last} clocks`, picture.width - 12, picture.height - 10, quiet);
  for (const { number, session } of lanes) picture.line(errorLine(session, x, y, wide), strokeOf(number, 1.5));
  picture.line([x(Math.min(clock, last)), 8, x(Math.min(clock, last)), 16 + high], { colour: colour("ink"), width: 1 });
}

/** As many points as there are pixels: of the clocks of one, the greatest and the least. */
function errorLine(session: Session, x: (at: number) => number, y: (e: number) => number, wide: number): number[] {
  const each = Math.max(1, Math.floor(session.last / Math.max(1, wide)));
  const points: number[] = [];
  for (let clock = 0; clock <= session.last; clock += each) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = clock; i < clock + each && i <= session.last; ++i) {
      const error = session.figure(i, "error");
      low = Math.min(low, error);
      high = Math.max(high, error);
    }
    points.push(x(clock), y(high));
    if (low !== high) points.push(x(clock), y(low));
  }
  return points;
}
