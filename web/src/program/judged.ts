// What the run came to that is shown as it was recorded, in the numbers of `leadscrew run --json`.

import type { Recording, RunResult } from "../engine/recording";
import { fixed, html } from "../ui/dom";

type Row = readonly [name: string, value: number | null, text: string];

const percent = (ratio: number): string => `${fixed(ratio * 100, 1)} %`;
const mm = (value: number): string => `${fixed(value * 1000, 3)} µm`;
const seconds = (value: number): string => `${fixed(value, 3)} s`;

function rowsOf(result: RunResult): Row[] {
  const { feed, tip } = result;
  return [
    ["Time", result.time_s, seconds(result.time_s)],
    ["of it dwell", result.dwell_s, seconds(result.dwell_s)],
    ["Without jerk limit", result.bound_s, seconds(result.bound_s)],
    ["Length", result.length_mm, `${fixed(result.length_mm, 3)} mm`],
    ["Moves", result.moves, result.moves.toLocaleString("en")],
    ["Words", result.words, result.words.toLocaleString("en")],
    ["Deviation", result.deviation_mm, mm(result.deviation_mm)],
    ["Tolerance", result.tolerance_mm, mm(result.tolerance_mm)],
    ...(tip === undefined
      ? []
      : ([
          ["Of the tip", tip.deviation_mm, mm(tip.deviation_mm)],
          ["Of its direction", tip.orientation_deviation_deg, `${fixed(tip.orientation_deviation_deg, 4)}°`],
        ] as const)),
    ["Feed of programmed", feed.max_ratio, percent(feed.max_ratio)],
    ["Feed ripple", feed.ripple, feed.ripple === null ? "none" : percent(feed.ripple)],
    ...result.axes.flatMap((axis): Row[] => [
      [`Velocity ${axis.name}`, axis.velocity_ratio ?? 0, percent(axis.velocity_ratio ?? 0)],
      [`Acceleration ${axis.name}`, axis.acceleration_ratio ?? 0, percent(axis.acceleration_ratio ?? 0)],
      [`Jerk ${axis.name}`, axis.jerk_ratio ?? 0, percent(axis.jerk_ratio ?? 0)],
    ]),
    ...result.losses.map(({ cause, s }): Row => [`Lost to ${cause}`, s, seconds(s)]),
    ["Objections", result.violation_count, result.violation_count.toLocaleString("en")],
  ];
}

function eventTable(recording: Recording, chosen: (line: number, time: number) => void): HTMLElement {
  const { events, event_count: count } = recording;
  const text = (value: number | null): string => (value === null ? "" : String(value));
  const rows = events.map(({ t, line, code, output, value, q, waits }) =>
    html(
      "tr",
      {},
      html("td", {}, html("button", { type: "button", class: "link", click: () => chosen(line, t) }, String(line))),
      ...[code, text(output), text(value), text(q), seconds(t), waits ? "rests" : "goes on"].map((cell) =>
        html("td", {}, cell),
      ),
    ),
  );
  const columns = ["Line", "Code", "Output", "Value", "Q", "At", "Motion"];
  return html(
    "details",
    { id: "events" },
    html(
      "summary",
      {},
      `Events: ${count.toLocaleString("en")}${count > events.length ? `, the first ${events.length}` : ""}`,
    ),
    html(
      "div",
      { class: "table", tabindex: 0, role: "group", "aria-label": "Events" },
      html(
        "table",
        {},
        html("thead", {}, html("tr", {}, ...columns.map((each) => html("th", { scope: "col" }, each)))),
        html("tbody", {}, ...rows),
      ),
    ),
  );
}

export class JudgedPanel {
  readonly element: HTMLElement;

  constructor(recording: Recording, chosen: (line: number, time: number) => void) {
    const { result, command, version } = recording;
    const verdict =
      result.violation_count === 0
        ? "The referee, who reads the words alone, objects to none of them."
        : `The referee objects to ${result.violation_count.toLocaleString("en")} words.`;
    this.element = html(
      "section",
      { class: "panel judged", "aria-label": "As recorded" },
      html("h2", {}, "As recorded"),
      html("p", { id: "verdict", class: result.violation_count === 0 ? "note" : "error" }, verdict),
      html(
        "dl",
        { class: "numbers", id: "judged", "aria-label": "Figures of the recording" },
        ...rowsOf(result).map(([name, value, text]) =>
          html(
            "div",
            { "data-name": name, "data-value": value === null ? "null" : String(value) },
            html("dt", {}, name),
            html("dd", {}, text),
          ),
        ),
      ),
      recording.events.length === 0 ? undefined : eventTable(recording, chosen),
      html("p", { class: "note" }, `On ${result.machine}, by Leadscrew ${version}:`),
      html(
        "code",
        { class: "command", id: "recorded-by", tabindex: 0, "aria-label": "Command of the recording" },
        command,
      ),
      html(
        "p",
        { class: "note" },
        "What is changed here is planned anew by the engine in this page, by the period, mode, tolerance, smoothing and start of that command.",
      ),
    );
  }

  /** Is it what the page shows? */
  set isShown(isShown: boolean) {
    this.element.hidden = !isShown;
  }
}
