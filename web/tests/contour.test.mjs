// Cutter compensation in the program's page: what the program tells, beside the way of the tool's middle.

import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { seriousFindings } from "./axe.mjs";
import { built, native, openBrowser, serve } from "./browser.mjs";
import { choose, downloaded, openProgram, planned, resized, write } from "./program.mjs";

/** A plate of 60 mm by 40 mm with round corners, about which a tool of 10 mm goes at its left. */
const plate = `G21 G90 G17
T1 M6
G43 H1
G0 X-20 Y-15 Z5
G1 Z-2 F300
G41 D1 G1 X0 Y-10 F900
Y32
G2 X8 Y40 R8
G1 X52
G2 X60 Y32 R8
G1 Y8
G2 X52 Y0 R8
G1 X-10
G40 G1 X-20 Y-15
G0 Z5
M2
`;
const tools = "T1 P1 D10 Z40 ;end mill\n";

let server, browser, folder;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), "leadscrew-contour-"));
  server = await serve();
  browser = await openBrowser();
});
after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true });
});

async function withPlate(options = {}) {
  const opened = await openProgram(browser, `${server.address}program.html`, options);
  await opened.page.fill("#tools", tools);
  await opened.page.press("#tools", "Tab");
  assert.equal(await write(opened.page, plate, "plate.ngc"), "ready");
  return opened;
}

/** Lines of the picture that are dashed as the contour is: the number of places of each. */
function contoursIn(svg) {
  return [...svg.matchAll(/<polyline[^>]*>/g)]
    .map(([line]) => line)
    .filter((line) => /stroke-dasharray="2 3"/.test(line))
    .map((line) => /points="([^"]*)"/.exec(line)[1].trim().split(/\s+/).length);
}

test("the programmed contour is drawn apart, and a switch takes it away", async () => {
  const { page, strays, failures, close } = await withPlate();
  assert.ok(await page.isVisible("#contour"));
  assert.match(await page.textContent("#legend"), /programmed contour/);
  await page.click("#view-top");
  const [contour, ...more] = contoursIn(await downloaded(page, "export-svg"));
  assert.deepEqual(more, []);
  assert.ok(contour > 9 + 3 * 8 && contour < 200, `${contour} places`); // three arcs
  const before = Number(await page.getAttribute("#space", "data-pictures"));
  await page.focus("#contour");
  await page.keyboard.press("Space");
  await page.waitForFunction((count) => Number(document.querySelector("#space").dataset.pictures) > count, before);
  assert.doesNotMatch(await page.textContent("#legend"), /programmed contour/);
  assert.deepEqual(contoursIn(await downloaded(page, "export-svg")), []);
  await page.waitForFunction(() => /[#&]g41=0/.test(location.hash));
  await page.reload();
  assert.equal(await planned(page), "ready");
  assert.equal(await page.isChecked("#contour"), false);
  assert.deepEqual(await seriousFindings(page), []);
  assert.deepEqual([strays, failures], [[], []]);
  await close();
});

test("a program without compensation has no contour apart", async () => {
  const { page, close } = await openProgram(browser, `${server.address}program.html`);
  assert.equal(await choose(page, "04-square"), "ready");
  assert.equal(await page.isVisible("#contour"), false);
  assert.doesNotMatch(await page.textContent("#legend"), /contour/);
  await close();
});

test("a report draws it too; pictures", async () => {
  const [program, table, report] = ["plate.ngc", "tools.tbl", "plate.html"].map((name) => join(folder, name));
  writeFileSync(program, plate);
  writeFileSync(table, tools);
  native(["run", program, "--quiet", "--tools", table, "--report", report]);
  assert.ok(readFileSync(report, "utf8").includes('id="recording"'));
  const pictures = join(built, "screenshots");
  mkdirSync(pictures, { recursive: true });
  const { page, failures, close } = await openProgram(browser, pathToFileURL(report).href);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    assert.match(await page.textContent("#legend"), /programmed contour/);
    assert.equal(contoursIn(await downloaded(page, "export-svg")).length, 1);
    for (const width of [1280, 390]) {
      await resized(page, width);
      await page.screenshot({ path: join(pictures, `contour-${colorScheme}-${width}.png`), timeout: 120_000 });
    }
  }
  assert.deepEqual(failures, []);
  await close();
});

/** Pixels of the path's picture that have the first colour of its legend. */
async function legendPixels(page) {
  const picture = (await page.locator("#space").screenshot()).toString("base64");
  return await page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    const wanted = getComputedStyle(document.querySelector("#legend .chip")).backgroundColor.match(/\d+/g).map(Number);
    let equal = 0;
    for (let i = 0; i < data.length; i += 4)
      if (wanted.every((channel, k) => Math.abs(data[i + k] - channel) <= 2)) ++equal;
    return equal;
  }, picture);
}

test("the path has the colours of its legend", async () => {
  const { page, close } = await openProgram(browser, `${server.address}program.html`);
  assert.equal(await choose(page, "04-square"), "ready");
  await page.selectOption("#colouring", "part");
  await resized(page, 1280);
  // What has been drawn is seen a moment later, on a busy computer a long one.
  let count = 0;
  for (let look = 0; look < 100 && count <= 500; ++look) count = await legendPixels(page);
  assert.ok(count > 500, `${count} pixels`);
  await close();
});
