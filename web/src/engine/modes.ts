// What a program has in force from block to block: taken as the engine tells it, and read where a page shows it.

import * as layout from "./layout";
import type { MotionModule } from "./motion_module";

/** What a program has in force, as the engine tells it (leadscrew_modes), where it changes. */
export interface ModesData {
  /** Entries of Blocks, from each of which on a record holds, and which. */
  readonly block: Int32Array;
  readonly entry: Int32Array;
  /** Those that differ, one behind the other. */
  readonly records: Uint8Array;
}

/** Takes modes as they come; the same ones are kept once. */
export class ModesList {
  private readonly block: number[] = [];
  private readonly entry: number[] = [];
  private readonly records: Uint8Array[] = [];
  private readonly known = new Map<string, number>();
  private readonly decoder = new TextDecoder("latin1");

  take(module: MotionModule, at: number): void {
    const of = layout.modes;
    const record = new Uint8Array(module.calls.memory.buffer, at, of.size).slice();
    const key = this.decoder.decode(record.subarray(of.motion));
    let entry = this.known.get(key);
    if (entry === undefined) {
      entry = this.records.push(record) - 1;
      this.known.set(key, entry);
    }
    this.block.push(module.integer(at + of.block));
    this.entry.push(entry);
  }

  done(): ModesData {
    const { size } = layout.modes;
    const records = new Uint8Array(this.records.length * size);
    this.records.forEach((record, i) => records.set(record, i * size));
    return { block: Int32Array.from(this.block), entry: Int32Array.from(this.entry), records };
  }
}

const codes = [
  "motion",
  "plane",
  "units",
  "distance",
  "arcDistance",
  "feedMode",
  "pathMode",
  "retract",
  "compensation",
  "toolLength",
  "spindle",
  "coolant",
  "system",
] as const;

export interface Modes extends Readonly<Record<(typeof codes)[number], string>> {
  /** mm, P and Q of G64. */
  readonly tolerance: number;
  readonly naiveCam: number;
  /** mm/s, or mm a revolution under G95; 0: none is known. */
  readonly feed: number;
  /** Revolutions a minute. */
  readonly spindleSpeed: number;
  /** Of the coordinate system, a number an axis, mm or degrees. */
  readonly offset: readonly number[];
  readonly tool: number;
  /** -1: none. */
  readonly selectedTool: number;
}

/** In force in a block; undefined of a program that moves nothing. */
export function modesOf({ block, entry, records }: ModesData, at: number): Modes | undefined {
  let [first, end] = [0, block.length];
  while (first < end) {
    const middle = (first + end) >> 1;
    if ((block[middle] ?? 0) <= at) first = middle + 1;
    else end = middle;
  }
  const found = entry[Math.max(first - 1, 0)];
  if (found === undefined) return undefined;
  const of = layout.modes;
  const record = records.subarray(found * of.size, (found + 1) * of.size);
  const view = new DataView(record.buffer, record.byteOffset, record.byteLength);
  const text = (from: number): string => new TextDecoder().decode(record.subarray(from, record.indexOf(0, from)));
  return {
    ...(Object.fromEntries(codes.map((name) => [name, text(of[name])])) as Record<(typeof codes)[number], string>),
    tolerance: view.getFloat64(of.tolerance, true),
    naiveCam: view.getFloat64(of.naiveCam, true),
    feed: view.getFloat64(of.feed, true),
    spindleSpeed: view.getFloat64(of.spindleSpeed, true),
    offset: [...Array(layout.axes).keys()].map((axis) => view.getFloat64(of.offset + 8 * axis, true)),
    tool: view.getInt32(of.tool, true),
    selectedTool: view.getInt32(of.selectedTool, true),
  };
}
