// Other machines and tools in the program's page: surfaces and five axes, beside the native command.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { seriousFindings } from "./axe.mjs";
import { native, openBrowser, root, serve } from "./browser.mjs";
import { choose, downloaded, exampleText, figure, openProgram, planned, rowsOf, write } from "./program.mjs";

const trunnion = readFileSync(join(root, "machines/table-table-ac.toml"), "utf8");
const tools = readFileSync(join(root, "examples/tools.tbl"), "utf8");

let server, browser, opened, folder;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), "leadscrew-web-"));
  server = await serve();
  browser = await openBrowser();
  opened = await openProgram(browser, `${server.address}program.html`);
  opened.page.setDefaultTimeout(200_000); // a surface takes its time
});
after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true });
});

/** Words of the command, of the columns that the page has: it tells no poses. */
function wordsOf(text, files, columns) {
  const [program, trace] = [join(folder, "program.ngc"), join(folder, "words.csv")];
  writeFileSync(program, text);
  const more = Object.entries(files).flatMap(([option, content]) => {
    const name = join(folder, option.slice(2));
    writeFileSync(name, content);
    return [option, name];
  });
  native(["run", program, "--quiet", "--trace", trace, ...more]);
  const { columns: all, rows } = rowsOf(readFileSync(trace, "utf8"));
  const wanted = columns.map((name) => all.indexOf(name));
  return rows.map((row) => wanted.map((at) => row[at]));
}

/**
 * Lengths within `limit`, mm; angles as near at 50 mm from the axis; feeds, which are differences over a millisecond, less so; path
 * lengths besides to 1e-12, since they add up.
 */
function assertSame(shown, expected, limit = 1e-9) {
  const limits = { feed: 1e4 * limit, A: 100 * limit, C: 100 * limit };
  assert.equal(shown.rows.length, expected.length);
  shown.rows.forEach((row, i) =>
    row.forEach((value, k) => {
      const name = shown.columns[k];
      const off = Math.abs(value - expected[i][k]);
      const adding = name === "s" ? 1e-12 * value : 0;
      assert.ok(off <= (limits[name] ?? limit) + adding, `row ${i}, ${name}: ${value}, ${expected[i][k]}`);
    }),
  );
}

for (const [name, axes, files] of [
  ["16-patch", "XYZ", { "--tools": tools }],
  ["13-blade", "XYZAC", { "--machine": trunnion }],
]) {
  test(`${name} is planned: its words are the command's`, { timeout: 240_000 }, async () => {
    const { page } = opened;
    assert.equal(await choose(page, name), "ready");
    const shown = rowsOf(await downloaded(page, "export-csv"));
    assert.deepEqual(shown.columns.slice(4), [...axes]);
    assertSame(shown, wordsOf(exampleText(name), files, shown.columns));
    const areas = (await downloaded(page, "export-svg")).match(/<polygon /g)?.length ?? 0;
    assert.ok(name === "16-patch" ? areas > 50 : areas >= 1, `${areas} areas of surfaces and tool`);
    const command = await page.textContent("#command");
    for (const option of ["--machine", "--tools"]) assert.equal(command.includes(option), option in files, command);
    assert.deepEqual(await page.$$eval(".limits th[scope=row]", (all) => all.map((each) => each.textContent[0])), [
      ...axes,
    ]);
  });
}

test("a machine file is opened, changed and saved", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  const file = join(folder, "trunnion.toml");
  writeFileSync(file, trunnion);
  const run = await page.getAttribute(".program", "data-run");
  await page.setInputFiles("#machine-file", file);
  await page.waitForFunction((before) => document.querySelector(".program").dataset.run !== before, run);
  assert.equal(await planned(page), "ready");
  assert.equal(await page.textContent("#machine-name"), "table-table-ac");
  assert.equal(await page.inputValue("#limit-velocity-C"), "360");
  await page.fill("#limit-velocity-X", "5");
  await page.press("#limit-velocity-X", "Enter");
  await page.fill("#limit-tolerance", "0.02");
  await page.press("#limit-tolerance", "Enter");
  assert.equal(await planned(page), "ready");
  const saved = await downloaded(page, "machine-save");
  assert.equal(
    saved.trim(),
    trunnion
      .trim()
      .replace("max_velocity_mm_s = 400", "max_velocity_mm_s = 5.0")
      .replace("tolerance_mm = 0.01 ", "tolerance_mm = 0.02 ")
      .replace("tolerance_mm = 0.01\n", "tolerance_mm = 0.02\n")
      .replace(/^(max_\w+|tolerance_mm) = (\d+)$/gm, "$1 = $2.0"),
  );
  const shown = rowsOf(await downloaded(page, "export-csv"));
  assertSame(shown, wordsOf(exampleText("04-square"), { "--machine": saved }, shown.columns));
  assert.deepEqual(await seriousFindings(page), []);
  const other = await openProgram(browser, page.url());
  assert.equal(await figure(other.page, "Time"), await figure(page, "Time"));
  assert.equal(await other.page.inputValue("#limit-velocity-X"), "5");
  await other.close();
});

test("a machine file that is wrong is told, and the one before stays", async () => {
  const { page } = opened;
  const before = await page.textContent("#machine-name");
  writeFileSync(join(folder, "wrong.toml"), trunnion.replace("max_velocity_mm_s = 400", "max_velocity_mm_s = -1"));
  await page.setInputFiles("#machine-file", join(folder, "wrong.toml"));
  await page.waitForFunction(() => /^line 16: /.test(document.querySelector("#machine-file-error").textContent));
  assert.equal(await page.textContent("#machine-name"), before);
  writeFileSync(join(folder, "none.toml"), "name = ");
  await page.setInputFiles("#machine-file", join(folder, "none.toml"));
  await page.waitForFunction(() => /^line 1: /.test(document.querySelector("#machine-file-error").textContent));
  await page.click("#machine-reset");
  await planned(page);
  assert.equal(await page.textContent("#machine-name"), "");
  assert.deepEqual(await page.$$eval(".limits th[scope=row]", (all) => all.map((each) => each.textContent)), [
    "X",
    "Y",
    "Z",
  ]);
});

test("a tool table is typed", async () => {
  const { page } = opened;
  const surface = "G21 G90 T1 M6\nG6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX8\nX0 Y6\nX8\nG6.5 D1 H0.2 L1 Z2 F6000\nM2\n";
  assert.equal(await write(page, surface), "unsound");
  await page.fill("#tools", "T1 D10 R5");
  await page.press("#tools", "Tab");
  await page.waitForFunction(() => document.querySelector(".program").dataset.state === "ready");
  const shown = rowsOf(await downloaded(page, "export-csv"));
  assertSame(shown, wordsOf(surface, { "--tools": "T1 D10 R5\n" }, shown.columns));
});

test("gouges are the command's, and each leads to its line", async () => {
  const { page } = opened;
  const surface = "G6.4 D3 P2 Q2 I2 J2\nX0 Y0 Z0\nX20\nX0 Y20\nX20\n";
  const text = `G21 G90\n${surface}T1 M6\nG6.5 D3 Q5 Z10 F3000\nG0 X7 Y9 Z5\nG1 Z-0.5 F500\nG1 Z5\nM2\n`;
  await page.fill("#tools", "T1 D10 R0 L40 H50 K30");
  await page.press("#tools", "Tab");
  assert.equal(await write(page, text), "ready");
  await page.click("#gouges-look");
  await page.waitForSelector("#gouges tr");
  const shown = await page.$$eval("#gouges tr", (rows) =>
    rows.map((row) => [...row.children].map((cell) => cell.textContent)),
  );
  const [program, table] = [join(folder, "gouging.ngc"), join(folder, "gouging.tbl")];
  writeFileSync(program, text);
  writeFileSync(table, "T1 D10 R0 L40 H50 K30\n");
  const { gouging } = JSON.parse(native(["check", program, "--gouge", "--json", "--tools", table], 1));
  const { line, depth_mm, part, surface: number, u, v } = gouging.worst;
  assert.deepEqual(
    shown.map(([of, , ...found]) => [Number(of), found[0], found[1], ...found.slice(2).map(Number)]),
    [[line, part, `D${number}`, depth_mm, u, v]],
  );
  await page.click("#gouges button");
  assert.equal(await page.getAttribute(".program", "data-line"), shown[0][0]);
  assert.deepEqual(await seriousFindings(page), []);
});

test("the nearest place of a pass by a pole is listed, and leads there", async () => {
  const { page } = opened;
  const file = join(folder, "trunnion.toml");
  writeFileSync(file, trunnion);
  const run = await page.getAttribute(".program", "data-run");
  await page.setInputFiles("#machine-file", file);
  await page.waitForFunction((before) => document.querySelector(".program").dataset.run !== before, run);
  assert.equal(await write(page, "G21 G90 G94\nG0 A-10\nG43.4 H0\nG1 X20 A10 F2000\nG49\nM2\n"), "ready");
  const [start, passed, ...more] = await page.$$eval("#poles li", (all) => all.map((each) => each.textContent));
  assert.match(start, /^Line 2: 0\.000° from a pole/); // where motion begins
  assert.match(passed, /^Line 4: 0\.0\d\d° from a pole/);
  assert.deepEqual(more, []);
  await page.click("#poles li:nth-child(2) button");
  assert.ok(/^\D?0\.0\d\d$/.test(await figure(page, "A", "now")));
  await page.click("#machine-reset");
});

test("nothing leaves the page, and nothing fails in it", () => {
  assert.deepEqual(opened.strays, []);
  assert.deepEqual(opened.failures, []);
});
