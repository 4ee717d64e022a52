// What the tests share: the page on a server of its own or from disk, Chromium without a way out, the native command.

import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const root = fileURLToPath(new URL("../..", import.meta.url));
export const built = process.env.LEADSCREW_WEB ?? join(root, "build/web");
export const lessonFile = join(built, "file/lesson.html");

const types = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
};

/** The served page: {address, close}. */
export async function serve(folder = join(built, "page")) {
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url ?? "/", "http://localhost").pathname);
    const file = join(folder, path === "/" ? "index.html" : path);
    try {
      const bytes = readFileSync(file);
      response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export async function openBrowser() {
  return await chromium.launch({
    executablePath: process.env.LEADSCREW_CHROMIUM ?? "/usr/bin/chromium",
    args: [
      "--no-sandbox",
      "--disable-gpu",
      "--disable-background-networking",
      "--disable-component-update",
      "--no-first-run",
    ],
  });
}

/**
 * A page that notes what it asks for beyond its own address, and what goes wrong in it.
 * @param {import("playwright-core").Browser} browser
 */
export async function openPage(browser, address, { ready = settled, ...options } = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 900 },
    acceptDownloads: true,
    ...options,
  });
  const page = await context.newPage();
  const strays = [];
  const failures = [];
  const home = address.startsWith("file:") ? address.split("#")[0] : new URL(address).origin;
  page.on("request", (request) => {
    const url = request.url();
    if (!url.startsWith(home) && !url.startsWith("data:") && !url.startsWith("blob:")) strays.push(url);
  });
  page.on("pageerror", (error) => failures.push(error.message));
  page.on("console", (message) => message.type() === "error" && failures.push(message.text()));
  await page.goto(address);
  await ready(page);
  return { page, strays, failures, close: () => context.close() };
}

/** Until what was set has been loaded and told. */
export async function settled(page) {
  await page.waitForFunction(() => {
    const lesson = document.querySelector(".lesson");
    if (lesson === null || lesson.dataset.loading !== lesson.dataset.loaded) return false;
    return lesson.dataset.state === "empty" || lesson.dataset.told === lesson.dataset.clock;
  });
}

/** In the page: so many pictures of it go by. */
export async function frames(count) {
  for (let i = 0; i < count; ++i) await new Promise((resume) => requestAnimationFrame(resume));
}

export async function choose(page, preset) {
  await page.selectOption("#preset", preset);
  await settled(page);
}

export async function click(page, id) {
  await page.click(`#${id}`);
  await settled(page);
}

export async function clockOf(page) {
  return Number(await page.getAttribute(".lesson", "data-clock"));
}

export async function stateOf(page) {
  return await page.getAttribute(".lesson", "data-state");
}

/** The numbers of this cycle, by their names. */
export async function numbersOf(page) {
  return await page.$$eval(".numbers > div", (all) =>
    Object.fromEntries(all.map((each) => [each.dataset.name, each.querySelector("dd").textContent.replace("−", "-")])),
  );
}

/** All of the table until this cycle: {columns, rows}, read as it scrolls by. */
export async function tableOf(page) {
  return await page.evaluate(async () => {
    const frame = document.querySelector(".table");
    const columns = [...frame.querySelectorAll("th")].map((each) => each.textContent);
    const rows = [];
    const last = Number(document.querySelector(".lesson").dataset.clock);
    let passes = 0; // a busy computer may draw too late for one
    for (let top = 0; rows.filter(Boolean).length <= last; top += 200) {
      frame.scrollTop = top;
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      for (const row of frame.querySelectorAll("tr[data-clock]"))
        rows[Number(row.dataset.clock)] = [...row.cells].map((cell) => Number(cell.textContent.replace("−", "-")));
      if (top <= frame.scrollHeight + 1000) continue;
      const missing = [...Array(last + 1).keys()].filter((clock) => !rows[clock]);
      if (++passes === 3 && missing.length > 0) throw new Error(`the table has not clocks ${missing} of ${last}`);
      top = -200;
    }
    return { columns, rows };
  });
}

export const command = process.env.LEADSCREW ?? join(root, "build/release/leadscrew");

/** What the native command prints; it ends with that status, or one of those. */
export function native(args, status = 0) {
  const { status: ended, stdout, stderr } = spawnSync(command, args, { encoding: "utf8", maxBuffer: 2 ** 30 });
  if (![status].flat().includes(ended)) throw new Error(`leadscrew ${args.join(" ")} ended with ${ended}: ${stderr}`);
  return stdout;
}

/** Of `pulse --table`: {columns, rows}. */
export function nativeTable(args) {
  const lines = native(args).split("\n");
  const head = lines.findIndex((line) => line.trim().startsWith("clock"));
  const rows = [];
  for (const line of lines.slice(head + 1)) {
    if (line.trim() === "") break;
    rows.push(line.trim().split(/\s+/).map(Number));
  }
  return { columns: lines[head].trim().split(/\s+/), rows };
}

/** The page's own command line. */
export async function commandOf(page) {
  const words = (await page.textContent("#command")).split(" ");
  if (words[0] !== "leadscrew") throw new Error(words.join(" "));
  return words.slice(1);
}

/** All that the page says of the cycle it stands at. */
export async function signatureOf(page) {
  return await page.evaluate(() => {
    const text = (selector) => [...document.querySelectorAll(selector)].map((each) => each.textContent).join("|");
    const wires = [...document.querySelectorAll(".wire")].map(
      (each) => `${each.getAttribute("aria-label")} ${each.classList.contains("lit")}`,
    );
    return [
      text(".numbers dd"),
      text("#why p"),
      text("tr.now td"),
      wires.join("|"),
      text(".block-value"),
      document.querySelector("#scrub").value,
    ].join("\n");
  });
}
