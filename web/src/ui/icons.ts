// Signs of buttons, drawn: no font is sure to have them.

import { svg } from "./dom";

/** Outlines in a square of 16. */
const outlines = {
  begin: "M3 3h2v10H3zM13 3v10L6 8z",
  back: "M12 2.5v11L3 8z",
  play: "M4 2.5v11L13 8z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  end: "M11 3h2v10h-2zM3 3v10l7-5z",
} as const;
export type IconName = keyof typeof outlines;

export function icon(name: IconName): SVGSVGElement {
  return svg("svg", { class: "icon", viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { d: outlines[name] }));
}

/** Another sign in the same place. */
export function redrawIcon(button: Element, name: IconName): void {
  const path = button.querySelector(".icon path");
  if (path?.getAttribute("d") !== outlines[name]) path?.setAttribute("d", outlines[name]);
}
