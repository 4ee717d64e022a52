// The program's page: the engine is opened first, and plans while the page's own script comes.

import { PlannerClient } from "./engine/planner_client";
import { recordingOfPage } from "./engine/recording";
import { Planning } from "./program/planning";
import "uplot/dist/uPlot.min.css";
import "./style/page.css";
import "./style/panel.css";
import "./style/program.css";
import { show } from "./ui/shell";

void show(async () => {
  const script = import("./program/workbench");
  const planner = await PlannerClient.open();
  const planning = await Planning.open(planner, recordingOfPage());
  void planning.run();
  const { Workbench } = await script;
  return new Workbench(planner, planning);
});
