// Words beside one another: positions and slides are the command's, figures are the papers' and the studies', sliders and
// the link do what they say.

import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { missedByTab, seriousFindings, tabbed } from "./axe.mjs";
import { built, native, nativeTable, openBrowser, openPage, serve } from "./browser.mjs";

let server, browser, words;
const folder = mkdtempSync(join(tmpdir(), "leadscrew-words-"));
before(async () => {
  server = await serve();
  browser = await openBrowser();
  words = await open(`${server.address}words.html`);
});
after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true });
});

async function open(address, options = {}) {
  return await openPage(browser, address, { ready: loaded, ...options });
}

async function loaded(page) {
  await page.waitForFunction(() => {
    const all = document.querySelector(".words");
    return all !== null && all.dataset.loaded !== undefined && all.dataset.loading === all.dataset.loaded;
  });
}

async function show(page, id) {
  await page.selectOption("#comparison", id);
  await loaded(page);
  await page.click("#last");
}

/** Cells of the table, by the names of its columns. */
async function rowsOf(page) {
  return await page.$$eval(".figures tr[data-lane]", (all) => {
    const columns = [...document.querySelectorAll(".figures thead th")].map((each) => each.textContent.split(",")[0]);
    return all.map((row) => {
      const below = row.nextElementSibling;
      return {
        ...Object.fromEntries([...row.cells].map((cell, i) => [columns[i], cell.textContent])),
        Published: below?.className === "paper" ? below.cells[1].textContent : "",
      };
    });
  });
}

async function save(page, id) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#${id}`)]);
  return readFileSync(await download.path(), "utf8");
}

/** What the script of the page writes, in the folder. */
async function saveFiles(page) {
  const script = await save(page, "save-script");
  for (const [, name, text] of script.matchAll(/^cat >(\S+) <<'END'\n([^]*?)\nEND$/gm))
    writeFileSync(join(folder, name), `${text}\n`);
}

const numbersOf = (csv) =>
  csv
    .trim()
    .split("\n")
    .slice(1)
    .map((line) => line.split(",").map(Number));

/** Of a command of the page: columns of its trace, by their names, row after row. */
function traceOf(command) {
  const trace = join(folder, "trace.csv");
  const args = command
    .split("#")[0]
    .trim()
    .split(" ")
    .slice(1)
    .map((word) => (/^lane-/.test(word) ? join(folder, word) : word))
    .filter((word) => word !== "--json");
  native([...args, "--quiet", "--trace", trace], [0, 1]);
  const text = readFileSync(trace, "utf8");
  const columns = text.split("\n")[0].split(",");
  return numbersOf(text).map((row) => Object.fromEntries(row.map((value, i) => [columns[i], value])));
}

for (const id of ["rules", "one-block", "loops", "corner"])
  test(`words and slides of “${id}” are the command's`, async () => {
    const { page } = words;
    await show(page, id);
    const commands = (await page.textContent("#commands")).split("\n");
    await saveFiles(page);
    const all = numbersOf(await save(page, "save-words"));
    for (const [i, command] of commands.entries()) {
      const mine = all.filter(([lane]) => lane === i + 1);
      const theirs = traceOf(command);
      const [x, y] = command.includes("simulate") ? ["actual_X", "actual_Y"] : ["X", "Y"];
      const count = Math.min(mine.length, theirs.length);
      assert.ok(count > 50 && (x === "actual_X" || mine.length === theirs.length), `${command}: ${mine.length}`);
      for (let k = 0; k < count; ++k) {
        const [, , atX, atY] = mine[k];
        const off = Math.max(Math.abs(atX - theirs[k][x]), Math.abs(atY - theirs[k][y]));
        assert.ok(off <= 1e-9, `${command}: ${off} mm at ${k}`);
      }
    }
  });

test("figures of the rules are those of the study, and the paper's stand beside", async () => {
  const { page } = words;
  await show(page, "rules");
  const rows = await rowsOf(page);
  // Of feed-fluctuation, at 10 mm/s and 10 ms: 0.70 and 0.016 and 33 % with V from the first word on; here motion begins at rest.
  for (const [i, [least, most]] of [
    [0, 0.01],
    [0.5, 0.71],
    [0.015, 0.017],
    [27, 33.5],
  ].entries()) {
    const error = Number(rows[i]["Feed error"]);
    assert.ok(error >= least && error <= most, `${rows[i].Method}: ${error} %`);
  }
  assert.ok(Math.abs(Number(rows[0]["Chord error"]) - 0.444) < 0.001, rows[0]["Chord error"]);
  assert.match(rows[1].Published, /^feed error below 2 % \(Real-time/);
  await show(page, "one-block");
  const times = (await rowsOf(page)).map((row) => Number(row.Time));
  assert.ok(Math.abs(times[0] - 3.1) < 0.1 && times[1] > 2.8 * times[0], times.join());
  await page.fill("#feed", "11");
  await loaded(page);
  for (const row of await rowsOf(page)) assert.equal(row.Published, "");
});

test("pulses stand beside words on one curve and one clock, as the command makes them", async () => {
  const { page } = words;
  await show(page, "pulses");
  const rows = await rowsOf(page);
  const commands = (await page.textContent("#commands")).split("\n");
  const all = numbersOf(await save(page, "save-words"));
  const around = (2 * Math.PI * 10) / 20;
  for (const [lane, blu] of [
    [2, 0.1],
    [3, 0.05],
  ]) {
    const args = commands[lane].split(" ").slice(1);
    const [expected] = JSON.parse(native(args)).methods;
    const row = rows[lane];
    assert.equal(row.Words, String(expected.clocks));
    assert.equal(row.Pulses, String(expected.pulses));
    assert.ok(
      Math.abs(Number(row["Greatest error"]) - 1000 * blu * expected.max_error_blu) < 0.1,
      row["Greatest error"],
    );
    assert.ok(Math.abs(Number(row.Time) - around) < 0.02 * around, row.Time);
    const table = nativeTable(args.map((word) => (word === "--json" ? "--table" : word)));
    const [x, y] = [table.columns.indexOf("x"), table.columns.indexOf("y")];
    const mine = all.filter(([number]) => number === lane + 1);
    assert.equal(mine.length, table.rows.length);
    mine.forEach(([, , atX, atY], i) => {
      assert.ok(Math.abs(atX - blu * table.rows[i][x]) < 1e-9 && Math.abs(atY - blu * table.rows[i][y]) < 1e-9, `${i}`);
    });
    // Over T two clocks pass, or four: of X and Y at once, √2 times as fast.
    const speed = Number(row["Greatest speed"]);
    assert.ok(speed >= 20 && speed <= 20 * Math.SQRT2 + 0.01, `${speed}`);
  }
  assert.ok(Number(rows[0].Words) < Number(rows[2].Words) && rows[0].Pulses === "");
  await page.fill("#blu-3", "0.03");
  await loaded(page);
  assert.match(await page.textContent("#blu-3-error"), /a = 10 mm is no whole number of 0\.03 mm/);
  await page.selectOption("#curve", "corner");
  await loaded(page);
  assert.match(await page.textContent("#method-4-error"), /lines, circles and ellipses/);
  assert.equal((await rowsOf(page)).length, 2);
});

test("a circle by integration errs as its rule does", async () => {
  const { page } = words;
  await show(page, "integration");
  const rows = await rowsOf(page);
  const [radius, angle] = [10, (50 * 0.01) / 10];
  const steps = Math.floor((2 * Math.PI) / angle);
  const grown = (factor) => 1000 * radius * (factor ** steps - 1);
  const near = (row, value, share) =>
    assert.ok(
      Math.abs(Number(row["Greatest error"]) - value) < share * value,
      `${row.Method}: ${row["Greatest error"]}`,
    );
  near(rows[0], grown(Math.sqrt(1 + angle ** 2)), 0.001);
  near(rows[1], grown(Math.sqrt(1 + angle ** 4 / 4)), 0.01);
  assert.ok(Number(rows[2]["Greatest error"]) < 1e-6, rows[2]["Greatest error"]);
  near(rows[3], (1000 * radius * angle) / 2, 0.6); // x² − Txy + y²: an ellipse through the start
  assert.match(rows[0].Published, /T² a step/);
  assert.equal(rows[2].Published, "");
  assert.equal(await page.isVisible("#loops-1"), false);
  await page.selectOption("#curve", "line");
  await loaded(page);
  assert.match(await page.textContent("#method-1-error"), /choose a circle/);
});

test("T, V and gains are sliders", async () => {
  const { page } = words;
  await show(page, "loops");
  const before = await rowsOf(page);
  const press = async (id, key) => {
    await page.focus(`#${id}`);
    await page.keyboard.press(key);
    await loaded(page);
  };
  await press("feed-slider", "PageDown");
  assert.notEqual(await page.inputValue("#feed"), "50");
  assert.ok(Number((await rowsOf(page))[0].Time) > Number(before[0].Time));
  await press("period-slider", "Home");
  assert.equal(await page.inputValue("#period"), "0.05");
  assert.match(await page.textContent("#period-error"), /more than 20000 words/);
  await page.fill("#feed", "50");
  await page.fill("#period", "2");
  await loaded(page);
  await page.click("#last");
  const slow = await rowsOf(page);
  assert.ok(Number(slow[0].Words) < Number(before[0].Words));
  await page.fill("#kv-3", "10");
  await loaded(page);
  await page.click("#last");
  const soft = await rowsOf(page);
  assert.ok(Number(soft[2]["Greatest error"]) > 2 * Number(slow[2]["Greatest error"]));
  await page.fill("#kv-3", "1000");
  await loaded(page);
  assert.match(await page.textContent("#loops-3-error"), /not stable/);
  await page.fill("#kv-3", "10");
  await page.fill("#d-2", "x");
  await loaded(page);
  assert.match(await page.textContent("#d-2-error"), /“x” is none of 0 to 200 units\/mm/);
  assert.equal((await rowsOf(page)).length, 3);
});

async function picturesOf(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return await page.$$eval("canvas", (all) =>
    all.filter((each) => each.checkVisibility()).map((each) => each.toDataURL()),
  );
}

test("a link brings everything back", async () => {
  const { page } = words;
  await show(page, "corner");
  await page.selectOption("#layout", "beside");
  await page.selectOption("#magnified", "10");
  await page.fill("#kv-3", "25");
  await loaded(page);
  await page.click("#nearer");
  await page.focus("#content");
  await page.keyboard.press("ArrowLeft");
  await page.waitForTimeout(400);
  await page.evaluate(() => document.activeElement.blur());
  const other = await open(page.url());
  // What a word costs is measured anew.
  const told = async (of) => (await rowsOf(of)).map((row) => ({ ...row, "Cost a word": "" }));
  assert.deepEqual(await told(other.page), await told(page));
  assert.equal(await other.page.textContent("#position"), await page.textContent("#position"));
  const [mine, theirs] = [await picturesOf(page), await picturesOf(other.page)];
  assert.ok(mine.length === 6 && mine.every((each, i) => each === theirs[i]), `${mine.length} pictures`);
  await other.close();
  await page.selectOption("#layout", "overlay");
});

test("files hold what is shown", async () => {
  const { page } = words;
  await show(page, "rules");
  const csv = (await save(page, "save-csv")).split("\n");
  assert.match(csv[0], /^method,loops,words,pulses,/);
  assert.match(csv[2], /^"Taylor, first order",T 10 ms,303,,3\.030,/);
  assert.match(await save(page, "save-svg"), /^<svg xmlns=.*<title>The curve and what is made of it until clock 303/);
  assert.match(await save(page, "save-png"), /^.PNG/);
});

test("Tab comes to every control, and shows where it is; axe finds nothing serious", async () => {
  const { page } = words;
  await show(page, "gains");
  assert.deepEqual(
    (await tabbed(page)).filter(({ isSeen }) => !isSeen).map(({ name }) => name),
    [],
  );
  assert.deepEqual(await missedByTab(page), []);
  assert.deepEqual(await seriousFindings(page), []);
});

for (const theme of ["light", "dark"])
  test(`one file from disk, and pictures of it, ${theme}`, async () => {
    const shots = join(built, "screenshots");
    mkdirSync(shots, { recursive: true });
    const file = pathToFileURL(join(built, "file/words.html")).href;
    const { page, strays, failures, close } = await open(file, { colorScheme: theme });
    for (const [id, layout] of [
      ["gains", "overlay"],
      ["pulses", "overlay"],
      ["corner", "beside"],
    ]) {
      await page.selectOption("#layout", layout);
      await show(page, id);
      for (const width of [1280, 1024, 390]) {
        await page.setViewportSize({ width, height: 900 });
        await page.waitForTimeout(100);
        const over = await page.evaluate(
          () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
        );
        assert.ok(over <= 0, `${id} at ${width} px is ${over} px too wide`);
        await page.screenshot({ path: join(shots, `words-${id}-${theme}-${width}.png`), fullPage: true });
      }
    }
    if (theme === "dark") assert.deepEqual(await seriousFindings(page), []);
    assert.deepEqual(strays, []);
    assert.deepEqual(failures, []);
    await close();
  });

test("nothing failed and nothing left the page", () => {
  assert.deepEqual([...new Set(words.failures)].slice(0, 5), []);
  assert.deepEqual(words.strays, []);
});
