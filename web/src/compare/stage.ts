// The pictures: lanes over one another or beside one another, by one camera that keys, the wheel and the pointer move; and
// strips over their clock.

import { CanvasPicture, SvgPicture } from "../draw/picture";
import { html } from "../ui/dom";
import { mark } from "./lane_forms";
import { stripMargin, type Camera, type Layout, type Scene, type View } from "./scene";
import { mostLanes } from "./state";

export interface StageEvents {
  look(camera: Camera | undefined): void;
  layout(layout: Layout): void;
  seek(clock: number): void;
}

/** Of a picture over the clock: the element's id, its title, and what it is called. */
export interface Strip {
  readonly id: string;
  readonly title: string;
  readonly label: string;
}

const most = 4e9; // across

export class Stage {
  readonly element: HTMLElement;
  private readonly canvases: HTMLCanvasElement[] = [];
  private readonly frames: HTMLElement[] = [];
  private readonly captions: HTMLElement[] = [];
  private readonly strips: HTMLCanvasElement[];
  private readonly layout: HTMLSelectElement;
  private shown: { scene: Scene; view: View; clock: number; text: string } | undefined;
  private draws = 0;
  private drag: { readonly x: number; readonly y: number; readonly camera: Camera } | undefined;

  /** `least`: so many units across at the nearest. */
  constructor(
    private readonly events: StageEvents,
    private readonly told: readonly Strip[],
    private readonly least = 4,
  ) {
    const cells = [...Array(mostLanes).keys()].map(() => this.canvas());
    this.strips = told.map(({ id }) => html("canvas", { role: "img", id }));
    this.layout = html("select", {
      id: "layout",
      "aria-label": "How the paths are laid out",
      change: () => events.layout(this.layout.value as Layout),
    });
    this.layout.append(new Option("Over one another", "overlay"), new Option("Beside one another", "beside"));
    for (const strip of this.strips) strip.addEventListener("click", (event) => this.seekTo(event, strip));
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
        html("div", { class: "paths" }, ...cells),
      ),
      ...told.map(({ id, title }, i) =>
        html(
          "section",
          { class: "panel", "aria-labelledby": `${id}-title` },
          html("h2", { id: `${id}-title` }, title),
          html("div", { class: "frame waves" }, this.strips[i]),
        ),
      ),
    );
    const sizes = new ResizeObserver(() => this.draw());
    for (const frame of [...this.frames, ...this.strips.map((each) => each.parentElement)])
      if (frame !== null) sizes.observe(frame);
  }

  /** A picture of paths with what stands above it. */
  private canvas(number = this.canvases.length): HTMLElement {
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
    const caption = html("p", { class: "path-caption" });
    this.captions.push(caption);
    return html("div", { class: "path-cell" }, caption, frame);
  }

  /** What is looked at, also where that is the whole curve. */
  private camera(): Camera | undefined {
    const [canvas] = this.canvases;
    if (this.shown === undefined || this.shown.scene.lanes.length === 0 || canvas === undefined) return undefined;
    const [width, height] = this.sizeOf(canvas);
    return this.shown.view.camera ?? this.shown.scene.whole({ width, height });
  }

  /** As a link has it. */
  private look({ x, y, across }: Camera): void {
    const [atX, atY, width] = [x, y, across].map((each) => Number(each.toPrecision(8)));
    this.events.look({ x: atX ?? x, y: atY ?? y, across: width ?? across });
  }

  private zoom(by: number): void {
    const camera = this.camera();
    if (camera === undefined) return;
    this.look({ ...camera, across: Math.max(this.least, Math.min(most, camera.across * by)) });
  }

  private move(x: number, y: number): void {
    const camera = this.camera();
    if (camera === undefined) return;
    this.look({ ...camera, x: camera.x + x * camera.across, y: camera.y + y * camera.across });
  }

  private dragTo(event: PointerEvent, canvas: HTMLCanvasElement): void {
    if (this.drag === undefined) return;
    const { camera, x, y } = this.drag;
    const blu = camera.across / this.sizeOf(canvas)[0];
    this.look({
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

  private seekTo(event: MouseEvent, strip: HTMLCanvasElement): void {
    if (this.shown === undefined) return;
    const { left, right } = stripMargin;
    const [width] = this.sizeOf(strip);
    this.events.seek(
      Math.round(((event.offsetX - left) / (width - left - right)) * Math.max(1, this.shown.scene.last)),
    );
  }

  update(scene: Scene, view: View, clock: number, text: string): void {
    this.shown = { scene, view, clock, text };
    const { lanes } = scene;
    this.layout.value = view.layout;
    const isBeside = view.layout === "beside";
    this.frames.forEach((frame, i) => {
      const lane = isBeside ? lanes[i] : undefined;
      if (frame.parentElement !== null) frame.parentElement.hidden = i > 0 && lane === undefined;
      const title = isBeside ? `Path of ${lane?.title ?? ""}` : "Paths of all methods";
      frame.setAttribute("aria-label", `${title}: arrows move, + and − zoom, 0 shows all`);
      const named = lane === undefined ? [] : [mark(lane.number), `${lane.title}: ${lane.detail}`.replace(/: $/, "")];
      this.captions[i]?.replaceChildren(...named);
    });
    this.frames[0]?.closest(".paths")?.classList.toggle("beside", isBeside && lanes.length > 1);
    if (this.draws === 0) this.draws = requestAnimationFrame(() => this.draw());
  }

  draw(): void {
    this.draws = 0;
    if (this.shown === undefined) return;
    const { scene, view, clock, text } = this.shown;
    this.canvases.forEach((canvas, i) => {
      if (canvas.closest<HTMLElement>(".path-cell")?.hidden !== false) return;
      const lane = view.layout === "overlay" ? undefined : i;
      scene.drawPaths(new CanvasPicture(canvas, ...this.sizeOf(canvas)), lane, view.camera, clock);
      canvas.setAttribute("aria-label", lane === undefined ? text : (scene.lanes[i]?.title ?? ""));
    });
    this.strips.forEach((strip, i) => {
      scene.drawStrip(i, new CanvasPicture(strip, ...this.sizeOf(strip)), clock);
      strip.setAttribute("aria-label", `${this.told[i]?.label}, which stands at ${clock}`);
    });
  }

  private sizeOf(canvas: HTMLCanvasElement): [number, number] {
    const frame = canvas.parentElement;
    return [Math.max(160, frame?.clientWidth ?? 640), Math.max(120, frame?.clientHeight ?? 320)];
  }

  svg(): string {
    const picture = new SvgPicture(800, 600, this.shown?.text ?? "");
    if (this.shown !== undefined)
      this.shown.scene.drawPaths(picture, undefined, this.shown.view.camera, this.shown.clock);
    return picture.toString();
  }

  /** The paths over one another, and the strips below. */
  async png(): Promise<Blob> {
    const all = html("canvas", { width: 1600, height: 1200 + 400 * this.strips.length });
    if (this.shown !== undefined) {
      const { scene, view, clock } = this.shown;
      const paths = html("canvas");
      scene.drawPaths(new CanvasPicture(paths, 800, 600, 2), undefined, view.camera, clock);
      all.getContext("2d")?.drawImage(paths, 0, 0);
      this.strips.forEach((_, i) => {
        const strip = html("canvas");
        scene.drawStrip(i, new CanvasPicture(strip, 800, 200, 2), clock);
        all.getContext("2d")?.drawImage(strip, 0, 1200 + 400 * i);
      });
    }
    return await new Promise((resolve, reject) =>
      all.toBlob((blob) => (blob === null ? reject(new Error("no picture")) : resolve(blob)), "image/png"),
    );
  }
}
