// The page's address, which keeps what is set: the browser takes a few changes of it a second.

const betweenChanges = 400; // ms

export class Address {
  private timer = 0;

  constructor(private readonly link: () => Promise<string>) {}

  /** Soon, with what is set by then. */
  keep(): void {
    if (this.timer !== 0) return;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      void this.link().then((link) => history.replaceState(null, "", link));
    }, betweenChanges);
  }
}
