// Where fields of leadscrew.h are in WebAssembly: web/engine/layout.cpp holds the compiler to the same numbers.

export const error = {
  size: 1136,
  severity: 4,
  line: 16,
  column: 24,
  code: 32,
  message: 80,
  hint: 592,
  file: 848,
  field: 1104,
} as const;

export const options = {
  size: 168,
  onDiagnostic: 92,
  start: 8,
  file: 100,
  tools: 104,
  toolsLength: 108,
  onProgress: 116,
  stepRule: 148,
  pathMode: 152,
  hasTolerance: 156,
  tolerance: 160,
} as const;

export const limits = {
  size: 400,
  least: 8,
  greatest: 80,
  velocity: 152,
  acceleration: 224,
  jerk: 296,
  tolerance: 368,
  chordError: 376,
  axes: 384,
  period: 392,
} as const;

export const word = { size: 120, tick: 0, position: 8, speed: 88, feed: 96, state: 112 } as const;
export const loopOptions = { size: 96, controller: 4, encoder: 8, gains: 16 } as const;
export const followed = { size: 304, tick: 8, position: 16, velocity: 88, control: 160, current: 232 } as const;
export const loopFigures = {
  size: 264,
  periods: 8,
  greatest: 16,
  rms: 88,
  overshoot: 160,
  feedGreatest: 232,
  feedMean: 240,
  contour: 248,
  contourRms: 256,
} as const;

export const modes = {
  size: 256,
  block: 24,
  motion: 32,
  plane: 40,
  units: 48,
  distance: 56,
  arcDistance: 64,
  feedMode: 72,
  pathMode: 80,
  retract: 88,
  compensation: 96,
  toolLength: 104,
  spindle: 112,
  coolant: 120,
  system: 128,
  tolerance: 144,
  naiveCam: 152,
  feed: 160,
  spindleSpeed: 168,
  offset: 176,
  tool: 248,
  selectedTool: 252,
} as const;
export const judged = { size: 40, distance: 8, tolerance: 16, line: 24 } as const;
export const verdict = { size: 48, deviation: 8, tolerance: 16, startError: 24, endError: 32, objections: 40 } as const;

export const checked = { size: 176, blocks: 8, moves: 16, bound: 24, least: 32, greatest: 104 } as const;

export const motionFigures = {
  size: 296,
  time: 8,
  bound: 16,
  dwell: 24,
  length: 32,
  feedProgrammed: 40,
  tolerance: 48,
  velocity: 56,
  acceleration: 128,
  jerk: 200,
  words: 272,
  blocks: 280,
  moves: 288,
} as const;

export const block = {
  size: 176,
  line: 8,
  file: 16,
  visit: 20,
  begin: 24,
  seconds: 32,
  leastSeconds: 40,
  length: 48,
  feedAsked: 56,
  feedReached: 64,
  middle: 72,
  cause: 144,
  part: 168,
  pass: 172,
} as const;

export const pose = { size: 96, tip: 8, direction: 32, poleAngle: 56, offset: 64, tool: 88 } as const;
export const tool = {
  size: 56,
  number: 4,
  diameter: 16,
  cornerRadius: 24,
  length: 32,
  holderDiameter: 40,
  holderLength: 48,
} as const;
export const surface = { size: 24, number: 4, cells: 12, corners: 16, normals: 20 } as const;
export const contour = { size: 32, line: 8, count: 24, places: 28 } as const;
export const gouge = {
  size: 144,
  line: 8,
  part: 20,
  pass: 24,
  toolPart: 28,
  surface: 32,
  depth: 40,
  clearance: 48,
  u: 56,
  v: 64,
  place: 72,
  tip: 96,
  direction: 120,
} as const;

export const state = {
  size: 344,
  position: 8,
  velocity: 80,
  acceleration: 152,
  jerk: 224,
  pathLength: 296,
  speed: 304,
  feed: 312,
  line: 320,
  state: 328,
} as const;
export const hold = { size: 12, kind: 4, axis: 8 } as const;
export const axes = 9;

export const task = {
  size: 128,
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
  semiAxes: 96,
  isFree: 112,
  places: 116,
  accumulation: 120,
} as const;

export const conventions = {
  size: 176,
  bits: 4,
  capacity: 16,
  clocksPerBlu: 24,
  preload: 32,
  order: 56,
  tie: 80,
  end: 104,
  scale: 136,
  places: 144,
  accumulation: 152,
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
export const list = {
  methods: 0,
  preloads: 1,
  orders: 2,
  ties: 3,
  capacity: 4,
  ellipses: 5,
  free: 6,
  accumulations: 7,
  places: 8,
} as const;
