// The program's page: panels around one plan, and the clock that walks along it.

import type { PlannerClient } from "../engine/planner_client";
import type { LiveMachine, LiveSample } from "../engine/live_types";
import type { Diagnostic, FeedChange, Gouge, Limits, Phase, Plan } from "../engine/motion_types";
import { sampleAt, takeJudged, timeOf, timeOfLine, ToolsOfLines } from "../engine/path";
import { download } from "../lesson/files";
import { html } from "../ui/dom";
import { inTurn } from "../ui/in_turn";
import type { Mode } from "../ui/shell";
import { Address } from "./address";
import { Editor } from "./editor";
import type { Example } from "./examples";
import { FiguresPanel, LossTable } from "./figures";
import { FilesPanel } from "./files_panel";
import { GougePanel } from "./gouge_panel";
import { JudgedPanel } from "./judged";
import { LivePanel, type LiveTexts } from "./live_panel";
import { LoopPanel } from "./loop_panel";
import { FeedPanel } from "./feed_panel";
import { MachineForm } from "./machine_form";
import { ModesPanel } from "./modes_panel";
import { Playback } from "./playback";
import { Plots } from "./plots";
import { PathPanel } from "./path_panel";
import { ProgramPanel } from "./program_panel";
import type { End, Planning, PlanningEvents } from "./planning";
import { Progress } from "./progress";
import { machineFile, programOf, type Settings } from "./settings";

export class Workbench implements Mode {
  readonly element: HTMLElement;
  private plan: Plan | undefined;
  private sample = 0;
  private line = 0;
  private shown = 0; // number of the run whose plan that is
  private readonly tools = new ToolsOfLines();
  private isNewText = true;
  private readonly editor: Editor;
  private readonly program: ProgramPanel;
  private readonly machineForm: MachineForm;
  private readonly path: PathPanel;
  private readonly plots = new Plots(
    (time) => this.playback.seek(time),
    (stretch) => {
      this.settings.stretch = stretch;
      this.address.keep();
    },
  );
  private readonly playback: Playback = new Playback((time) => this.stand(time));
  private readonly figures = new FiguresPanel();
  private readonly address = new Address(() => this.planning.link());
  private readonly modes = new ModesPanel();
  private readonly feed = new FeedPanel({
    changed: (changes) => void this.changeFeed(changes),
    now: () => this.playback.now,
  });
  private readonly losses = new LossTable((line, time) => this.goTo(line, time));
  private readonly gouges = new GougePanel({
    look: () => this.lookForGouges(),
    found: (gouges) => this.path.view.markGouges(gouges),
    chosen: (sample) => this.pick(sample),
  });
  private readonly loops = new LoopPanel({
    follow: async (options) => {
      const slides = await this.planning.slides(options);
      this.progress.rest("");
      return slides;
    },
    changed: () => {
      this.settings.loops = this.loops.asked;
      this.address.keep();
    },
  });
  private readonly progress = new Progress(() => this.planning.cancel());
  /** Where a machine is driven. */
  private readonly live = LivePanel.ofPage({
    began: (machine, texts) => void this.showDriven(machine, texts),
    moved: (machine, sample) => this.follow(machine, sample),
  });
  private readonly judged: JudgedPanel | undefined;
  private readonly files = new FilesPanel({
    trace: async () => (this.plan === undefined ? undefined : await this.planning.trace()),
    steps: async () => (this.plan === undefined ? undefined : await this.planning.steps()),
    svg: () => this.path.view.svgText(),
    png: () => this.path.view.pngBlob(),
    times: this.plots,
  });

  /** Its planning is under way. */
  constructor(
    planner: PlannerClient,
    private readonly planning: Planning,
  ) {
    const { recording } = planning;
    if (recording !== undefined) {
      this.judged = new JudgedPanel(recording, (line, time) => this.goTo(line, time));
      document.title = `${recording.name}: motion report`;
    }
    this.editor = new Editor(this.settings.text, {
      changed: (text) => planning.typed(text),
      pointed: (line) => this.pointed(line),
      explain: (code) => planning.explain(code),
    });
    this.program = new ProgramPanel(this.editor, {
      open: (name, text) => this.openText(name, text),
      example: (example) => void this.openExample(example),
      save: () => download(this.settings.name, this.settings.text, "text/plain"),
    });
    this.machineForm = new MachineForm({
      changed: (limits, override) => this.change({ limits, override }),
      opened: (file) => void this.openMachine(file),
      equipped: (tools) => this.change({ tools: tools.trim() }),
      saved: () => download("machine.toml", machineFile(this.settings), "application/toml"),
    });
    this.path = new PathPanel({
      picked: (sample) => this.pick(sample),
      coloured: (colouring) => {
        this.settings.colouring = colouring;
        this.address.keep();
      },
      unjudged: () => void this.judge(),
      contoured: (isShown) => {
        this.settings.hasContour = isShown;
        this.address.keep();
      },
      moved: () => {
        if (this.plan === undefined) return;
        this.settings.seen = this.path.view.seen;
        this.address.keep();
      },
    });
    this.element = html(
      "div",
      { class: "program" },
      html("div", { class: "side" }, this.program.element, this.machineForm.element),
      html(
        "div",
        { class: "main" },
        this.live?.element,
        this.progress.element,
        this.path.element(this.figures.now, this.playback.element, this.feed.element, this.modes.element),
        this.plots.panel(),
        html("section", { class: "panel", "aria-label": "Figures" }, html("h2", {}, "Figures"), this.figures.figures),
        this.judged?.element,
        this.losses.element,
        this.loops.element,
        this.gouges.element,
        this.files.element,
      ),
    );
    planner.onProgress = (phase: Phase, share: number) => this.progress.show(phase, share);
    addEventListener("hashchange", () => void this.restore());
    document.addEventListener("keydown", (event) => this.playback.key(event));
    this.showSettings();
    planning.tell(this.planningEvents());
  }

  private planningEvents(): PlanningEvents {
    return {
      begun: (isRecorded) => {
        this.tell("planning");
        this.showCommand();
        this.address.keep();
        if (this.judged !== undefined) this.judged.isShown = isRecorded;
      },
      diagnosed: (diagnostics) => this.showDiagnostics(diagnostics),
      planned: (plan, hasAll, isCurrent) => this.load(plan, hasAll, isCurrent),
      gouged: (gouges) => this.gouges.show(gouges),
      ended: (why, said) => this.end(why, said),
      equipped: () => this.showSettings(),
      refused: (message) => this.machineForm.refuse(message),
    };
  }

  private get settings(): Settings {
    return this.planning.settings;
  }

  private get machine(): Limits {
    return this.planning.machine;
  }

  redraw(): void {
    this.path.view.repaint();
    this.path.showLegend(this.plan);
    this.plots.redraw();
    this.loops.redraw();
    this.mark();
  }

  private async openExample({ name, text, machine, tools }: Example): Promise<void> {
    const file = machine ?? "";
    if (file !== this.settings.machine && !(await this.planning.takeMachine(file))) return;
    this.settings.tools = tools ?? "";
    this.showSettings();
    this.openText(`${name}.ngc`, text);
  }

  /** A machine file, or the built-in mill, as it is. */
  private async openMachine(file: string): Promise<void> {
    if (await this.planning.takeMachine(file)) this.settings.override = 100;
    await this.planning.run();
  }

  private openText(name: string, text: string): void {
    this.settings.name = name;
    this.settings.text = text;
    const turned = this.settings.seen.split("_").slice(0, 2).join("_");
    Object.assign(this.settings, { time: 0, seen: turned, stretch: undefined, changes: [] });
    this.isNewText = true;
    this.editor.set(text);
    void this.planning.run();
  }

  /** The program that is driven is planned here too, on its machine and with its tools. */
  private async showDriven(machine: LiveMachine, texts: LiveTexts): Promise<void> {
    if (texts.program === "" || !(await this.planning.takeMachine(texts.machine))) return;
    this.settings.tools = texts.tools;
    this.showSettings();
    this.openText(machine.program.split("/").at(-1) ?? machine.program, texts.program);
  }

  /** The tool is that of the line, by the plan; where no axis turns, its offset too. */
  private follow(machine: LiveMachine, sample: LiveSample): void {
    this.playback.stop();
    const { plan } = this;
    const tool = plan === undefined ? undefined : this.tools.at(plan, sample.line);
    if (plan !== undefined && tool !== undefined) this.modes.stand(plan, tool.block);
    this.figures.follow(machine, sample);
    const at = (letter: string): number => sample.actual[machine.axes.findIndex(({ name }) => name === letter)] ?? 0;
    const tip = ["X", "Y", "Z"].map((letter, i) => at(letter) - (tool?.offset[i] ?? 0));
    this.path.view.standAt(sample.tip ?? tip, sample.direction ?? [0, 0, 1], tool?.number ?? 0);
    this.markLine(sample.line);
  }

  private change(change: Partial<Settings>): void {
    Object.assign(this.settings, change);
    void this.planning.run();
  }

  /** Motion goes on from the last of them, where it was going on. */
  private async changeFeed(changes: readonly FeedChange[]): Promise<void> {
    const { plays } = this.playback.now;
    this.playback.stop();
    Object.assign(this.settings, { changes, time: changes.at(-1)?.time ?? this.settings.time, stretch: undefined });
    await this.planning.run();
    const isShown = this.element.dataset["state"] === "ready" && this.settings.changes === changes;
    if (plays && isShown && !this.playback.isPlaying) this.playback.toggle(1);
  }

  private async restore(): Promise<void> {
    if (!(await this.planning.restore())) return;
    this.isNewText = true;
    this.editor.set(this.settings.text);
    this.showSettings();
    await this.planning.run();
  }

  private async lookForGouges(): Promise<readonly Gouge[] | Diagnostic | undefined> {
    try {
      return await this.planning.gouges();
    } finally {
      this.progress.rest("");
    }
  }

  /** Of the plan that is shown, unless it is another by then. */
  private async judge(): Promise<void> {
    const { plan } = this;
    const { state, samples } = this.element.dataset;
    if (plan?.deviations !== undefined || state !== "ready" || samples !== "all") return;
    const judged = await this.planning.judged();
    if (judged === undefined || plan === undefined || plan !== this.plan) return;
    this.progress.rest("code" in judged ? `The referee: ${judged.message}` : "");
    if ("code" in judged) return;
    await takeJudged(plan, judged);
    if (plan !== this.plan) return;
    this.path.judge(plan);
    this.figures.stand(plan, this.sample);
    this.element.dataset["judged"] = String(this.planning.number);
  }

  /** There is no plan; what is shown of the last one stays where it is of the same text, as it was before a change. */
  private end(why: End, said: string): void {
    this.plan = undefined;
    this.playback.stop();
    if (this.isNewText) this.element.dataset["shows"] = "nothing";
    this.tell(why);
    this.progress.rest(said);
  }

  /** A panel at a time: between two the page is free. What lies below all that is seen at first comes last. */
  private async load(plan: Plan, hasAll: boolean, isCurrent: () => boolean): Promise<void> {
    delete this.element.dataset["shows"];
    const panels = [
      () => this.path.load(plan, this.settings.colouring, this.isNewText ? this.settings.seen : undefined),
      () => this.figures.load(plan),
      () => this.losses.load(plan),
      () => this.gouges.load(plan),
      () => this.loops.load(plan),
      () => this.plots.load(plan, this.settings.stretch),
    ];
    if (!(await inTurn(panels, isCurrent))) return;
    this.plan = plan;
    if (this.shown === this.planning.number) this.stand(this.playback.time);
    else this.begin(plan);
    this.element.dataset["samples"] = hasAll ? "all" : "some";
    this.tell("ready");
    if (!hasAll) return;
    this.loops.planned();
    const isDrawn = await inTurn(this.plots.rows(), isCurrent);
    if (isDrawn && this.settings.colouring === "deviation") await this.judge();
  }

  private begin({ figures, period }: Plan): void {
    this.shown = this.planning.number;
    this.progress.rest("");
    [this.line, this.isNewText] = [0, false];
    this.playback.load(figures.time, period, this.settings.time);
    this.feed.show(this.settings);
  }

  private tell(state: string): void {
    this.element.dataset["state"] = state;
    this.element.dataset["run"] = String(this.planning.number);
  }

  private showSettings(): void {
    this.machineForm.show(this.machine, this.settings);
    this.path.show(this.settings);
    this.feed.show(this.settings);
    this.loops.restore(this.settings.loops);
    this.program.show(this.settings);
    this.showCommand();
  }

  private showCommand(): void {
    this.program.show(this.settings);
    this.files.show(this.settings, this.machine, this.planning.isRecorded);
    this.loops.name((hasFile) => programOf(this.settings, this.machine, false, hasFile));
  }

  private showDiagnostics(diagnostics: readonly Diagnostic[]): void {
    const ofMachine = diagnostics.find(({ field, line }) => field !== "" && line === 0);
    this.machineForm.complain(ofMachine?.field ?? "", ofMachine === undefined ? "" : ofMachine.message);
    const ofText = diagnostics.filter((each) => each !== ofMachine);
    this.editor.mark(ofText);
    this.program.list(ofText);
  }

  /** The clock has moved. */
  private stand(time: number): void {
    this.settings.time = time;
    const { plan } = this;
    if (plan === undefined) return;
    this.sample = sampleAt(plan, time);
    this.path.view.stand(this.sample);
    this.plots.stand(time);
    this.loops.stand(time);
    this.figures.stand(plan, this.sample);
    this.modes.stand(plan, plan.samples.block[this.sample] ?? 0);
    this.feed.stand(time);
    this.mark();
    this.address.keep();
  }

  /** The line that is in motion: in the text, and along the path. */
  private mark(): void {
    if (this.plan === undefined) return;
    this.markLine(this.plan.blocks.line[this.plan.samples.block[this.sample] ?? 0] ?? 0);
  }

  private markLine(line: number): void {
    this.editor.move(line, !this.editor.hasFocus);
    this.element.dataset["line"] = String(line);
    if (line === this.line) return;
    this.line = line;
    const { plan } = this;
    if (plan !== undefined && (!this.playback.isPlaying || plan.samples.count < 200_000)) this.path.view.mark(line);
  }

  private pointed(line: number): void {
    const time = this.plan === undefined ? undefined : timeOfLine(this.plan, line);
    if (time === undefined || this.plan === undefined) return;
    this.playback.stop();
    this.playback.seek(time + 1.5 * this.plan.samples.step);
  }

  private pick(sample: number): void {
    if (this.plan === undefined) return;
    this.playback.stop();
    this.playback.seek(timeOf(this.plan, sample));
    this.editor.goTo(this.line);
  }

  private goTo(line: number, time: number): void {
    this.playback.stop();
    this.playback.seek(time + 1.5 * (this.plan?.samples.step ?? 0));
    this.editor.goTo(line);
  }
}
