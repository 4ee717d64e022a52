// The path by WebGL.

import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  OrthographicCamera,
  Scene as ThreeScene,
  Vector3,
  WebGLRenderer,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import type { PathData, SurfaceMesh } from "../engine/motion_types";
import { frameOf, type Camera } from "./camera";
import { wideLines } from "./wide_lines";

const mostWideSegments = 60_000; // more are drawn a pixel wide

/** Colours of what has one. */
export interface Paints {
  readonly rapid: string;
  readonly surface: string;
  /** None: it is not shown. */
  readonly contour: string | undefined;
}

/** Vertices of segments that are rapids, or are not: pairs of the path's. */
function pairsOf(path: PathData, isRapid: boolean): Int32Array {
  const pairs = new Int32Array(path.samples.length * 2);
  let count = 0;
  for (let v = 1; v < path.samples.length; ++v) {
    if (path.isApart[v] === 1 || (path.isRapid[v] === 1) !== isRapid) continue;
    pairs[count++] = v - 1;
    pairs[count++] = v;
  }
  return pairs.slice(0, count);
}

/** Three numbers of each of these vertices. */
function taken(from: Float32Array, vertices: Int32Array): Float32Array {
  const numbers = new Float32Array(vertices.length * 3);
  for (let i = 0; i < vertices.length; ++i)
    for (let k = 0; k < 3; ++k) numbers[i * 3 + k] = from[(vertices[i] ?? 0) * 3 + k] ?? 0;
  return numbers;
}

const levels = 255;
/** Three.js reckons with light, of which screens show another power (IEC 61966-2-1): for each level of a channel. */
const light = Float32Array.from({ length: levels + 1 }, (_, level) => {
  const shown = level / levels;
  return shown <= 0.04045 ? shown / 12.92 : ((shown + 0.055) / 1.055) ** 2.4;
});

/** Of colours as screens show them. */
function lit(colours: Float32Array): Float32Array {
  return colours.map((shown) => light[Math.round(shown * levels)] ?? 0);
}

/** Two triangles a quadrilateral, of corners 0 1 2 and 0 2 3. */
function geometryOf(mesh: SurfaceMesh): BufferGeometry {
  const corners = mesh.corners.length / 3;
  const index = new Uint32Array((corners / 4) * 6);
  for (let cell = 0; cell < corners / 4; ++cell)
    [0, 1, 2, 0, 2, 3].forEach((corner, i) => (index[cell * 6 + i] = cell * 4 + corner));
  return new BufferGeometry()
    .setAttribute("position", new BufferAttribute(mesh.corners, 3))
    .setAttribute("normal", new BufferAttribute(mesh.normals, 3))
    .setIndex(new BufferAttribute(index, 1));
}

export class Scene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new ThreeScene();
  private readonly eye = new OrthographicCamera();
  private readonly drawn = new Group();
  private readonly surfaces = new Group();
  private readonly lamp = new DirectionalLight(0xffffff, 2);
  /** Behind the path that lies on it. */
  private readonly shade = new MeshLambertMaterial({
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 8,
  });
  private readonly wide = new LineMaterial({ vertexColors: true, linewidth: 2.5 });
  private feeds: Int32Array = new Int32Array();
  private contour: Float32Array = new Float32Array();
  private path: PathData | undefined;
  private reach = 1;

  constructor(canvas: OffscreenCanvas) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.scene.add(this.drawn, this.surfaces, this.lamp, this.lamp.target, new AmbientLight(0xffffff, 1.2));
  }

  /** In pixels of the page, of which each is `ratio` of the screen. */
  size(width: number, height: number, ratio: number): void {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.wide.resolution.set(width, height);
    [this.eye.left, this.eye.right, this.eye.top, this.eye.bottom] = [-width / 2, width / 2, height / 2, -height / 2];
  }

  load(path: PathData, surfaces: readonly SurfaceMesh[], contour: Float32Array): void {
    for (const each of this.surfaces.children) (each as Mesh).geometry.dispose();
    this.surfaces.clear();
    for (const mesh of surfaces) this.surfaces.add(new Mesh(geometryOf(mesh), this.shade));
    this.path = path;
    this.contour = contour;
    this.feeds = pairsOf(path, false);
    this.reach = Math.max(1e-3, ...[0, 1, 2].map((i) => (path.greatest[i] ?? 0) - (path.least[i] ?? 0)));
  }

  /** `colours` has three numbers a vertex of the path, of the sample that it ends with. */
  paint(colours: Float32Array, { rapid, surface, contour }: Paints): void {
    this.shade.color.set(new Color(surface));
    const { path, feeds } = this;
    if (path === undefined) return;
    for (const each of this.drawn.children) (each as LineSegments).geometry.dispose();
    this.drawn.clear();
    // Both ends have the colour of the sample that the segment leads to.
    const ends = feeds.map((v, i) => (i % 2 === 0 ? v + 1 : v));
    if (feeds.length > 0) this.drawn.add(this.feedLines(taken(path.places, feeds), lit(taken(colours, ends))));
    this.addDashed(taken(path.places, pairsOf(path, true)), rapid, this.reach / 90);
    if (contour !== undefined) this.addDashed(this.contour, contour, this.reach / 200);
  }

  /** Lines of a pixel: places of both ends, six numbers each. */
  private addDashed(ends: Float32Array, colour: string, dash: number): void {
    if (ends.length === 0) return;
    const material = new LineDashedMaterial({ color: new Color(colour), dashSize: dash, gapSize: dash });
    const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(ends, 3));
    this.drawn.add(new LineSegments(geometry, material).computeLineDistances());
  }

  draw(camera: Camera, paper: string): void {
    const [, up, out] = frameOf(camera);
    const target = new Vector3(...camera.target);
    const distance = this.reach * 10 + 1000;
    this.eye.position
      .set(out[0] ?? 0, out[1] ?? 0, out[2] ?? 0)
      .multiplyScalar(distance)
      .add(target);
    this.lamp.position.copy(this.eye.position); // the light falls from where one looks, so that what bends is shaded
    this.lamp.target.position.copy(target);
    this.eye.up.set(up[0] ?? 0, up[1] ?? 0, up[2] ?? 0);
    this.eye.lookAt(target);
    this.eye.zoom = camera.scale;
    this.eye.near = 0.1;
    this.eye.far = distance * 2;
    this.eye.updateProjectionMatrix();
    this.renderer.setClearColor(new Color(paper), 1);
    this.renderer.render(this.scene, this.eye);
  }

  private feedLines(places: Float32Array, painted: Float32Array): LineSegments | Mesh {
    if (places.length / 6 <= mostWideSegments) return wideLines(places, painted, this.wide);
    const geometry = new BufferGeometry()
      .setAttribute("position", new BufferAttribute(places, 3))
      .setAttribute("color", new BufferAttribute(painted, 3));
    return new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
  }
}
