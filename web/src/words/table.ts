// The figures of lanes of reference words.

import { LaneTable, type Column } from "../compare/lane_table";
import type { Figure, Track } from "./measure";
import { fixed } from "../ui/dom";

export interface Told {
  readonly track: Track;
  /** Of the track that is in force. */
  readonly entry: number;
  /** Of a word, ns. */
  readonly cost: number;
  /** Of a lane of pulses: until each clock. */
  readonly pulses: Float64Array | undefined;
}

/** Three or four digits, and none that a million needs not. */
function digits(value: number): string {
  return Number(value.toPrecision(4)).toLocaleString("en", { maximumFractionDigits: 6, useGrouping: false });
}

const of = (figure: Figure, times = 1): ((told: Told) => string) => {
  return ({ track, entry }) => digits((track.until[figure][entry] ?? 0) * times);
};

const columns: readonly Column<Told>[] = [
  ["Words", "periods until here; of pulses, their clocks", ({ entry }) => String(entry)],
  ["Pulses", "steps until here", ({ pulses, entry }) => (pulses === undefined ? "" : String(pulses[entry] ?? 0))],
  ["Time, s", "until here, to rest at the end", ({ track, entry }) => fixed(track.period * entry, 3)],
  ["Greatest speed, mm/s", "over a period", of("maxSpeed")],
  ["Feed error, %", "greatest departure from V of a period, where the plan says constant speed", of("feedError", 100)],
  ["Chord error, µm", "greatest distance of the middle between two words from the curve", of("chordError", 1000)],
  ["Greatest error, µm", "distance of words, or of slides where loops follow, from the curve", of("maxError", 1000)],
  ["RMS error, µm", "over all words or places", of("rmsError", 1000)],
  ["Acceleration, mm/s²", "greatest second difference of X or Y over T², of pulses too", of("acceleration")],
  ["Jerk, mm/s³", "greatest third difference of X or Y over T³, of pulses too", of("jerk")],
  ["Cost a word, µs", "of reading, planning and interpolation, on this machine", ({ cost }) => digits(cost / 1000)],
];

export function wordTable(): LaneTable<Told> {
  return new LaneTable("Figures of all lanes", "loops", columns);
}
