// What the reader has set, and the link that brings it back.

import type { Limits } from "../engine/motion_types";
import { examples } from "./examples";

export const colourings = ["speed", "acceleration", "jerk", "limit", "line"] as const;
export type Colouring = (typeof colourings)[number];

export interface Settings {
  text: string;
  /** Of the file, or the example's. */
  name: string;
  limits: Limits;
  /** Of the feed, %. */
  override: number;
  colouring: Colouring;
  /** Where the cursor is, s. */
  time: number;
}

const longestLink = 8000; // characters; longer ones mail and chat programs cut off

export function initial(limits: Limits): Settings {
  const [first] = examples;
  if (first === undefined) throw new Error("there are no examples");
  return { text: first.text, name: `${first.name}.ngc`, limits, override: 100, colouring: "speed", time: 0 };
}

async function through(stream: CompressionStream | DecompressionStream, bytes: Uint8Array): Promise<Uint8Array> {
  const piped = new Blob([bytes as BlobPart]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}

async function packed(text: string): Promise<string> {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  let characters = "";
  for (const byte of bytes) characters += String.fromCharCode(byte);
  return btoa(characters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

async function unpacked(text: string): Promise<string> {
  const characters = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(characters, (character) => character.charCodeAt(0));
  return new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes));
}

const limitNames = { velocity: "v", acceleration: "a", jerk: "j" } as const;

/** A text that no link can hold is left out. */
export async function toLink(settings: Settings, machine: Limits): Promise<string> {
  const link = new URLSearchParams();
  link.set("program", "1");
  const example = examples.find(({ text }) => text === settings.text);
  if (example !== undefined) {
    link.set("ex", example.name);
  } else if (settings.text.length < 100_000) {
    const text = await packed(settings.text);
    if (text.length <= longestLink) {
      link.set("z", text);
      link.set("name", settings.name);
    }
  }
  for (const [name, short] of Object.entries(limitNames) as ["velocity" | "acceleration" | "jerk", string][])
    if (settings.limits[name].join() !== machine[name].join()) link.set(short, settings.limits[name].join("_"));
  if (settings.limits.tolerance !== machine.tolerance) link.set("tol", String(settings.limits.tolerance));
  if (settings.override !== 100) link.set("o", String(settings.override));
  link.set("c", settings.colouring);
  link.set("t", settings.time.toFixed(3));
  return `#${link.toString()}`;
}

/** What a link lacks, or has wrong, is as it is without one. */
export async function fromLink(hash: string, machine: Limits): Promise<Settings> {
  const link = new URLSearchParams(hash.replace(/^#/, ""));
  const settings = initial({ ...machine });
  const example = examples.find(({ name }) => name === link.get("ex"));
  if (example !== undefined) {
    settings.text = example.text;
    settings.name = `${example.name}.ngc`;
  }
  const text = link.get("z");
  if (text !== null) {
    try {
      settings.text = await unpacked(text);
      settings.name = link.get("name") ?? "program.ngc";
    } catch {
      // half a link: the example, then
    }
  }
  for (const [name, short] of Object.entries(limitNames) as ["velocity" | "acceleration" | "jerk", string][]) {
    const numbers = (link.get(short) ?? "").split("_").map(Number);
    if (numbers.length === machine[name].length && numbers.every((each, i) => each > 0 || machine[name][i] === 0))
      settings.limits[name] = numbers;
  }
  const tolerance = Number(link.get("tol") ?? NaN);
  if (tolerance >= 0) settings.limits.tolerance = tolerance;
  const override = Number(link.get("o") ?? NaN);
  if (override > 0 && override <= 200) settings.override = override;
  const colouring = colourings.find((each) => each === link.get("c"));
  if (colouring !== undefined) settings.colouring = colouring;
  const time = Number(link.get("t") ?? NaN);
  if (time >= 0) settings.time = time;
  return settings;
}

function isMachine(limits: Limits, machine: Limits): boolean {
  return JSON.stringify(limits) === JSON.stringify(machine);
}

/** That gives the same words. */
export function commandOf(settings: Settings, machine: Limits): string {
  const name = /^[\w.-]+$/.test(settings.name) ? settings.name : `'${settings.name.replaceAll("'", "'\\''")}'`;
  const file = isMachine(settings.limits, machine) ? "" : " --machine machine.toml";
  return `leadscrew run ${name}${file} --trace words.csv`;
}

/** The machine as a file of the command. */
export function machineFile(limits: Limits): string {
  const lines = [
    'name = "mill3"',
    `tolerance_mm = ${real(limits.tolerance)}`,
    `chord_error_mm = ${real(limits.chordError)}`,
  ];
  for (const [i, letter] of [..."XYZ"].entries())
    lines.push(
      "",
      `[axis.${letter}]`,
      `travel_mm = [${real(limits.least[i] ?? 0)}, ${real(limits.greatest[i] ?? 0)}]`,
      `max_velocity_mm_s = ${real(limits.velocity[i] ?? 0)}`,
      `max_acceleration_mm_s2 = ${real(limits.acceleration[i] ?? 0)}`,
      `max_jerk_mm_s3 = ${real(limits.jerk[i] ?? 0)}`,
      "blu_mm = 0.001",
    );
  return `${lines.join("\n")}\n`;
}

/** As TOML writes it. */
function real(value: number): string {
  const text = String(value);
  return /^-?\d+$/.test(text) ? `${text}.0` : text;
}
