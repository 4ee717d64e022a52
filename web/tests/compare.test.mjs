// Methods beside one another: each row of figures is the native command's, on one clock; the link brings all of it back.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { missedByTab, seriousFindings, tabbed } from "./axe.mjs";
import { built, choose, click, commandOf, native, nativeTable, openBrowser, openPage, serve } from "./browser.mjs";

let server, browser, compare;
before(async () => {
  server = await serve();
  browser = await openBrowser();
  compare = await open(`${server.address}compare.html`);
});
after(async () => {
  await browser?.close();
  server?.close();
});

async function open(address, options = {}) {
  return await openPage(browser, address, { ready: loaded, ...options });
}

async function loaded(page) {
  await page.waitForFunction(() => {
    const all = document.querySelector(".compare");
    return all !== null && all.dataset.loaded !== undefined && all.dataset.loading === all.dataset.loaded;
  });
}

async function chooseComparison(page, id) {
  await page.selectOption("#comparison", id);
  await loaded(page);
}

async function press(page, id) {
  await page.click(`#${id}`);
  await loaded(page);
}

/** Cells of the table, by the names of its columns. */
async function rowsOf(page) {
  return await page.$$eval(".figures tr[data-lane]", (all) => {
    const columns = [...document.querySelectorAll(".figures thead th")].map((each) => each.textContent);
    return all.map((row) => {
      const below = row.nextElementSibling;
      return {
        ...Object.fromEntries([...row.cells].map((cell, i) => [columns[i], cell.textContent.replaceAll("−", "-")])),
        Published: below?.className === "paper" ? below.cells[1].textContent : "",
      };
    });
  });
}

/** The words of the command of each method. */
async function commandsOf(page) {
  return (await page.textContent("#commands")).split("\n").map((line) => line.split(" ").slice(1));
}

const idsOf = async (page) =>
  (await page.$$eval("#comparison option", (all) => all.map((each) => each.value))).filter((id) => id !== "");

test("figures of every comparison are the command's", async () => {
  const { page } = compare;
  const ids = await idsOf(page);
  assert.ok(ids.length >= 7);
  for (const id of ids) {
    await chooseComparison(page, id);
    await press(page, "last");
    const rows = await rowsOf(page);
    const commands = await commandsOf(page);
    assert.equal(rows.length, commands.length);
    for (const [i, row] of rows.entries()) {
      const [expected] = JSON.parse(native(commands[i])).methods;
      const what = `${id} ${i + 1}`;
      assert.equal(row.Clocks, String(expected.clocks), what);
      assert.equal(row.Pulses, String(expected.pulses), what);
      assert.equal(row["Greatest error"], expected.max_error_blu.toFixed(3), what);
      assert.equal(row["RMS error"], expected.rms_error_blu.toFixed(3), what);
      assert.equal(row.End, `(${expected.end.join(", ")})`, what);
    }
  }
});

test("the paper's row stands beside those that reproduce it, and nowhere else", async () => {
  const { page } = compare;
  await chooseComparison(page, "fpga");
  await press(page, "last");
  const rows = await rowsOf(page);
  for (const [i, [steps, error]] of [
    [10, ".877"],
    [8, ".385"],
    [7, ".385"],
    [7, ".385"],
  ].entries()) {
    assert.match(rows[i].Published, new RegExp(`^${steps} steps.* error \\${error} \\(FPGA-based`));
    assert.equal(rows[i].Clocks, String(steps));
    assert.equal(rows[i]["Greatest error"], `0${error}`);
  }
  for (const change of [
    { endX: "5", endY: "0" },
    { startX: "0", startY: "5" },
  ]) {
    for (const [id, value] of Object.entries(change)) await page.fill(`#${id}`, value);
    await loaded(page);
    const all = await rowsOf(page);
    assert.equal(all.length, 4);
    for (const row of all) assert.equal(row.Published, "");
  }
});

/** Of the steps of `pulse --table`: their length, and how far 16 clocks of them are from the mean. */
function wayOf(rows, columns) {
  const [x, y] = ["dx", "dy"].map((name) => columns.indexOf(name));
  const steps = rows.slice(1).map((row) => Math.hypot(row[x], row[y]));
  const sum = (some) => some.reduce((all, each) => all + each, 0);
  const mean = (16 * sum(steps)) / steps.length;
  const windows = steps.slice(15).map((_, i) => sum(steps.slice(i, i + 16)));
  return { length: sum(steps), ripple: Math.max(...windows.map((each) => Math.abs(each - mean))) / mean };
}

/** Of the steps of `pulse --table`: the greatest difference of this order of X or Y, over steps of 16 clocks. */
function differenceOf(rows, columns, order) {
  let greatest = -1;
  for (const name of ["dx", "dy"]) {
    const at = columns.indexOf(name);
    let values = rows.map((_, i) => rows.slice(1, i + 1).reduce((place, row) => place + row[at], 0));
    for (let k = 0; k < order; ++k) values = values.slice(16).map((value, i) => value - values[i]);
    greatest = Math.max(greatest, ...values.map(Math.abs));
  }
  return greatest < 0 ? "" : String(greatest);
}

test("length, ripple, acceleration and jerk follow from the command's rows", async () => {
  const { page } = compare;
  for (const id of ["bits", "loads"]) {
    await chooseComparison(page, id);
    await press(page, "last");
    const rows = await rowsOf(page);
    const commands = await commandsOf(page);
    for (const [i, row] of rows.entries()) {
      const table = nativeTable(commands[i].map((word) => (word === "--json" ? "--table" : word)));
      const { length, ripple } = wayOf(table.rows, table.columns);
      assert.ok(Math.abs(Number(row.Length) - length) <= 0.005 + 1e-9, `${row.Length} ${length}`);
      assert.ok(Math.abs(parseFloat(row.Ripple) - 100 * ripple) <= 0.05 + 1e-9, `${row.Ripple} ${ripple}`);
      assert.equal(row.Acceleration, differenceOf(table.rows, table.columns, 2));
      assert.equal(row.Jerk, differenceOf(table.rows, table.columns, 3));
    }
  }
});

test("time at the feed is that of the clock: q/L or q/R clocks a BLU, of integrators alone", async () => {
  const { page } = compare;
  await chooseComparison(page, "line");
  await press(page, "last");
  await page.fill("#feed", "8.5");
  const timesOf = async () => (await rowsOf(page)).map(({ Time }) => Time);
  const time = (16 / ((16 / Math.hypot(11, 7)) * 8.5)).toFixed(2);
  assert.deepEqual(await timesOf(), [time, time, "", ""]);
  await page.fill("#feed", "-1");
  assert.match(await page.textContent("#feed-error"), /more than 0 BLU\/s/);
  assert.deepEqual(await timesOf(), ["", "", "", ""]);
  await page.focus("#feed-slider");
  await page.keyboard.press("End");
  assert.equal(await page.inputValue("#feed"), "500");
  await page.fill("#feed", "10");
});

test("all of them stand at the same clock", async () => {
  const { page } = compare;
  await chooseComparison(page, "line");
  for (let i = 0; i < 9; ++i) await page.click("#step");
  await page.click("#back");
  const rows = await rowsOf(page);
  const commands = await commandsOf(page);
  for (const [i, row] of rows.entries()) {
    const { rows: all, columns } = nativeTable(commands[i].map((word) => (word === "--json" ? "--table" : word)));
    const until = all.slice(1, 9);
    const pulses = until.filter((each) => each[columns.indexOf("dx")] !== 0 || each[columns.indexOf("dy")] !== 0);
    assert.equal(row.Clocks, "8");
    assert.equal(row.Pulses, String(pulses.length));
  }
  await page.fill("#interval", "0");
  await page.click("#run");
  await page.waitForFunction(() => document.querySelector(".compare").dataset.state === "stopped");
  assert.equal(await page.textContent("#position"), "18 of 18");
  assert.deepEqual(
    (await rowsOf(page)).map((row) => row.Clocks),
    ["16", "16", "11", "18"],
  );
});

test("methods are added and removed, up to four, and messages stand at their fields", async () => {
  const { page } = compare;
  await chooseComparison(page, "line");
  assert.ok(await page.isDisabled("#add-lane"));
  await press(page, "remove-4");
  await press(page, "remove-1");
  assert.equal((await rowsOf(page)).length, 2);
  await press(page, "add-lane");
  assert.equal((await rowsOf(page)).length, 3);
  await page.fill("#bits-1", "3");
  await loaded(page);
  const said = (await page.$$eval(".error", (all) => all.map((each) => each.textContent))).join(" ");
  assert.match(said, /4 bits would hold it/);
  assert.equal((await rowsOf(page)).length, 2);
  await page.fill("#bits-1", "some");
  await loaded(page);
  assert.match(await page.textContent("#bits-1-error"), /whole number from 1 to 30/);
  await chooseComparison(page, "ellipse");
  await page.selectOption("#method-2", "bresenham");
  await loaded(page);
  assert.match(await page.textContent("#method-2-error"), /ellipses are for dda and koren/);
  await page.fill("#semiY", "0");
  await loaded(page);
  assert.match(await page.textContent("#semiY-error"), /a semi-axis is 1 BLU or more/);
});

/** Of all canvases that are seen. */
async function picturesOf(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return await page.$$eval("canvas", (all) =>
    all.filter((each) => each.checkVisibility()).map((each) => each.toDataURL()),
  );
}

test("a link brings everything back", async () => {
  const { page } = compare;
  await chooseComparison(page, "loads");
  await page.selectOption("#order-2", "growing-first");
  await loaded(page);
  await page.selectOption("#layout", "beside");
  await page.click("#nearer");
  await page.focus(".path-frame");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("+");
  await page.evaluate(() => {
    const scrub = document.querySelector("#scrub");
    scrub.value = "29";
    scrub.dispatchEvent(new Event("input"));
  });
  await page.waitForTimeout(500);
  await page.evaluate(() => document.activeElement.blur());
  const other = await open(page.url());
  assert.deepEqual(await rowsOf(other.page), await rowsOf(page));
  assert.equal(await other.page.textContent("#commands"), await page.textContent("#commands"));
  assert.equal(await other.page.textContent("#position"), await page.textContent("#position"));
  assert.equal(await other.page.inputValue("#layout"), "beside");
  assert.deepEqual(await picturesOf(other.page), await picturesOf(page));
  await other.close();
});

test("the lesson's curve is laid beside other methods", async () => {
  const lesson = await openPage(browser, server.address);
  await choose(lesson.page, "ellipse");
  await click(lesson.page, "last");
  const command = await commandOf(lesson.page);
  await lesson.page.click("#to-compare");
  await loaded(lesson.page);
  const commands = await commandsOf(lesson.page);
  assert.deepEqual(
    commands.map((words) => words[words.indexOf("--method") + 1]),
    ["koren", "dda"],
  );
  assert.deepEqual(
    commands[0],
    command.map((word) => (word === "--table" ? "--json" : word)),
  );
  assert.equal(await lesson.page.textContent("#position"), "74 of 78");
  assert.deepEqual(lesson.failures, []);
  await lesson.close();
});

test("keys do what the mouse does", async () => {
  const { page } = compare;
  await chooseComparison(page, "fpga");
  await page.selectOption("#layout", "overlay");
  await page.click("#whole");
  await press(page, "first");
  await page.focus("#content");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.textContent("#position"), "2 of 10");
  await page.keyboard.press("End");
  assert.equal(await page.textContent("#position"), "10 of 10");
  const [whole] = await picturesOf(page);
  await page.focus(".path-frame");
  await page.keyboard.press("+");
  await page.keyboard.press("ArrowUp");
  assert.equal(await page.textContent("#position"), "10 of 10");
  const [near] = await picturesOf(page);
  assert.notEqual(near, whole);
  await page.keyboard.press("0");
  const [again] = await picturesOf(page);
  assert.equal(again, whole);
});

test("Tab comes to every control, and shows where it is", async () => {
  const { page } = compare;
  await chooseComparison(page, "orders");
  await page.selectOption("#layout", "beside");
  const unseen = (await tabbed(page)).filter(({ isSeen }) => !isSeen).map(({ name }) => name);
  assert.deepEqual(unseen, []);
  assert.deepEqual(await missedByTab(page), []);
  await page.selectOption("#layout", "overlay");
});

test("axe finds nothing serious, light and dark, right and wrong", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const { page, close } = await open(`${server.address}compare.html`, { colorScheme });
    await press(page, "last");
    assert.deepEqual(await seriousFindings(page), []);
    await page.fill("#bits-2", "x");
    await loaded(page);
    assert.deepEqual(await seriousFindings(page), []);
    await close();
  }
});

test("files hold what is shown", async () => {
  const { page } = compare;
  await chooseComparison(page, "fpga");
  await press(page, "last");
  const save = async (kind) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#save-${kind}`)]);
    return readFileSync(await download.path());
  };
  const csv = String(await save("csv")).split("\n");
  assert.match(csv[0], /^method,conventions,clocks,pulses,/);
  assert.match(csv[2], /^DDA in hardware,"q = 5, half-lagging, parallel",8,7,1\.143,0\.80,/);
  const picture = String(await save("svg"));
  assert.match(picture, /^<svg xmlns=.*<title>The true counterclockwise arc from \(5, 0\) to \(0, 5\)/);
  const paths = [...picture.matchAll(/<polyline [^>]*stroke="(#\w+)" stroke-width="(2|4.4|6.8|9.2)"/g)];
  assert.equal(new Set(paths.map(([, colour, width]) => `${colour} ${width}`)).size, 5); // and the true curve
  assert.equal((await save("png")).subarray(1, 4).toString(), "PNG");
  const dump = String(await save("vcd"));
  assert.deepEqual(
    [...dump.matchAll(/\$scope module (\w+)/g)].map(([, name]) => name),
    ["point_comparison_1", "dda_2", "min_error_3", "improved_min_error_4"],
  );
  const marks = [...dump.matchAll(/\$var integer 64 (\S) /g)].map(([, mark]) => mark);
  assert.equal(new Set(marks).size, marks.length);
  assert.match(dump, /\n#10\n/);
});

for (const theme of ["light", "dark"]) {
  test(`one file from disk, and pictures of it, ${theme}`, async () => {
    const file = join(built, "file/compare.html");
    assert.ok(statSync(file).size < 400_000, `${statSync(file).size} bytes`);
    const folder = join(built, "screenshots");
    mkdirSync(folder, { recursive: true });
    const { page, strays, failures, close } = await open(pathToFileURL(file).href, { colorScheme: theme });
    for (const [id, layout] of [
      ["fpga", "overlay"],
      ["orders", "beside"],
      ["ellipse", "overlay"],
    ]) {
      await chooseComparison(page, id);
      await page.selectOption("#layout", layout);
      await press(page, "last");
      for (const width of [1280, 1024, 390]) {
        await page.setViewportSize({ width, height: 900 });
        await page.waitForTimeout(150);
        const over = await page.evaluate(
          () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
        );
        assert.ok(over <= 0, `${id} at ${width} px is ${over} px too wide`);
        await page.screenshot({ path: join(folder, `compare-${id}-${theme}-${width}.png`), fullPage: true });
      }
    }
    assert.deepEqual(strays, []);
    assert.deepEqual(failures, []);
    await close();
  });
}

test("nothing failed and nothing left the page", () => {
  assert.deepEqual([...new Set(compare.failures)].slice(0, 5), []);
  assert.deepEqual(compare.strays, []);
});
