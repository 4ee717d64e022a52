// What every mode of the workbench has around it: colours, and what is said when the engine does not start.

import { html } from "./dom";
import { themeSwitch } from "./theme";

export interface Mode {
  readonly element: HTMLElement;
  /** After the colours have changed. */
  redraw(): void;
}

/** Puts into the page what `open` makes. */
export async function show(open: () => Promise<Mode>): Promise<void> {
  const main = document.querySelector("main");
  const tools = document.querySelector(".page-tools");
  if (main === null || tools === null) return;
  let redraw = (): void => {};
  tools.append(
    html(
      "label",
      { class: "theme" },
      html("span", {}, "Colours"),
      themeSwitch(() => redraw()),
    ),
  );
  try {
    const mode = await open();
    redraw = () => mode.redraw();
    main.replaceChildren(mode.element);
  } catch (failure) {
    main.replaceChildren(
      html("p", { class: "failure", role: "alert" }, `The engine did not start: ${String(failure)}`),
    );
  }
}
