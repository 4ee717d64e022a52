// The program's page.

import { PlannerClient } from "./engine/planner_client";
import { recordingOfPage } from "./engine/recording";
import { Workbench } from "./program/workbench";
import "uplot/dist/uPlot.min.css";
import "./style/page.css";
import "./style/panel.css";
import "./style/program.css";
import { show } from "./ui/shell";

void show(async () => {
  const planner = await PlannerClient.open();
  return await Workbench.open(planner, recordingOfPage());
});
