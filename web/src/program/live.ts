// The running machine, where the page is served by `leadscrew drive --serve`: its events, and wishes to it.

import type { LiveMachine, LiveSample, Wish } from "../engine/live_types";

export interface LiveCalls {
  began(machine: LiveMachine): void;
  moved(sample: LiveSample): void;
  missed(count: number): void;
  /** The connection is gone; it is looked for again. */
  lost(): void;
  ended(): void;
}

/** Where its events are; undefined where no machine is driven. */
export function liveAddress(): string | undefined {
  return document.querySelector<HTMLMetaElement>('meta[name="leadscrew-live"]')?.content;
}

export function watch(address: string, calls: LiveCalls): void {
  const source = new EventSource(address);
  const on = (name: string, call: (data: unknown) => void): void =>
    source.addEventListener(name, (event) => call(JSON.parse((event as MessageEvent<string>).data)));
  on("machine", (data) => calls.began(data as LiveMachine));
  on("sample", (data) => calls.moved(data as LiveSample));
  on("missed", (data) => calls.missed((data as { missed: number }).missed));
  on("end", () => {
    source.close();
    calls.ended();
  });
  source.addEventListener("error", () => calls.lost());
}

/** Of the program that is driven, its machine file or its tool table; empty where there is none. */
export async function liveText(address: string, of: "program" | "machine" | "tools"): Promise<string> {
  const answer = await fetch(`${address}/${of}`);
  if (!answer.ok) throw new Error(await answer.text());
  return await answer.text();
}

/** Empty where it is obeyed; else why not. */
export async function wish(address: string, token: string, wanted: Wish): Promise<string> {
  try {
    const answer = await fetch(`${address}/control`, {
      method: "POST",
      headers: { "X-Leadscrew-Token": token },
      body: JSON.stringify(wanted),
    });
    return answer.ok ? "" : await answer.text();
  } catch {
    return "the machine does not answer";
  }
}
