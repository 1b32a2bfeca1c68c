/** Published materials, from tables. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { caseOf } from "../../python/viscoroll/app/page/case.js";
import { exampleState } from "../../python/viscoroll/app/page/examples.js";
import { withMaterials } from "../../python/viscoroll/app/page/tabulated.js";

const tables = { foam: { 293.15: { type: "elastic", modulus: 1e4 } } };
const known = (table) =>
  withMaterials({ case: { ball: { layers: [{ shear_modulus: table }] } }, fields: true }, tables);

test("a published material becomes its table", () => {
  const { known: request } = known({ type: "published", name: "foam", temperature: 293.15 });
  assert.deepEqual(request.case.ball.layers[0].shear_modulus, { type: "elastic", modulus: 1e4 });
});

test("materials of the library and the rest of a request do not change", () => {
  const tablesOfPaper = caseOf(exampleState("paper"));
  assert.deepEqual(withMaterials({ case: tablesOfPaper, fields: true }, tables), {
    known: { case: tablesOfPaper, fields: true },
  });
});

test("a temperature that is not tabulated gives an error at its parameter", () => {
  const { error } = known({ type: "published", name: "foam", temperature: 293.5 });
  assert.equal(error.parameter, "ball.layers[0].shear_modulus.temperature");
  assert.match(error.message, /temperature must be 263\.15, 273\.15, .* on this page, got 293\.5 K/);
});
