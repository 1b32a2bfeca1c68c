/** Change of the rolling body: numbers stay, or a text says what changed. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { withBody } from "../../python/viscoroll/app/page/body_change.js";
import { caseOf, initialState, outerRadius } from "../../python/viscoroll/app/page/case.js";

const thin = { ...initialState(), load: [80, "kgf"], speed: [4, "km/h"] };

test("load, speed, layers and outer diameter stay if the values remain total values", () => {
  const { state, changed } = withBody(thin, "wheel");
  assert.deepEqual(changed, []);
  for (const name of ["load", "speed", "layers"]) assert.deepEqual(state[name], thin[name]);
  assert.equal(outerRadius(state), outerRadius(thin));
  assert.deepEqual(withBody(state, "ball").state.load, thin.load);
});

test("a load per length is the load over the width of the tread", () => {
  const ball = { ...initialState(), width: [30, "mm"] };
  const { state: roller, changed } = withBody(ball, "cylinder");
  assert.deepEqual(changed, ["The load of 100 N is now 3.333 N/mm, for a width of 30 mm."]);
  assert.equal(caseOf(roller).rolling.load, 3333.333333333);
  const { state: wheel, changed: back } = withBody(roller, "wheel");
  assert.deepEqual(back, ["The load of 3.333 N/mm is now 100 N, for a width of 30 mm."]);
  assert.deepEqual(wheel.load, [100, "N"]);
});

test("a text about the drive appears only if the form shows a drive", () => {
  const driven = { ...initialState(), drive: "torque", torque: [3, "N m"], pressed: "penetration" };
  assert.deepEqual(withBody(driven, "cylinder").changed, []);
  const { state, changed } = withBody({ ...driven, friction: 0.3 }, "cylinder");
  assert.deepEqual(state.torque, [100, "N m/m"]);
  assert.deepEqual(changed, ["The torque of 3 N m is now 100 N m/m, for a width of 30 mm."]);
  assert.deepEqual(withBody(state, "wheel").state.torque, [3, "N m"]);
});

test("a counterbody that the page does not offer for the body is replaced", () => {
  const { state, changed } = withBody({ ...initialState(), on: "groove" }, "cylinder");
  assert.equal(state.on, "rigid");
  assert.equal(changed[0], "The counterbody is now a rigid plane: the page has no roller on a rigid groove or rail.");
});

test("a solid ball becomes a wheel with a core", () => {
  const solid = { ...initialState(), inner_boundary: "solid", curvature: "exact" };
  const { state, changed } = withBody(solid, "wheel");
  assert.deepEqual(changed, ["A wheel has a rigid core, here with a radius of 20 mm."]);
  assert.deepEqual([state.inner_boundary, state.curvature], ["rigid", "sphere"]);
  assert.equal(caseOf(state).wheel.core_radius, 0.02);
});
