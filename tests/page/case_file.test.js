/** Case files that the site reads; tests/python/app/test_case_text.py compares them with those that Python reads. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { caseOf, stateOf } from "../../python/viscoroll/app/page/case.js";
import { openCase } from "../../python/viscoroll/app/page/case_file.js";
import { caseFileOf } from "../../python/viscoroll/app/page/code.js";
import { EXAMPLES, exampleState } from "../../python/viscoroll/app/page/examples.js";
import { parseToml } from "../../python/viscoroll/app/page/toml.js";

test("the page opens the case files that it writes", () => {
  for (const name of Object.keys(EXAMPLES)) {
    const tables = caseOf(exampleState(name));
    const found = openCase(caseFileOf(tables));
    assert.deepEqual(found.tables, tables, name);
    assert.deepEqual(caseOf(stateOf(found.tables).state), tables, name);
  }
});

test("values, keys and tables of TOML", () => {
  const text = `
a.b = [1, 2.5e-3,  # a comment
  -1_000]
"two words" = 'C:\\path'   # another
c = { d = true, e = "x\\ty", f = {} }
[g]
[[g.h]]
i = +7
[[g.h]]
[g.h.j]
k = .5`;
  assert.throws(() => parseToml(text), { message: "line 11: expected a number, a text in quotes, true, false, a list or a table" });
  assert.deepEqual(parseToml(text.replace(" .5", " 0.5")), {
    a: { b: [1, 0.0025, -1000] },
    "two words": "C:\\path",
    c: { d: true, e: "x\ty", f: {} },
    g: { h: [{ i: 7 }, { j: { k: 0.5 } }] },
  });
});

test("errors of TOML name their line", () => {
  const lines = [
    ["a = 1\na = 2", "line 2: a is given twice"],
    ["a = 1 2", "line 1: expected the end of the line"],
    ["[a\n", 'line 1: expected "]"'],
    ["= 5", "line 1: expected a key"],
    ["a = 1\n[a]", "line 2: a is not a table"],
    ["a = [1, 2", 'line 1: expected "," or "]"'],
    ['a = """x"""', "line 1: this page does not read texts of several lines"],
    ["a = 1979-05-27", "line 1: expected a number, a text in quotes, true, false, a list or a table"],
    ["__proto__ = 5", "line 1: this key is not allowed"],
  ];
  for (const [text, message] of lines) assert.throws(() => parseToml(text), { message }, text);
});

const ball = (keys, rolling = "load = 1\nangular_speed = 1") => `
[ball]
${keys}
[[ball.layers]]
thickness = "1 mm"
shear_modulus = "1.2 MPa"
poisson_ratio = 0.5
[rolling]
${rolling}
`;

test("texts with units become numbers in SI units, and the outer diameter the radius of the core", () => {
  const { tables } = openCase(ball('outer_diameter = "4.2 cm"', 'load = "10 kgf"\nspeed = "3.6 km/h"'));
  assert.equal(tables.ball.core_radius, 0.02);
  assert.equal(tables.ball.layers[0].shear_modulus, 1.2e6);
  assert.deepEqual(tables.rolling, { load: 98.0665, speed: 1 });
  const roller = openCase(ball("core_radius = 0.02", 'load = "2 N/mm"\nangular_speed = "60 rpm"').replaceAll("ball", "cylinder"));
  assert.deepEqual(roller.tables.rolling, { load: 2000, angular_speed: 6.28318530718 });
});

test("cases that the page cannot read are rejected", () => {
  const refused = (text) => openCase(text).error.message;
  const unit = 'ball.core_radius must be a number [m] or have a unit that this page reads, got "2 N"';
  assert.equal(refused(ball('core_radius = "2 N"')), unit);
  assert.match(refused(ball("core_radius = 0.02", 'load = 1\nspeed = "2 rpm"')), /^rolling.speed must be a number \[m\/s\]/);
  assert.match(refused("[rolling]\nload = 1"), /^one of the tables ball, cylinder, wheel must be given/);
  assert.equal(refused("wheel = 5"), "wheel must be a table");
  assert.equal(refused("ball.core_radius = 1"), "exactly one of rolling.load and rolling.penetration must be given");
  const thin = ball("core_radius = 0.02").replaceAll("ball", "wheel");
  assert.equal(refused(thin), "wheel.width must be given");
  assert.match(refused(ball("core_radius = inf")), /must be finite on this page/);
  assert.match(refused(ball("core_radius = 1").replace("thickness", "thick")), /^a number is missing/);
  assert.match(refused(ball('core_radius = "20 mm"').replace('"1.2 MPa"', '{ type = "elastic" }')), /^a number is missing/);
});

test("tables that the page does not support are named", () => {
  const { tables, skipped } = openCase(`${ball("core_radius = 0.02")}[thermal]\nconvection = 10`);
  assert.deepEqual(skipped, ["thermal"]);
  assert.deepEqual(Object.keys(tables), ["ball", "rolling"]);
});
