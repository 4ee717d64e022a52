// The program's page in use: line, path and time go together; large programs; keys; axe; links; one file.

import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { missedByTab, seriousFindings, tabbed } from "./axe.mjs";
import { built, openBrowser, serve } from "./browser.mjs";
import {
  assertSameWords,
  choose,
  downloaded,
  exampleText,
  figure,
  nativeWords,
  openProgram,
  planned,
  programAddress,
  resized,
  rowsOf,
  setTime,
  write,
} from "./program.mjs";

let server, browser, opened, address;
before(async () => {
  server = await serve();
  browser = await openBrowser();
  address = `${server.address}program.html`;
  opened = await openProgram(browser, address);
});
after(async () => {
  await browser?.close();
  server?.close();
});

async function timeOf(page) {
  return Number(await page.inputValue("#time"));
}

/** Of the words at this time: number of the line and position, as the table of words has them. */
function wordAt({ columns, rows }, time) {
  const row = rows[Math.round(time / 0.001)];
  return Object.fromEntries(columns.map((name, i) => [name, row[i]]));
}

test("time tells the line and the place", async () => {
  const { page } = opened;
  await choose(page, "01-plate");
  const words = rowsOf(await downloaded(page, "export-csv"));
  const end = Number(await page.getAttribute("#time", "max"));
  for (const share of [0.11, 0.37, 0.5, 0.83]) {
    const time = Math.round(share * end * 1000) / 1000;
    await setTime(page, time);
    const word = wordAt(words, time);
    assert.equal(await figure(page, "Line", "now"), String(word.line));
    assert.equal(await page.getAttribute(".program", "data-line"), String(word.line));
    for (const axis of ["X", "Y", "Z"]) {
      const shown = (await figure(page, axis, "now")).replace("−", "-");
      assert.equal(Number(shown), Number(word[axis].toFixed(3)));
    }
    const marked = await page.$eval(".cm-moving", (each) => each.textContent);
    assert.equal(marked, exampleText("01-plate").split("\n")[word.line - 1]);
  }
});

test("some samples of a plan are shown at once, all of them follow, and the clock goes on", async () => {
  const { page } = opened;
  await page.evaluate(() => {
    const program = document.querySelector(".program");
    globalThis.shown = [];
    const note = () => {
      const { state, samples } = program.dataset;
      if (state !== "ready" || globalThis.shown.at(-1)?.[0] === samples) return;
      globalThis.shown.push([samples, document.querySelector("#time").value]);
      if (samples !== "some") return;
      const slider = document.querySelector("#time");
      slider.value = "7.5";
      slider.dispatchEvent(new Event("input"));
    };
    new MutationObserver(note).observe(program, { attributes: true, attributeFilter: ["data-state"] });
  });
  await choose(page, "03-arcs-in-three-planes");
  await choose(page, "01-plate");
  const shown = await page.evaluate(() => globalThis.shown);
  assert.deepEqual(
    shown.slice(-2).map(([samples]) => samples),
    ["some", "all"],
  );
  assert.equal(Number(shown.at(-1)[1]), 7.5);
  assert.equal(await timeOf(page), 7.5);
  const rows = rowsOf(await downloaded(page, "times-csv")).rows;
  assert.ok(Math.abs(rows[1][0] - rows[0][0] - 0.001) < 1e-9);
});

test("a line of the text, and of the list of lost time, tells the time", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  const words = rowsOf(await downloaded(page, "export-csv"));
  const [t, line] = [words.columns.indexOf("t"), words.columns.indexOf("line")];
  for (const number of [4, 5]) {
    await page.click(`.cm-line:nth-child(${number})`);
    const time = await timeOf(page);
    const first = words.rows.find((row) => row[line] === number && row[t] > 0)[t];
    assert.ok(Math.abs(time - first) <= 0.0025, `line ${number}: ${time} s, it begins at ${first} s`);
    assert.equal(await figure(page, "Line", "now"), String(number));
  }
  const dearest = await page.textContent(".losses tbody tr:first-child button");
  await page.click(".losses tbody tr:first-child button");
  assert.equal(await figure(page, "Line", "now"), dearest);
});

test("a click on the path tells line and time", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  await page.click("#view-top");
  await page.waitForTimeout(100);
  const box = await page.locator("#space").boundingBox();
  const found = new Set();
  // Along a cross through the picture each side of the square is met once.
  for (const [dx, dy] of [
    [1, 0],
    [0, 1],
  ])
    for (let at = 0.02; at < 1; at += 0.04) {
      const [x, y] = dx ? [at * box.width, box.height / 2] : [box.width / 2, at * box.height];
      await page.mouse.click(box.x + x, box.y + y);
      found.add(await figure(page, "Line", "now"));
    }
  assert.ok(found.size >= 4, [...found].join());
});

/** Pixels of the path's picture that are not its ground. */
async function paintedPixels(page) {
  const picture = (await page.locator("#space").screenshot()).toString("base64");
  return await page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const to = canvas.getContext("2d");
    to.drawImage(image, 0, 0);
    const { data } = to.getImageData(0, 0, image.width, image.height);
    const ground = data.slice(4 * (10 * image.width + 10), 4 * (10 * image.width + 10) + 3);
    let painted = 0;
    for (let i = 0; i < data.length; i += 4) painted += ground.some((each, k) => each !== data[i + k]) ? 1 : 0;
    return painted;
  }, picture);
}

test("the path is drawn, and the tool over it without drawing the path again", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  const pictures = async () => Number(await page.getAttribute("#space", "data-pictures"));
  await page.waitForTimeout(300);
  assert.equal(await page.getAttribute("#space", "data-by"), "webgl");
  // Four sides of hundreds of pixels each, and a margin around them that the tool would not fill.
  let painted = 0;
  for (let look = 0; look < 100 && painted <= 2500; ++look) painted = await paintedPixels(page);
  assert.ok(painted > 2500, `${painted} pixels`);
  const before = await pictures();
  assert.ok(before > 0);
  await setTime(page, 0.3);
  await page.waitForTimeout(300);
  assert.equal(await pictures(), before);
  await page.click("#view-top");
  await page.waitForFunction((count) => Number(document.querySelector("#space").dataset.pictures) > count, before);
});

test("what was drawn of another program is not left beside one that is refused", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  await write(page, "G21 G90 G1 X1Q F600\nM2\n");
  assert.equal(await page.isVisible("#space"), false);
  assert.equal(await page.isVisible("#figures"), false);
  await choose(page, "04-square");
  assert.equal(await page.isVisible("#space"), true);
});

test("it plays forward and back", async () => {
  const { page } = opened;
  await choose(page, "01-plate");
  await setTime(page, 30); // far from both ends, where a slow computer would come to rest before the button
  await page.click("#play");
  await page.waitForFunction(() => Number(document.querySelector("#time").value) > 30.2);
  await page.click("#play");
  const there = await timeOf(page);
  await page.selectOption("#speed", "5");
  await page.click("#play-back");
  await page.waitForFunction((from) => Number(document.querySelector("#time").value) < from - 1, there);
  await page.click("#play-back");
  const here = await timeOf(page);
  await page.waitForTimeout(150);
  assert.equal(await timeOf(page), here);
  await page.selectOption("#speed", "1");
});

test("what a code means is said where one points at it", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  const code = page.locator(".cm-line span", { hasText: /^G21$/ }).first();
  await code.hover();
  await page.waitForSelector(".explanation");
  assert.match(await page.textContent(".explanation"), /millimet/i);
  await page.mouse.move(5, 5);
});

test("colours: each has its legend, and rapids are apart", async () => {
  const { page } = opened;
  await choose(page, "06-drilling");
  for (const [colouring, text] of [
    ["speed", /mm\/min/],
    ["acceleration", /mm\/s²/],
    ["jerk", /mm\/s³/],
    ["limit", /feed word.*jerk/],
    ["line", /\d/],
  ]) {
    await page.selectOption("#colouring", colouring);
    assert.match(await page.textContent("#legend"), text);
    assert.match(await page.textContent("#legend"), /rapid/);
    const svg = await downloaded(page, "export-svg");
    assert.match(svg, /stroke-dasharray/, "rapids are dashed");
  }
  // The greatest feed of the scale is that of feed moves: rapids are faster.
  await page.selectOption("#colouring", "speed");
  const words = rowsOf(await downloaded(page, "export-csv"));
  const fastest = Math.max(...words.rows.map((row) => row[3])) * 60;
  const shown = Number((await page.textContent("#legend .number:nth-of-type(3)")).replace(/[^\d.]/g, ""));
  assert.ok(shown > 0 && shown < 0.8 * fastest, `${shown} of ${fastest}`);
});

test("what is shown over time is a picture and a table", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  const words = rowsOf(await downloaded(page, "export-csv"));
  const all = rowsOf(await downloaded(page, "times-csv"));
  assert.deepEqual(all.columns.slice(0, 6), ["t", "line", "feed", "X", "Y", "Z"]);
  assert.equal(all.rows.length, words.rows.length);
  const [x, vx, wordX] = [all.columns.indexOf("X"), all.columns.indexOf("vX"), words.columns.indexOf("X")];
  all.rows.forEach((row, i) => assert.equal(row[x], words.rows[i][wordX]));
  // Velocities are those of the positions, half a period aside.
  for (const i of [50, 200, 400])
    assert.ok(Math.abs((all.rows[i + 1][x] - all.rows[i - 1][x]) / 2e-3 - all.rows[i][vx]) < 0.05, `row ${i}`);
  await setTime(page, 0.3);
  await page.click("#time-near");
  const near = rowsOf(await downloaded(page, "times-csv"));
  assert.ok(near.rows.length < all.rows.length / 2 && near.rows[0][0] > 0.2, `${near.rows.length} rows`);
  const svg = await downloaded(page, "times-svg");
  for (const text of ["velocity, mm/s", "acceleration, mm/s²", "jerk, mm/s³", "feed"])
    assert.ok(svg.includes(text), text);
  assert.ok((svg.match(/<polyline/g) ?? []).length > 20);
  const folder = join(built, "screenshots");
  mkdirSync(folder, { recursive: true });
  await page.click("#time-all");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#times-png")]);
  assert.equal(download.suggestedFilename(), "04-square.time.png");
  await download.saveAs(join(folder, "over-time.png"));
});

const blocks = 100_000;
const large = (() => {
  const lines = ["G21 G90 G64 P0.01 F3000"];
  for (let i = 1; i < blocks - 1; ++i) {
    const angle = i * 0.02;
    const radius = 20 + 60 * (i / blocks);
    lines.push(`G1 X${(radius * Math.cos(angle)).toFixed(3)} Y${(radius * Math.sin(angle)).toFixed(3)}`);
  }
  return `${lines.join("\n")}\nM2\n`;
})();

/** Of the page's main thread, ms: by the processor's time, and by the clock, which others who have the processors stretch. What
 * the browser sweeps of its memory meanwhile is no task of the page. */
function longestTasks({ traceEvents }) {
  const threads = traceEvents.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const tasks = traceEvents.filter(
    ({ name, pid, tid, args }) =>
      name === "ThreadControllerImpl::RunTask" &&
      !args.src_file?.includes("/heap/") &&
      threads.some((each) => each.pid === pid && each.tid === tid),
  );
  const most = (field) => Math.round(Math.max(...tasks.map((task) => task[field] ?? 0)) / 1000);
  return { worked: most("tdur"), lasted: most("dur") };
}

test(
  "100 000 blocks: progress is seen, the page stays free, it can be cancelled, and is planned",
  { timeout: 240_000 },
  async () => {
    const { page } = opened;
    await browser.startTracing(page, { categories: ["toplevel", "__metadata"] });
    // By its path: the test's own way of handing over bytes would keep the page busy.
    const folder = mkdtempSync(join(tmpdir(), "leadscrew-web-"));
    writeFileSync(join(folder, "large.ngc"), large);
    await page.setInputFiles("#file", join(folder, "large.ngc"));
    await page.waitForSelector("#cancel", { state: "visible" });
    rmSync(folder, { recursive: true });
    await page.waitForFunction(() => document.querySelector("#progress").value > 0.02);
    await page.click("#cancel");
    assert.equal(await planned(page), "cancelled");
    assert.match(await page.textContent("#said"), /Cancelled/);
    await page.fill("#limit-tolerance", "0.011");
    await page.press("#limit-tolerance", "Enter");
    await page.waitForSelector("#cancel", { state: "visible" });
    await page.waitForFunction(() => document.querySelector(".program").dataset.state === "ready", undefined, {
      timeout: 200_000,
    });
    assert.equal(await figure(page, "Blocks"), blocks.toLocaleString("en"));
    await page.waitForTimeout(300);
    const { worked, lasted } = longestTasks(JSON.parse(await browser.stopTracing()));
    console.log(`tasks of the page work for ${worked} ms at most, and last ${lasted} ms`);
    assert.ok(worked > 5 && worked <= 100, `a task works for ${worked} ms`);
    assert.ok(lasted <= 1000, `a task lasts ${lasted} ms`);
    await page.click("#machine-reset");
    await choose(page, "04-square");
  },
);

test("Tab comes to every control, and shows where it is", async () => {
  const { page } = opened;
  await write(page, "G21 G90 G1 X100 Y50 F60000\nM2\n");
  const leave = async (of) => {
    const isInside = await of.evaluate(() => document.activeElement?.closest(".cm-editor") !== null);
    if (isInside) await of.keyboard.press("Escape");
  };
  const stops = await tabbed(page, leave);
  assert.deepEqual(
    stops.filter(({ isSeen }) => !isSeen).map(({ name }) => name),
    [],
  );
  assert.deepEqual(await missedByTab(page), []);
});

test("keys do what the mouse does", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  await page.evaluate(() => document.activeElement?.blur());
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.equal(await timeOf(page), 0.002);
  await page.keyboard.press("ArrowLeft");
  assert.equal(await timeOf(page), 0.001);
  await page.keyboard.press("Shift+ArrowRight");
  assert.equal(await timeOf(page), 0.101);
  await page.keyboard.press("End");
  assert.equal(await timeOf(page), Number(await page.getAttribute("#time", "max")));
  await page.keyboard.press("Home");
  await page.keyboard.press(" ");
  await page.waitForFunction(() => Number(document.querySelector("#time").value) > 0.05);
  await page.keyboard.press(" ");
  await page.focus("#space");
  const before = await downloaded(page, "export-svg");
  await page.focus("#space");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("+");
  assert.notEqual(await downloaded(page, "export-svg"), before);
  await page.focus("#space");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("0");
  assert.equal(await downloaded(page, "export-svg"), before);
});

for (const theme of ["light", "dark"]) {
  test(`axe finds nothing serious, ${theme}`, async () => {
    const { page } = opened;
    await page.selectOption("header select", theme);
    await choose(page, "01-plate");
    await page.waitForTimeout(300);
    assert.deepEqual(await seriousFindings(page), []);
    await write(page, "G21 G90 G1 X1Q F600\nG1 X100 F60000\nM2\n");
    assert.deepEqual(await seriousFindings(page), []);
    await page.selectOption("header select", "auto");
  });
}

test("a link brings text, machine, colours and time back", async () => {
  const { page } = opened;
  const text = "G21 G90 F1200\n(größer)\nG1 X30 Y10\nG2 X50 Y10 I10 J0\nM2\n";
  await write(page, text, "mine.ngc");
  await page.selectOption("#colouring", "jerk");
  await page.fill("#limit-velocity-Y", "20");
  await page.press("#limit-velocity-Y", "Enter");
  await planned(page);
  await setTime(page, 0.5);
  await page.focus("#space");
  for (const key of ["+", "+", "ArrowLeft", "Shift+ArrowUp"]) await page.keyboard.press(key);
  await page.click("#time-near");
  await page.waitForFunction(() => ["t=0.500", "&z=", "&v3=", "&s="].every((each) => location.hash.includes(each)));
  await page.waitForTimeout(1000);
  const hash = new URL(page.url()).hash;
  const other = await openProgram(browser, page.url());
  assert.equal(await other.page.inputValue("#colouring"), "jerk");
  assert.equal(await other.page.inputValue("#limit-velocity-Y"), "20");
  assert.equal(await timeOf(other.page), 0.5);
  assert.equal(await downloaded(other.page, "save"), text);
  assert.equal(await figure(other.page, "Time"), await figure(page, "Time"));
  await other.page.waitForTimeout(1000);
  assert.equal(new URL(other.page.url()).hash, hash); // camera and stretch of time as well
  await other.close();
  await page.click("#view-fit");
  await page.click("#time-all");
  await page.click("#machine-reset");
  await planned(page);
});

test("of two links, one behind the other, the last is shown", async () => {
  const { page } = opened;
  const link = new URL(page.url()).hash;
  await write(page, "G21 G90 F1200\nG1 X7\nM2\n");
  await page.waitForFunction((before) => location.hash !== before, link);
  const run = await page.getAttribute(".program", "data-run");
  await page.evaluate((last) => {
    location.hash = "";
    location.hash = last;
  }, link);
  await page.waitForFunction((before) => document.querySelector(".program").dataset.run !== before, run);
  assert.equal(await planned(page), "ready");
  assert.match(await downloaded(page, "save"), /größer/);
  assert.deepEqual(opened.failures, []);
});

test("one file runs from disk, and asks for nothing", async () => {
  const { page, strays, failures, close } = await openProgram(browser, programAddress);
  assert.equal(await choose(page, "03-arcs-in-three-planes"), "ready");
  const folder = join(built, "screenshots");
  mkdirSync(folder, { recursive: true });
  const expected = nativeWords(folder, exampleText("03-arcs-in-three-planes"));
  assertSameWords(rowsOf(await downloaded(page, "export-csv")), expected);
  assert.deepEqual(strays, []);
  assert.deepEqual(failures, []);
  await close();
});

test("nothing leaves the page that is served", () => {
  assert.deepEqual(opened.strays, []);
  assert.deepEqual(opened.failures, []);
});

test("pictures, light and dark", async () => {
  const folder = join(built, "screenshots");
  mkdirSync(folder, { recursive: true });
  const { page, close } = await openProgram(browser, address);
  await choose(page, "01-plate");
  await setTime(page, 4.2);
  for (const theme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: theme });
    for (const width of [1280, 1024, 390]) {
      await resized(page, width);
      const over = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.ok(over <= 0, `at ${width} px it is ${over} px too wide`);
      await page.screenshot({ path: join(folder, `program-${theme}-${width}.png`), fullPage: true });
    }
  }
  await close();
});
