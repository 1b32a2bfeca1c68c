/** Units: typed text, its SI value, and the display of results. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { UNITS } from "../../python/viscoroll/app/page/unit_table.js";
import {
  SI,
  fromSI,
  numberText,
  quantityText,
  resultUnit,
  toSI,
  unitNamed,
} from "../../python/viscoroll/app/page/units.js";

test("the SI unit of every quantity is one of its units, or empty", () => {
  for (const [quantity, units] of Object.entries(UNITS)) {
    assert.ok(quantity in SI);
    if (SI[quantity] !== "") assert.ok(SI[quantity] in units, quantity);
  }
});

test("conversions do not add round-off to decimals", () => {
  assert.equal(toSI([3, "mm"], "length"), 0.003);
  assert.equal(toSI([0.1, "MPa"], "modulus"), 1e5);
  assert.equal(toSI([55, "%"], "percent"), 0.55);
  assert.deepEqual(fromSI(0.003, "mm", "length"), [3, "mm"]);
  assert.equal(toSI([20, "°C"], "temperature"), 293.15);
  assert.deepEqual(fromSI(263.15, "°C", "temperature"), [-10, "°C"]);
});

test("units agree with their definitions", () => {
  assert.equal(toSI([1, "in"], "length"), 0.0254);
  assert.equal(toSI([1, "kgf"], "force"), 9.80665);
  assert.ok(Math.abs(toSI([1, "psi"], "modulus") - (0.45359237 * 9.80665) / 0.0254 ** 2) < 1e-8);
  assert.ok(Math.abs(toSI([1, "lbf"], "force") - 0.45359237 * 9.80665) < 1e-11);
});

test("speeds of the center are converted to angular speeds with the radius", () => {
  assert.equal(toSI([36, "km/h"], "speed", 0.5), 20);
  assert.equal(toSI([1.5, "m/s"], "speed", 0.05), 30);
  assert.ok(Math.abs(toSI([60, "rpm"], "speed") - 2 * Math.PI) < 1e-12);
  for (const unit of Object.keys(UNITS.speed)) {
    const [value] = fromSI(toSI([12, unit], "speed", 0.04), unit, "speed", 0.04);
    assert.ok(Math.abs(value - 12) < 1e-11, unit);
  }
});

test("results are displayed in the usual units", () => {
  assert.equal(quantityText(0.0113962, "N m"), "11.4 mN m");
  assert.equal(quantityText(8.46e6, "Pa"), "8.46 MPa");
  assert.equal(quantityText(3.2e5, "Pa"), "0.32 MPa");
  assert.equal(quantityText(1.475e-4, "m"), "0.1475 mm");
  assert.equal(quantityText(2.2e-5, "m^2"), "22 mm²");
  assert.equal(quantityText(-0.25, "N"), "−250 mN");
  assert.equal(quantityText(0.0054, "1"), "0.0054");
  assert.equal(quantityText(null, "m"), "undetermined");
  assert.equal(quantityText(0.0359721, "N", 0.009), "36.0 ± 0.3 mN");
  assert.equal(quantityText(-466.43, "N", 0.16), "−470 ± 70 N");
  assert.equal(quantityText(11.391712, "N m", 1e-9), "11.3917 N m");
  assert.equal(numberText(6e6), "6·10⁶");
  assert.equal(numberText(2.5e-7), "2.5·10⁻⁷");
});

test("units in line contact are per length", () => {
  assert.equal(resultUnit("N m", true), "N m/m");
  assert.equal(resultUnit("Pa", true), "Pa");
  assert.equal(resultUnit("N m", false), "N m");
});

test("units are recognized in usual spellings", () => {
  assert.equal(unitNamed("kg", "force"), "kgf");
  assert.equal(unitNamed("MPA", "modulus"), "MPa");
  assert.equal(unitNamed("Nm", "torque"), "N m");
  assert.equal(unitNamed("furlong", "length"), undefined);
});
