/** Numbers on axes: round numbers, as many as fit. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { decadeTicks, roundTicks } from "../../python/viscoroll/app/page/ticks.js";

test("there are about five ticks, at round numbers within the axis", () => {
  assert.deepEqual(roundTicks(-4.8, 4.8, 9), [-4, -2, 0, 2, 4]);
  assert.deepEqual(roundTicks(0, 0.037, 5), [0, 0.01, 0.02, 0.03]);
  assert.deepEqual(roundTicks(0, 350, 5), [0, 100, 200, 300]);
});

test("short axes have fewer ticks", () => {
  assert.deepEqual(roundTicks(-4.8, 4.8, 2.1), [0]);
  assert.deepEqual(roundTicks(-5, 5, 2.1), [-5, 0, 5]);
});

test("ticks of decades are at 1, 2 and 5, or only at 1", () => {
  assert.deepEqual(decadeTicks(0.4, 7), [0.5, 1, 2, 5]);
  assert.deepEqual(decadeTicks(0.08, 75), [0.1, 1, 10]);
});
