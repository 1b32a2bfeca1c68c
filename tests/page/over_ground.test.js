/** Motions over obstacles, and the surfaces that the view draws. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { initialState } from "../../python/viscoroll/app/page/case.js";
import { heightAt, motionOf, surfacesAt } from "../../python/viscoroll/app/page/over_ground.js";

const state = (more = {}) => ({ ...initialState(), obstacle: "step", obstacle_size: [0.42, "mm"], ...more });
const close = (value, wanted) => assert.ok(Math.abs(value - wanted) < 1e-12, `${value} is not ${wanted}`);

test("the motion passes a step at the speed of the form", () => {
  const { rolling, motion, ground, axle, ball, numerics } = motionOf(state());
  assert.equal(rolling, undefined);
  assert.equal(axle, undefined);
  assert.equal(ball.core_radius, 0.02);
  assert.deepEqual(numerics, { compliance: "radial" });
  // The body begins 0.6 r_o before the distance sqrt(2 r_o h) at which it touches the edge.
  close(ground.at, 0.6 * 0.021 + Math.sqrt(2 * 0.021 * 0.42e-3));
  assert.deepEqual(ground, { type: "step", height: 0.42e-3, at: ground.at });
  close(motion.distance[1], 2 * ground.at);
  close(motion.distance[1] / motion.time[1], 2.5 * 0.021);
  assert.equal(motion.load, 100);
});

test("obstacles have the keys of their types", () => {
  const ground = (obstacle) => motionOf(state({ obstacle })).ground;
  assert.deepEqual(Object.keys(ground("half_sine")), ["type", "height", "length", "at"]);
  assert.deepEqual(Object.keys(ground("joint")), ["type", "depth", "width", "at"]);
  assert.deepEqual(Object.keys(ground("corrugation")), ["type", "amplitude", "period"]);
});

test("an axle has a mass, or a given height with a fixed gap", () => {
  assert.deepEqual(motionOf(state({ axle: "mass", axle_mass: 3 })).axle, { mass: 3 });
  const { motion, axle } = motionOf(state({ axle: "mass", pressed: "penetration", penetration: [0.2, "mm"] }));
  assert.equal(axle, undefined);
  assert.equal(motion.load, undefined);
  close(motion.axle_height, 0.0208);
});

test("heights are those of the shapes", () => {
  assert.equal(heightAt({ type: "step", height: 2, at: 1 }, 1), 2);
  assert.equal(heightAt({ type: "step", height: 2, at: 1 }, 0.999), 0);
  close(heightAt({ type: "half_sine", height: 2, length: 6, at: 1 }, 2), 2 * Math.cos(Math.PI / 6));
  assert.equal(heightAt({ type: "half_sine", height: 2, length: 6, at: 1 }, 4.1), 0);
  assert.equal(heightAt({ type: "joint", depth: 2, width: 1, at: 1 }, 0.5), -2);
  assert.equal(heightAt({ type: "joint", depth: 2, width: 1, at: 1 }, 1.5), 0);
  close(heightAt({ type: "corrugation", amplitude: 2, period: 8 }, 1), Math.SQRT2);
});

test("a soft body follows the ground, and soft ground a rigid body", () => {
  const ground = { type: "step", height: 0, at: 0 };
  const at = { radius: 1, distance: 0, height: 0.99, half: 0.5 };
  const middle = 150;
  const soft = surfacesAt({ ball: { core_radius: 0.9, layers: [{}] }, ground }, at);
  assert.deepEqual([soft.body[middle], soft.ground[middle], soft.contact[middle]], [0, 0, 0]);
  const rigid = surfacesAt({ ball: { core_radius: 1, layers: [] }, plane: { layers: [{}] }, ground }, at);
  for (const surface of ["body", "ground", "contact"]) close(rigid[surface][middle], -0.01);
  assert.equal(rigid.contact[0], null);
  close(rigid.body[0], 0.99 - Math.sqrt(0.75));
});
