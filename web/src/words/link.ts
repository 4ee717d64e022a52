// The link that brings a comparison of words back.

import { layouts } from "../compare/scene";
import { cameraOf, cameraText, mostLanes } from "../compare/state";
import { curveKinds } from "./curves";
import {
  curveNumbers,
  initialState,
  laneNumbers,
  laneOf,
  loopKinds,
  magnifications,
  methods,
  type Lane,
  type State,
} from "./state";

const laneOrder = ["method", "loops", ...laneNumbers] as const;

export function toLink(state: State): string {
  const link = new URLSearchParams();
  link.set("words", "1");
  link.set("curve", state.curve);
  for (const key of curveNumbers) link.set(key, state[key]);
  for (const lane of state.lanes) link.append("l", laneOrder.map((key) => lane[key]).join(","));
  link.set("layout", state.layout);
  link.set("times", String(state.magnified));
  link.set("dt", state.interval);
  link.set("k", String(state.clock));
  if (state.camera !== undefined) link.set("at", cameraText(state.camera));
  return `#${link.toString()}`;
}

function laneFrom(text: string): Lane {
  const parts = text.slice(0, 160).split(",");
  const lane = laneOf(methods.find((each) => each === parts[0]) ?? "arc-length");
  lane.loops = loopKinds.find((each) => each === parts[1]) ?? "none";
  laneNumbers.forEach((key, i) => (lane[key] = (parts[i + 2] ?? lane[key]).slice(0, 20)));
  return lane;
}

/** What a link lacks, or has wrong, is as it is without one. */
export function fromLink(hash: string): State {
  const link = new URLSearchParams(hash.replace(/^#/, ""));
  const state = initialState();
  if (link.get("words") === null) return state;
  state.curve = curveKinds.find((each) => each === link.get("curve")) ?? state.curve;
  for (const key of curveNumbers) state[key] = (link.get(key) ?? state[key]).slice(0, 20);
  const lanes = link.getAll("l").slice(0, mostLanes).map(laneFrom);
  if (lanes.length > 0) state.lanes = lanes;
  state.layout = layouts.find((each) => each === link.get("layout")) ?? state.layout;
  state.magnified = magnifications.find((each) => String(each) === link.get("times")) ?? state.magnified;
  state.interval = (link.get("dt") ?? state.interval).slice(0, 10);
  const clock = Number(link.get("k") ?? 0);
  state.clock = Number.isInteger(clock) && clock > 0 ? clock : 0;
  state.camera = cameraOf(link.get("at"));
  return state;
}
