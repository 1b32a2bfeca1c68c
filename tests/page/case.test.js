/** Conversion between states and cases, and links that restore states. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { caseOf, fileOf, initialState, outerRadius, stateOf } from "../../python/viscoroll/app/page/case.js";
import { pointsOf, spread } from "../../python/viscoroll/app/page/curve.js";
import { EXAMPLES, exampleState } from "../../python/viscoroll/app/page/examples.js";
import { fragmentOf, stateOfFragment } from "../../python/viscoroll/app/page/link.js";
import { KINDS, newLayer } from "../../python/viscoroll/app/page/materials.js";

const README = {
  ball: {
    core_radius: 0.02,
    inner_boundary: "rigid",
    layers: [
      {
        thickness: 0.001,
        shear_modulus: {
          type: "standard_linear_solid",
          instantaneous_modulus: 6e6,
          relaxed_modulus: 3e6,
          relaxation_time: 0.125,
        },
        poisson_ratio: 0.5,
        density: 1000,
      },
    ],
  },
  rolling: { load: 100, angular_speed: 2.5, friction: 0 },
  numerics: { accuracy: 0.01, compliance: "radial" },
};

test("the page starts with the case of the README", () => {
  assert.deepEqual(caseOf(initialState()), README);
});

test("the outer diameter determines the core radius, and the core radius the outer radius", () => {
  const state = { ...initialState(), given: "outer_diameter", size: [42, "mm"] };
  assert.deepEqual(caseOf(state), README);
  assert.equal(outerRadius(initialState()), 0.021);
});

test("converting a case to a state and back does not change it", () => {
  for (const name of Object.keys(EXAMPLES)) {
    const tables = caseOf(exampleState(name));
    const { state, left } = stateOf(tables);
    assert.deepEqual(left, [], name);
    assert.deepEqual(caseOf(state), tables, name);
  }
});

test("converting materials of all kinds to a state and back does not change them", () => {
  for (const [kind, { initial }] of Object.entries(KINDS)) {
    if (initial === null) continue;
    const layer = { ...newLayer(), kind, ...initial };
    const tables = caseOf({ ...initialState(), layers: [layer] });
    assert.equal(stateOf(tables).state.layers[0].kind, kind);
    assert.deepEqual(caseOf(stateOf(tables).state), tables);
  }
});

test("changing the scale keeps the modulus of a hardness, within the range of the scale", () => {
  const { chosen } = KINDS.hardness.fields.find(({ name }) => name === "scale");
  assert.deepEqual(chosen({ hardness: 95 }, "D"), { scale: "D", hardness: 45 });
  assert.deepEqual(chosen({ hardness: 35 }, "A"), { scale: "A", hardness: 85 });
  assert.deepEqual(chosen({ hardness: 60 }, "D"), { scale: "D", hardness: 30 });
});

test("a material without fields in the form is kept unchanged", () => {
  const prony = { type: "prony", instantaneous_modulus: 1e6, weights: [0.5], relaxation_times: [1] };
  const tables = structuredClone(README);
  tables.ball.layers[0].shear_modulus = prony;
  assert.deepEqual(caseOf(stateOf(tables).state), tables);
});

test("numerics without fields in the form are kept, except those of a mesh", () => {
  const numerics = { accuracy: 0.02, compliance: "radial", patch_load: "spherical", slip_kinematics: "flat" };
  const { state, left } = stateOf({ ...README, numerics });
  assert.deepEqual(left, []);
  assert.deepEqual(caseOf(state).numerics, numerics);
});

test("unsupported keys are reported by name", () => {
  const tables = { ...README, numerics: { nodes_per_revolution: 500 }, other_ball: { core_radius: 1, layers: [] } };
  assert.deepEqual(stateOf(tables).left, ["numerics.nodes_per_revolution", "other_ball"]);
});

test("a body is pressed by a load or by a penetration", () => {
  const pressed = { ...initialState(), pressed: "penetration", penetration: [0.1, "mm"] };
  assert.deepEqual(caseOf(pressed).rolling, { penetration: 1e-4, angular_speed: 2.5, friction: 0 });
  const { state, left } = stateOf(caseOf(pressed));
  assert.deepEqual(caseOf(state), caseOf(pressed));
  assert.deepEqual(left, []);
  assert.deepEqual(stateOfFragment(fragmentOf(pressed)), pressed);
  assert.ok(pointsOf(pressed, "load").every(({ unit, tables }) => unit === "mm" && !("load" in tables.rolling)));
});

test("keys with default values need no support", () => {
  const plain = { sides: "free", hub: "straight", width: 0.03, core_radius: 0.02, layers: README.ball.layers };
  const tables = { wheel: plain, rolling: { ...README.rolling, drive: { force: 0 } }, numerics: { curvature: "sphere" } };
  assert.deepEqual(stateOf(tables).left, []);
  const heated = { ...README.ball, layers: [{ ...README.ball.layers[0], conductivity: 0.2 }] };
  assert.deepEqual(stateOf({ ...README, ball: heated }).left, ["ball.layers[0].conductivity"]);
});

test("the table of the temperature is that of the form, outside of the case", () => {
  const heated = { ...initialState(), temperature: "on", ambient: [23, "°C"], core: "isothermal" };
  const thermal = { convection: 10, ambient: 296.15, conductivity: 0.2, core: "isothermal" };
  assert.deepEqual(fileOf(heated), { ...README, thermal });
  assert.deepEqual(caseOf(heated), README);
  assert.deepEqual(fileOf(stateOf(fileOf(heated)).state), fileOf(heated));
  assert.deepEqual(stateOf(fileOf(heated)).left, []);
  assert.deepEqual(stateOfFragment(fragmentOf(heated)), heated);
  const solid = stateOf({ ...README, thermal: { ...thermal, core: 0.3, conductivity: [0.25], shift: {} } });
  assert.deepEqual(fileOf(solid.state).thermal, { ...thermal, core: 0.3, conductivity: 0.25 });
  assert.deepEqual(solid.left, ["thermal.conductivity"]);
});

test("a case without friction has no drive", () => {
  assert.equal("drive" in caseOf({ ...initialState(), drive: "torque", torque: [1, "N m"] }).rolling, false);
  const slid = { ...README, rolling: { ...README.rolling, drive: { creepage: 0.1 } } };
  assert.deepEqual(stateOf(slid).left, ["rolling.drive"]);
  const towed = { ...initialState(), friction: 0.3, drive: "torque" };
  assert.deepEqual(caseOf(towed).rolling.drive, { torque: 0 });
  const powered = { ...towed, drive: "power", power: [50, "mW"] };
  assert.deepEqual(caseOf(powered).rolling.drive, { power: 0.05 });
  assert.deepEqual(stateOf(caseOf(powered)).state.power, [0.05, "W"]);
});

test("a link restores every example", () => {
  assert.equal(fragmentOf(initialState()), "");
  for (const name of Object.keys(EXAMPLES)) {
    const state = exampleState(name);
    const fragment = fragmentOf(state);
    assert.match(fragment, /^(#[\w-]+)?$/);
    if (fragment) assert.deepEqual(stateOfFragment(fragment), state);
  }
});

test("other fragments do not give a state", () => {
  for (const fragment of ["", "#", "#answer", "#%%%", "#bnVsbA", "#eyJ4IjoxfQ"])
    assert.equal(stateOfFragment(fragment), null);
  for (const part of [{ layers: 5 }, { layers: [{ kind: "wood" }] }, { load: "heavy" }, { load: [1, "furlong"] }])
    assert.equal(stateOfFragment(`#${btoa(JSON.stringify(part))}`), null);
});

test("a curve has the case in its middle, and its ends are solved first", () => {
  const state = exampleState("caster");
  for (const along of ["speed", "load", "thickness"]) {
    const points = pointsOf(state, along);
    assert.equal(new Set(points.map(({ at }) => at)).size, points.length);
    assert.ok(points.slice(2).every(({ at }) => at > points[0].at && at < points[1].at));
  }
  assert.deepEqual(spread(5), [0, 4, 2, 1, 3]);
  assert.deepEqual(
    [...spread(21)].sort((a, b) => a - b),
    Array.from({ length: 21 }, (_, i) => i),
  );
  assert.deepEqual(pointsOf({ ...state, layers: [] }, "thickness"), []);
});

test("a case with the speed of the ground keeps it", () => {
  const { state, left } = stateOf({
    cylinder: { core_radius: 0.042, layers: [{ thickness: 0.008, shear_modulus: 2e6, poisson_ratio: 0.5 }] },
    rolling: { load: 3000, speed: 10 },
  });
  assert.deepEqual(state.speed, [10, "m/s"]);
  assert.deepEqual(left, []);
  assert.equal(caseOf(state).rolling.angular_speed, 200);
});
