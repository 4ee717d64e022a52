// The path in space: turned, moved and brought nearer by pointer and keys; a click tells which place is meant.

import { CanvasPicture, SvgPicture, type Picture } from "../draw/picture";
import type { Gouge, PathData, Plan } from "../engine/motion_types";
import { html } from "../ui/dom";
import { fit, pan, projector, turn, views, zoom, type Camera, type View } from "./camera";
import { coloursOf, rangeOf, type Look } from "./colours";
import { Overlay, type StandingTool } from "./overlay";
import { drawPath } from "./path_picture";
import { SceneClient } from "./scene_client";
import type { Colouring } from "./settings";

const nearPick = 14; // px

export class PathView {
  readonly element = html("div", {
    class: "space",
    id: "space",
    tabindex: 0,
    role: "img",
    "aria-label": "Path in space",
  });
  private readonly scene: SceneClient | undefined;
  private readonly canvas: HTMLCanvasElement;
  private readonly overlay = new Overlay();
  private readonly camera: Camera = { azimuth: -60, elevation: 35.26, target: [0, 0, 0], scale: 1 };
  private plan: Plan | undefined;
  private path: PathData | undefined;
  private colouring: Colouring = "speed";
  private hasContour = true;
  private tool: StandingTool | undefined;
  private frame = 0;
  private readonly firstView = { azimuth: views.iso.azimuth, elevation: views.iso.elevation };
  private isPathStale = false;
  /** All of the path is in the picture, whatever its size. */
  private isFitted = true;
  private width = 0;

  constructor(
    private readonly picked: (sample: number) => void,
    private readonly moved: () => void,
  ) {
    try {
      this.scene = new SceneClient(() => this.countPicture());
    } catch {
      // a browser without WebGL: in two dimensions, then
    }
    this.canvas = this.scene?.canvas ?? document.createElement("canvas");
    for (const each of [this.canvas, this.overlay.canvas]) each.setAttribute("aria-hidden", "true");
    this.element.append(this.canvas, this.overlay.canvas);
    this.element.dataset["by"] = this.scene === undefined ? "canvas" : "webgl";
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  /** From where it is seen: turned by degrees, and, where that is not all of it, so many mm across around a place. Empty: as at first. */
  get seen(): string {
    const { azimuth, elevation, target, scale } = this.camera;
    if (this.isFitted && azimuth === views.iso.azimuth && elevation === views.iso.elevation) return "";
    const near = this.isFitted ? [] : [...target, this.element.clientWidth / scale];
    return [azimuth, elevation, ...near].map((each) => Number(each.toPrecision(7))).join("_");
  }

  /** The same again; what is none leaves it as it is. */
  see(text: string): void {
    const [azimuth = NaN, elevation = NaN, x, y, z, across] = text.split("_").map(Number);
    const isView = text !== "" && Number.isFinite(azimuth) && Math.abs(elevation) <= 90;
    Object.assign(this.camera, isView ? { azimuth, elevation } : this.firstView);
    this.fit();
    if (x === undefined || y === undefined || z === undefined || across === undefined) return;
    if (![x, y, z].every(Number.isFinite) || !(across > 0)) return;
    this.camera.target = [x, y, z];
    this.camera.scale = this.element.clientWidth / across;
    this.isFitted = false;
    this.draw();
  }

  /** `seen`: from where; without it, as before. */
  load(plan: Plan, colouring: Colouring, seen: string | undefined): void {
    this.plan = plan;
    this.path = plan.path;
    this.overlay.mark([]);
    this.overlay.gouges = [];
    this.overlay.poles = plan.poles.map(({ sample }) => [...plan.samples.tip.subarray(sample * 3, sample * 3 + 3)]);
    this.scene?.load(plan.drawn, plan.surfaces, plan.contour);
    this.paint(colouring);
    if (seen !== undefined) this.see(seen);
  }

  paint(colouring: Colouring): void {
    this.colouring = colouring;
    if (this.plan === undefined) return;
    this.scene?.paint(this.lookOf(this.plan), this.hasContour);
    this.draw();
  }

  /** The plan has been judged. */
  judge(plan: Plan): void {
    if (plan !== this.plan) return;
    this.scene?.judge(plan.path.share);
    this.repaint();
  }

  /** What the program tells where cutter compensation is on. */
  showContour(isShown: boolean): void {
    this.hasContour = isShown;
    this.repaint();
  }

  repaint(): void {
    this.paint(this.colouring);
  }

  /** Where the tool is, and which line it moves along. */
  stand(sample: number): void {
    const { plan } = this;
    if (plan === undefined) return;
    const { tip, direction, tool } = plan.samples;
    this.tool = {
      tip: [...tip.subarray(sample * 3, sample * 3 + 3)],
      direction: [...direction.subarray(sample * 3, sample * 3 + 3)],
      shape: plan.tools.find(({ number }) => number === tool[sample]),
    };
    this.drawOver();
  }

  /** Where the running machine has its tool, of this number. */
  standAt(tip: readonly number[], direction: readonly number[], tool: number): void {
    const shape = this.plan?.tools.find(({ number }) => number === tool);
    this.tool = { tip, direction, shape };
    const told = [...tip, ...direction].map((each) => each.toFixed(3)).join(" ");
    this.element.dataset["tool"] = `${shape === undefined ? "" : `T${shape.number} `}${told}`;
    this.drawOver();
  }

  /** Where the tool cuts too deep. */
  markGouges(gouges: readonly Gouge[]): void {
    this.overlay.gouges = gouges.map(({ place }) => place);
    this.drawOver();
  }

  mark(line: number): void {
    const { plan, path } = this;
    if (plan === undefined || path === undefined) return;
    const vertices: number[] = [];
    for (let v = 1; v < path.samples.length; ++v)
      if (plan.blocks.line[plan.samples.block[path.samples[v] ?? 0] ?? 0] === line) vertices.push(v);
    this.overlay.mark(vertices);
    this.drawOver();
  }

  look(view: View): void {
    Object.assign(this.camera, { azimuth: views[view].azimuth, elevation: views[view].elevation });
    this.fit();
  }

  fit(): void {
    if (this.path === undefined) return;
    this.isFitted = true;
    fit(this.camera, this.path.least, this.path.greatest, this.element.clientWidth, this.element.clientHeight);
    this.draw();
  }

  svgText(): string {
    const picture = new SvgPicture(this.element.clientWidth, this.element.clientHeight, "Path of the tool");
    this.drawOn(picture, this.tool);
    return picture.toString();
  }

  async pngBlob(): Promise<Blob> {
    const canvas = document.createElement("canvas");
    this.drawOn(new CanvasPicture(canvas, this.element.clientWidth, this.element.clientHeight), this.tool);
    return await new Promise((resolve, reject) =>
      canvas.toBlob((blob) => (blob === null ? reject(new Error("no picture")) : resolve(blob)), "image/png"),
    );
  }

  private lookOf(plan: Plan): Look {
    const isDark = getComputedStyle(document.documentElement).colorScheme === "dark";
    return { colouring: this.colouring, range: rangeOf(plan, this.colouring), isDark };
  }

  private drawOn(picture: Picture, tool: StandingTool | undefined): void {
    if (this.plan === undefined) return;
    const { path, surfaces, contour } = this.plan;
    const shown = this.hasContour ? contour : new Float32Array();
    drawPath(picture, path, coloursOf(path, this.lookOf(this.plan)), this.camera, surfaces, shown, tool);
  }

  /** The path, and what moves over it. */
  private draw(): void {
    this.isPathStale = true;
    this.element.dataset["drawing"] = "";
    this.moved();
    this.drawOver();
  }

  private drawOver(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.drawNow());
  }

  private drawNow(): void {
    this.frame = 0;
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || this.path === undefined) return;
    if (this.isPathStale) {
      if (this.scene !== undefined) this.scene.draw(this.camera);
      else this.drawOn(new CanvasPicture(this.canvas, width, height), undefined);
    }
    this.isPathStale = false;
    this.settle();
    this.overlay.draw(this.camera, width, height, this.path, this.tool);
  }

  private countPicture(): void {
    this.element.dataset["pictures"] = String(Number(this.element.dataset["pictures"] ?? 0) + 1);
    this.settle();
  }

  private settle(): void {
    if (!this.isPathStale && (this.scene?.isIdle ?? true)) delete this.element.dataset["drawing"];
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    this.scene?.size(width, height);
    if (this.width > 0) this.camera.scale *= width / this.width;
    this.width = width;
    if (this.isFitted) this.fit();
    else this.draw();
  }

  private listen(): void {
    const { element, camera } = this;
    let from: PointerEvent | undefined;
    let moved = 0;
    element.addEventListener("pointerdown", (event) => {
      from = event;
      moved = 0;
      element.setPointerCapture(event.pointerId);
    });
    element.addEventListener("pointermove", (event) => {
      if (from === undefined) return;
      const [x, y] = [event.clientX - from.clientX, event.clientY - from.clientY];
      moved += Math.abs(x) + Math.abs(y);
      this.isFitted = false;
      if (event.shiftKey || event.buttons === 2 || event.buttons === 4) pan(camera, x, y);
      else turn(camera, -x / 3, y / 3);
      from = event;
      this.draw();
    });
    element.addEventListener("pointerup", (event) => {
      from = undefined;
      if (moved < 4) this.pick(event.offsetX, event.offsetY);
    });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY / 400), event.offsetX, event.offsetY);
      },
      { passive: false },
    );
    element.addEventListener("keydown", (event) => this.key(event));
  }

  private zoom(factor: number, x: number, y: number): void {
    this.isFitted = false;
    zoom(this.camera, factor, x, y, this.element.clientWidth, this.element.clientHeight);
    this.draw();
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { clientWidth: width, clientHeight: height } = this.element;
    const go = (x: number, y: number): void => {
      this.isFitted = false;
      if (event.shiftKey) pan(this.camera, 30 * x, -30 * y);
      else turn(this.camera, -5 * x, -5 * y);
    };
    const actions: Readonly<Record<string, () => void>> = {
      ArrowLeft: () => go(-1, 0),
      ArrowRight: () => go(1, 0),
      ArrowUp: () => go(0, 1),
      ArrowDown: () => go(0, -1),
      "+": () => this.zoom(1.25, width / 2, height / 2),
      "=": () => this.zoom(1.25, width / 2, height / 2),
      "-": () => this.zoom(0.8, width / 2, height / 2),
      "0": () => this.fit(),
    };
    const action = actions[event.key];
    if (action === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    action();
    this.draw();
  }

  /** The place of the path that is nearest to the pixel. */
  private pick(x: number, y: number): void {
    const { path } = this;
    if (path === undefined) return;
    const project = projector(this.camera, this.element.clientWidth, this.element.clientHeight);
    let [nearest, distance] = [-1, nearPick];
    const at = [0, 0, 0];
    for (let v = 0; v < path.samples.length; ++v) {
      for (let i = 0; i < 3; ++i) at[i] = path.places[v * 3 + i] ?? 0;
      const [px, py] = project(at);
      const here = Math.hypot(px - x, py - y);
      if (here < distance) [nearest, distance] = [v, here];
    }
    if (nearest >= 0) this.picked(path.samples[nearest] ?? 0);
  }
}
