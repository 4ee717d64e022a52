// A number of a form as text and as a slider.

import { quantity } from "../lesson/settings";
import { html } from "../ui/dom";
import type { Fields } from "./fields";

/** Least and greatest; more may stand behind. */
export type Range = readonly [number, number, ...unknown[]];

const sliderSteps = 400;

/** Sliders are even in the logarithm; those that begin at 0 in the square root. */
function valueAt([least, most]: Range, step: number): number {
  const share = step / sliderSteps;
  const value = least > 0 ? least * (most / least) ** share : most * share * share;
  return Number(value.toPrecision(3));
}
function stepAt([least, most]: Range, value: number): number {
  const share = least > 0 ? Math.log(value / least) / Math.log(most / least) : Math.sqrt(value / most);
  return Math.round(share * sliderSteps);
}

export class Slid {
  readonly element: HTMLElement;
  private readonly slider: HTMLInputElement;

  constructor(
    private readonly fields: Fields,
    private readonly id: string,
    label: string,
    private readonly range: Range,
    change: (text: string) => void,
    name = label,
  ) {
    this.slider = html("input", {
      id: `${id}-slider`,
      type: "range",
      min: 0,
      max: sliderSteps,
      step: 1,
      "aria-label": name,
      input: () => change(String(valueAt(range, Number(this.slider.value)))),
    });
    this.element = html("div", { class: "feed" }, fields.text(id, label, change, name), this.slider);
  }

  /** `otherwise`: what counts where nothing stands. */
  show(text: string, isShown: boolean, otherwise: string, error = ""): void {
    this.fields.show(this.id, text, isShown, error);
    this.element.hidden = !isShown;
    const value = quantity(text.trim() === "" ? otherwise : text);
    if (!(value >= this.range[0] && value <= this.range[1])) return;
    this.slider.value = String(stepAt(this.range, value));
    this.slider.setAttribute("aria-valuetext", String(value));
  }
}
