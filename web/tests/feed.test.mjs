// Feed that is held and turned while motion plays, and the modes that are in force on the way.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { seriousFindings } from "./axe.mjs";
import { built, openBrowser } from "./browser.mjs";
import {
  downloaded,
  figure,
  openProgram,
  planned,
  programAddress,
  resized,
  rowsOf,
  setTime,
  write,
} from "./program.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
  mkdirSync(join(built, "screenshots"), { recursive: true });
});
after(async () => await browser?.close());

const timeOf = async (page) => Number(await page.inputValue("#time"));
const endOf = async (page) => Number(await page.getAttribute("#time", "max"));

/** Until what was pressed has been planned. */
async function replanned(page, press) {
  const run = await page.getAttribute(".program", "data-run");
  await press();
  await page.waitForFunction((before) => document.querySelector(".program").dataset.run !== before, run);
  assert.equal(await planned(page), "ready");
}

/** The words of X, and their differences over the period. */
async function motionOf(page) {
  const { columns, rows } = rowsOf(await downloaded(page, "export-csv"));
  const x = rows.map((row) => row[columns.indexOf("X")]);
  const differences = (of) => of.map((each, i) => (i === 0 ? 0 : (each - of[i - 1]) / 1e-3));
  const velocity = differences(x);
  const acceleration = differences(velocity);
  return { x, velocity, acceleration, jerk: differences(acceleration) };
}

const far = "G21 G90 F6000\nG1 X300\nM2\n";

test("a hold brakes within the limits, stands as long as one waits, and goes on", async () => {
  const { page, failures, close } = await openProgram(browser, programAddress);
  assert.equal(await write(page, far), "ready");
  const plain = await motionOf(page);
  const whole = await endOf(page);
  await page.selectOption("#speed", "0.5");
  await page.click("#play");
  await page.waitForFunction(() => Number(document.querySelector("#time").value) > 0.4);
  await replanned(page, () => page.click("#feed-hold"));
  const pressed = Number(/held from ([\d.]+) s/.exec(await page.textContent("#feed-said"))[1]);
  assert.equal(await page.textContent("#feed-hold"), "Resume");
  await page.waitForFunction(() => document.querySelector("#time").value === document.querySelector("#time").max);
  const stands = await endOf(page);
  assert.ok(stands > pressed + 0.05 && stands < pressed + 1, `held at ${pressed} s it stands at ${stands} s`);
  assert.equal(await figure(page, "Feed, mm/min", "now"), "0");
  assert.equal(await figure(page, "Held by", "now"), "rest");
  const held = await motionOf(page);
  const before = Math.floor(pressed * 1000);
  assert.deepEqual(held.x.slice(0, before), plain.x.slice(0, before)); // as it was until the button was pressed
  assert.ok(held.velocity[before + 20] > 1, "it does not stand at once");
  await page.waitForTimeout(600);

  await replanned(page, () => page.click("#feed-hold"));
  assert.equal(await page.textContent("#feed-hold"), "Hold");
  await page.selectOption("#speed", "10");
  await page.waitForFunction(() => document.querySelector("#time").value === document.querySelector("#time").max);
  const { x, acceleration, jerk } = await motionOf(page);
  assert.ok(Math.abs(x.at(-1) - 300) < 1e-9);
  // Half as fast as the clock: 0.3 s of the motion at least went by while it stood.
  assert.ok((await endOf(page)) > whole + 0.3, `${await endOf(page)} s, of ${whole} s without`);
  assert.ok(Math.max(...acceleration.map(Math.abs)) <= 1000 * 1.001);
  assert.ok(Math.max(...jerk.map(Math.abs)) <= 20000 * 1.001);
  assert.match(await page.textContent(".exports .note"), /held or turned/);

  await replanned(page, () => page.click("#feed-clear"));
  assert.equal(await endOf(page), whole);
  assert.deepEqual(failures, []);
  await close();
});

test("feed is turned from where the tool stands on, and a link brings all of it back", async () => {
  const { page, close } = await openProgram(browser, programAddress);
  assert.equal(await write(page, far), "ready");
  await setTime(page, 1);
  await page.fill("#feed-now", "50");
  await replanned(page, () => page.press("#feed-now", "Tab"));
  assert.equal(await timeOf(page), 1);
  await setTime(page, 0.9);
  assert.equal(await figure(page, "Feed, mm/min", "now"), "6000");
  await setTime(page, 1.8);
  assert.equal(await figure(page, "Feed, mm/min", "now"), "3000");
  assert.equal(await figure(page, "Held by", "now"), "feed");
  await replanned(page, () => page.click("#feed-hold"));
  await page.waitForFunction(() => location.hash.includes("feed=1%3A0.5_1.8%3A0") && location.hash.includes("t=1.800"));
  const other = await openProgram(browser, page.url());
  assert.equal(await other.page.textContent("#feed-hold"), "Resume");
  assert.equal(await endOf(other.page), await endOf(page));
  await other.close();
  await page.fill("#feed-now", "500");
  await page.press("#feed-now", "Tab");
  assert.match(await page.textContent("#feed-said"), /1 to 200 %/);
  await write(page, "G21 G90 F600\nG1 X1\nM2\n"); // another program has none of it
  assert.equal(await page.textContent("#feed-hold"), "Hold");
  await close();
});

const modal = `G21 G90 G64 P0.05 Q0.02 F600
G1 X10
T3 M6
S8000 M3 M8
G43 H3 G18 G91 G61
X1
G10 L2 P2 X7
G55 G90 G20
F30 X2
M2
`;

test("what is in force is told where the tool stands", async () => {
  const { page, failures, close } = await openProgram(browser, programAddress);
  assert.equal(await write(page, modal), "ready");
  const told = (name) => figure(page, name, "modes");
  await page.click(".cm-line:nth-child(2)");
  for (const [name, text] of [
    ["Motion", "G1"],
    ["Plane", "G17"],
    ["Units", "G21"],
    ["Distance", "G90 G91.1"],
    ["Path", "G64 P0.05 Q0.02"],
    ["Feed mode", "G94"],
    ["Feed", "600 mm/min"],
    ["Offset", "G54"],
    ["Tool", "0"],
    ["Length", "G49"],
    ["Radius", "G40"],
    ["Spindle", "M5 S0"],
    ["Coolant", "M9"],
  ])
    assert.equal(await told(name), text, name);
  await page.click(".cm-line:nth-child(6)");
  assert.equal(await figure(page, "Line", "now"), "6");
  assert.deepEqual([await told("Plane"), await told("Distance"), await told("Path")], ["G18", "G91 G91.1", "G61"]);
  assert.deepEqual([await told("Tool"), await told("Spindle"), await told("Coolant")], ["3", "M3 S8000", "M8"]);
  await page.click(".cm-line:nth-child(9)");
  assert.deepEqual([await told("Units"), await told("Feed"), await told("Offset")], ["G20", "762 mm/min", "G55 X7"]);
  assert.deepEqual(failures, []);
  await close();
});

test("pictures, light and dark", async () => {
  const { page, close } = await openProgram(browser, programAddress, { colorScheme: "dark" });
  assert.equal(await write(page, far), "ready");
  await setTime(page, 1);
  await replanned(page, () => page.click("#feed-hold"));
  for (const colorScheme of ["dark", "light"]) {
    await page.emulateMedia({ colorScheme });
    assert.deepEqual(await seriousFindings(page), []);
    for (const width of [1280, 390]) {
      await resized(page, width);
      const over = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.ok(over <= 0, `at ${width} px it is ${over} px too wide`);
      await page.screenshot({ path: join(built, "screenshots", `feed-${colorScheme}-${width}.png`), fullPage: true });
    }
  }
  await close();
});
