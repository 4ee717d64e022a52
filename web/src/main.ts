// The lesson's page.

import { openEngine } from "leadscrew:engine";
import { Lesson } from "./lesson/lesson";
import "./style/page.css";
import "./style/panel.css";
import "./style/lesson.css";
import "./style/display.css";
import { show } from "./ui/shell";

void show(async () => {
  const engine = await openEngine();
  return new Lesson(engine, await engine.catalogue());
});
