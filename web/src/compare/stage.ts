// The pictures: lanes over one another or beside one another, by one camera that keys, the wheel and the pointer move; and
// their errors over the clock.

import { CanvasPicture, SvgPicture } from "../draw/picture";
import { html } from "../ui/dom";
import { drawErrors, drawLanes, wholeCamera, type Drawn } from "./pictures";
import { mostLanes, type Camera, type State } from "./state";

export interface StageEvents {
  look(camera: Camera | undefined): void;
  layout(layout: State["layout"]): void;
  seek(clock: number): void;
}

const least = 4; // BLU across
const most = 4e9;

export class Stage {
  readonly element: HTMLElement;
  private readonly canvases: HTMLCanvasElement[] = [];
  private readonly frames: HTMLElement[] = [];
  private readonly errors = html("canvas", { role: "img", id: "errors" });
  private readonly layout: HTMLSelectElement;
  private shown: { lanes: readonly Drawn[]; state: State; clock: number; text: string } | undefined;
  private draws = 0;
  private drag: { readonly x: number; readonly y: number; readonly camera: Camera } | undefined;

  constructor(private readonly events: StageEvents) {
    for (let i = 0; i < mostLanes; ++i) this.canvas(i);
    this.layout = html("select", {
      id: "layout",
      "aria-label": "How the paths are laid out",
      change: () => events.layout(this.layout.value as State["layout"]),
    });
    this.layout.append(new Option("Over one another", "overlay"), new Option("Beside one another", "beside"));
    this.errors.addEventListener("click", (event) => this.seekTo(event));
    const button = (id: string, text: string, name: string, press: () => void): HTMLElement =>
      html("button", { type: "button", id, "aria-label": name, click: press }, text);
    this.element = html(
      "div",
      { class: "stage-panels" },
      html(
        "section",
        { class: "panel", "aria-labelledby": "paths-title" },
        html(
          "div",
          { class: "panel-head" },
          html("h2", { id: "paths-title" }, "Paths"),
          html(
            "div",
            { class: "tools" },
            this.layout,
            button("nearer", "+", "Nearer", () => this.zoom(1 / 1.5)),
            button("farther", "−", "Farther", () => this.zoom(1.5)),
            button("whole", "Whole curve", "Show the whole curve", () => events.look(undefined)),
          ),
        ),
        html("div", { class: "paths" }, ...this.frames),
      ),
      html(
        "section",
        { class: "panel", "aria-labelledby": "errors-title" },
        html("h2", { id: "errors-title" }, "Error over the clock, BLU"),
        html("div", { class: "frame waves" }, this.errors),
      ),
    );
    const sizes = new ResizeObserver(() => this.draw());
    for (const frame of [...this.frames, this.errors.parentElement]) if (frame !== null) sizes.observe(frame);
  }

  private canvas(number: number): void {
    const canvas = html("canvas", { role: "img", id: `path-${number + 1}` });
    const frame = html("div", { class: "frame path-frame", tabindex: 0, role: "group" }, canvas);
    frame.addEventListener("keydown", (event) => this.key(event));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(event.deltaY < 0 ? 1 / 1.2 : 1.2);
    });
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      const camera = this.camera();
      if (camera !== undefined) this.drag = { x: event.clientX, y: event.clientY, camera };
    });
    canvas.addEventListener("pointermove", (event) => this.dragTo(event, canvas));
    canvas.addEventListener("pointerup", () => (this.drag = undefined));
    this.canvases.push(canvas);
    this.frames.push(frame);
  }

  /** What is looked at, also where that is the whole curve. */
  private camera(): Camera | undefined {
    if (this.shown === undefined || this.shown.lanes.length === 0) return undefined;
    const [width, height] = this.sizeOf(this.canvases[0] ?? this.errors);
    return this.shown.state.camera ?? wholeCamera(this.shown.lanes, { width, height });
  }

  private zoom(by: number): void {
    const camera = this.camera();
    if (camera === undefined) return;
    this.events.look({ ...camera, across: Math.max(least, Math.min(most, camera.across * by)) });
  }

  private move(x: number, y: number): void {
    const camera = this.camera();
    if (camera === undefined) return;
    this.events.look({ ...camera, x: camera.x + x * camera.across, y: camera.y + y * camera.across });
  }

  private dragTo(event: PointerEvent, canvas: HTMLCanvasElement): void {
    if (this.drag === undefined) return;
    const { camera, x, y } = this.drag;
    const blu = camera.across / this.sizeOf(canvas)[0];
    this.events.look({
      ...camera,
      x: camera.x - (event.clientX - x) * blu,
      y: camera.y + (event.clientY - y) * blu,
    });
  }

  private key(event: KeyboardEvent): void {
    const actions: Readonly<Record<string, () => void>> = {
      ArrowLeft: () => this.move(-0.1, 0),
      ArrowRight: () => this.move(0.1, 0),
      ArrowUp: () => this.move(0, 0.1),
      ArrowDown: () => this.move(0, -0.1),
      "+": () => this.zoom(1 / 1.5),
      "=": () => this.zoom(1 / 1.5),
      "-": () => this.zoom(1.5),
      "0": () => this.events.look(undefined),
    };
    const action = actions[event.key];
    if (action === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  }

  private seekTo(event: MouseEvent): void {
    if (this.shown === undefined) return;
    const last = Math.max(1, ...this.shown.lanes.map(({ session }) => session.last));
    const [width] = this.sizeOf(this.errors);
    this.events.seek(Math.round(((event.offsetX - 52) / (width - 64)) * last));
  }

  update(lanes: readonly Drawn[], state: State, clock: number, text: string): void {
    this.shown = { lanes, state, clock, text };
    this.layout.value = state.layout;
    const isBeside = state.layout === "beside";
    this.frames.forEach((frame, i) => {
      frame.hidden = i > 0 && !(isBeside && i < lanes.length);
      const title = isBeside ? `Path of ${lanes[i]?.title ?? ""}` : "Paths of all methods";
      frame.setAttribute("aria-label", `${title}: arrows move, + and − zoom, 0 shows all`);
    });
    this.frames[0]?.parentElement?.classList.toggle("beside", isBeside && lanes.length > 1);
    if (this.draws === 0) this.draws = requestAnimationFrame(() => this.draw());
  }

  draw(): void {
    this.draws = 0;
    if (this.shown === undefined) return;
    const { lanes, state, clock, text } = this.shown;
    this.canvases.forEach((canvas, i) => {
      if (canvas.parentElement?.hidden !== false) return;
      const some = state.layout === "overlay" ? lanes : lanes.slice(i, i + 1);
      const lane = state.layout === "overlay" ? undefined : lanes[i];
      const title = lane === undefined ? "" : `${lane.number + 1}  ${lane.title}: ${lane.detail}`.replace(/: $/, "");
      drawLanes(new CanvasPicture(canvas, ...this.sizeOf(canvas)), some, state.camera, clock, title);
      canvas.setAttribute("aria-label", state.layout === "overlay" ? text : (lanes[i]?.title ?? ""));
    });
    drawErrors(new CanvasPicture(this.errors, ...this.sizeOf(this.errors)), lanes, clock);
    this.errors.setAttribute("aria-label", `Errors of all methods over the clock, which stands at ${clock}`);
  }

  private sizeOf(canvas: HTMLCanvasElement): [number, number] {
    const frame = canvas.parentElement;
    return [Math.max(160, frame?.clientWidth ?? 640), Math.max(120, frame?.clientHeight ?? 320)];
  }

  svg(): string {
    const picture = new SvgPicture(800, 600, this.shown?.text ?? "");
    if (this.shown !== undefined) drawLanes(picture, this.shown.lanes, this.shown.state.camera, this.shown.clock);
    return picture.toString();
  }

  /** The paths over one another, and their errors below. */
  async png(): Promise<Blob> {
    const all = html("canvas", { width: 1600, height: 1600 });
    const [paths, errors] = [html("canvas"), html("canvas")];
    if (this.shown !== undefined) {
      const { lanes, state, clock } = this.shown;
      drawLanes(new CanvasPicture(paths, 800, 600, 2), lanes, state.camera, clock);
      drawErrors(new CanvasPicture(errors, 800, 200, 2), lanes, clock);
      all.getContext("2d")?.drawImage(paths, 0, 0);
      all.getContext("2d")?.drawImage(errors, 0, 1200);
    }
    return await new Promise((resolve, reject) =>
      all.toBlob((blob) => (blob === null ? reject(new Error("no picture")) : resolve(blob)), "image/png"),
    );
  }
}
