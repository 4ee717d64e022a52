// Much to be done, and a page that stays free meanwhile.

/** One after the other, the page free between two; false where they are not wanted any more. */
export async function inTurn(steps: readonly (() => void)[], isWanted: () => boolean): Promise<boolean> {
  for (const step of steps) {
    step();
    await new Promise((resume) => setTimeout(resume));
    if (!isWanted()) return false;
  }
  return true;
}
