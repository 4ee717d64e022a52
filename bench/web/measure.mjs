// The workbench in Chromium, as `leadscrew serve` gives it: five runs, each by a browser of its own that has cached nothing.
//
//   first view   from the address to the example planned, drawn and open to input, by the first of its samples: the page's own
//                clock, from navigation on; in a browser that has come to rest, and in one that is itself still starting
//   large        100 000 blocks read, planned and drawn: the longest task of the page's main thread, from Chromium's trace
//   zoom         a million samples plotted: from the end of the drag, or the click, to the next picture (Event Timing), ms in
//                steps of 8
//   memory       the most that the page's process, workers included, was resident in, shared libraries too (VmHWM)
//
// On two processors that nothing else has: the load is printed.

import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { cpus, loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { command, openBrowser } from "../../web/tests/browser.mjs";

const runs = Number(process.argv[2] ?? 5);
const largeBlocks = 100_000;

/** A spiral in lines of half a millimetre and less. */
function spiral() {
  const lines = ["G21 G90 G64 P0.01 F3000"];
  for (let i = 1; i < largeBlocks - 1; ++i) {
    const angle = i * 0.02;
    const radius = 20 + 60 * (i / largeBlocks);
    lines.push(`G1 X${(radius * Math.cos(angle)).toFixed(3)} Y${(radius * Math.sin(angle)).toFixed(3)}`);
  }
  return `${lines.join("\n")}\nM2\n`;
}

/** Just below a million words of a millisecond: 1000 s of turns on circles that grow, and a dwell. */
function million() {
  const lines = ["G21 G90 G17 F600"];
  let seconds = 0;
  for (let radius = 1; seconds < 985; radius += 0.5) {
    lines.push(`G1 X${radius}`, `G2 X${radius} Y0 I${-radius} J0`);
    seconds += (2 * Math.PI * radius) / 10 + 0.2;
  }
  return `${lines.join("\n")}\nM2\n`;
}

async function served() {
  const server = spawn(command, ["serve", "--port", "0"]);
  const address = await new Promise((resolve, reject) => {
    server.stdout.once("data", (data) => resolve(String(data).trim()));
    server.stderr.once("data", (data) => reject(new Error(String(data))));
  });
  return { address, close: () => server.kill("SIGINT") };
}

/** Notes when a mode first says that it is ready, and how long input takes to be seen. */
function watchPage() {
  globalThis.inputs = [];
  const isReady = () => {
    const program = document.querySelector('.program[data-state="ready"]');
    const lesson = document.querySelector(".lesson");
    if (program !== null) return Number(document.querySelector("#space").dataset.pictures ?? 0) > 0;
    return (
      lesson !== null &&
      lesson.dataset.loading === lesson.dataset.loaded &&
      lesson.dataset.told === lesson.dataset.clock
    );
  };
  const look = () => {
    if (isReady()) globalThis.readyAt ??= performance.now();
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  new PerformanceObserver((list) => {
    for (const { name, duration } of list.getEntries()) globalThis.inputs.push([name, duration]);
  }).observe({ type: "event", durationThreshold: 16 });
}

async function pageOf(browser, address) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  const page = await context.newPage();
  await page.addInitScript(watchPage);
  await page.goto(address);
  await page.waitForFunction(() => globalThis.readyAt !== undefined, undefined, { timeout: 60_000 });
  return page;
}

/** `rest`: ms between the browser's start and the page's. */
async function firstView(address, rest) {
  const browser = await openBrowser();
  await new Promise((resume) => setTimeout(resume, rest));
  const page = await pageOf(browser, address);
  const ready = await page.evaluate(() => globalThis.readyAt);
  await browser.close();
  return ready;
}

/** Of the page's main thread, ms: by the clock, and by the processor's time. */
function longestTask({ traceEvents }) {
  const threads = traceEvents.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const tasks = traceEvents.filter(
    ({ name, pid, tid }) =>
      name === "ThreadControllerImpl::RunTask" && threads.some((each) => each.pid === pid && each.tid === tid),
  );
  const most = (field) => Math.max(...tasks.map((task) => task[field] ?? 0)) / 1000;
  return { lasted: most("dur"), worked: most("tdur") };
}

async function open(page, file) {
  const run = await page.getAttribute(".program", "data-run");
  await page.setInputFiles("#file", file);
  await page.waitForFunction(
    (before) => {
      const { run: now, state, samples } = document.querySelector(".program").dataset;
      return now !== before && state !== "planning" && !(state === "ready" && samples === "some");
    },
    run,
    { timeout: 600_000, polling: 100 },
  );
  const state = await page.getAttribute(".program", "data-state");
  if (state !== "ready") throw new Error(`${file} is ${state}: ${await page.textContent("#found")}`);
}

/** Peak of the renderers, MB. */
async function memoryOf(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  const peaks = processInfo
    .filter(({ type }) => type === "renderer")
    .map(({ id }) => Number(/VmHWM:\s*(\d+) kB/.exec(readFileSync(`/proc/${id}/status`, "utf8"))[1]) / 1024);
  return Math.max(...peaks);
}

async function large(address, folder) {
  const browser = await openBrowser();
  const page = await pageOf(browser, `${address}program.html`);
  await browser.startTracing(page, { categories: ["toplevel", "__metadata"] });
  const begun = performance.now();
  await open(page, join(folder, "large.ngc"));
  const seconds = (performance.now() - begun) / 1000;
  await page.waitForTimeout(500);
  const task = longestTask(JSON.parse(await browser.stopTracing()));
  const memory = await memoryOf(browser);
  await browser.close();
  return { ...task, seconds, memory };
}

/** The longest of the inputs of these names, ms; what is below 16 is not told, and counts as 16. */
async function longestInput(page, names, act) {
  await page.evaluate(() => globalThis.inputs.splice(0));
  await act();
  await page.waitForTimeout(500);
  const inputs = await page.evaluate(() => globalThis.inputs);
  return Math.max(16, ...inputs.filter(([name]) => names.includes(name)).map(([, duration]) => duration));
}

async function zoom(address, folder) {
  const browser = await openBrowser();
  const page = await pageOf(browser, `${address}program.html`);
  await open(page, join(folder, "million.ngc"));
  const words = Number((await page.textContent('#figures [data-name="Words"] dd')).replaceAll(",", ""));
  const plot = page.locator("#plots .plot-area .u-over").first();
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.boundingBox();
  const drag = async (from, to) => {
    await page.mouse.move(box.x + from * box.width, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + to * box.width, box.y + box.height / 2, { steps: 4 });
    await page.mouse.up();
  };
  const drags = [];
  await browser.startTracing(page, { categories: ["toplevel", "__metadata"] });
  for (const [from, to] of [
    [0.1, 0.95],
    [0.1, 0.9],
    [0.3, 0.7],
  ])
    drags.push(await longestInput(page, ["pointerup", "mouseup"], () => drag(from, to)));
  const all = await longestInput(page, ["click"], () => page.click("#time-all"));
  const { worked } = longestTask(JSON.parse(await browser.stopTracing()));
  const memory = await memoryOf(browser);
  await browser.close();
  return { words, worked, drag: Math.max(...drags), all, memory };
}

function told(name, values, unit, digits = 0) {
  const sorted = [...values].sort((a, b) => a - b);
  const [least, median, most] = [sorted[0], sorted[Math.floor(sorted.length / 2)], sorted.at(-1)].map((each) =>
    each.toFixed(digits),
  );
  console.log(`${name.padEnd(66)} ${median.padStart(7)} ${unit}   (${least} … ${most})`);
}

const folder = mkdtempSync(join(tmpdir(), "leadscrew-bench-"));
writeFileSync(join(folder, "large.ngc"), spiral());
writeFileSync(join(folder, "million.ngc"), million());
const server = await served();
try {
  console.log(`${cpus()[0].model}, ${cpus().length} processors; load ${loadavg()[0].toFixed(2)}; median of ${runs}`);
  const repeat = async (measure) => {
    const found = [];
    for (let i = 0; i < runs; ++i) found.push(await measure());
    return found;
  };
  for (const [name, file] of [
    ["lesson, first view", "index.html"],
    ["program, first view: planned and drawn", "program.html"],
  ]) {
    told(name, await repeat(() => firstView(server.address + file, 1500)), "ms");
    told(`${name}, while the browser starts`, await repeat(() => firstView(server.address + file, 0)), "ms");
  }
  const larges = await repeat(() => large(server.address, folder));
  const of = (all, key) => all.map((each) => each[key]);
  told("100 000 blocks: read, planned and drawn", of(larges, "seconds"), "s", 1);
  told("100 000 blocks: longest task of the main thread, by the clock", of(larges, "lasted"), "ms");
  told("100 000 blocks: longest task of the main thread, processor time", of(larges, "worked"), "ms");
  told("100 000 blocks: memory of the page's process at most", of(larges, "memory"), "MB");
  const zooms = await repeat(() => zoom(server.address, folder));
  told("samples", of(zooms, "words"), "");
  told("zoom by a drag, to the next picture", of(zooms, "drag"), "ms");
  told("zooming: longest task of the main thread, processor time", of(zooms, "worked"), "ms");
  told("all of it again, to the next picture", of(zooms, "all"), "ms");
  told("memory of the page's process at most", of(zooms, "memory"), "MB");
  console.log(`load ${loadavg()[0].toFixed(2)} at the end`);
} finally {
  server.close();
  rmSync(folder, { recursive: true });
}
