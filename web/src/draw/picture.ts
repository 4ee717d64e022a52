// One way to draw for the screen and for files: lines, areas, text in pixels; on a canvas, or as the text of an SVG.

export interface Stroke {
  readonly colour: string;
  readonly width?: number;
  readonly dash?: readonly number[];
  readonly opacity?: number;
}

export interface TextStyle {
  readonly colour: string;
  readonly size?: number;
  readonly align?: "left" | "center" | "right";
  readonly weight?: number;
}

export interface Picture {
  readonly width: number;
  readonly height: number;
  /** x, y, x, y … */
  line(points: ArrayLike<number>, stroke: Stroke): void;
  circle(
    x: number,
    y: number,
    radius: number,
    style: Stroke | { readonly fill: string; readonly opacity?: number },
  ): void;
  rectangle(x: number, y: number, width: number, height: number, fill: string, opacity?: number): void;
  /** A polygon: x, y, x, y …; `edge` in its own colour closes the seam to the next one. */
  area(points: ArrayLike<number>, fill: string, opacity?: number, edge?: boolean): void;
  text(text: string, x: number, y: number, style: TextStyle): void;
}

const family = "system-ui, sans-serif";

export class CanvasPicture implements Picture {
  private readonly to: CanvasRenderingContext2D;

  constructor(
    canvas: HTMLCanvasElement,
    readonly width: number,
    readonly height: number,
    scale = devicePixelRatio || 1,
  ) {
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
    const to = canvas.getContext("2d");
    if (to === null) throw new Error("this browser draws on no canvas");
    this.to = to;
    to.scale(scale, scale);
    to.lineJoin = "round";
    to.lineCap = "round";
  }

  line(points: ArrayLike<number>, stroke: Stroke): void {
    const { to } = this;
    to.beginPath();
    for (let i = 0; i + 1 < points.length; i += 2) to.lineTo(points[i] ?? 0, points[i + 1] ?? 0);
    this.stroke(stroke);
  }

  circle(
    x: number,
    y: number,
    radius: number,
    style: Stroke | { readonly fill: string; readonly opacity?: number },
  ): void {
    const { to } = this;
    to.beginPath();
    to.arc(x, y, radius, 0, 2 * Math.PI);
    if (!("fill" in style)) return this.stroke(style);
    to.globalAlpha = style.opacity ?? 1;
    to.fillStyle = style.fill;
    to.fill();
    to.globalAlpha = 1;
  }

  rectangle(x: number, y: number, width: number, height: number, fill: string, opacity = 1): void {
    this.to.globalAlpha = opacity;
    this.to.fillStyle = fill;
    this.to.fillRect(x, y, width, height);
    this.to.globalAlpha = 1;
  }

  area(points: ArrayLike<number>, fill: string, opacity = 1, edge = false): void {
    const { to } = this;
    to.beginPath();
    for (let i = 0; i + 1 < points.length; i += 2) to.lineTo(points[i] ?? 0, points[i + 1] ?? 0);
    to.closePath();
    to.globalAlpha = opacity;
    to.fillStyle = to.strokeStyle = fill;
    to.lineWidth = 0.7;
    to.fill();
    if (edge) to.stroke();
    to.globalAlpha = 1;
  }

  text(text: string, x: number, y: number, style: TextStyle): void {
    const { to } = this;
    to.font = `${style.weight ?? 400} ${style.size ?? 12}px ${family}`;
    to.textAlign = style.align ?? "left";
    to.fillStyle = style.colour;
    to.fillText(text, x, y);
  }

  private stroke(stroke: Stroke): void {
    const { to } = this;
    to.globalAlpha = stroke.opacity ?? 1;
    to.strokeStyle = stroke.colour;
    to.lineWidth = stroke.width ?? 1;
    to.setLineDash([...(stroke.dash ?? [])]);
    to.stroke();
    to.setLineDash([]);
    to.globalAlpha = 1;
  }
}

function escaped(text: string): string {
  return text.replace(/[&<>"]/g, (character) => `&#${character.charCodeAt(0)};`);
}

function short(value: number): string {
  return String(Math.round(value * 100) / 100);
}

export class SvgPicture implements Picture {
  private readonly parts: string[] = [];

  constructor(
    readonly width: number,
    readonly height: number,
    private readonly title: string,
  ) {}

  line(points: ArrayLike<number>, stroke: Stroke): void {
    const at: string[] = [];
    for (let i = 0; i + 1 < points.length; i += 2) at.push(`${short(points[i] ?? 0)},${short(points[i + 1] ?? 0)}`);
    this.parts.push(`<polyline points="${at.join(" ")}" fill="none" ${this.stroke(stroke)}/>`);
  }

  circle(
    x: number,
    y: number,
    radius: number,
    style: Stroke | { readonly fill: string; readonly opacity?: number },
  ): void {
    const look =
      "fill" in style ? `fill="${style.fill}" opacity="${style.opacity ?? 1}"` : `fill="none" ${this.stroke(style)}`;
    this.parts.push(`<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}" ${look}/>`);
  }

  rectangle(x: number, y: number, width: number, height: number, fill: string, opacity = 1): void {
    const size = `x="${short(x)}" y="${short(y)}" width="${short(width)}" height="${short(height)}"`;
    this.parts.push(`<rect ${size} fill="${fill}" opacity="${opacity}"/>`);
  }

  area(points: ArrayLike<number>, fill: string, opacity = 1, edge = false): void {
    const at: string[] = [];
    for (let i = 0; i + 1 < points.length; i += 2) at.push(`${short(points[i] ?? 0)},${short(points[i + 1] ?? 0)}`);
    const seam = edge ? ` stroke="${fill}" stroke-width="0.7"` : "";
    this.parts.push(`<polygon points="${at.join(" ")}" fill="${fill}" opacity="${opacity}"${seam}/>`);
  }

  text(text: string, x: number, y: number, style: TextStyle): void {
    const anchor = style.align === "center" ? "middle" : style.align === "right" ? "end" : "start";
    const font = `font-family="${family}" font-size="${style.size ?? 12}" font-weight="${style.weight ?? 400}"`;
    const at = `x="${short(x)}" y="${short(y)}" text-anchor="${anchor}"`;
    this.parts.push(`<text ${at} ${font} fill="${style.colour}">${escaped(text)}</text>`);
  }

  toString(): string {
    const size = `width="${this.width}" height="${this.height}" viewBox="0 0 ${this.width} ${this.height}"`;
    const name = `<title>${escaped(this.title)}</title>`;
    return `<svg xmlns="http://www.w3.org/2000/svg" ${size} role="img">${name}${this.parts.join("\n")}</svg>\n`;
  }

  private stroke(stroke: Stroke): string {
    const dash = stroke.dash === undefined ? "" : ` stroke-dasharray="${stroke.dash.join(" ")}"`;
    return (
      `stroke="${stroke.colour}" stroke-width="${stroke.width ?? 1}" stroke-opacity="${stroke.opacity ?? 1}" ` +
      `stroke-linejoin="round" stroke-linecap="round"${dash}`
    );
  }
}
