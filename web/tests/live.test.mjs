// The running machine in the page: `leadscrew drive --serve`, watched, held, slowed and stopped from there.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { seriousFindings } from "./axe.mjs";
import { built, command, openBrowser, root } from "./browser.mjs";
import { downloaded, figure, openProgram, resized } from "./program.mjs";

// Along X at Y 5, for minutes: it is always stopped.
const text = `G21 G90 F600\nG0 Y5\n${"G1 X200\nX0\n".repeat(10)}M2\n`;

let browser, folder;
const drives = [];
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(join(tmpdir(), "leadscrew-live-"));
});
after(async () => {
  await browser?.close();
  for (const drive of drives) drive.kill("SIGKILL");
  rmSync(folder, { recursive: true });
});

/** {address, token, ended}, the last a promise of the status. */
async function driven(text, ...options) {
  writeFileSync(join(folder, "driven.ngc"), text);
  const args = ["drive", "driven.ngc", "--serve", "0", "--control", "--quiet", ...options];
  const drive = spawn(command, args, { cwd: folder });
  drives.push(drive);
  const ended = new Promise((resolve) => drive.on("exit", resolve));
  const told = await new Promise((resolve, reject) => {
    let all = "";
    drive.stderr.on("data", (data) => {
      all += data;
      if (all.includes("\n")) resolve(all);
    });
    drive.on("exit", () => reject(new Error(all)));
  });
  const [, address, token] = /live at (\S+), token (\S+)/.exec(told);
  return { address, token, ended };
}

const live = (page, name) => figure(page, name, "live");

async function comesTo(page, state) {
  await page.waitForFunction((wanted) => document.querySelector(".live").dataset.machine === wanted, state);
}

test("the machine is seen, its program planned, and whoever has the token controls it", async () => {
  const { address, token, ended } = await driven(text);
  const { page, strays, failures, close } = await openProgram(browser, address);
  await page.waitForFunction(() => document.querySelector("#live-said").textContent.includes("driven.ngc on mill3"));
  await comesTo(page, "moving");
  await page.waitForFunction(() => document.querySelector(".program").dataset.state === "ready");
  assert.equal(await downloaded(page, "save"), text);
  assert.equal(await live(page, "Y"), "5.000");
  const before = Number(await live(page, "X"));
  await page.waitForFunction(
    (from) => Number(document.querySelector('#live [data-name="X"] dd').textContent) !== from,
    before,
  );
  assert.equal(await page.getAttribute(".program", "data-line"), await live(page, "Line"));
  assert.equal(await figure(page, "Y", "now"), "5.000"); // where the machine is, not where the plan begins
  assert.deepEqual([await figure(page, "Motion", "modes"), await figure(page, "Feed", "modes")], ["G1", "600 mm/min"]);
  assert.deepEqual(await seriousFindings(page), []);

  await page.click("#live-hold");
  await page.waitForFunction(() => document.querySelector("#live-error").textContent.includes("token"));
  await page.fill("#live-token", token);
  await page.click("#live-hold");
  await comesTo(page, "held");
  await page.waitForFunction(() => document.querySelector('#live [data-name="Feed, /min"] dd').textContent === "0");
  const there = await live(page, "X");
  await page.waitForTimeout(200);
  assert.ok(Math.abs(Number(await live(page, "X")) - Number(there)) < 0.01); // the slides settle
  assert.equal(await page.textContent("#live-hold"), "Resume");
  await page.click("#live-hold");
  await comesTo(page, "moving");
  await page.fill("#live-feed", "50");
  await page.press("#live-feed", "Tab");
  await page.waitForFunction(() => document.querySelector('#live [data-name="Feed, /min"] dd').textContent === "300");
  assert.equal(await live(page, "Override"), "50 %");
  const pictures = join(built, "screenshots");
  mkdirSync(pictures, { recursive: true });
  for (const colorScheme of ["dark", "light"]) {
    await page.emulateMedia({ colorScheme });
    for (const width of [1280, 390]) {
      await resized(page, width);
      await page.screenshot({ path: join(pictures, `live-${colorScheme}-${width}.png`), fullPage: true });
      const over = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.ok(over <= 0, `at ${width} px it is ${over} px too wide`);
    }
  }
  // The refusal is the one failure, and is meant.
  assert.deepEqual(
    failures.filter((each) => !each.includes("403")),
    [],
  );
  assert.deepEqual(strays, []);

  await page.click("#live-stop");
  await page.waitForFunction(() => document.querySelector("#live-said").textContent === "It has ended");
  assert.equal(await ended, 130);
  await close();
});

test("a pause waits for the page, without a terminal", async () => {
  const { address, token, ended } = await driven("G21 G90 F6000\nG1 X1\nM0\nG1 X2\nM2\n");
  const { page, close } = await openProgram(browser, address);
  await comesTo(page, "paused");
  assert.match(await live(page, "State"), /line 3$/);
  await page.fill("#live-token", token);
  await page.click("#live-go-on");
  await page.waitForFunction(() => document.querySelector("#live-said").textContent === "It has ended");
  assert.equal(await live(page, "X"), "2.000");
  assert.equal(await ended, 0);
  await close();
});

test("a hold within a thread waits for its end, which is told", async () => {
  const { address, token, ended } = await driven("G21 G90 G94\nS300 M3\nM0\nG33 Z-20 K1\nG1 X5 F600\nM2\n");
  const { page, close } = await openProgram(browser, address);
  await comesTo(page, "paused");
  await page.fill("#live-token", token);
  await page.click("#live-go-on");
  await comesTo(page, "moving");
  await page.click("#live-hold");
  await comesTo(page, "hold_waits");
  assert.equal(await page.textContent("#live-hold"), "Resume");
  await comesTo(page, "held");
  assert.equal(await live(page, "State"), "held");
  await page.waitForFunction(() =>
    /^−(20.00|19.99)/.test(document.querySelector('#live [data-name="Z"] dd').textContent),
  );
  await page.click("#live-hold");
  await page.waitForFunction(() => document.querySelector("#live-said").textContent === "It has ended");
  assert.equal(await ended, 0);
  await close();
});

test("of five axes program and tool are seen as well: its shape, its tip and its direction", async () => {
  writeFileSync(join(folder, "tools.tbl"), "T2 P2 D10 R5 Z30 L40 H50 K60\n");
  const moves = "G1 X20 Y5 A-30 C40\nX0 A0 C0\n".repeat(20);
  const { address, token, ended } = await driven(
    `G21 G90 F600\nT2 M6\nG43.4 H2\n${moves}G49\nM2\n`,
    "--machine",
    join(root, "machines/table-table-ac.toml"),
    "--tools",
    "tools.tbl",
  );
  const { page, failures, close } = await openProgram(browser, address);
  await page.waitForFunction(() => document.querySelector(".program").dataset.state === "ready");
  assert.match(await page.textContent(".machine"), /C/);
  await page.waitForFunction(() => {
    const [tool, , , , i, j, k] = (document.querySelector("#space").dataset.tool ?? "").split(" ");
    const [x, y, z] = [i, j, k].map(Number);
    return tool === "T2" && z < 0.999 && Math.abs(Math.hypot(x, y, z) - 1) < 2e-3;
  });
  const tip = (await page.getAttribute("#space", "data-tool")).split(" ").slice(1, 4).map(Number);
  assert.ok(tip[0] > -0.5 && tip[0] < 20.5 && Math.abs(tip[2] + 30) < 0.5, `the tip is at ${tip}`);
  await page.screenshot({ path: join(built, "screenshots", "live-five-axes.png"), fullPage: true });
  await page.fill("#live-token", token);
  await page.click("#live-stop");
  assert.equal(await ended, 130);
  assert.deepEqual(failures, []);
  await close();
});
