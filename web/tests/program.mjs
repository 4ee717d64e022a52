// What the tests of programs share: the page with a plan, and what it shows beside the native command.

import assert from "node:assert/strict";
import { join } from "node:path";
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { built, frames, native, openPage, root } from "./browser.mjs";

export const programFile = join(built, "file/program.html");
export const programAddress = pathToFileURL(programFile).href;

export function exampleText(name) {
  return readFileSync(join(root, "examples", `${name}.ngc`), "utf8");
}

/** Until what is set has been planned, refused, or cancelled. */
export async function planned(page) {
  await page.waitForFunction(() => {
    const { state, samples } = document.querySelector(".program")?.dataset ?? {};
    return state !== undefined && state !== "planning" && !(state === "ready" && samples === "some");
  });
  return await page.getAttribute(".program", "data-state");
}

export async function openProgram(browser, address, options = {}) {
  const opened = await openPage(browser, address, { ...options, ready: planned });
  return opened;
}

export async function choose(page, name) {
  await page.selectOption("#example", name);
  return await planned(page);
}

/** In place of the text; waits for what comes of it. */
export async function write(page, text, name = "own.ngc") {
  const run = await page.getAttribute(".program", "data-run");
  await page.setInputFiles("#file", { name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await page.waitForFunction((before) => document.querySelector(".program").dataset.run !== before, run);
  return await planned(page);
}

/** The clock, moved there as by its slider; s. */
export async function setTime(page, time) {
  await page.evaluate((to) => {
    const slider = document.querySelector("#time");
    slider.value = String(to);
    slider.dispatchEvent(new Event("input"));
  }, time);
}

/** The window is so wide. A canvas that was never in it is none in a picture of the whole page: the path is looked at. */
export async function resized(page, width) {
  await page.setViewportSize({ width, height: 900 });
  await page.evaluate(() => document.querySelector("#space").scrollIntoView());
  await page.evaluate(frames, 3); // its size is seen in the first, asked for in the second, shown in the third
  await page.waitForFunction(() => document.querySelector("#space").dataset.drawing === undefined);
  await page.waitForTimeout(100); // what is drawn is seen a moment later
}

export async function downloaded(page, id) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#${id}`)]);
  return readFileSync(await download.path(), "utf8");
}

/** Of CSV: {columns, rows}. */
export function rowsOf(csv) {
  const [head, ...lines] = csv.trim().split("\n");
  return { columns: head.split(","), rows: lines.map((line) => line.split(",").map(Number)) };
}

/** Columns and lines the same, numbers within a nanometre. */
export function assertSameWords(shown, expected) {
  assert.deepEqual(shown.columns, expected.columns);
  assert.equal(shown.rows.length, expected.rows.length);
  shown.rows.forEach((row, i) =>
    row.forEach((value, k) => {
      const limit = shown.columns[k] === "line" ? 0 : 1e-9;
      assert.ok(Math.abs(value - expected.rows[i][k]) <= limit, `row ${i}, ${shown.columns[k]}: ${value}`);
    }),
  );
}

/** Words by the native command. */
export function nativeWords(folder, text, machine) {
  const [program, trace] = [join(folder, "program.ngc"), join(folder, "words.csv")];
  writeFileSync(program, text);
  const more = machine === undefined ? [] : ["--machine", join(folder, "machine.toml")];
  if (machine !== undefined) writeFileSync(join(folder, "machine.toml"), machine);
  native(["run", program, "--quiet", "--trace", trace, ...more]);
  return rowsOf(readFileSync(trace, "utf8"));
}

/** A value of the lists of figures, by its name. */
export async function figure(page, name, list = "figures") {
  return await page.textContent(`#${list} [data-name="${name}"] dd`);
}
