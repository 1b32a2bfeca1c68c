/** Texts about a case that the user keeps. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { initialState } from "../../python/viscoroll/app/page/case.js";
import { caseText, changeText } from "../../python/viscoroll/app/page/comparison.js";
import { exampleState } from "../../python/viscoroll/app/page/examples.js";

test("a change in percent", () => {
  assert.equal(changeText(2, 2.5), " (+25\u00a0%)");
  assert.equal(changeText(2, 1.99), " (−0.5\u00a0%)");
  assert.equal(changeText(1e-3, 5), " (+499900\u00a0%)");
  assert.equal(changeText(2, 2), " (±0\u00a0%)");
  assert.equal(changeText(0, 2), "");
  assert.equal(changeText(2, Number.NaN), "");
});

test("a case in one line", () => {
  assert.equal(caseText(initialState()), "ball 42 mm, 100 N, 2.5 rad/s");
  assert.equal(caseText(exampleState("caster")), "wheel 100 mm, 80 kgf, 4 km/h");
  assert.equal(caseText({ ...initialState(), pressed: "penetration" }), "ball 42 mm, 0.2 mm, 2.5 rad/s");
});
