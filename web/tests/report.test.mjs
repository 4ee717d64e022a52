// `leadscrew run --report`: the page with the recording inside, opened from disk, shows the figures of `run --json` without
// planning anything, and plans anew what is changed.

import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { seriousFindings } from "./axe.mjs";
import { built, native, openBrowser, root } from "./browser.mjs";
import {
  assertSameWords,
  downloaded,
  exampleText,
  figure,
  openProgram,
  planned,
  resized,
  rowsOf,
  write,
} from "./program.mjs";

let browser, folder;
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(join(tmpdir(), "leadscrew-report-"));
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

/** Of an example: {address, result, trace}, the result as printed. */
function reported(name, ...options) {
  const [page, trace] = [join(folder, `${name}.html`), join(folder, `${name}.csv`)];
  const args = ["run", join(root, "examples", `${name}.ngc`), "--json", "--report", page, "--trace", trace, ...options];
  const breaks = options.includes("--interpolator"); // published rules of steps may break limits, which is told
  const result = JSON.parse(native(args, breaks ? [0, 1] : 0));
  return { address: pathToFileURL(page).href, result, trace };
}

/** Name and value of all figures of the recording. */
async function judged(page) {
  return new Map(
    await page.$$eval("#judged > div", (all) =>
      all.map((each) => [each.dataset.name, each.dataset.value === "null" ? null : Number(each.dataset.value)]),
    ),
  );
}

test("a report shows what run --json prints", async () => {
  const { address, result } = reported("01-plate");
  const { page, strays, failures, close } = await openProgram(browser, address);
  assert.equal(await page.getAttribute(".program", "data-state"), "ready");
  const shown = await judged(page);
  const expected = {
    Time: result.time_s,
    "of it dwell": result.dwell_s,
    "Without jerk limit": result.bound_s,
    Length: result.length_mm,
    Moves: result.moves,
    Words: result.words,
    Deviation: result.deviation_mm,
    Tolerance: result.tolerance_mm,
    "Feed of programmed": result.feed.max_ratio,
    "Feed ripple": result.feed.ripple,
    Objections: result.violation_count,
  };
  for (const { name, velocity_ratio, acceleration_ratio, jerk_ratio } of result.axes) {
    expected[`Velocity ${name}`] = velocity_ratio;
    expected[`Acceleration ${name}`] = acceleration_ratio;
    expected[`Jerk ${name}`] = jerk_ratio;
  }
  for (const { cause, s } of result.losses) expected[`Lost to ${cause}`] = s;
  assert.deepEqual(Object.fromEntries(shown), expected);
  assert.equal(await figure(page, "Words"), result.words.toLocaleString("en"));
  assert.match(await page.textContent("#recorded-by"), /^leadscrew run .*01-plate\.ngc --json --report/);
  assert.match(await page.textContent("#verdict"), /objects to none/);
  assert.ok((await page.$$(".losses tbody tr")).length > 0);
  assert.equal(await downloaded(page, "save"), exampleText("01-plate"));
  assert.deepEqual(await seriousFindings(page), []);
  assert.deepEqual(strays, []);
  assert.deepEqual(failures, []);
  await close();
});

test("its words are the trace's, and the clock walks along them", async () => {
  const { address, trace } = reported("04-square");
  const { page, close } = await openProgram(browser, address);
  const words = rowsOf(readFileSync(trace, "utf8"));
  assertSameWords(rowsOf(await downloaded(page, "export-csv")), words);
  await page.press("body", "Home");
  for (let i = 0; i < 120; ++i) await page.press("body", "ArrowRight");
  const at = words.columns.indexOf("X");
  assert.equal(await figure(page, "X", "now"), words.rows[120][at].toFixed(3));
  await close();
});

test("at a period of which no second is a whole number its times are the trace's", async () => {
  const { address, trace } = reported("04-square", "--period", "300us");
  const { page, close } = await openProgram(browser, address);
  const [shown, words] = [rowsOf(await downloaded(page, "export-csv")), rowsOf(readFileSync(trace, "utf8"))];
  assertSameWords(shown, words);
  for (const [i, [time]] of shown.rows.entries()) assert.equal(time, words.rows[i][0]);
  await close();
});

test("what is changed is planned anew, and what is changed back is the recording", async () => {
  const { address, result } = reported("04-square");
  const { page, failures, close } = await openProgram(browser, address);
  const text = exampleText("04-square");
  assert.equal(await write(page, "G21 G90 F600\nG1 X1\nM2\n"), "ready");
  assert.equal(await page.isVisible(".judged"), false);
  assert.notEqual(await figure(page, "Words"), result.words.toLocaleString("en"));
  assert.equal(await write(page, text), "ready");
  assert.equal(await page.isVisible(".judged"), true);
  assert.equal(await figure(page, "Words"), result.words.toLocaleString("en"));
  await page.waitForFunction(() => !/[#&](z|ex)=/.test(location.hash)); // the recording is what there is without a link
  await page.reload();
  assert.equal(await planned(page), "ready");
  assert.equal(await page.isVisible(".judged"), true);
  assert.deepEqual(failures, []);
  await close();
});

test("what is changed is planned as the run was asked: by its period, mode, tolerance and start", async () => {
  const asked = ["--period", "2ms", "--mode", "exact-stop", "--start", "X1,Y2"];
  const { address } = reported("04-square", ...asked);
  const { page, failures, close } = await openProgram(browser, address);
  const text = `${exampleText("04-square").replace(/\nM2|\nM30/, "\nG1 X3 Y4\n$&")}`;
  assert.notEqual(text, exampleText("04-square"));
  assert.equal(await write(page, text), "ready");
  const [program, trace, dump] = [
    join(folder, "changed.ngc"),
    join(folder, "changed.csv"),
    join(folder, "changed.vcd"),
  ];
  writeFileSync(program, text);
  native(["run", program, "--quiet", "--trace", trace, "--pulses", dump, ...asked]);
  assertSameWords(rowsOf(await downloaded(page, "export-csv")), rowsOf(readFileSync(trace, "utf8")));
  assert.ok((await downloaded(page, "export-vcd")) === readFileSync(dump, "utf8"));
  assert.match(await page.textContent("#command"), /--period 2000us --mode exact-stop --start X1,Y2 --trace/);
  assert.deepEqual(failures, []);
  await close();
});

test("smoothing and rule of steps stand in the command; what is changed is smoothed so too, and steps by arc length", async () => {
  const asked = ["--mode", "blend", "--tolerance", "0.2", "--smoothing", "least-time"];
  const { address, trace, result } = reported("04-square", ...asked, "--interpolator", "newton");
  const { page, failures, close } = await openProgram(browser, address);
  const options = /--mode blend --tolerance 0\.2 --smoothing least-time --interpolator newton --trace/;
  assert.match(await page.textContent("#command"), options);
  assertSameWords(rowsOf(await downloaded(page, "export-csv")), rowsOf(readFileSync(trace, "utf8")));
  const text = `${exampleText("04-square")}\n`;
  assert.equal(await write(page, text), "ready");
  assert.match(await page.textContent("#command"), /--smoothing least-time --trace/);
  const [program, changed] = [join(folder, "smoothed.ngc"), join(folder, "smoothed.csv")];
  writeFileSync(program, text);
  native(["run", program, "--quiet", "--trace", changed, ...asked]);
  const words = rowsOf(readFileSync(changed, "utf8"));
  assertSameWords(rowsOf(await downloaded(page, "export-csv")), words);
  const splines = JSON.parse(native(["run", program, "--json", ...asked.slice(0, 4)]));
  assert.ok(result.time_s < splines.time_s - 1e-3, `${result.time_s} s, of splines ${splines.time_s} s`);
  assert.deepEqual(failures, []);
  await close();
});

test("acceleration and jerk are differences of the recording's words", async () => {
  const [program, file, trace] = ["feeds.ngc", "feeds.html", "feeds.csv"].map((name) => join(folder, name));
  writeFileSync(program, "G21 G90 F6000\nG1 X20\nG1 X25 Y10\nM2\n");
  native(["run", program, "--quiet", "--report", file, "--trace", trace]);
  const { page, close } = await openProgram(browser, pathToFileURL(file).href);
  const { columns, rows } = rowsOf(readFileSync(trace, "utf8"));
  const places = ["X", "Y", "Z"].map((name) => rows.map((row) => row[columns.indexOf(name)]));
  for (const [order, name] of [
    [2, "acceleration"],
    [3, "jerk"],
  ]) {
    // Before the first word the axes stand where it is.
    const differences = places.map((values) => {
      let all = [values[0], values[0], values[0], ...values];
      for (let k = 0; k < order; ++k) all = all.slice(1).map((each, i) => (each - all[i]) / 1e-3);
      return all.slice(3 - order);
    });
    const greatest = Math.max(...differences[0].map((_, i) => Math.hypot(...differences.map((axis) => axis[i]))));
    await page.selectOption("#colouring", name);
    assert.equal((await page.textContent("#legend .ramp + .number")).split(" ")[0], greatest.toFixed(0));
  }
  await close();
});

test("five axes, a surface and its tool; pictures", async () => {
  const { address, result } = reported(
    "17-patch-leaning",
    "--machine",
    join(root, "machines/table-table-ac.toml"),
    "--tools",
    join(root, "examples/tools.tbl"),
    "--allow-gouge",
  );
  const { page, failures, close } = await openProgram(browser, address);
  assert.equal((await judged(page)).get("Of the tip"), result.tip.deviation_mm);
  assert.match(await page.textContent("#gouges-note"), /deeper|found/);
  await page.selectOption("#colouring", "part");
  const pictures = join(built, "screenshots");
  mkdirSync(pictures, { recursive: true });
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    for (const width of [1280, 390]) {
      await resized(page, width);
      await page.screenshot({
        path: join(pictures, `report-${colorScheme}-${width}.png`),
        fullPage: width === 1280,
        timeout: 120_000,
      });
      const over = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.ok(over <= 0, `at ${width} px it is ${over} px too wide`);
    }
  }
  assert.deepEqual(failures, []);
  await close();
});
