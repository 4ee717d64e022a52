// The workbench: one page, a mode at a time.

import { openEngine } from "leadscrew:engine";
import { Lesson } from "./lesson/lesson";
import "./style/page.css";
import "./style/lesson.css";
import "./style/display.css";
import { html } from "./ui/dom";
import { themeSwitch } from "./ui/theme";

async function begin(): Promise<void> {
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
    const engine = await openEngine();
    const lesson = new Lesson(engine, await engine.catalogue());
    redraw = () => lesson.redraw();
    main.replaceChildren(lesson.element);
  } catch (failure) {
    main.replaceChildren(
      html("p", { class: "failure", role: "alert" }, `The engine did not start: ${String(failure)}`),
    );
  }
}

void begin();
