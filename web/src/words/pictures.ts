// Tracks over the curve, their errors as many times as is asked; and errors and speeds over the clock.

import { frameOfCamera, strokeOf } from "../compare/pictures";
import { stripMargin, type Camera, type Scene } from "../compare/scene";
import type { Picture } from "../draw/picture";
import { drawGrid } from "../lesson/graph";
import { signed } from "../ui/dom";
import { colour } from "../ui/theme";
import type { Curve } from "./curves";
import type { Track } from "./measure";

export interface DrawnTrack {
  readonly title: string;
  readonly detail: string;
  readonly number: number;
  readonly track: Track;
}

const truthPlaces = 800;
const edge = 36; // pixels around all
const leastShown = 1e-3; // µm or mm/s: what is below is rounding

export class TrackScene implements Scene {
  readonly last: number;

  constructor(
    private readonly curve: Curve,
    readonly lanes: readonly DrawnTrack[],
    /** s a clock. */
    private readonly period: number,
    private readonly magnified: number,
    private readonly feed: number,
  ) {
    const ends = lanes.map(({ track }) => Math.ceil(((track.count - 1) * track.period) / period - 1e-9));
    this.last = Math.max(0, ...ends);
  }

  /** The entry of a track that is in force at a clock. */
  entry(track: Track, clock: number): number {
    return Math.min(track.count - 1, Math.floor((clock * this.period) / track.period + 1e-9));
  }

  whole(size: { width: number; height: number }): Camera {
    let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i <= 200; ++i) {
      const [x, y] = this.curve.at(i / 200);
      [left, right] = [Math.min(left, x), Math.max(right, x)];
      [bottom, top] = [Math.min(bottom, y), Math.max(top, y)];
    }
    const [wide, high] = [Math.max(right - left, 1e-3), Math.max(top - bottom, 1e-3)];
    const scale = Math.min((size.width - 2 * edge) / wide, (size.height - 2 * edge) / high);
    return { x: (left + right) / 2, y: (bottom + top) / 2, across: size.width / scale };
  }

  drawPaths(picture: Picture, lane: number | undefined, camera: Camera | undefined, clock: number): void {
    picture.rectangle(0, 0, picture.width, picture.height, colour("paper"));
    const frame = frameOfCamera(camera ?? this.whole(picture), picture);
    drawGrid(picture, frame);
    const truth: number[] = [];
    for (let i = 0; i <= truthPlaces; ++i) {
      const [x, y] = this.curve.at(i / truthPlaces);
      truth.push(frame.x(x), frame.y(y));
    }
    picture.line(truth, { colour: colour("truth"), width: 2 });
    const some = lane === undefined ? this.lanes : this.lanes.slice(lane, lane + 1);
    for (const { number, track } of some) {
      const until = this.entry(track, clock);
      const line: number[] = [];
      for (let i = 0; i <= until; ++i)
        line.push(...this.shown(track, i).map((each, k) => (k ? frame.y(each) : frame.x(each))));
      picture.line(line, strokeOf(number, 1.8));
      if (line.length > 2 && (frame.scale * (track.speed[until] ?? 0) * track.period > 9 || frame.scale > 4000))
        for (let i = 0; i < line.length; i += 2)
          picture.circle(line[i] ?? 0, line[i + 1] ?? 0, 2.4, { fill: strokeOf(number).colour });
    }
    for (const { number, track } of some) {
      const [x, y] = this.shown(track, this.entry(track, clock));
      picture.circle(frame.x(x), frame.y(y), 6.5, { fill: colour("paper") });
      picture.circle(frame.x(x), frame.y(y), 5, { fill: strokeOf(number).colour });
    }
  }

  /** A place with its error as many times as is asked. */
  private shown({ x, y, trueX, trueY }: Track, i: number): [number, number] {
    const [cx, cy] = [trueX[i] ?? 0, trueY[i] ?? 0];
    return [cx + this.magnified * ((x[i] ?? 0) - cx), cy + this.magnified * ((y[i] ?? 0) - cy)];
  }

  drawStrip(strip: number, picture: Picture, clock: number): void {
    if (strip === 0) this.drawOver(picture, clock, ({ error }) => error, 1000, "µm", true);
    else this.drawOver(picture, clock, ({ speed }) => speed, 1, "mm/s", false);
  }

  /** Values of each track, so many times, over the clock; from −most to most, or from 0. */
  private drawOver(
    picture: Picture,
    clock: number,
    of: (track: Track) => Float64Array,
    times: number,
    unit: string,
    isSigned: boolean,
  ): void {
    picture.rectangle(0, 0, picture.width, picture.height, colour("paper"));
    const [wide, high] = [picture.width - stripMargin.left - stripMargin.right, picture.height - 40];
    let most = isSigned ? 0 : this.feed;
    for (const { track } of this.lanes) for (const each of of(track)) most = Math.max(most, Math.abs(each) * times);
    most = Math.max(most, leastShown);
    const x = (at: number): number => stripMargin.left + (at / Math.max(1, this.last)) * wide;
    const y = (value: number): number =>
      12 + (isSigned ? high / 2 - (value / most) * (high / 2 - 2) : high - (value / most) * (high - 4));
    const quiet = { colour: colour("quiet"), size: 11, align: "right" } as const;
    for (const level of isSigned ? [-1, 0, 1] : [0, 0.5, 1]) {
      const value = level * most;
      picture.line([stripMargin.left, y(value), picture.width - stripMargin.right, y(value)], {
        colour: colour(level === 0 ? "axis" : "grid"),
      });
      picture.text(signed(Number(value.toPrecision(3))), stripMargin.left - 6, y(value) + 4, quiet);
    }
    picture.text(unit, stripMargin.left, picture.height - 10, { ...quiet, align: "left" });
    const seconds = Number((this.last * this.period).toPrecision(4));
    picture.text(`${seconds} s`, picture.width - stripMargin.right, picture.height - 10, quiet);
    for (const { number, track } of this.lanes) {
      const values = of(track);
      const line = linesOf(
        values,
        wide,
        (i) => x((i * track.period) / this.period),
        (value) => y(value * times),
      );
      picture.line(line, strokeOf(number, 1.5));
    }
    const now = x(Math.min(clock, this.last));
    picture.line([now, 8, now, 16 + high], { colour: colour("ink"), width: 1 });
  }
}

/** As many points as there are pixels: of the entries of one, the greatest and the least. */
function linesOf(
  values: Float64Array,
  wide: number,
  x: (entry: number) => number,
  y: (value: number) => number,
): number[] {
  const each = Math.max(1, Math.floor(values.length / Math.max(1, wide)));
  const points: number[] = [];
  for (let i = 0; i < values.length; i += each) {
    const some = values.subarray(i, i + each);
    const [low, high] = [Math.min(...some), Math.max(...some)];
    points.push(x(i), y(high));
    if (low !== high) points.push(x(i), y(low));
  }
  return points;
}
