// Methods of reference pulses beside one another: each lane is a recording of the engine.

import type { Catalogue, Engine, Method, Task } from "../engine/types";
import { download, vcdText } from "../lesson/files";
import { methodTitles } from "../lesson/form";
import { graphText } from "../lesson/graph";
import { Session } from "../lesson/session";
import { commandOf, fieldOf, quantity, taskOf, type FieldErrors } from "../lesson/settings";
import type { Mode } from "../ui/shell";
import { CurveForm } from "./curve_form";
import { pulseTable, rowOf, type Compared } from "./figure_table";
import { conventionsText } from "./figures";
import { LaneForms } from "./lane_forms";
import { LanePage } from "./lane_page";
import { PulseScene } from "./pictures";
import { comparisonOf, figureOf, fromLink, laneKeys, settingsOfLane, stateOf, toLink, type State } from "./state";

const mostClocks = 131_072;
const nearest = 4; // BLU across

export class Compare implements Mode {
  readonly element: HTMLElement;
  private state: State = fromLink(location.hash);
  private readonly curveForm: CurveForm;
  private readonly laneForms: LaneForms;
  private readonly page: LanePage;
  private readonly table = pulseTable();
  private compared: readonly Compared[] = [];
  private curveErrors: FieldErrors = new Map();
  private laneErrors: FieldErrors[] = [];

  constructor(
    private readonly engine: Engine,
    private readonly catalogue: Catalogue,
  ) {
    this.curveForm = new CurveForm({
      choose: (comparison) => this.reset(stateOf(comparison)),
      change: (change) => {
        Object.assign(this.state.curve, change);
        this.state.camera = undefined;
        void this.load(0);
      },
      feed: (feed) => {
        this.state.curve.feed = feed;
        this.show();
      },
    });
    this.laneForms = new LaneForms(catalogue, {
      change: (lanes) => {
        this.state.lanes = lanes;
        void this.load(this.page.player.clock);
      },
    });
    this.page = this.pageOfLanes();
    this.element = this.page.element;
    void this.load(this.state.curve.clock);
  }

  private pageOfLanes(): LanePage {
    const label = "Errors of all methods over the clock";
    return new LanePage(
      {
        kind: "pulses",
        name: "compare",
        forms: [this.curveForm.element, this.laneForms.element],
        strips: [{ id: "errors", title: "Error over the clock, BLU", label }],
        least: nearest,
        table: this.table,
        files: [["save-vcd", "VCD", () => this.saveDump()]],
        exampleInterval: "0.1",
      },
      {
        link: () => this.link(),
        restore: () => {
          this.state = fromLink(location.hash);
          void this.load(this.state.curve.clock);
        },
        interval: () => this.state.curve.interval,
        setInterval: (text) => (this.state.curve.interval = text),
        view: () => this.state,
        show: () => this.show(),
      },
    );
  }

  redraw(): void {
    this.page.redraw();
  }

  /** A scope for each lane, by its number, since two of them may have one method. */
  private saveDump(): void {
    const scopes = this.compared.map(({ drawn }) => ({
      name: `${drawn.task.method}-${drawn.number + 1}`,
      session: drawn.session,
    }));
    download("leadscrew-compare.vcd", vcdText(scopes, this.page.player.clock), "text/plain");
  }

  private reset(state: State): void {
    const { interval, feed } = this.state.curve;
    this.state = { ...state, curve: { ...state.curve, interval, feed }, layout: this.state.layout };
    void this.load(0);
  }

  private link(): string {
    return toLink({ ...this.state, curve: { ...this.state.curve, clock: this.page.player.clock } });
  }

  private methodOf(name: string): Method | undefined {
    return this.catalogue.methods.find((each) => each.name === name);
  }

  /** Of a lane; errors of the curve are the same in each. */
  private taskOfLane(number: number, errors: FieldErrors): Task | undefined {
    const lane = this.state.lanes[number];
    const method = this.methodOf(lane?.method ?? "");
    if (lane === undefined) return undefined;
    if (method === undefined) errors.set("method", `there is no method ${lane.method}`);
    const task = taskOf(settingsOfLane(this.state, lane), method, errors);
    errors.delete("interval");
    errors.delete("polling");
    errors.delete("feed");
    return errors.size > 0 ? undefined : task;
  }

  private async load(clock: number): Promise<void> {
    const load = this.page.begin();
    this.page.player.pause();
    const [curveErrors, laneErrors, compared]: [FieldErrors, FieldErrors[], Compared[]] = [new Map(), [], []];
    for (const number of this.state.lanes.keys()) {
      const errors: FieldErrors = new Map();
      const task = this.taskOfLane(number, errors);
      const drawn = task === undefined ? undefined : await this.record(number, task, errors);
      if (!this.page.isCurrent(load)) return;
      if (drawn !== undefined) compared.push(drawn);
      for (const [key, message] of errors)
        if (!(laneKeys as readonly string[]).includes(key)) curveErrors.set(key, message);
      laneErrors.push(errors);
    }
    [this.compared, this.curveErrors, this.laneErrors] = [compared, curveErrors, laneErrors];
    this.page.loaded(load, Math.max(0, ...compared.map(({ drawn }) => drawn.session.last)), clock);
  }

  private async record(number: number, task: Task, errors: FieldErrors): Promise<Compared | undefined> {
    const problems = await this.engine.problems(task);
    const recording = problems.length > 0 ? undefined : await this.engine.load(task, mostClocks);
    if (recording !== undefined && "code" in recording) problems.push(recording);
    for (const { field, message, hint } of problems)
      errors.set(fieldOf(field), hint === "" ? message : `${message}: ${hint}`);
    if (recording === undefined || "code" in recording) return undefined;
    const session = new Session(() => {});
    session.load(recording, 0);
    const lane = this.state.lanes[number];
    const figure = lane === undefined ? undefined : figureOf(this.state, lane);
    const detail = conventionsText(recording.conventions);
    return {
      drawn: { title: methodTitles[task.method] ?? task.method, detail, number, task, session },
      conventions: detail,
      source: figure?.source ?? "",
      published: figure?.published ?? "",
      clocksPerBlu: recording.conventions.clocksPerBlu,
      command: commandOf(task).replace("--table", "--json"),
    };
  }

  private show(): void {
    const { state, compared } = this;
    const feed = quantity(state.curve.feed);
    this.curveForm.update(state, comparisonOf(state), this.curveErrors, feed > 0);
    const methods = state.lanes.map(({ method }) => this.methodOf(method));
    this.laneForms.update(state, methods, this.laneErrors);
    this.page.show({
      scene: new PulseScene(compared.map(({ drawn }) => drawn)),
      count: compared.length,
      text: this.text(),
      commands: compared.map(({ command }) => command),
    });
    this.table.update(compared.map((each) => rowOf(each, this.page.player.clock, feed)));
  }

  /** What the picture shows, in words. */
  private text(): string {
    const one = this.compared[0]?.drawn;
    if (one === undefined) return "Nothing can be drawn yet";
    const [curve] = graphText(one.task, one.session).split(" and the steps");
    return `${curve} and the steps of ${this.compared.map(({ drawn }) => drawn.title).join(", ")} until clock ${this.page.player.clock}`;
  }
}
