/** Report of a result: sections, words for the body, units and digits. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { Report, labelOf } from "../../python/viscoroll/app/page/report.js";
import { BODIES } from "../../python/viscoroll/app/page/schema.js";

const scalar = (name, unit, group, precision, description) => ({ name, unit, group, precision, description });

const TABLE = [
  scalar("rolling_resistance_force", "N", "answer", "error_estimate model_error", "push force, dissipated power / V"),
  scalar("dissipated_power", "W", "answer", "error_estimate", "dissipated power"),
  scalar("load", "N", "answer", "error_estimate", "normal load P"),
  scalar("contact_length", "m", "answer", "", "contact length, along the path"),
  scalar("contact_width", "m", "answer", "", "contact width"),
  scalar("penetration", "m", "answer", "error_estimate", "penetration"),
  scalar("finite_strain_torque", "N m", "answer", "", "resisting torque at finite strain"),
  scalar("driving_torque", "N m", "friction", "error_estimate", "driving torque T"),
  scalar("creepage", "1", "friction", "%", "creepage"),
  scalar("error_estimate", "1", "certainty", "%", "relative error of the mesh"),
  scalar("model_error", "1", "certainty", "%", "relative error of linear theory"),
  scalar("lateral_force", "N", "other", "", "lateral force on the rolling body"),
  scalar("bulk_power", "W", "other", "error_estimate", "power dissipated in the layers"),
];

const SCALARS = {
  rolling_resistance_force: 0.5424,
  dissipated_power: 2,
  load: 100,
  contact_length: 0.00523,
  contact_width: 0.0055,
  penetration: null,
  driving_torque: 0.011392,
  creepage: null,
  error_estimate: 0.0034,
  model_error: 0.11,
  lateral_force: 0,
  bulk_power: 2,
};

const report = (body, given = {}, scalars = {}) =>
  new Report({ ...SCALARS, ...scalars }, TABLE, {
    prescribed: "load",
    friction: 0,
    angularSpeed: 2.5,
    ...BODIES[body],
    ...given,
  });

const texts = (rows) => rows.map(({ label, text }) => `${label}: ${text}`);

test("the answer comes first, with its errors", () => {
  const { answer, "how certain": certain, "further results": further } = report("ball").sections();
  assert.deepEqual(texts(answer), [
    "push force: 540 ± 60 mN",
    "dissipated power: 2.000 ± 0.007 W",
    "contact length: 5.23 mm",
    "contact width: 5.5 mm",
    "penetration: undetermined",
  ]);
  assert.deepEqual(texts(certain), ["relative error of the mesh: 0.34 %", "relative error of linear theory: 11 %"]);
  assert.deepEqual(texts(further), ["driving torque T: 11.39 ± 0.04 mN m"]);
});

test("with friction, the drive is part of the answer", () => {
  const rows = texts(report("ball", { friction: 0.3 }, { creepage: -0.0276 }).sections().answer);
  assert.ok(rows.includes("driving torque T: 11.39 ± 0.04 mN m"));
  assert.ok(rows.includes("creepage: −2.76 %"));
});

test("a roller has a nip length, and values per length", () => {
  const found = report("cylinder", {}, { lateral_force: 2 });
  assert.equal(found.label("contact_length"), "nip length");
  assert.equal(found.text("driving_torque"), "11.39 ± 0.04 mN m/m");
  assert.equal(found.explanation("contact_length"), "along the path");
  assert.ok(!texts(found.sections().answer).some((row) => row.startsWith("contact width")));
  assert.ok(texts(found.sections()["further results"]).includes("lateral force on the roller: 2 N/m"));
  assert.equal(labelOf(TABLE.at(-2)), "lateral force on the rolling body");
});

test("a given penetration makes the load a result", () => {
  const rows = texts(report("ball", { prescribed: "penetration" }, { penetration: 1e-4 }).sections().answer);
  assert.ok(rows.includes("normal load P: 100.0 ± 0.3 N"));
  assert.ok(!rows.some((row) => row.startsWith("penetration")));
});

test("a material without loss is named", () => {
  const [row] = report("ball", {}, { bulk_power: 0 }).sections().answer;
  assert.equal(row.text, "this material dissipates nothing");
});

test("the torque at finite strain answers if it is that of the drive", () => {
  const labels = (resistance) => {
    const scalars = { finite_strain_torque: 0.0114, resisting_torque: resistance };
    const { answer, "further results": further } = report("ball", {}, scalars).sections();
    return [answer, further].map((rows) => rows.some(({ name }) => name === "finite_strain_torque"));
  };
  assert.deepEqual(labels(0.011392), [true, false]);
  assert.deepEqual(labels(0.0071), [false, true]);
});
