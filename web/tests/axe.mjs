// For everyone: what axe finds, and what Tab comes to.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Serious and critical findings, as texts. */
export async function seriousFindings(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return found.violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(
      ({ id, nodes }) =>
        `${id}: ${nodes
          .map((node) => node.target)
          .slice(0, 5)
          .join(" ")}`,
    );
}

/** What Tab comes to, from the top of the page to where it begins again; each with whether its focus can be seen. */
export async function tabbed(page, leave = async () => {}) {
  await page.focus(".skip");
  await page.keyboard.press("Tab");
  const stops = [];
  for (let i = 0; i < 200; ++i) {
    await leave(page);
    await page.keyboard.press(i === 0 ? "Shift+Tab" : "Tab"); // first back to the top
    const stop = await page.evaluate(() => {
      const element = document.activeElement;
      if (element === null || element === document.body) return null;
      const isOutlined = (of) => {
        const style = getComputedStyle(of);
        return style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2;
      };
      const line = element.querySelector?.(".wire-line");
      const editor = element.closest(".cm-editor");
      const isSeen =
        isOutlined(element) ||
        (editor !== null && isOutlined(editor)) ||
        (line !== null && line !== undefined && parseFloat(getComputedStyle(line).strokeWidth) >= 4);
      element.dataset.tabbed = "1";
      return { name: element.id || element.getAttribute("aria-label") || element.className, isSeen };
    });
    if (stop === null) break;
    stops.push(stop);
  }
  return stops;
}

/** Controls that Tab has not come to. */
export async function missedByTab(page) {
  return await page.$$eval("button, input, select, summary, a, [tabindex='0']", (all) =>
    all
      .filter((each) => each.checkVisibility() && !each.disabled && each.dataset.tabbed !== "1" && each.tabIndex >= 0)
      .filter((each) => each.type !== "radio" || each.checked)
      .map((each) => each.id || each.outerHTML.slice(0, 80)),
  );
}
