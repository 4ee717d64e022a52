// For everyone: every control by keyboard with visible focus, no serious finding of axe, messages at the fields, files.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { missedByTab, seriousFindings, tabbed } from "./axe.mjs";
import { choose, click, clockOf, openBrowser, openPage, serve, settled, stateOf } from "./browser.mjs";

let server, browser, lesson;
before(async () => {
  server = await serve();
  browser = await openBrowser();
  lesson = await openPage(browser, server.address);
});
after(async () => {
  await browser?.close();
  server?.close();
});

for (const preset of ["line-11-7", "across-quadrants", "fpga-min", "ellipse", "koren-half-turn"]) {
  test(`${preset}: Tab comes to every control, and shows where it is`, async () => {
    const { page } = lesson;
    await choose(page, preset);
    await page.check("#predict");
    await click(page, "step");
    const stops = await tabbed(page);
    const unseen = stops.filter(({ isSeen }) => !isSeen).map(({ name }) => name);
    assert.deepEqual(unseen, []);
    const missed = await missedByTab(page);
    assert.deepEqual(missed, []);
    await page.uncheck("#predict");
  });
}

test("keys do what the mouse does", async () => {
  const { page } = lesson;
  await choose(page, "circle-10");
  const press = async (id, key) => {
    await page.focus(id);
    await page.keyboard.press(key);
    await settled(page);
    return await clockOf(page);
  };
  assert.equal(await press("#step", "Enter"), 1);
  assert.equal(await press("#step", " "), 2);
  assert.equal(await press("#back", "Enter"), 1);
  assert.equal(await press("#scrub", "ArrowRight"), 2);
  assert.equal(await press("#last", "Enter"), 104);
  assert.equal(await press("#scrub", "Home"), 0);
  assert.ok((await press("#next-pulse", "Enter")) > 0);
  assert.ok((await press("#next-border", "Enter")) > 10);
  assert.equal(await press("#first", "Enter"), 0);
  await page.evaluate(() => document.activeElement?.blur());
  for (const [key, clock] of [
    ["ArrowRight", 1],
    ["ArrowRight", 2],
    ["ArrowLeft", 1],
    ["End", 104],
    ["Home", 0],
  ]) {
    await page.keyboard.press(key);
    await settled(page);
    assert.equal(await clockOf(page), clock, key);
  }
  await page.keyboard.press(" ");
  assert.equal(await stateOf(page), "running");
  await page.keyboard.press(" ");
  assert.notEqual(await stateOf(page), "running");
  await press("#mode-automatic", "ArrowRight");
  assert.ok(await page.isChecked("#mode-single"));
  assert.ok(await page.isDisabled("#run"));
  await press("#mode-single", "ArrowLeft");
  await press("#start-switch", " ");
  assert.match(await stateOf(page), /waiting|running/);
  await press("#start-switch", " ");
  await press("#module-arc", "ArrowLeft");
  assert.equal(await page.getAttribute(".lesson", "data-module"), "line");
  assert.equal(await page.evaluate(() => document.activeElement.id), "module-line");
  await page.focus(".wire");
  assert.match(await page.textContent("#probe"), /^Jx into the sum: \d+$/);
});

for (const theme of ["light", "dark"]) {
  test(`axe finds nothing serious, ${theme}`, async () => {
    const { page } = lesson;
    await page.selectOption("header select", theme);
    for (const preset of ["line-11-7", "across-quadrants", "fpga-improved"]) {
      await choose(page, preset);
      await page.check("#predict");
      await click(page, "step");
      await page.waitForTimeout(250);
      const serious = await seriousFindings(page);
      assert.deepEqual(serious, [], preset);
      await page.uncheck("#predict");
    }
  });
}

test("what is wrong is said at its field, with what would be right", async () => {
  const { page } = lesson;
  const cases = [
    ["line-11-7", { endX: "abc" }, "endX", /no whole number.*such as 5/],
    ["line-11-7", { endX: "" }, "endX", /missing/],
    ["line-11-7", { endX: "99" }, "endX", /register Jx of 4 bits holds no more than 15.*7 bits would hold it/],
    ["line-11-7", { endX: "0", endY: "0" }, "endX", /where it starts.*a full circle is an arc/],
    ["circle-10", { centerX: "10" }, "centerX", /radius is 0.*a centre away from the start/],
    ["circle-10", { endX: "9" }, "endX", /9\.000 BLU from the centre.*half a BLU/],
    ["circle-10", { bits: "31" }, "bits", /from 1 to 30/],
    ["circle-10", { capacity: "12" }, "capacity", /leave one of the two empty/],
    ["line-11-7", { feed: "0" }, "feed", /more than 0/],
    ["line-11-7", { interval: "-1" }, "interval", /0 \(as fast as can be\)/],
    ["line-11-7", { polling: "0" }, "polling", /0\.01 to 60/],
    ["line-11-7", { bits: "20" }, "endX", /131,072 clocks/],
  ];
  for (const [preset, values, field, message] of cases) {
    await choose(page, preset);
    for (const [id, value] of Object.entries(values)) await page.fill(`#${id}`, value);
    await settled(page);
    assert.match(await page.textContent(`#${field}-error`), message, JSON.stringify(values));
    assert.equal(await page.getAttribute(`#${field}`, "aria-invalid"), "true");
    for (const [id] of Object.entries(values))
      if (id === "interval" || id === "polling" || id === "feed") await page.fill(`#${id}`, "0.5");
  }
  await choose(page, "line-11-7");
  assert.equal(await page.$$eval("[aria-invalid]", (all) => all.length), 0);
});

test("files hold what is shown", async () => {
  const { page } = lesson;
  await choose(page, "line-11-7");
  await click(page, "last");
  const save = async (kind) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#save-${kind}`)]);
    assert.match(download.suggestedFilename(), new RegExp(`\\.${kind}$`));
    return readFileSync(await download.path());
  };
  const csv = String(await save("csv"))
    .trim()
    .split("\n");
  assert.equal(csv.length, 18);
  assert.equal(csv[0].split(",")[0], "clock");
  assert.match(csv[17], /^16,1,1,11,7,11,7,/);
  const picture = String(await save("svg"));
  assert.match(picture, /^<svg xmlns=.*<title>The true line from \(0, 0\) to \(11, 7\)/);
  assert.equal(
    await page.evaluate(
      (text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror"),
      picture,
    ),
    null,
  );
  assert.equal((await save("png")).subarray(1, 4).toString(), "PNG");
  const dump = String(await save("vcd"));
  assert.match(dump, /\$var integer 64 . rx \$end/);
  assert.match(dump, /\n#16\n/);
});

test("nothing failed and nothing left the page", () => {
  assert.deepEqual([...new Set(lesson.failures)].slice(0, 5), []);
  assert.deepEqual(lesson.strays, []);
});
