// The modes of the program that are in force where the tool stands.

import { axisLetters, type Plan } from "../engine/motion_types";
import { modesOf, type Modes } from "../engine/modes";
import { fixed, html } from "../ui/dom";
import { put } from "./figures";

/** As a program writes it: no digits that say nothing. */
function short(value: number): string {
  return String(Number(value.toFixed(4)));
}

function feedText({ feed, feedMode }: Modes): string {
  if (feed === 0) return "none";
  return feedMode === "G95" ? `${short(feed)} mm/rev` : `${fixed(feed * 60, 0)} mm/min`;
}

function pathText({ pathMode, tolerance, naiveCam }: Modes): string {
  return pathMode === "G64" ? `G64 P${short(tolerance)} Q${short(naiveCam)}` : pathMode;
}

function offsetText({ system, offset }: Modes): string {
  const axes = offset.map((each, axis) => (each === 0 ? "" : ` ${axisLetters[axis]}${short(each)}`)).join("");
  return `${system}${axes}`;
}

function toolText({ tool, selectedTool }: Modes): string {
  return selectedTool >= 0 && selectedTool !== tool ? `${tool}, T${selectedTool} next` : String(tool);
}

function rowsOf(modes: Modes): [string, string][] {
  return [
    ["Motion", modes.motion],
    ["Plane", modes.plane],
    ["Units", modes.units],
    ["Distance", `${modes.distance} ${modes.arcDistance}`],
    ["Path", pathText(modes)],
    ["Feed mode", modes.feedMode],
    ["Feed", feedText(modes)],
    ["Offset", offsetText(modes)],
    ["Tool", toolText(modes)],
    ["Length", modes.toolLength],
    ["Radius", modes.compensation],
    ["Spindle", `${modes.spindle} S${fixed(modes.spindleSpeed, 0)}`],
    ["Coolant", modes.coolant],
    ["Cycles", modes.retract],
  ];
}

export class ModesPanel {
  readonly element: HTMLElement;
  private readonly list = html("dl", { class: "numbers", id: "modes", "aria-label": "Modes in force" });
  private shown: { readonly plan: Plan; readonly block: number } | undefined;

  constructor() {
    this.element = html("details", { class: "in-force", open: true }, html("summary", {}, "In force here"), this.list);
  }

  stand(plan: Plan, block: number): void {
    if (this.shown?.plan === plan && this.shown.block === block) return;
    this.shown = { plan, block };
    const modes = modesOf(plan.modes, block);
    put(this.list, modes === undefined ? [] : rowsOf(modes));
  }
}
