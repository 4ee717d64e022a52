// The clock that several lanes have in common: steps, runs on time, keys.

const mostClocksAFrame = 256;

export interface PlayerEvents {
  /** The clock, or whether it runs. */
  changed(): void;
  /** s between two clocks; 0: as fast as can be. */
  pace(): number;
}

export class Player {
  clock = 0;
  last = 0;
  isRunning = false;

  constructor(private readonly events: PlayerEvents) {}

  /** Other lanes; nothing is told. */
  load(last: number, clock: number): void {
    this.last = last;
    this.clock = Math.min(clock, last);
  }

  pause(): void {
    this.isRunning = false;
  }

  seek(clock: number): void {
    this.clock = Math.max(0, Math.min(clock, this.last));
    this.events.changed();
  }

  step(by: number): void {
    this.pause();
    this.seek(this.clock + by);
  }

  toggle(): void {
    if (this.isRunning) {
      this.pause();
      this.events.changed();
      return;
    }
    if (this.last === 0 || !(this.events.pace() >= 0)) return;
    if (this.clock === this.last) this.clock = 0;
    this.isRunning = true;
    this.run();
    this.events.changed();
  }

  private run(): void {
    let before = performance.now();
    let owed = 0;
    const go = (now: number): void => {
      if (!this.isRunning) return;
      const pace = this.events.pace();
      owed = pace > 0 ? Math.min(owed + (now - before) / 1000 / pace, mostClocksAFrame) : mostClocksAFrame;
      before = now;
      const clocks = Math.floor(owed);
      owed -= clocks;
      if (this.clock + clocks >= this.last) this.isRunning = false;
      if (clocks > 0) this.seek(this.clock + clocks);
      if (this.isRunning) requestAnimationFrame(go);
    };
    requestAnimationFrame(go);
  }

  /** Where no control, of which these are some, has these keys. */
  key(event: KeyboardEvent, controls: string): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches(controls)) return;
    const actions: Readonly<Record<string, () => void>> = {
      ArrowRight: () => this.step(1),
      ArrowLeft: () => this.step(-1),
      Home: () => this.seek(0),
      End: () => this.seek(this.last),
      ...(target.matches("button, a, summary") ? {} : { " ": () => this.toggle() }),
    };
    const action = actions[event.key];
    if (action === undefined) return;
    event.preventDefault();
    action();
  }
}
