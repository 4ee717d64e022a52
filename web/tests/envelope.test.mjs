// What the plots draw of many samples, beside the least and the greatest of each part, looked for one by one.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { transformWithEsbuild } from "vite";
import { root } from "./browser.mjs";

const source = readFileSync(join(root, "web/src/program/envelope.ts"), "utf8");
const { code } = await transformWithEsbuild(source, "envelope.ts");
const { envelopeOf } = await import(`data:text/javascript,${encodeURIComponent(code)}`);

const [count, axes, bins] = [100_003, 3, 800];
let seed = 1;
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
const values = Float32Array.from({ length: count * axes }, () => random() * 2 - 1);
const channels = [0, 1, 2].map((offset) => ({ values, stride: axes, offset }));

test("each part of a stretch has its least and its greatest sample", () => {
  for (let run = 0; run < 40; ++run) {
    const [a, b] = [Math.floor(random() * count), Math.floor(random() * count)].sort((x, y) => x - y);
    const [first, last] = run === 0 ? [0, count - 1] : [a, b];
    const [times, ...lists] = envelopeOf({ step: 0.001 }, channels, first, last);
    if (last - first < 1600) continue;
    assert.equal(times.length, 2 * bins);
    const border = (bin) => first + Math.floor((bin * (last - first + 1)) / bins);
    lists.forEach((list, axis) => {
      for (let bin = 0; bin < bins; ++bin) {
        const of = [];
        for (let i = border(bin); i < border(bin + 1); ++i) of.push(values[i * axes + axis]);
        assert.equal(list[2 * bin], Math.min(...of));
        assert.equal(list[2 * bin + 1], Math.max(...of));
      }
    });
  }
});

test("a short stretch has every sample", () => {
  const [times, x] = envelopeOf({ step: 0.001 }, channels, 10, 20);
  assert.deepEqual(
    times,
    [...Array(11).keys()].map((i) => (10 + i) * 0.001),
  );
  assert.deepEqual(
    x,
    [...Array(11).keys()].map((i) => values[(10 + i) * axes]),
  );
});
