// Words, figures and diagnostics of the program's page beside those of the native command.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { command, native, openBrowser, serve } from "./browser.mjs";
import {
  assertSameWords,
  choose,
  downloaded,
  exampleText,
  figure,
  nativeWords,
  openProgram,
  planned,
  rowsOf,
  write,
} from "./program.mjs";

let server, browser, opened, folder;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), "leadscrew-web-"));
  server = await serve();
  browser = await openBrowser();
  opened = await openProgram(browser, `${server.address}program.html`);
});
after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true });
});

for (const name of ["01-plate", "03-arcs-in-three-planes", "09-butterfly"]) {
  test(`${name}: words and figures are the command's`, async () => {
    const { page } = opened;
    assert.equal(await choose(page, name), "ready");
    const text = exampleText(name);
    assertSameWords(rowsOf(await downloaded(page, "export-csv")), nativeWords(folder, text));
    const run = JSON.parse(native(["run", join(folder, "program.ngc"), "--json"]));
    assert.equal(await figure(page, "Time"), `${run.time_s.toFixed(3)} s`);
    assert.equal(await figure(page, "No controller under"), `${run.bound_s.toFixed(3)} s`);
    assert.equal(await figure(page, "Words"), run.words.toLocaleString("en"));
    assert.equal(await figure(page, "Blocks"), run.blocks.toLocaleString("en"));
  });
}

test("pulses are the command's dump, byte by byte; a machine that is too fast for them is told", async () => {
  const { page } = opened;
  await choose(page, "03-arcs-in-three-planes");
  const [program, dump] = [join(folder, "arcs.ngc"), join(folder, "steps.vcd")];
  writeFileSync(program, exampleText("03-arcs-in-three-planes"));
  native(["run", program, "--quiet", "--pulses", dump]);
  const shown = await downloaded(page, "export-vcd");
  const expected = readFileSync(dump, "utf8");
  assert.ok(expected.length > 10_000 && /X_step/.test(expected));
  assert.ok(shown === expected, `${shown.length} of ${expected.length} bytes`);
  const velocity = await page.inputValue("#limit-velocity-X");
  await page.fill("#limit-velocity-X", "2000");
  await page.press("#limit-velocity-X", "Enter");
  await planned(page);
  await page.click("#export-vcd");
  await page.waitForFunction(() => /^No pulses: /.test(document.querySelector("#steps-error").textContent));
  await page.fill("#limit-velocity-X", velocity);
  await page.press("#limit-velocity-X", "Enter");
  await planned(page);
});

test("another machine: its file, as saved, gives the command the same words", async () => {
  const { page } = opened;
  await choose(page, "04-square");
  const before = await figure(page, "Time");
  await page.fill("#limit-jerk-X", "1500");
  await page.press("#limit-jerk-X", "Enter");
  await page.waitForFunction(
    (time) => document.querySelector('#figures [data-name="Time"] dd').textContent !== time,
    before,
  );
  await planned(page);
  assert.match(await page.textContent("#command"), /--machine machine\.toml/);
  const machine = await downloaded(page, "machine-save");
  assertSameWords(rowsOf(await downloaded(page, "export-csv")), nativeWords(folder, exampleText("04-square"), machine));
  await page.fill("#limit-jerk-X", "none");
  await page.press("#limit-jerk-X", "Enter");
  assert.match(await page.textContent("#machine-error"), /Jerk of X.*a number above 0/);
  assert.equal(await page.getAttribute("#limit-jerk-X", "aria-invalid"), "true");
  await page.click("#machine-reset");
  await planned(page);
  assert.equal(await figure(page, "Time"), before);
});

for (const period of [300, 333.333]) {
  test(`a period of ${period} µs, of which no second is a whole number: times are the command's`, async () => {
    const { page } = opened;
    await choose(page, "04-square");
    const machine = `period_us = ${period}\n${await downloaded(page, "machine-save")}`;
    const file = join(folder, "period.toml");
    writeFileSync(file, machine);
    await page.setInputFiles("#machine-file", file);
    await page.waitForFunction(() => document.querySelector("#machine-name").textContent === "mill3");
    assert.equal(await planned(page), "ready");
    const [shown, expected] = [
      rowsOf(await downloaded(page, "export-csv")),
      nativeWords(folder, exampleText("04-square"), machine),
    ];
    assert.equal(expected.rows[3][0], (3 * Math.round(period * 1000)) / 1e9);
    assertSameWords(shown, expected);
    for (const [i, [time]] of shown.rows.entries()) assert.equal(time, expected.rows[i][0]);
    await page.click("#machine-reset");
    await planned(page);
  });
}

test("feed override is planned at once", async () => {
  const { page } = opened;
  await write(page, "G21 G90 G1 X100 F600\nM2\n");
  const time = parseFloat(await figure(page, "Time"));
  await page.focus("#override");
  await page.evaluate(() => {
    const slider = document.querySelector("#override");
    slider.value = "50";
    slider.dispatchEvent(new Event("change"));
  });
  await planned(page);
  assert.ok(parseFloat(await figure(page, "Time")) > 1.5 * time);
  await page.click("#machine-reset");
  await planned(page);
});

/** Of `check --json`, whatever it returns. */
function nativeDiagnostics(text) {
  const program = join(folder, "checked.ngc");
  writeFileSync(program, text);
  let told;
  try {
    told = execFileSync(command, ["check", program, "--json"], {
      encoding: "utf8",
      stdio: ["ignore", "pipe", "ignore"],
    });
  } catch (failure) {
    told = failure.stdout;
  }
  return JSON.parse(told).diagnostics;
}

for (const [what, text] of [
  ["errors", "G21 G90 G1 X10 F600\nG1 X1Q\nG2 X5 I1\nG1 Y\nG999\nM2\n"],
  ["umlauts before a column", "G21 G90 (größer) G1 Xx F600\nM2\n"],
  ["a feed that axes do not keep up with", "G21 G90 G1 X100 Y50 F60000\nM2\n"],
  ["beyond travel", "G21 G90 G0 X900\nM2\n"],
]) {
  test(`diagnostics are those of check: ${what}`, async () => {
    const { page } = opened;
    await write(page, text, "checked.ngc");
    const expected = nativeDiagnostics(text);
    assert.ok(expected.length > 0);
    const shown = await page.$$eval("#found li", (all) =>
      all.map((each) => ({
        code: each.dataset.code,
        severity: ["note", "warning", "error"][Number(each.dataset.severity)],
        place: each.querySelector("button").textContent,
        text: each.querySelector("span").textContent.trim(),
      })),
    );
    assert.deepEqual(
      shown,
      expected.map(({ code, severity, line, column, message, hint }) => ({
        code,
        severity,
        place: line > 0 ? `${line}:${column}` : "program",
        // Behind what would be right the command names its own options.
        text: hint ? `${message}: ${hint.replace(/; --.*$/, "")}` : message,
      })),
    );
    const marks = await page.$$eval(".cm-lintRange", (all) => all.length);
    assert.ok(marks > 0, "something is underlined");
    const isSound = expected.every(({ severity }) => severity !== "error");
    assert.equal(await planned(page), isSound ? "ready" : "unsound");
  });
}
