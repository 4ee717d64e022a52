// One file, below 400 kB, that opens from disk and asks for nothing; a picture of each module, light and dark.

import assert from "node:assert/strict";
import { mkdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { built, choose, click, lessonFile, nativeTable, openBrowser, openPage, settled, tableOf } from "./browser.mjs";

let browser;
before(async () => (browser = await openBrowser()));
after(async () => await browser?.close());

const address = pathToFileURL(lessonFile).href;

test("the lesson is one file below 400 kB", () => {
  assert.ok(statSync(lessonFile).size < 400_000, `${statSync(lessonFile).size} bytes`);
});

test("it runs from disk, and asks for nothing", async () => {
  const { page, strays, failures, close } = await openPage(browser, address);
  await choose(page, "across-quadrants");
  await click(page, "last");
  const shown = await tableOf(page);
  const expected = nativeTable(
    "pulse --method dda --preload zero --arc --start 6,8 --end -8,6 --cw --bits 4 --table".split(" "),
  );
  const places = expected.columns.map((name) => shown.columns.indexOf(name));
  assert.deepEqual(
    shown.rows.map((row) => places.map((place) => row[place])),
    expected.rows,
  );
  assert.deepEqual(strays, []);
  assert.deepEqual(failures, []);
  await close();
});

test("pictures, light and dark", async () => {
  const folder = join(built, "screenshots");
  mkdirSync(folder, { recursive: true });
  const { page, close } = await openPage(browser, address, { colorScheme: "dark" });
  for (const [module, preset, clock] of [
    ["linear", "line-across", 9],
    ["circular", "across-quadrants", 43],
    ["elliptic", "ellipse-hardware", 71],
  ]) {
    await choose(page, preset);
    for (let i = 0; i < clock; ++i) await page.click("#step");
    await settled(page);
    for (const theme of ["dark", "light"]) {
      await page.emulateMedia({ colorScheme: theme });
      for (const width of [1280, 1024, 390]) {
        await page.setViewportSize({ width, height: 900 });
        await page.waitForTimeout(150);
        const over = await page.evaluate(
          () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
        );
        assert.ok(over <= 0, `${module} at ${width} px is ${over} px too wide`);
        await page.screenshot({ path: join(folder, `lesson-${module}-${theme}-${width}.png`), fullPage: true });
      }
    }
  }
  await close();
});
