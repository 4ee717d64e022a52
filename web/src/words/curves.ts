// The curves of the comparison of words: as places, and as blocks of a part program.

export type Place = readonly [number, number];

export interface Curve {
  /** At 0 … 1, mm. */
  at(u: number): Place;
  /** It is made of lines, which any course keeps. */
  readonly isPolygon: boolean;
  /** As one block, or as one a smooth piece; without its feed, from where it begins. */
  readonly blocks: readonly string[];
}

/** That a program has a number with: it reads back as the same. */
function word(letter: string, value: number): string {
  return `${letter}${value.toFixed(12).replace(/\.?0+$/, "") || "0"}`;
}

function place([x, y]: Place): string {
  return `${word("X", x)} ${word("Y", y)}`;
}

/** The plane cubic of the real-time paper: x = 20u, y = −50u³ + 80u² − 10u, mm. */
const cubic: Curve = {
  isPolygon: false,
  at: (u) => [20 * u, ((-50 * u + 80) * u - 10) * u],
  blocks: ["G6.2 P4 K0 X0 Y0", "K0 X[20/3] Y[-10/3]", "K0 X[40/3] Y20", "K0 X20 Y20", ...Array<string>(4).fill("K1")],
};

/** A whole turn, counterclockwise, from (a, 0) around (0, 0), by four rational quadratics. */
function ellipse(a: number, b: number): Curve {
  const corners = [
    [1, 0],
    [1, 1],
    [0, 1],
    [-1, 1],
    [-1, 0],
    [-1, -1],
    [0, -1],
    [1, -1],
    [1, 0],
  ] as const;
  const knots = [0, 0, 0, 1, 1, 2, 2, 3, 3];
  const blocks = corners.map(([x, y], i) => {
    const weight = x !== 0 && y !== 0 ? ` R[SQRT[0.5]]` : "";
    return `${i === 0 ? "G6.2 P3 " : ""}K${knots[i]} ${place([x * a, y * b])}${weight}`;
  });
  return {
    isPolygon: false,
    at: (u) => [a * Math.cos(2 * Math.PI * u), b * Math.sin(2 * Math.PI * u)],
    blocks: [...blocks, "K4", "K4", "K4"],
  };
}

/** Lines through these places. */
function polygon(places: readonly Place[]): Curve {
  const lengths = places.slice(1).map(([x, y], i) => Math.hypot(x - (places[i]?.[0] ?? 0), y - (places[i]?.[1] ?? 0)));
  const whole = lengths.reduce((sum, each) => sum + each, 0);
  return {
    isPolygon: true,
    at: (u) => {
      let left = u * whole;
      for (const [i, length] of lengths.entries()) {
        if (left <= length || i === lengths.length - 1) {
          const [from, to] = [places[i] ?? [0, 0], places[i + 1] ?? [0, 0]];
          const share = length > 0 ? left / length : 0;
          return [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
        }
        left -= length;
      }
      return places[0] ?? [0, 0];
    },
    blocks: places.slice(1).map((each) => `G1 ${place(each)}`),
  };
}

export const curveKinds = ["cubic", "circle", "ellipse", "corner", "line"] as const;
export type CurveKind = (typeof curveKinds)[number];

/** `a` and `b`, mm: radius, semi-axes, legs of the corner, or the end of the line. */
export function curveOf(kind: CurveKind, a: number, b: number): Curve {
  switch (kind) {
    case "cubic":
      return cubic;
    case "circle":
      return ellipse(a, a);
    case "ellipse":
      return ellipse(a, b);
    case "corner":
      return polygon([
        [0, 0],
        [a, 0],
        [a, b],
      ]);
    case "line":
      return polygon([
        [0, 0],
        [a, b],
      ]);
  }
}

/** How the blocks are joined: as one curve, or as so many lines with a stop at each or blended within mm. */
export type Course =
  | { readonly kind: "curve" }
  | { readonly kind: "stops"; readonly lines: number }
  | { readonly kind: "blend"; readonly lines: number; readonly tolerance: number };

/** From where the curve begins; the feed in mm/s. */
export function programOf(curve: Curve, course: Course, feed: number): string {
  const blocks =
    course.kind === "curve" || curve.isPolygon
      ? curve.blocks
      : [...Array(course.lines).keys()].map((i) => `G1 ${place(curve.at((i + 1) / course.lines))}`);
  const mode = course.kind === "blend" ? `G64 ${word("P", course.tolerance)}` : "G61";
  return [`G21 G90 G17 ${mode} G94`, word("F", feed * 60), ...blocks, "M2", ""].join("\n");
}

/** mm */
export function lengthOf(curve: Curve): number {
  let length = 0;
  let [x, y] = curve.at(0);
  for (let i = 1; i <= 400; ++i) {
    const [nextX, nextY] = curve.at(i / 400);
    length += Math.hypot(nextX - x, nextY - y);
    [x, y] = [nextX, nextY];
  }
  return Math.max(length, 1e-9);
}

const looks = 24; // places that are compared before the nearest is narrowed down
const golden = (Math.sqrt(5) - 1) / 2;

/** Of the place of the curve that is nearest to a point, not before `from` by more than `behind`, nor far beyond. */
export function nearest(curve: Curve, [x, y]: Place, from: number, behind: number, ahead: number): number {
  const distance = (u: number): number => {
    const [cx, cy] = curve.at(u);
    return (cx - x) ** 2 + (cy - y) ** 2;
  };
  const [low, high] = [Math.max(0, from - behind), Math.min(1, from + ahead)];
  const step = (high - low) / looks;
  let best = low;
  let least = Infinity;
  for (let i = 0; i <= looks; ++i) {
    const now = distance(low + i * step);
    if (now < least) [least, best] = [now, low + i * step];
  }
  let [left, right] = [Math.max(low, best - step), Math.min(high, best + step)];
  let [one, other] = [right - golden * (right - left), left + golden * (right - left)];
  let [atOne, atOther] = [distance(one), distance(other)];
  while (right - left > 1e-12) {
    if (atOne < atOther) {
      [right, other, atOther] = [other, one, atOne];
      one = right - golden * (right - left);
      atOne = distance(one);
    } else {
      [left, one, atOne] = [one, other, atOther];
      other = left + golden * (right - left);
      atOther = distance(other);
    }
  }
  return (left + right) / 2;
}
