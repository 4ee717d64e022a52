// A module of web/engine in WebAssembly: memory, text, errors.

import * as layout from "./layout";
import type { Problem } from "./types";

export interface CommonExports {
  readonly memory: WebAssembly.Memory;
  _initialize(): void;
  malloc(size: number): number;
  free(at: number): void;
}

/** What the module calls of the page, by names. */
export type PageCalls = Readonly<Record<string, (...values: number[]) => number | void>>;

const noSuchFile = 8; // EBADF of WASI

/** The C library asks at once which folders there are: none. For the rest of the system it asks only where a program opens
 * files, ends or prints, which the engine never does. */
function importsOf(module: WebAssembly.Module, page: PageCalls): WebAssembly.Imports {
  const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[name] =
      (from === "page" ? page[name] : name === "fd_prestat_get" ? () => noSuchFile : undefined) ??
      (() => {
        throw new Error(`the engine called ${name}`);
      });
  }
  return imports;
}

export class WasmModule<Exports extends CommonExports> {
  private lastView: DataView;

  protected constructor(readonly calls: Exports) {
    this.lastView = new DataView(calls.memory.buffer);
  }

  protected static async started<Exports extends CommonExports>(
    module: WebAssembly.Module,
    page: PageCalls = {},
  ): Promise<Exports> {
    const instance = await WebAssembly.instantiate(module, importsOf(module, page));
    const calls = instance.exports as unknown as Exports;
    calls._initialize();
    return calls;
  }

  /** Of the memory as it is: where that grows, views of it end. */
  get view(): DataView {
    const { buffer } = this.calls.memory;
    if (this.lastView.buffer !== buffer) this.lastView = new DataView(buffer);
    return this.lastView;
  }

  /** Zeroed; freed when `use` returns. */
  with<T>(size: number, use: (at: number) => T): T {
    const at = this.calls.malloc(size);
    new Uint8Array(this.calls.memory.buffer, at, size).fill(0);
    try {
      return use(at);
    } finally {
      this.calls.free(at);
    }
  }

  withText<T>(text: string, use: (at: number) => T): T {
    const bytes = new TextEncoder().encode(text);
    return this.with(bytes.length + 1, (at) => {
      new Uint8Array(this.calls.memory.buffer, at, bytes.length).set(bytes);
      return use(at);
    });
  }

  /** Up to its 0. */
  text(at: number): string {
    const bytes = new Uint8Array(this.calls.memory.buffer, at);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  integer(at: number): number {
    return Number(this.view.getBigInt64(at, true));
  }

  withError<T>(use: (at: number) => T): T {
    return this.with(layout.error.size, (at) => {
      this.view.setUint32(at, layout.error.size, true);
      return use(at);
    });
  }

  problem(at: number): Problem {
    return {
      code: this.text(at + layout.error.code),
      message: this.text(at + layout.error.message),
      hint: this.text(at + layout.error.hint),
      field: this.text(at + layout.error.field),
    };
  }
}
