/** Messages of the solver in the words of the form and in the units of its fields. */

import { numberText, suitableUnit } from "./units.js";

/** A number with an SI unit in a text. */
const QUANTITY = /(?<![\w.])(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?) (N m\/m|N m|N\/m|W\/m|m\/s|Pa|N|m|W)(?![\w/^])/g;

/** A path of a key such as "ball.layers[0].thickness", and a name such as "angular_speed". */
const PATH = /\b(?:on|ball|cylinder|wheel|plane|groove|other_[a-z]+|rolling|numerics|drive|layers?\[\d+\])(?:\.\w+(?:\[\d+\])?)+/g;
const NAME = /\b[a-z]+(?:_[a-z]+)+\b/g;

/** The text of a range at the beginning of a rule; the reason for the range may follow. */
const RANGE = /^must be (?:in [[(].*?[\])]|[<>]=? -?[\d.]+(?:e[-+]?\d+)?)/;

/** Signs of comparison in rules with other texts. */
const COMPARED = { ">": "greater than", ">=": "at least", "<": "less than", "<=": "at most" };

/** A remark after a value, as in "0.015 m, with which it drops by 0.015 m". */
const REMARK = /^[^(,;]*( \(.*|, .*)$/;

/**
 * The text of an error.
 * @param {object} error an error of the solver
 * @param {object} [field] field of the form that has the parameter, with `label`, `siUnit`, `typed()`, `inUnit(si)`, and
 *   `derived` if the parameter follows from the number of the field
 */
export function errorText({ message, parameter, rule, value, allowed }, field) {
  if (!parameter) return inPageUnits(message);
  const isTyped = field && !field.derived;
  const hasUnit = isTyped || (field && allowed && field.siUnit === allowed.unit);
  const quantity = (si) => (hasUnit ? field.inUnit(si) : inSuitableUnit(si, allowed?.unit ?? ""));
  const subject = isTyped ? field.label.replace(/ \(.*\)$|, forward$/, "") + placeOf(parameter) : inWords(parameter);
  return `${subject} ${ruleText(rule, allowed, quantity)}${gotText(value, isTyped ? field : null, quantity)}`;
}

/** A rule with the ends of its range written by `quantity`, if it begins with a range. */
function ruleText(rule, allowed, quantity) {
  const range = allowed && RANGE.exec(rule);
  if (!range) return inPageUnits(rule.replace(/(?<=^must be )[<>]=?(?= )/, (sign) => COMPARED[sign]));
  const after = rule.slice(range[0].length);
  const reason = allowed.unit && after.startsWith(` ${allowed.unit}`) ? after.slice(1 + allowed.unit.length) : after;
  return `must be ${rangeText(allowed, quantity)}${inPageUnits(reason)}`;
}

/** A range in words, such as "greater than −1 and at most 0.5"; `quantity` writes a number in SI units. */
export function rangeText({ minimum, maximum, excludes_minimum, excludes_maximum }, quantity) {
  const ends = [
    minimum === null ? null : `${excludes_minimum ? "greater than" : "at least"} ${quantity(minimum)}`,
    maximum === null ? null : `${excludes_maximum ? "less than" : "at most"} ${quantity(maximum)}`,
  ].filter(Boolean);
  return ends.join(" and ") || "a finite number";
}

/** A text with its quantities in the units that the page uses for results, and its names of keys in words. */
export function inPageUnits(text) {
  return text
    .replace(QUANTITY, (_, number, unit) => inSuitableUnit(Number(number), unit))
    .replace(PATH, inWords)
    .replace(/(\w+)="(\w+)"/g, "$1 $2")
    .replace(NAME, (name) => name.replaceAll("_", " "))
    .replace(/( of the counterbody){2,}/g, "$1");
}

/** The key of a path in words: "thickness of layer 1" for "ball.layers[0].thickness". */
function inWords(path) {
  const name = path.split(".").at(-1).replace(/\[\d+\]$/, "");
  return name.replaceAll("_", " ") + (/layers?\[\d+\]$/.test(path) ? "" : placeOf(path));
}

function placeOf(path) {
  const layer = /layers?\[(\d+)\]/.exec(path);
  const ofLayer = layer ? ` of layer ${Number(layer[1]) + 1}` : "";
  return /^(on|plane|groove|other_\w+)\./.test(path) ? `${ofLayer} of the counterbody` : ofLayer;
}

function gotText(value, field, quantity) {
  if (!value) return "";
  if (field) return `, got ${field.typed()}${inPageUnits(REMARK.exec(value)?.[1] ?? "")}`;
  return `, got ${/^[-\d.e+]+$/.test(value) ? quantity(Number(value)) : inPageUnits(value)}`;
}

function inSuitableUnit(value, unit) {
  const [name, scale] = unit ? suitableUnit(value, unit) : ["", 1];
  return `${numberText(value / scale, 5)} ${name}`.trim();
}
