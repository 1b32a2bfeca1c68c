/** Text of cases in Python and in case files; tests/python/app/test_page.py tests that both give the same numbers. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { caseOf, fileOf, initialState } from "../../python/viscoroll/app/page/case.js";
import { caseFileOf, pythonOf } from "../../python/viscoroll/app/page/code.js";
import { exampleState } from "../../python/viscoroll/app/page/examples.js";

test("Python code for the case of the README", () => {
  const text = pythonOf(caseOf(initialState()));
  assert.match(text, /^import viscoroll as vr\n/);
  assert.match(text, /StandardLinearSolid\(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0\.125\)/);
  assert.match(text, /ball = vr\.CoatedSphere\(core_radius=0\.02, inner_boundary="rigid", layers=\[layer\]\)/);
  assert.match(text, /r = vr\.solve\(/);
  assert.ok(text.split("\n").every((line) => line.length <= 120));
});

test("Python code with a temperature", () => {
  const text = pythonOf(fileOf({ ...initialState(), temperature: "on" }));
  const call = 't = r.temperature(convection=10.0, ambient=293.15, conductivity=0.2, core="insulated")\nprint(t)\n';
  assert.ok(text.endsWith(`print(r)\n${call}`), text);
  assert.match(caseFileOf(fileOf({ ...initialState(), temperature: "on" })), /^\[thermal\]\nconvection = 10\.0\n/m);
});

test("Python code for data sheets calls the conversion functions", () => {
  const text = pythonOf(caseOf(exampleState("skate")));
  assert.match(text, /hardness_to_modulus\(82\.0\)\.value/);
  assert.match(text, /rebound_to_loss_factor\(0\.7\)\.value/);
});

test("case file for the case of the README", () => {
  const text = caseFileOf(caseOf(initialState()));
  assert.match(
    text,
    /^\[ball\]\ncore_radius = 0\.02\ninner_boundary = "rigid"\n\n\[\[ball\.layers\]\]\nthickness = 1e-3\n/m,
  );
  assert.match(text, /^shear_modulus = \{ type = "standard_linear_solid", instantaneous_modulus = 6e6, /m);
  assert.match(text, /^\[rolling\]\nload = 100\.0\nangular_speed = 2\.5\nfriction = 0\.0\n/m);
});

test("integers are written as integers", () => {
  const tables = { ...caseOf(initialState()), numerics: { nodes_per_revolution: 400 } };
  assert.match(caseFileOf(tables), /^nodes_per_revolution = 400$/m);
});
