// From where a path is seen: turned about its middle, without perspective.

export interface Camera {
  /** Of the view's direction in the plane, and above it, degrees. */
  azimuth: number;
  elevation: number;
  /** What stands in the middle of the picture, mm. */
  target: [number, number, number];
  /** Pixels a mm. */
  scale: number;
}

export const views = {
  iso: { name: "3-D", azimuth: -60, elevation: 35.26 },
  top: { name: "Top", azimuth: -90, elevation: 90 },
  front: { name: "Front", azimuth: -90, elevation: 0 },
  side: { name: "Side", azimuth: 0, elevation: 0 },
} as const;
export type View = keyof typeof views;

const radians = Math.PI / 180;

/** To the right of the picture, up in it, and out of it. */
export function frameOf(camera: Camera): readonly [number[], number[], number[]] {
  const [a, e] = [camera.azimuth * radians, camera.elevation * radians];
  const out = [Math.cos(a) * Math.cos(e), Math.sin(a) * Math.cos(e), Math.sin(e)];
  const right = [-Math.sin(a), Math.cos(a), 0];
  const up = [-Math.cos(a) * Math.sin(e), -Math.sin(a) * Math.sin(e), Math.cos(e)];
  return [right, up, out];
}

export function dot(a: readonly number[], b: readonly number[]): number {
  return (a[0] ?? 0) * (b[0] ?? 0) + (a[1] ?? 0) * (b[1] ?? 0) + (a[2] ?? 0) * (b[2] ?? 0);
}

/** Pixels from the upper left corner. */
export function projector(camera: Camera, width: number, height: number): (at: readonly number[]) => [number, number] {
  const [right, up] = frameOf(camera);
  const [x, y] = [dot(right, camera.target), dot(up, camera.target)];
  return (at) => [width / 2 + (dot(right, at) - x) * camera.scale, height / 2 - (dot(up, at) - y) * camera.scale];
}

/** All of the box in the picture. */
export function fit(
  camera: Camera,
  least: readonly number[],
  greatest: readonly number[],
  width: number,
  height: number,
): void {
  const [right, up] = frameOf(camera);
  const box: [number, number, number] = [0, 1, 2].map((i) => ((least[i] ?? 0) + (greatest[i] ?? 0)) / 2) as never;
  camera.target = box;
  const half = [0, 1, 2].map((i) => ((greatest[i] ?? 0) - (least[i] ?? 0)) / 2);
  const reach = (axis: readonly number[]): number =>
    half.reduce((sum, each, i) => sum + Math.abs(each * (axis[i] ?? 0)), 0);
  const margin = 0.42;
  const scale = Math.min(
    (margin * width) / Math.max(reach(right), 1e-6),
    (margin * height) / Math.max(reach(up), 1e-6),
  );
  camera.scale = Math.min(scale, 1e4);
}

export function turn(camera: Camera, right: number, up: number): void {
  camera.azimuth = (camera.azimuth + right) % 360;
  camera.elevation = Math.min(Math.max(camera.elevation + up, -90), 90);
}

/** By so many pixels. */
export function pan(camera: Camera, x: number, y: number): void {
  const [right, up] = frameOf(camera);
  camera.target = camera.target.map(
    (each, i) => each - ((right[i] ?? 0) * x - (up[i] ?? 0) * y) / camera.scale,
  ) as Camera["target"];
}

/** Nearer by a factor, while what is at this pixel stays there. */
export function zoom(camera: Camera, factor: number, x: number, y: number, width: number, height: number): void {
  const [dx, dy] = [x - width / 2, y - height / 2];
  pan(camera, -dx, -dy);
  camera.scale = Math.min(Math.max(camera.scale * factor, 1e-3), 1e6);
  pan(camera, dx, dy);
}
