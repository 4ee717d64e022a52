// What is shown, as files.

import { CanvasPicture, SvgPicture } from "../draw/picture";
import type { Task } from "../engine/types";
import { drawGraph, drawWaves, graphText, type GraphStyle } from "./graph";
import type { Session } from "./session";

export function download(name: string, content: Blob | string, type: string): void {
  const blob = typeof content === "string" ? new Blob([content], { type }) : content;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export function svgText(task: Task, session: Session, style: GraphStyle): string {
  const picture = new SvgPicture(800, 600, graphText(task, session));
  drawGraph(picture, task, session, style);
  return picture.toString();
}

/** The graph, and the waves below it. */
export async function pngBlob(task: Task, session: Session, style: GraphStyle): Promise<Blob> {
  const all = document.createElement("canvas");
  const [graph, waves] = [document.createElement("canvas"), document.createElement("canvas")];
  drawGraph(new CanvasPicture(graph, 800, 600, 2), task, session, style);
  drawWaves(new CanvasPicture(waves, 800, 160, 2), session);
  all.width = 1600;
  all.height = 1520;
  const to = all.getContext("2d");
  to?.drawImage(graph, 0, 0);
  to?.drawImage(waves, 0, 1200);
  return await new Promise((resolve, reject) =>
    all.toBlob((blob) => (blob === null ? reject(new Error("no picture")) : resolve(blob)), "image/png"),
  );
}

/** Every row until now. */
export function csvText(session: Session): string {
  const columns = session.recording?.columns ?? [];
  const lines = [columns.join(",")];
  for (let clock = 0; clock <= session.clock; ++clock)
    lines.push(columns.map((name) => session.value(clock, name)).join(","));
  return `${lines.join("\n")}\n`;
}

/** What a dump has as a scope of its own. */
export interface Scope {
  readonly name: string;
  readonly session: Session;
}

/** A value-change dump: every column of each scope until a clock, a microsecond a clock. */
export function vcdText(scopes: readonly Scope[], until: number): string {
  const bits = (value: number): string => (value < 0 ? BigInt.asUintN(64, BigInt(value)) : BigInt(value)).toString(2);
  let marks = 0;
  const mark = (): string => String.fromCharCode(33 + marks++); // 94 of them; four scopes have no more than 80 signals
  const lines = ["$timescale 1 us $end"];
  const signals = scopes.flatMap(({ name, session }) => {
    lines.push(`$scope module ${name.replaceAll("-", "_")} $end`);
    const columns = (session.recording?.columns ?? []).filter((column) => column !== "clock");
    const own = columns.map((column) => ({ column, session, mark: mark() }));
    for (const signal of own) lines.push(`$var integer 64 ${signal.mark} ${signal.column} $end`);
    lines.push("$upscope $end");
    return own;
  });
  lines.push("$enddefinitions $end");
  for (let clock = 0; clock <= until; ++clock) {
    const changed = signals.flatMap(({ column, session, mark }) => {
      if (clock > session.last) return [];
      const value = session.value(clock, column);
      return clock > 0 && session.value(clock - 1, column) === value ? [] : [`b${bits(value)} ${mark}`];
    });
    if (changed.length > 0) lines.push(`#${clock}`, ...changed);
  }
  return `${lines.join("\n")}\n`;
}
