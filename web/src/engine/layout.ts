// Where fields of leadscrew.h are in WebAssembly: web/engine/layout.cpp holds the compiler to the same numbers.

export const error = { size: 1136, code: 32, message: 80, hint: 592, field: 1104 } as const;

export const task = {
  size: 96,
  kind: 4,
  turns: 8,
  bits: 12,
  start: 24,
  end: 40,
  center: 56,
  capacity: 72,
  method: 80,
  preload: 84,
  order: 88,
  tie: 92,
} as const;

export const conventions = {
  size: 136,
  bits: 4,
  capacity: 16,
  clocksPerBlu: 24,
  preload: 32,
  order: 56,
  tie: 80,
  end: 104,
} as const;

export const figures = {
  size: 96,
  clocks: 8,
  pulses: 16,
  position: 24,
  worst: 40,
  worstClock: 56,
  error: 64,
  maxError: 72,
  rmsError: 80,
  isDone: 88,
} as const;

/** What functions return, and lists of leadscrew_pulse_name(). */
export const code = { ok: 0, rejected: 1 } as const;
export const kind = { line: 0, arc: 1 } as const;
export const list = { methods: 0, preloads: 1, orders: 2, ties: 3, capacity: 4 } as const;
