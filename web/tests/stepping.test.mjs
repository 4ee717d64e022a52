// Steps back are exact, runs make every cycle, breakpoints stop where they say, links bring all of it back.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import {
  choose,
  click,
  clockOf,
  openBrowser,
  openPage,
  serve,
  settled,
  signatureOf,
  stateOf,
  tableOf,
} from "./browser.mjs";

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

async function set(page, values) {
  for (const [id, value] of Object.entries(values)) {
    const isChoice = (await page.$eval(`#${id}`, (element) => element.tagName)) === "SELECT";
    await (isChoice ? page.selectOption(`#${id}`, value) : page.fill(`#${id}`, value));
    await settled(page);
  }
}

/** A circle of 1886 cycles, far more than lie between two snapshots of the engine. */
async function longCircle(page) {
  await choose(page, "koren-circle");
  await set(page, { startX: "300", endX: "300" });
}

test("a step back and one on are the identity at 1000 random places", async () => {
  const { page } = lesson;
  await longCircle(page);
  const found = await page.evaluate(async () => {
    const lesson = document.querySelector(".lesson");
    const scrub = document.querySelector("#scrub");
    const told = async () => {
      if (lesson.dataset.told === lesson.dataset.clock) return;
      await new Promise((resolve) => {
        const watch = new MutationObserver(() => {
          if (lesson.dataset.told !== lesson.dataset.clock) return;
          watch.disconnect();
          resolve();
        });
        watch.observe(lesson, { attributeFilter: ["data-told"] });
      });
    };
    const texts = (selector, of = (each) => each.textContent) =>
      [...document.querySelectorAll(selector)].map(of).join("|");
    const all = () =>
      [
        texts(".numbers dd"),
        texts("#why p"),
        texts("tr.now td"),
        texts(".wire", (each) => each.getAttribute("aria-label") + each.classList),
        texts(".block-value"),
      ].join("\n");
    const last = Number(scrub.max);
    document.documentElement.style.display = "none"; // words and pictures are made all the same; only nobody paints them
    let state = 1980;
    const seen = new Set();
    for (let i = 0; i < 1000; ++i) {
      state = (state * 1103515245 + 12345) % 2147483648;
      const clock = 1 + (state % last);
      scrub.value = String(clock);
      scrub.dispatchEvent(new Event("input"));
      await told();
      const before = all();
      seen.add(before);
      const frames = () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      if (i % 100 === 0) await frames();
      const picture = i % 100 === 0 ? document.querySelector("#graph").toDataURL() : "";
      document.querySelector("#back").click();
      await told();
      if (Number(lesson.dataset.clock) !== clock - 1)
        return `clock ${clock}: a step back leads to ${lesson.dataset.clock}`;
      if (all() === before) return `clock ${clock}: a step back changes nothing`;
      document.querySelector("#step").click();
      await told();
      if (all() !== before) return `clock ${clock}:\n${before}\nis not\n${all()}`;
      if (picture !== "") await frames();
      if (picture !== "" && document.querySelector("#graph").toDataURL() !== picture)
        return `clock ${clock}: the picture`;
    }
    document.documentElement.style.display = "";
    return seen.size;
  });
  assert.equal(typeof found, "number", String(found));
  assert.ok(found > 500, `only ${found} places differ`);
});

test("a run makes every cycle, however fast", async () => {
  const { page } = lesson;
  await choose(page, "circle-10");
  for (const interval of ["0", "0.002"]) {
    await click(page, "first");
    await page.fill("#interval", interval);
    await page.click("#run");
    await page.waitForFunction(() => document.querySelector(".lesson").dataset.state === "done");
    await settled(page);
    const { rows } = await tableOf(page);
    assert.deepEqual(
      rows.map((row) => row[0]),
      [...Array(105).keys()],
    );
  }
  assert.match(await page.textContent("#interpolation-time"), /^0\.2\d s$/);
});

test("the module waits for its switch, polled at its delay", async () => {
  const { page } = lesson;
  await choose(page, "line-11-7");
  await set(page, { polling: "0.4", interval: "0.001" });
  const start = Date.now();
  await page.click("#start-switch");
  assert.equal(await stateOf(page), "waiting");
  await page.waitForFunction(() => document.querySelector(".lesson").dataset.state !== "waiting");
  assert.ok(Date.now() - start >= 350, `it waited ${Date.now() - start} ms`);
  await page.waitForFunction(() => document.querySelector(".lesson").dataset.state === "done");
  assert.equal(await clockOf(page), 16);
});

test("breakpoints stop before a pulse and at a quadrant's border", async () => {
  const { page } = lesson;
  await choose(page, "across-quadrants");
  await page.fill("#interval", "0");
  const run = async () => {
    await page.click("#run");
    await page.waitForFunction(() => /breakpoint|done/.test(document.querySelector(".lesson").dataset.state));
    await settled(page);
    return await clockOf(page);
  };
  const table = await (async () => {
    await click(page, "last");
    const all = await tableOf(page);
    await click(page, "first");
    return all;
  })();
  const of = (clock, name) => table.rows[clock][table.columns.indexOf(name)];
  await page.check("#stop-border");
  const borders = table.rows
    .map((_, clock) => clock)
    .filter((clock) => clock > 0 && of(clock, "quadrant") !== of(clock - 1, "quadrant"));
  assert.equal(borders.length, 3);
  for (const border of borders) assert.equal(await run(), border);
  assert.equal(await run(), 80);
  await page.uncheck("#stop-border");
  await page.check("#stop-pulse");
  await click(page, "first");
  for (let i = 0, last = -1; i < 5; ++i) {
    const clock = await run();
    assert.ok(clock > last);
    for (let between = Math.max(last + 2, 1); between <= clock; ++between)
      assert.equal(Math.abs(of(between, "dx")) + Math.abs(of(between, "dy")), 0);
    assert.ok(of(clock + 1, "dx") !== 0 || of(clock + 1, "dy") !== 0);
    last = clock;
  }
  await page.uncheck("#stop-pulse");
});

test("a link brings everything back", async () => {
  const { page } = lesson;
  await choose(page, "circle-10");
  await set(page, {
    method: "koren",
    bits: "",
    capacity: "12",
    preload: "full",
    order: "growing-first",
    feed: "7",
    view: "near",
  });
  await page.check("#stop-border");
  await page.evaluate(() => {
    const scrub = document.querySelector("#scrub");
    scrub.value = "37";
    scrub.dispatchEvent(new Event("input"));
  });
  await settled(page);
  await page.waitForTimeout(500);
  const link = page.url();
  const other = await openPage(browser, link);
  assert.equal(await clockOf(other.page), 37);
  assert.equal(await signatureOf(other.page), await signatureOf(page));
  assert.equal(await other.page.textContent("#command"), await page.textContent("#command"));
  assert.ok(await other.page.isChecked("#stop-border"));
  for (const id of ["method", "capacity", "preload", "order", "feed", "view", "startX"])
    assert.equal(await other.page.inputValue(`#${id}`), await page.inputValue(`#${id}`), id);
  await other.close();
  await page.uncheck("#stop-border");
});

test("a link brings back an ellipse, and an arc without counters", async () => {
  const { page } = lesson;
  for (const preset of ["ellipse-hardware", "koren-half-turn-strict"]) {
    await choose(page, preset);
    await click(page, "step");
    await page.waitForTimeout(500);
    const other = await openPage(browser, page.url());
    assert.equal(await signatureOf(other.page), await signatureOf(page));
    assert.equal(await other.page.textContent("#command"), await page.textContent("#command"));
    assert.equal(await other.page.inputValue("#preset"), preset);
    await other.close();
  }
});

test("a prediction is judged by the cycle that follows", async () => {
  const { page } = lesson;
  await choose(page, "line-11-7");
  await page.check("#predict");
  await page.click('.pad button[data-x="1"][data-y="1"]');
  await settled(page);
  assert.equal(await page.textContent("#verdict"), "Not so: no pulse. 0 of 1 right.");
  await page.click('.pad button[data-x="1"][data-y="0"]');
  await settled(page);
  assert.equal(await page.textContent("#verdict"), "Right: X +1, Y 0. 1 of 2 right.");
  assert.equal(await clockOf(page), 2);
  assert.equal(
    await page.textContent("#why"),
    "Jx 11 + rx 11 = 22 ≥ 16: overflow, X +1, rx 6Jy 7 + ry 7 = 14 < 16: no overflow, ry 14",
  );
  await page.uncheck("#predict");
});

test("nothing failed and nothing left the page", () => {
  assert.deepEqual([...new Set(lesson.failures)].slice(0, 5), []);
  assert.deepEqual(lesson.strays, []);
});
