// The page that lays methods of reference words, loops behind them, and reference pulses beside one another.

import { openEngine } from "leadscrew:engine";
import { PlannerClient } from "./engine/planner_client";
import "./style/page.css";
import "./style/panel.css";
import "./style/lesson.css";
import "./style/display.css";
import "./style/compare.css";
import { show } from "./ui/shell";
import { WordCompare } from "./words/words";

void show(async () => await WordCompare.open(await PlannerClient.open(), await openEngine()));
