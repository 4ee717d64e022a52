// The page shows what the machine does: its rows and figures are those of the native command.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import {
  choose,
  click,
  commandOf,
  native,
  nativeTable,
  numbersOf,
  openBrowser,
  openPage,
  serve,
  settled,
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

/** The rows that the lesson's specification refers to: preset, curve, clocks, pulses, error. */
const references = [
  ["line-across", "--line --start 3,4 --end -9,-6 --bits 4", 16, 14, ".512"],
  ["across-quadrants", "--arc --start 6,8 --end -8,6 --center 0,0 --cw --bits 4", 80, 52, "1.180"],
  ["circle-10", "--arc --start 10,0 --end 10,0 --center 0,0 --ccw --bits 4", 104, 68, "1.180"],
  ["line-11-7", "--line --end 11,7 --bits 4", 16, 13, ".690"],
  ["one-quadrant", "--arc --start 5,0 --end 0,5 --center 0,0 --ccw --bits 3", 14, 8, ".831"],
];

for (const [preset, curve, clocks, pulses, error] of references) {
  test(`${preset}: each row of the table is the command's`, async () => {
    const { page } = lesson;
    await choose(page, preset);
    await click(page, "last");
    const args = ["pulse", "--method", "dda", "--preload", "zero", ...curve.split(" "), "--table"];
    const expected = nativeTable(args);
    const shown = await tableOf(page);
    assert.equal(expected.rows.length, clocks + 1);
    assert.equal(shown.rows.length, expected.rows.length);
    const places = expected.columns.map((name) => shown.columns.indexOf(name));
    assert.ok(!places.includes(-1), `${expected.columns} are not all among ${shown.columns}`);
    shown.rows.forEach((row, clock) =>
      assert.deepEqual(
        places.map((place) => row[place]),
        expected.rows[clock],
        `clock ${clock}`,
      ),
    );
    const numbers = await numbersOf(page);
    assert.equal(numbers.Cycle, String(clocks));
    const quadrant = shown.columns.indexOf("quadrant");
    if (quadrant >= 0) assert.match(numbers.Quadrant, new RegExp(`^[IV]+ \\(${shown.rows.at(-1)[quadrant]}\\)$`));
    assert.equal(numbers.Pulses, String(pulses));
    assert.equal(numbers.Greatest, error.padStart(5, "0"));
    assert.equal(native(await commandOf(page)), native(args), "the command that the page shows prints something else");
  });
}

test("places and accumulations: each row of the table is the command's", async () => {
  const { page } = lesson;
  await choose(page, "circle-10");
  await page.fill("#bits", "");
  for (const [fill, ending] of [
    [{ places: "6" }, "counters"],
    [{ accumulation: "floor" }, "free"],
    [{ accumulation: "symmetric" }, "free"],
  ]) {
    await page.selectOption("#ending", ending);
    for (const [id, value] of Object.entries(fill))
      if (id === "places") await page.fill("#places", value);
      else await page.selectOption(`#${id}`, value);
    await settled(page);
    await click(page, "last");
    const words = await commandOf(page);
    for (const [id, value] of Object.entries(fill)) assert.equal(words[words.indexOf(`--${id}`) + 1], value);
    const expected = nativeTable(words);
    const shown = await tableOf(page);
    const places = expected.columns.map((name) => shown.columns.indexOf(name));
    assert.deepEqual(
      shown.rows.map((row) => places.map((place) => row[place])),
      expected.rows,
    );
    await page.click("#back");
    await settled(page);
    assert.match(await page.textContent("#why"), /J[xy] /);
  }
  await page.fill("#bits", "4");
  await page.selectOption("#ending", "counters");
  await settled(page);
  assert.match(await page.textContent("#places-error"), /leave bits and capacity empty/);
});

test("an ellipse: each row of the table is the command's", async () => {
  const { page } = lesson;
  for (const preset of ["ellipse", "ellipse-hardware"]) {
    await choose(page, preset);
    await click(page, "last");
    const expected = nativeTable(await commandOf(page));
    const shown = await tableOf(page);
    assert.equal(shown.rows.length, expected.rows.length);
    assert.ok(expected.rows.length > 60);
    const places = expected.columns.map((name) => shown.columns.indexOf(name));
    shown.rows.forEach((row, clock) =>
      assert.deepEqual(
        places.map((place) => row[place]),
        expected.rows[clock],
        `${preset}, clock ${clock}`,
      ),
    );
  }
});

/** All that is told at the end of what is set, `set` among it: asked for at once, since there are many of them. */
async function toldAtEnd(page, set) {
  return await page.evaluate(async (values) => {
    const lesson = document.querySelector(".lesson");
    const isSettled = () =>
      lesson.dataset.loading === lesson.dataset.loaded &&
      (lesson.dataset.state === "empty" || lesson.dataset.told === lesson.dataset.clock);
    const settle = async () => {
      do await new Promise((resume) => setTimeout(resume));
      while (!isSettled());
    };
    for (const [id, value] of Object.entries(values)) {
      const select = document.querySelector(`#${id}`);
      select.value = value;
      select.dispatchEvent(new Event("change"));
    }
    await settle();
    document.querySelector("#last").click();
    await settle();
    const text = (selector) => document.querySelector(selector).textContent;
    const numbers = [...document.querySelectorAll(".numbers > div")].map((each) => [
      each.dataset.name,
      each.querySelector("dd").textContent.replace("−", "-"),
    ]);
    return { numbers: Object.fromEntries(numbers), command: text("#command"), inForce: text("#in-force") };
  }, set);
}

/** Figures at the end of what is set, beside those of the page's own command. */
async function expectFigures(page, what, set = {}) {
  const { numbers, command, inForce } = await toldAtEnd(page, set);
  const args = command
    .split(" ")
    .slice(1)
    .map((word) => (word === "--table" ? "--json" : word));
  const [expected] = JSON.parse(native(args)).methods;
  assert.equal(numbers.Cycle, String(expected.clocks), what);
  assert.equal(numbers.Pulses, String(expected.pulses), what);
  assert.equal(numbers.Greatest, expected.max_error_blu.toFixed(3), what);
  assert.equal(numbers.RMS, expected.rms_error_blu.toFixed(3), what);
  assert.deepEqual([numbers.X, numbers.Y], expected.end.map(String), what);
  for (const key of ["preload", "order", "tie", "accumulation", "end_rule"])
    if (expected.options[key] !== undefined)
      assert.ok(inForce.includes(expected.options[key]), `${what}: ${key} of ${inForce}`);
  return numbers;
}

/** What else a paper has published of a preset, beside the page's own numbers; each is looked at by one of these. */
const publishedElsewhere = {
  "koren-half-turn": (numbers) => Math.round(Math.hypot(numbers.X, numbers.Y)) === 10001,
  "koren-half-turn-strict": (numbers) => Math.round(Math.hypot(numbers.X, numbers.Y)) === 10001,
  "koren-hardware": (_, { inForce, rate }) => inForce.includes("q = 120000") && rate > 0,
  "lecture-axes": (numbers, { rate }) =>
    numbers.X === "1500" && numbers.Y === "2000" && Math.abs(numbers.Cycle / rate - 30) < 0.03,
  // Its own last digits come of a length that it rounds: 29 308.59 would be exact.
  "lecture-line": (numbers, { rate }) =>
    Math.abs(rate - 29309.43) < 1 &&
    Math.floor((rate * numbers.X) / numbers.Cycle) === 4472 &&
    Math.floor((rate * numbers.Y) / numbers.Cycle) === 2236,
  "lecture-delays": (_, { rate, first }) =>
    Math.abs(first("dx") / rate - 2) < 0.002 && Math.abs(first("dy") / rate - 4) < 0.004,
  "lecture-delay": (_, { rate, first }) => Math.abs(first("dx") / rate - 8) < 0.008,
};

test("what the papers publish beside steps and errors", async () => {
  const { page } = lesson;
  for (const [preset, holds] of Object.entries(publishedElsewhere)) {
    await choose(page, preset);
    const args = (await commandOf(page)).filter((word) => word !== "--table");
    const [{ options }] = JSON.parse(native([...args, "--json"])).methods;
    await click(page, "last");
    const numbers = await numbersOf(page);
    const table = numbers.Cycle > 10000 ? undefined : nativeTable([...args, "--table"]);
    const first = (name) => table.rows.findIndex((row) => row[table.columns.indexOf(name)] !== 0);
    const inForce = await page.textContent("#in-force");
    const rate = Number(/runs at ([\d.e+]+) Hz/.exec(await page.textContent("#clock-rate"))?.[1]);
    assert.ok(holds(numbers, { inForce, rate, first }), `${preset}: ${JSON.stringify(numbers)} ${rate} ${inForce}`);
    assert.ok(inForce.includes(options.end_rule), preset);
  }
});

test("each preset has the command's figures, and those that a paper has published", async () => {
  const { page } = lesson;
  const presets = await page.$$eval("#preset option", (all) =>
    all.map((each) => each.value).filter((value) => value !== ""),
  );
  assert.ok(presets.length >= 10, String(presets));
  for (const preset of presets) {
    await choose(page, preset);
    const numbers = await expectFigures(page, preset);
    const published = (await page.textContent("#preset-source")).split("Published: ")[1] ?? "";
    const [, error] = / error (\.\d+)/.exec(published) ?? [];
    if (error !== undefined) assert.equal(numbers.Greatest, `0${error}`, preset);
    const [, steps] = /(\d+) (?:steps|cycles)/.exec(published) ?? [];
    if (steps !== undefined) assert.equal(numbers.Cycle, steps, preset);
    assert.ok(
      published === "" || error !== undefined || steps !== undefined || preset in publishedElsewhere,
      `nothing looks at what is published of ${preset}`,
    );
  }
});

test("every method and option has the command's figures", async () => {
  const { page } = lesson;
  const valuesOf = async (id) =>
    (await page.$$eval(`#${id} option`, (all) => all.map((each) => each.value))).filter((value) => value !== "");
  for (const preset of ["line-11-7", "across-quadrants", "ellipse"]) {
    await choose(page, preset);
    await page.fill("#bits", "");
    await page.selectOption("#preload", "");
    for (const method of preset === "ellipse" ? ["dda", "koren"] : await valuesOf("method")) {
      await expectFigures(page, `${preset} ${method}`, { method });
      for (const option of ["preload", "order", "tie", "ending"]) {
        if (!(await page.isVisible(`#${option}`))) continue;
        for (const value of await valuesOf(option))
          await expectFigures(page, `${preset} ${method} ${option} ${value}`, { [option]: value });
        await page.selectOption(`#${option}`, option === "ending" ? "counters" : "");
      }
    }
  }
});

test("nothing failed and nothing left the page", () => {
  assert.deepEqual([...new Set(lesson.failures)].slice(0, 5), []);
  assert.deepEqual(lesson.strays, []);
});
