/** Rolling over an obstacle: the motion file for a state of the form, and the heights of its ground. */

import { caseOf, outerRadius } from "./case.js";
import { tidy, toSI } from "./units.js";

/** Obstacles by their types in motion files: label, and the keys of their size and of their length along the track. */
export const OBSTACLES = {
  half_sine: { label: "bump: half a sine", size: "height", length: "length" },
  step: { label: "step", size: "height", length: null },
  joint: { label: "joint between plates", size: "depth", length: "width" },
  corrugation: { label: "corrugation", size: "amplitude", length: "period" },
};

/** Distance that the body rolls before it touches the obstacle, and after it, divided by the radius. */
const BESIDE = 0.6;

/** Smallest number of periods of a corrugation over which the body rolls. */
const PERIODS = 3;

/** Whether the axle has a mass: only if the load is given, because a fixed gap prescribes the height of the axle. */
export const hasAxle = ({ axle, pressed }) => axle === "mass" && pressed === "load";

/** Tables of the motion file for a state with an obstacle, in SI units, without friction. */
export function motionOf(state) {
  const { rolling, numerics, ...bodies } = caseOf(state);
  const radius = outerRadius(state);
  const { ground, end } = trackOf(state, radius);
  const { load, penetration, angular_speed: speed } = rolling;
  const { compliance, curvature } = numerics;
  return {
    ...bodies,
    motion: {
      time: [0, tidy(end / (speed * radius))],
      distance: [0, end],
      ...(state.pressed === "load" ? { load } : { axle_height: tidy(radius - penetration) }),
    },
    ground,
    ...(hasAxle(state) ? { axle: { mass: state.axle_mass } } : {}),
    numerics: { compliance, ...(curvature ? { curvature } : {}) },
  };
}

/** Table of the ground, and the distance at which the motion ends [m]. */
function trackOf(state, radius) {
  const { size: sizeKey, length: lengthKey } = OBSTACLES[state.obstacle];
  const size = toSI(state.obstacle_size, "length");
  const length = lengthKey ? toSI(state.obstacle_length, "length") : 0;
  const touched = Math.sqrt(2 * radius * Math.abs(size)); // distance at which a rigid body touches an edge
  const before = touched + BESIDE * radius;
  const shape = { type: state.obstacle, [sizeKey]: size, ...(lengthKey ? { [lengthKey]: length } : {}) };
  if (state.obstacle === "corrugation") return { ground: shape, end: tidy(Math.max(PERIODS * length, before)) };
  return { ground: { ...shape, at: tidy(before + 0.5 * length) }, end: tidy(2 * before + length) };
}

/** Height of a ground at a distance [m], as in `Profile`. */
export function heightAt({ type, at = 0, ...shape }, distance) {
  const x = distance - at;
  switch (type) {
    case "step":
      return x >= 0 ? shape.height : 0;
    case "half_sine":
      return Math.abs(x) < 0.5 * shape.length ? shape.height * Math.cos((Math.PI * x) / shape.length) : 0;
    case "joint":
      return x >= -0.5 * shape.width && x < 0.5 * shape.width ? -shape.depth : 0;
    default:
      return shape.amplitude * Math.sin((2 * Math.PI * x) / shape.period);
  }
}

/** Number of points of a drawn surface. */
const POINTS = 301;

/**
 * Heights of body and ground around the axle [m]. Where the undeformed body is below the undeformed ground, they touch;
 * a soft body then follows the ground, and soft ground follows a rigid body.
 * @param {object} tables tables of a motion file
 * @param {object} of
 * @param {number} of.radius outer radius [m]
 * @param {number} of.distance distance of the axle along the track [m]
 * @param {number} of.height height of the axle [m]
 * @param {number} of.half half of the shown distance [m], smaller than the radius
 */
export function surfacesAt(tables, { radius, distance, height, half }) {
  const isSoft = Object.values(tables).some(({ layers, core_radius: core, inner_boundary: inside }) => {
    return layers?.length > 0 && (core !== undefined || inside !== undefined);
  });
  const x = Array.from({ length: POINTS }, (_, i) => distance + half * ((2 * i) / (POINTS - 1) - 1));
  const ground = x.map((one) => heightAt(tables.ground, one));
  const body = x.map((one) => height - Math.sqrt(radius ** 2 - (one - distance) ** 2));
  const touches = x.map((_, i) => body[i] < ground[i]);
  return {
    x,
    body: body.map((one, i) => (isSoft && touches[i] ? ground[i] : one)),
    ground: ground.map((one, i) => (!isSoft && touches[i] ? body[i] : one)),
    contact: ground.map((one, i) => (touches[i] ? (isSoft ? one : body[i]) : null)),
  };
}
