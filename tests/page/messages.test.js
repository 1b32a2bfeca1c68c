/** Messages of the solver in the words and units of the form. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { errorText, inPageUnits, rangeText } from "../../python/viscoroll/app/page/messages.js";
import { fromSI, numberText } from "../../python/viscoroll/app/page/units.js";

const range = (part) => ({ unit: "", minimum: null, maximum: null, excludes_minimum: false, excludes_maximum: false, ...part });
const error = (parameter, rule, value, allowed = null) => ({
  message: `${parameter} ${rule}, got ${value}`,
  parameter,
  rule,
  value,
  allowed: allowed && range(allowed),
});

const millimeters = (label, typed, derived = false) => ({
  label,
  derived,
  siUnit: "m",
  typed: () => `${typed} mm`,
  inUnit: (meters) => `${numberText(fromSI(meters, "mm", "length")[0])} mm`,
});

test("a range has the unit of the field, and the typed value follows", () => {
  const positive = { unit: "m", minimum: 0, excludes_minimum: true };
  const thin = error("ball.layers[1].thickness", "must be > 0 m", "-0.001", positive);
  assert.equal(
    errorText(thin, millimeters("thickness", "−1")),
    "thickness of layer 2 must be greater than 0 mm, got −1 mm",
  );
  const rest = { minimum: 0.001, maximum: 0.5, unit: "m", excludes_maximum: true };
  const deep = error("penetration", "must be in [0.001, 0.5) m, the thickness of the coating", "0.7", rest);
  assert.equal(
    errorText(deep, millimeters("penetration", "700")),
    "penetration must be at least 1 mm and less than 500 mm, the thickness of the coating, got 700 mm",
  );
});

test("a range in words", () => {
  const words = (part) => rangeText(range(part), String);
  assert.equal(words({ minimum: -1, maximum: 0.5, excludes_minimum: true }), "greater than -1 and at most 0.5");
  assert.equal(words({ maximum: 4 }), "at most 4");
  assert.equal(words({}), "a finite number");
});

test("a parameter that follows from the number of the field has its own name and unit", () => {
  const core = error("ball.core_radius", "must be > 0 m", "-0.002", { unit: "m", minimum: 0, excludes_minimum: true });
  assert.equal(
    errorText(core, millimeters("outer diameter", "2", true)),
    "core radius must be greater than 0 mm, got −2 mm",
  );
  const below = { unit: "Pa", maximum: 6e6 };
  const stiff = error("shear_modulus.relaxed_modulus", "must be <= instantaneous_modulus = 6e+06 Pa", "7e+06", below);
  assert.equal(errorText(stiff), "relaxed modulus must be at most instantaneous modulus = 6 MPa, got 7 MPa");
});

test("the reason of a range and a remark about the value stay", () => {
  const percent = { label: "rebound", derived: false, typed: () => "120 %", inUnit: (ratio) => `${100 * ratio} %` };
  const fraction = { minimum: 0.02, maximum: 1, excludes_maximum: true };
  const rebound = error("shear_modulus.rebound", "must be in [0.02, 1), as a fraction", "1.2; 1.2 % is 0.012", fraction);
  assert.equal(errorText(rebound, percent), "rebound must be at least 2 % and less than 100 %, as a fraction, got 120 %");
  const none = { minimum: null, maximum: 4 };
  const rough = error("friction", "must be <= 4 (no pair has more)", "30", none);
  const friction = { label: "friction", derived: false, typed: () => "30", inUnit: String };
  assert.equal(errorText(rough, friction), "friction must be at most 4 (no pair has more), got 30");
  const heavy = error("load", "must be small enough", "1e+05 N (pressed 0.00215 m into a coating)");
  const load = { label: "load", derived: false, typed: () => "100 kN" };
  assert.equal(errorText(heavy, load), "load must be small enough, got 100 kN (pressed 2.15 mm into a coating)");
});

test("rules that are not ranges have quantities in the units of the page", () => {
  const crown = error("wheel.crown_radius", "must be at least half of the width, 0.015 m", "0.001 m");
  assert.equal(
    errorText(crown, millimeters("crown radius", "1")),
    "crown radius must be at least half of the width, 15 mm, got 1 mm",
  );
  const groove = error("on.radius", "must be at least 2 % larger than the radius of the ball, 0.021 m", "0.01 m");
  assert.equal(
    errorText(groove, millimeters("radius across the path", "10")),
    "radius across the path of the counterbody must be at least 2 % larger than the radius of the ball, 21 mm, got 10 mm",
  );
});

test("texts have no names of keys and no SI units of lengths and moduli", () => {
  assert.equal(inPageUnits("ball.layers[0].thickness = 0.0205 m"), "thickness of layer 1 = 20.5 mm");
  assert.equal(inPageUnits("angular_speed at 3.5 m/s, 8.4e+06 Pa, 2 N m"), "angular speed at 3.5 m/s, 8.4 MPa, 2 N m");
  assert.equal(inPageUnits('with hub="crowned" (at most 0.2), e.g. 30 mm'), "with hub crowned (at most 0.2), e.g. 30 mm");
  assert.equal(inPageUnits("unless on.layers or on.base of the counterbody"), "unless layers of the counterbody or base of the counterbody");
  assert.equal(errorText({ message: "not enough memory", parameter: null }), "not enough memory");
});
