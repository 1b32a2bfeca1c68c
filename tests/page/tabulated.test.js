/** Materials that the library in WebAssembly does not compute, from tables. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { caseOf } from "../../python/viscoroll/app/page/case.js";
import { exampleState } from "../../python/viscoroll/app/page/examples.js";
import { withMaterials } from "../../python/viscoroll/app/page/tabulated.js";

const series = [1.5, 0.1, 0.2, 0.5, 0.3];
const times = { relaxation_times: [1, 2, 4, 8] };
const tables = {
  hardness: { A: { 82: 4e6 }, D: { 40: 3e7 } },
  rebound: { decades: 4.5, ...times, series: { 70: series } },
  loss_factor: { decades: 3, ...times, series: { 7: series } },
  published: { foam: { 293.15: { type: "elastic", modulus: 1e4 } } },
};
const known = (table) =>
  withMaterials({ case: { ball: { layers: [{ shear_modulus: table }] } }, fields: true }, tables);
const modulus = (table) => known(table).known.case.ball.layers[0].shear_modulus;

test("a series of 1 Pa at 1 rad/s is scaled", () => {
  const scaled = {
    type: "prony",
    instantaneous_modulus: 6e6,
    weights: [0.1, 0.2, 0.1, 0.3],
    relaxation_times: [0.01, 0.02, 0.04, 0.08],
  };
  const sheet = { type: "hardness", hardness: 82, rebound: 0.7, reference_frequency: 100, decades: 4.5 };
  assert.deepEqual(modulus(sheet), scaled);
  assert.deepEqual(modulus({ type: "loss_factor", modulus: 4e6, loss_factor: 0.07, reference_frequency: 100 }), scaled);
});

test("a hardness without a rebound gives an elastic material", () => {
  assert.deepEqual(modulus({ type: "hardness", hardness: 40, scale: "D" }), { type: "elastic", modulus: 3e7 });
});

test("a published material becomes its table", () => {
  assert.deepEqual(modulus({ type: "published", name: "foam", temperature: 293.15 }), { type: "elastic", modulus: 1e4 });
});

test("materials of the library and the rest of a request do not change", () => {
  const tablesOfPaper = caseOf(exampleState("paper"));
  assert.deepEqual(withMaterials({ case: tablesOfPaper, fields: true }, tables), {
    known: { case: tablesOfPaper, fields: true },
  });
});

test("values that are not tabulated give an error at their parameter", () => {
  const { error } = known({ type: "hardness", hardness: 82.5 });
  assert.equal(error.parameter, "ball.layers[0].shear_modulus.hardness");
  assert.match(error.message, /hardness must be a whole number in \[82, 82\] Shore A on this page, got 82\.5/);
  const rebound = known({ type: "hardness", hardness: 82, rebound: 0.705, reference_frequency: 1, decades: 4.5 });
  assert.match(rebound.error.message, /got 70\.5 %/);
  const others = known({ type: "loss_factor", modulus: 4e6, loss_factor: 0.07, reference_frequency: 1, decades: 5 });
  assert.match(others.error.message, /decades must be 3 on this page, got 5/);
});

test("the error for a material too hard for Shore A gives the hardness in Shore D", () => {
  assert.match(known({ type: "hardness", hardness: 95 }).error.message, /got 95; it is about 45 Shore D/);
  assert.doesNotMatch(known({ type: "hardness", hardness: 10 }).error.message, /Shore D/);
});
