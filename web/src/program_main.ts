// The program's page: the engine is opened first, and compiled while the page's own script comes.

import { PlannerClient } from "./engine/planner_client";
import "uplot/dist/uPlot.min.css";
import "./style/page.css";
import "./style/panel.css";
import "./style/program.css";
import { show } from "./ui/shell";

void show(async () => {
  const opening = PlannerClient.open();
  const [{ Workbench }, { recordingOfPage }] = await Promise.all([
    import("./program/workbench"),
    import("./engine/recording"),
  ]);
  return await Workbench.open(await opening, recordingOfPage());
});
