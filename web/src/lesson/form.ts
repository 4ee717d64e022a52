// The panel of initialisation: what is to be interpolated, by which method, and the start switch.

import type { Catalogue, Conventions, Method } from "../engine/types";
import { html } from "../ui/dom";
import { presets, type Preset } from "./presets";
import { quantity, type FieldErrors, type Settings } from "./settings";

type TextKey = { [Key in keyof Settings]: Settings[Key] extends string ? Key : never }[keyof Settings];

export interface FormEvents {
  change(change: Partial<Settings>): void;
  preset(preset: Preset): void;
  start(isOn: boolean): void;
}

interface Field {
  readonly input: HTMLInputElement | HTMLSelectElement;
  readonly error: HTMLElement;
  readonly row: HTMLElement;
}

export const methodTitles: Readonly<Record<string, string>> = {
  "point-comparison": "Point by point",
  dda: "DDA in hardware",
  "min-error": "Minimum error",
  "improved-min-error": "Improved minimum error",
  bresenham: "Bresenham",
  koren: "Koren's program",
};

export class Form {
  readonly element: HTMLElement;
  readonly switch = html(
    "button",
    { type: "button", class: "switch", role: "switch", "aria-checked": "false", id: "start-switch" },
    "Start switch",
  );
  readonly status = html("p", { class: "status", role: "status" });
  private readonly time = html("output", { class: "number", id: "system-time" });
  private readonly rate = html("p", { class: "note", id: "clock-rate" });
  private readonly inForce = html("p", { class: "note", id: "in-force" });
  private readonly source = html("p", { class: "note", id: "preset-source" });
  private readonly fields = new Map<TextKey, Field>();
  private readonly preset: HTMLSelectElement;

  constructor(
    private readonly catalogue: Catalogue,
    private readonly events: FormEvents,
  ) {
    this.preset = html("select", { id: "preset" }, new Option("Choose a figure of the papers", ""));
    for (const each of presets) this.preset.append(new Option(each.title, each.id));
    this.preset.addEventListener("change", () => {
      const chosen = presets.find((each) => each.id === this.preset.value);
      if (chosen !== undefined) events.preset(chosen);
    });
    this.switch.addEventListener("click", () => events.start(this.switch.getAttribute("aria-checked") !== "true"));
    this.element = html("section", { class: "panel", "aria-labelledby": "initialisation" }, ...this.content());
    setInterval(() => this.tick(), 1000);
    this.tick();
  }

  private content(): HTMLElement[] {
    return [
      html("h2", { id: "initialisation" }, "Initialisation"),
      html("div", { class: "field" }, html("label", { for: "preset" }, "Figure"), this.preset, this.source),
      this.select(
        "curve",
        "Arc of",
        [
          ["circle", "A circle"],
          ["ellipse", "An ellipse, by the same DDA"],
        ],
        "arc-only",
      ),
      this.pair("Semi-axes", ["semiX", "a"], ["semiY", "b"], "ellipse-only"),
      this.pair("Start", ["startX", "x"], ["startY", "y"]),
      this.pair("End", ["endX", "x"], ["endY", "y"]),
      this.pair("Centre", ["centerX", "x"], ["centerY", "y"], "arc-only"),
      this.select(
        "direction",
        "Direction",
        [
          ["ccw", "Counterclockwise"],
          ["cw", "Clockwise"],
        ],
        "arc-only",
      ),
      this.select(
        "method",
        "Method",
        this.catalogue.methods.map(({ name }) => [name, methodTitles[name] ?? name]),
      ),
      html(
        "div",
        { class: "columns" },
        this.text("bits", "Register bits n", "numeric"),
        this.text("capacity", "Capacity q", "numeric"),
      ),
      this.select("preload", "Remainders begin", [
        ["", "The method's own"],
        ...this.catalogue.preloads.map((name) => [name, name] as const),
      ]),
      this.select("order", "Order of integrators", [
        ["", "The method's own"],
        ...this.catalogue.orders.map((name) => [name, name] as const),
      ]),
      this.select("tie", "On the circle", [
        ["", "The method's own"],
        ...this.catalogue.ties.map((name) => [name, name] as const),
      ]),
      this.select("ending", "Ends", [
        ["counters", "By counters, quadrant by quadrant"],
        ["free", "After the clocks of its angle"],
      ]),
      this.select("accumulation", "Negative integrands", [
        ["", "The method's own"],
        ...this.catalogue.accumulations.map((name) => [name, name] as const),
      ]),
      this.text("places", "Places of the radius in q", "numeric"),
      this.inForce,
      html(
        "div",
        { class: "columns" },
        this.text("feed", "Feed v, BLU/s", "decimal"),
        this.text("polling", "Polling, s", "decimal"),
      ),
      this.rate,
      html("div", { class: "start" }, this.switch, this.status),
      html("p", { class: "clock" }, html("span", {}, "System time"), this.time),
    ];
  }

  /** What is set, what is wrong, and what the method has. */
  update(
    settings: Settings,
    method: Method | undefined,
    errors: FieldErrors,
    conventions: Conventions | undefined,
  ): void {
    for (const [key, field] of this.fields) {
      if (field.input.value !== settings[key] && document.activeElement !== field.input)
        field.input.value = settings[key];
      const error = errors.get(key);
      field.error.textContent = error ?? "";
      if (error !== undefined) field.input.setAttribute("aria-invalid", "true");
      else field.input.removeAttribute("aria-invalid");
    }
    const isArc = settings.module === "arc";
    for (const each of this.element.querySelectorAll<HTMLElement>(".arc-only")) each.hidden = !isArc;
    this.show("preload", method?.hasPreload === true);
    this.show("capacity", method?.hasCapacity === true);
    const isEllipse = isArc && settings.curve === "ellipse";
    for (const each of this.element.querySelectorAll<HTMLElement>(".ellipse-only")) each.hidden = !isEllipse;
    this.show("order", method?.hasOrder === true && isArc);
    this.show("tie", method?.hasTie === true && isArc && !isEllipse);
    this.show("ending", method?.hasFree === true && isArc && !isEllipse);
    const isFree = settings.ending === "free" && method?.hasFree === true;
    this.show("accumulation", method?.hasAccumulation === true && isArc && !isEllipse && isFree);
    this.show("places", method?.hasPlaces === true && isArc && !isEllipse && !isFree);
    this.tellConventions(settings, conventions);
  }

  /** The preset that is shown, with what the paper says of it. */
  showPreset(preset: Preset | undefined): void {
    this.preset.value = preset?.id ?? "";
    this.source.textContent =
      preset === undefined
        ? ""
        : `${preset.source}${preset.published === "" ? "" : `. Published: ${preset.published}`}`;
  }

  showStart(isOn: boolean, status: string): void {
    this.switch.setAttribute("aria-checked", String(isOn));
    if (this.status.textContent !== status) this.status.textContent = status;
  }

  private tellConventions(settings: Settings, conventions: Conventions | undefined): void {
    const parts: string[] = [];
    if (conventions !== undefined) {
      if (conventions.capacity > 0)
        parts.push(`q = ${conventions.capacity}${conventions.scale > 1 ? ` · ${conventions.scale}` : ""}`);
      if (conventions.preload !== "") parts.push(`remainders begin ${conventions.preload}`);
      if (conventions.order !== "") parts.push(conventions.order);
      if (conventions.places > 0) parts.push(`${conventions.places} binary places of R in q`);
      if (conventions.accumulation !== "") parts.push(conventions.accumulation);
      if (conventions.tie !== "") parts.push(`ties: ${conventions.tie}`);
      parts.push(`end: ${conventions.end}`);
    }
    this.inForce.textContent = parts.length > 0 ? `In force: ${parts.join(", ")}` : "";
    const clocks = conventions?.clocksPerBlu ?? 0;
    const rate = clocks * quantity(settings.feed);
    this.rate.textContent =
      rate > 0
        ? `For this feed the interpolator's clock runs at ${rate.toPrecision(4)} Hz, a cycle every ${(1 / rate).toPrecision(3)} s.`
        : "";
  }

  private show(key: TextKey, isShown: boolean): void {
    const field = this.fields.get(key);
    if (field !== undefined) field.row.hidden = !isShown;
  }

  private tick(): void {
    this.time.textContent = new Date().toLocaleTimeString("en-GB");
  }

  private pair(title: string, ...parts: [[TextKey, string], [TextKey, string], string?]): HTMLElement {
    const [x, y, className] = parts;
    const legend = html("legend", {}, title);
    return html(
      "fieldset",
      { class: className ?? "" },
      legend,
      html("div", { class: "columns" }, this.text(x[0], x[1], "text", title), this.text(y[0], y[1], "text", title)),
    );
  }

  private text(key: TextKey, label: string, mode: string, of = ""): HTMLElement {
    const input = html("input", {
      id: key,
      type: "text",
      inputmode: mode,
      autocomplete: "off",
      spellcheck: "false",
      maxlength: 20,
      "aria-describedby": `${key}-error`,
      "aria-label": of === "" ? undefined : `${of} ${label}`,
      input: () => this.events.change({ [key]: input.value }),
    });
    return this.field(key, label, input);
  }

  private select(
    key: TextKey,
    label: string,
    options: readonly (readonly [string, string])[],
    className = "",
  ): HTMLElement {
    const input = html("select", {
      id: key,
      "aria-describedby": `${key}-error`,
      change: () => this.events.change({ [key]: input.value }),
    });
    for (const [value, text] of options) input.append(new Option(text, value));
    const row = this.field(key, label, input);
    if (className !== "") row.classList.add(className);
    return row;
  }

  private field(key: TextKey, label: string, input: HTMLInputElement | HTMLSelectElement): HTMLElement {
    const error = html("p", { class: "error", id: `${key}-error`, role: "alert" });
    const row = html("div", { class: "field" }, html("label", { for: key }, label), input, error);
    this.fields.set(key, { input, error, row });
    return row;
  }
}
