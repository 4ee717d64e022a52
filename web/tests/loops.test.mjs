// Simulated loops behind the program's words: slides and figures are those of `leadscrew simulate`; the part, the sensor, the link.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { missedByTab, seriousFindings, tabbed } from "./axe.mjs";
import { native, openBrowser, root, serve } from "./browser.mjs";
import { choose, downloaded, figure, openProgram, rowsOf } from "./program.mjs";

let server, browser, opened;
const folder = mkdtempSync(join(tmpdir(), "leadscrew-loops-"));
const square = join(root, "examples/04-square.ngc");
before(async () => {
  server = await serve();
  browser = await openBrowser();
  opened = await openProgram(browser, `${server.address}program.html`);
  await choose(opened.page, "04-square");
});
after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true });
});

async function followed(page, state = "followed") {
  await page.waitForTimeout(250); // typing pauses
  await page.waitForFunction((wanted) => document.querySelector(".loops").dataset.state === wanted, state);
}

for (const [controller, options] of [
  ["own", []],
  ["pid", ["--gains", "2,2,15"]],
  ["pulses", ["--pulses"]],
])
  test(`slides are the command's: ${controller}`, async () => {
    const { page } = opened;
    await page.selectOption("#loops-controller", controller);
    if (await page.$eval("#loops-follow", (button) => button.textContent === "Follow"))
      await page.click("#loops-follow");
    await followed(page);
    const trace = join(folder, "followed.csv");
    const told = JSON.parse(native(["simulate", square, ...options, "--json", "--trace", trace], [0, 1]));
    const theirs = rowsOf(readFileSync(trace, "utf8"));
    const mine = rowsOf(await downloaded(page, "loops-csv"));
    const count = Math.min(theirs.rows.length, mine.rows.length);
    assert.ok(count > 1000, `${count} rows`);
    for (const name of ["actual_X", "actual_Y", "velocity_X", "control_X", "current_Y"]) {
      const [at, own] = [theirs.columns.indexOf(name), mine.columns.indexOf(name)];
      const size = name.startsWith("actual") ? 1e-9 : 1e-5;
      for (let i = 0; i < count; ++i) {
        const [value, expected] = [mine.rows[i][own], theirs.rows[i][at]];
        assert.ok(
          Math.abs(value - expected) <= size * Math.max(1, Math.abs(expected)),
          `${name}, row ${i}: ${value}, ${expected}`,
        );
      }
    }
    const x = told.axes.find(({ name }) => name === "X");
    assert.equal(await figure(page, "X lags", "loops-figures"), `${x.following_max_mm.toFixed(4)} mm`);
    assert.equal(await figure(page, "Contour error", "loops-figures"), `${(told.contour.max_mm * 1000).toFixed(1)} µm`);
    const [, command] = /^leadscrew (.*) --json$/.exec(await page.textContent("#loops-command"));
    const file = controller === "pulses" ? ["--machine", "machine.toml"] : []; // of the gain, which no option says
    assert.equal(command, ["simulate", "04-square.ngc", ...file, ...options].join(" "));
  });

async function pictures(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return await page.$$eval("#loops-part, #loops-signal", (all) => all.map((each) => each.toDataURL()));
}

test("gains, the encoder and the sensor do what they say, and what is wrong is told", async () => {
  const { page } = opened;
  await page.selectOption("#loops-controller", "cascade");
  await page.fill("#loops-backlash", "0.1");
  await page.fill("#loops-forward", "1");
  await page.selectOption("#loops-encoder", "rotary");
  await followed(page);
  const screw = await figure(page, "Contour error", "loops-figures");
  await page.selectOption("#loops-encoder", "linear");
  await page.waitForFunction(
    (before) => document.querySelector('#loops-figures [data-name="Contour error"] dd').textContent !== before,
    screw,
  );
  assert.ok(parseFloat(await figure(page, "Contour error", "loops-figures")) < parseFloat(screw));
  const [part, lag] = await pictures(page);
  await page.selectOption("#loops-shows", "current");
  await page.selectOption("#loops-view", "near");
  const [near, current] = await pictures(page);
  assert.ok(near !== part && current !== lag);
  assert.match(await downloaded(page, "loops-svg"), /^<svg xmlns=.*<title>The part in XY, from position feedback/);
  await page.fill("#loops-positionGain", "5000");
  await followed(page, "refused");
  assert.match(await page.textContent("#loops-note"), /not stable/);
  // What no option says is the machine file's.
  assert.equal(
    await page.textContent("#loops-command"),
    "leadscrew simulate 04-square.ngc --machine machine.toml --json",
  );
  await page.fill("#loops-positionGain", "x");
  assert.match(await page.textContent("#loops-positionGain-error"), /none of 0.1 to 5000 1\/s/);
  await page.fill("#loops-positionGain", "40");
  await followed(page);
});

test("a link follows again; every control is by Tab, and axe finds nothing serious", async () => {
  const { page } = opened;
  await page.waitForTimeout(500);
  const other = await openProgram(browser, page.url(), { colorScheme: "dark" });
  await followed(other.page);
  for (const name of ["Contour error", "Y lags"])
    assert.equal(await figure(other.page, name, "loops-figures"), await figure(page, name, "loops-figures"));
  await tabbed(other.page, async () => {
    const inEditor = await other.page.evaluate(() => document.activeElement.closest(".cm-editor") !== null);
    if (inEditor) await other.page.keyboard.press("Escape");
  });
  assert.deepEqual(await missedByTab(other.page), []);
  assert.deepEqual(await seriousFindings(other.page), []);
  await other.close();
  assert.deepEqual(opened.failures, []);
  assert.deepEqual(opened.strays, []);
});
