// What goes over to another thread with a message, and is not copied.

/** Of all arrays in it. */
export function buffersOf(result: unknown): ArrayBuffer[] {
  if (ArrayBuffer.isView(result)) return [result.buffer as ArrayBuffer];
  if (typeof result !== "object" || result === null || result instanceof Blob) return [];
  return Object.values(result).flatMap(buffersOf);
}
