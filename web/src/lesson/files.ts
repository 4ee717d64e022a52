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

/** A value-change dump: every column until now, a microsecond a clock. */
export function vcdText(session: Session, method: string): string {
  const columns = (session.recording?.columns ?? []).filter((name) => name !== "clock");
  const bits = (value: number): string => (value < 0 ? BigInt.asUintN(64, BigInt(value)) : BigInt(value)).toString(2);
  const mark = (i: number): string => String.fromCharCode(33 + i);
  const scope = method.replaceAll("-", "_");
  const lines = ["$timescale 1 us $end", `$scope module ${scope} $end`];
  columns.forEach((name, i) => lines.push(`$var integer 64 ${mark(i)} ${name} $end`));
  lines.push("$upscope $end", "$enddefinitions $end");
  for (let clock = 0; clock <= session.clock; ++clock) {
    const changed = columns.flatMap((name, i) => {
      const value = session.value(clock, name);
      return clock > 0 && session.value(clock - 1, name) === value ? [] : [`b${bits(value)} ${mark(i)}`];
    });
    if (changed.length > 0) lines.push(`#${clock}`, ...changed);
  }
  return `${lines.join("\n")}\n`;
}
