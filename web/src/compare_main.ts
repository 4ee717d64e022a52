// The page that lays methods beside one another.

import { openEngine } from "leadscrew:engine";
import { Compare } from "./compare/compare";
import "./style/page.css";
import "./style/panel.css";
import "./style/lesson.css";
import "./style/display.css";
import "./style/compare.css";
import { show } from "./ui/shell";

void show(async () => {
  const engine = await openEngine();
  return new Compare(engine, await engine.catalogue());
});
