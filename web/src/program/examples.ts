// Programs to begin with, as examples/ has them: with the machine and the tools that they need.

import plate from "../../../examples/01-plate.ngc?raw";
import bore from "../../../examples/02-helical-bore.ngc?raw";
import arcs from "../../../examples/03-arcs-in-three-planes.ngc?raw";
import square from "../../../examples/04-square.ngc?raw";
import finishing from "../../../examples/05-finishing.ngc?raw";
import drilling from "../../../examples/06-drilling.ngc?raw";
import butterfly from "../../../examples/09-butterfly.ngc?raw";
import cubic from "../../../examples/10-cubic.ngc?raw";
import blade from "../../../examples/13-blade.ngc?raw";
import patch from "../../../examples/16-patch.ngc?raw";
import leaning from "../../../examples/17-patch-leaning.ngc?raw";
import saddle from "../../../examples/18-saddle.ngc?raw";
import tools from "../../../examples/tools.tbl?raw";
import trunnion from "../../../machines/table-table-ac.toml?raw";
import splines from "../../../examples/11-splines.ngc?raw";

export interface Example {
  readonly name: string;
  readonly title: string;
  readonly text: string;
  /** A machine file; none for the built-in mill. */
  readonly machine?: string;
  readonly tools?: string;
}

export const examples: readonly Example[] = [
  { name: "01-plate", title: "Plate: pockets and lines", text: plate },
  { name: "02-helical-bore", title: "Bore along a helix", text: bore },
  { name: "03-arcs-in-three-planes", title: "Arcs in three planes", text: arcs },
  { name: "04-square", title: "Square", text: square },
  { name: "05-finishing", title: "Finishing, short lines", text: finishing },
  { name: "06-drilling", title: "Drilling cycles", text: drilling },
  { name: "09-butterfly", title: "Butterfly, one NURBS", text: butterfly },
  { name: "10-cubic", title: "Cubic", text: cubic },
  { name: "11-splines", title: "Splines and NURBS", text: splines },
  { name: "13-blade", title: "Blade in five axes", text: blade, machine: trunnion.trim() },
  { name: "16-patch", title: "Patch, one surface", text: patch, tools: tools.trim() },
  {
    name: "17-patch-leaning",
    title: "Patch in five axes",
    text: leaning,
    machine: trunnion.trim(),
    tools: tools.trim(),
  },
  {
    name: "18-saddle",
    title: "Saddle in five axes",
    text: saddle,
    machine: trunnion.trim(),
    tools: tools.trim(),
  },
];

/** The example of this text, if it is one. */
export function exampleOf(text: string): Example | undefined {
  return examples.find((example) => example.text === text);
}
