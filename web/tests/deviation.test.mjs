// How far motion is from its program: colours, legend and figures, beside distances that are measured here.

import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { seriousFindings } from "./axe.mjs";
import { built, native, openBrowser } from "./browser.mjs";
import { downloaded, figure, openProgram, programAddress, resized, rowsOf, write } from "./program.mjs";

let browser, folder;
before(async () => {
  browser = await openBrowser();
  folder = mkdtempSync(join(tmpdir(), "leadscrew-deviation-"));
  mkdirSync(join(built, "screenshots"), { recursive: true });
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

// Corners within 50 µm, then one within 200 µm.
const text = "G21 G90 G64 P0.05 F3000\nG1 X20\nY20\nG64 P0.2\nX0\nY40\nM2\n";
const corners = [
  [0, 0],
  [20, 0],
  [20, 20],
  [0, 20],
  [0, 40],
];

/** Of a point from the lines between corners, mm. */
function distanceOf([x, y]) {
  const distances = corners.slice(1).map(([toX, toY], i) => {
    const [fromX, fromY] = corners[i];
    const [dx, dy] = [toX - fromX, toY - fromY];
    const share = Math.min(Math.max(((x - fromX) * dx + (y - fromY) * dy) / (dx * dx + dy * dy), 0), 1);
    return Math.hypot(x - fromX - share * dx, y - fromY - share * dy);
  });
  return Math.min(...distances);
}

async function judged(page) {
  await page.selectOption("#colouring", "deviation");
  await page.waitForFunction(() => document.querySelector("#deviation")?.textContent.startsWith("100 %"));
  return await page.textContent("#deviation");
}

/** [µm off, µm allowed] where the tool stands. */
async function offAt(page, time) {
  await page.evaluate((to) => {
    const slider = document.querySelector("#time");
    slider.value = String(to);
    slider.dispatchEvent(new Event("input"));
  }, time);
  return (await figure(page, "Off the program, µm", "now")).split(" of ").map(Number);
}

async function assertAsMeasured(page) {
  const { columns, rows } = rowsOf(await downloaded(page, "export-csv"));
  const [t, x, y] = ["t", "X", "Y"].map((name) => columns.indexOf(name));
  const distances = rows.map((row) => distanceOf([row[x], row[y]]));
  const end = rows.at(-1)[t];
  const near = distances.map((each, i) => [each, i]).sort(([a], [b]) => b - a)[0][1];
  for (const i of [near, Math.round(0.2 * rows.length), Math.round(0.9 * rows.length)]) {
    const [off, allowed] = await offAt(page, rows[i][t]);
    assert.ok(
      Math.abs(off / 1000 - distances[i]) < allowed / 1000 / 8 + 1e-5,
      `${off} µm at ${rows[i][t]} of ${end} s`,
    );
    assert.ok(off <= allowed);
  }
  return Math.max(...distances) * 1000;
}

test("the path is coloured by its distance to the tolerance, in the legend are both in µm", async () => {
  const { page, failures, close } = await openProgram(browser, programAddress);
  assert.equal(await write(page, text), "ready");
  assert.equal(await page.locator('#now [data-name="Off the program, µm"]').count(), 0);
  const told = await judged(page);
  const [, least, greatest, far, share, line] =
    /100 % is ([\d.]+) µm to ([\d.]+) µm; nearest to it ([\d.]+) µm, (\d+) %, line (\d+)/.exec(told);
  assert.deepEqual([least, greatest].map(Number), [50, 200]);
  assert.ok(Number(share) > 30 && Number(share) <= 100, told);
  assert.ok(["2", "3", "5", "6"].includes(line), told);
  const farthest = await assertAsMeasured(page);
  assert.ok(Number(far) <= farthest * 1.01, `${told}, measured ${farthest} µm`);
  assert.match(await page.textContent("#legend"), /0.*100 % of the tolerance/);
  // Along straight lines nothing is off, at corners much: colours of both ends of the scale.
  const colours = new Set((await downloaded(page, "export-svg")).match(/stroke="rgb\([\d,]+\)"/g));
  assert.ok(colours.size > 5, [...colours].join());
  assert.deepEqual(failures, []);
  await close();
});

test("what is planned anew is judged anew, and a link asks for it", async () => {
  const { page, close } = await openProgram(browser, programAddress);
  assert.equal(await write(page, text), "ready");
  await judged(page);
  await page.waitForFunction(() => location.hash.includes("c=deviation") && location.hash.includes("z="));
  const other = await openProgram(browser, page.url());
  await other.page.waitForFunction(() => document.querySelector("#deviation")?.textContent.startsWith("100 %"));
  assert.equal(await other.page.textContent("#deviation"), await page.textContent("#deviation"));
  await other.close();
  await write(page, "G21 G90 G61 F600\nG1 X5\nM2\n");
  await page.waitForFunction(() =>
    /^100 % is 0 µm; nearest to it \S+ µm, 0 %/.test(document.querySelector("#deviation")?.textContent),
  );
  await close();
});

test("a report has what the run's referee found; pictures, light and dark", async () => {
  const [program, report] = [join(folder, "corners.ngc"), join(folder, "corners.html")];
  writeFileSync(program, text);
  native(["run", program, "--quiet", "--report", report]);
  const { page, failures, close } = await openProgram(browser, pathToFileURL(report).href);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    assert.match(await judged(page), /100 % is 50 µm to 200 µm/);
    await assertAsMeasured(page);
    assert.equal(await page.isVisible(".judged"), true);
    assert.deepEqual(await seriousFindings(page), []);
    for (const width of [1280, 390]) {
      await resized(page, width);
      await page.screenshot({
        path: join(built, "screenshots", `deviation-${colorScheme}-${width}.png`),
        fullPage: width === 1280,
      });
    }
  }
  assert.deepEqual(failures, []);
  await close();
});
