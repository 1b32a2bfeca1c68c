/** Curves in a plane, as SVG: axes with round numbers, lines, points, areas. */

import { svg } from "./dom.js";
import { shown } from "./units.js";

const LEFT = 62;
const RIGHT = 14;
const TOP = 14;
const BOTTOM = 46;

/** Height over width, and the least height [pixels], on telephones. */
const SHAPE = 0.52;
const LOWEST = 190;

let count = 0;

/**
 * @param {object} of
 * @param {number} of.width [pixels]
 * @param {{x: number[], y: number[], name: string, kind: string, fill?: boolean, points?: boolean}[]} of.lines
 *   `kind` is the class that gives them their color
 * @param {string} of.xLabel
 * @param {string} of.yLabel
 * @param {boolean} [of.logX]
 * @param {[number, number]} of.xRange
 * @param {[number, number]} [of.yRange]
 * @param {{x: number, y: number}} [of.mark] a point of its own
 * @returns {SVGElement}
 */
export function chart({ width, lines, xLabel, yLabel, logX = false, xRange, yRange, mark }) {
  const height = Math.max(Math.round(SHAPE * width), LOWEST);
  const [right, bottom] = [width - RIGHT, height - BOTTOM];
  const frame = `frame-${(count += 1)}`;
  const ys = [...lines.flatMap((line) => line.y), mark?.y].filter(Number.isFinite);
  const x = axis(xRange, [LEFT, right], logX);
  const y = axis(yRange ?? padded(ys), [bottom, TOP], false);
  return svg(
    "svg",
    { viewBox: `0 0 ${width} ${height}`, class: "chart", role: "img", "aria-label": `${yLabel} over ${xLabel}` },
    svg("clipPath", { id: frame }, svg("rect", { x: LEFT, y: TOP, width: right - LEFT, height: bottom - TOP })),
    ...x.ticks.map((tick) => svg("line", { class: "grid", x1: x.at(tick), x2: x.at(tick), y1: TOP, y2: bottom })),
    ...y.ticks.map((tick) => svg("line", { class: "grid", x1: LEFT, x2: right, y1: y.at(tick), y2: y.at(tick) })),
    ...x.ticks.map((tick) => label(x.at(tick), bottom + 18, "middle", shown(tick))),
    ...y.ticks.map((tick) => label(LEFT - 7, y.at(tick) + 4, "end", shown(tick))),
    label((LEFT + right) / 2, height - 8, "middle", xLabel, "name"),
    svg(
      "text",
      { class: "name", "text-anchor": "middle", transform: `translate(15 ${(TOP + bottom) / 2}) rotate(-90)` },
      yLabel,
    ),
    svg("g", { "clip-path": `url(#${frame})` }, ...lines.flatMap((line) => curve(line, x, y))),
    mark && Number.isFinite(mark.y)
      ? svg("circle", { class: "mark", cx: x.at(mark.x), cy: y.at(mark.y), r: 6 }, svg("title", {}, "this case"))
      : null,
    ...legend(lines),
  );
}

function curve({ x: xs, y: ys, kind, fill, points, name }, x, y) {
  const places = xs.map((value, i) => [x.at(value), y.at(ys[i])]).filter((place) => place.every(Number.isFinite));
  if (places.length === 0) return [];
  const path = places.map((place) => place.map((one) => one.toFixed(1)).join(",")).join("L");
  const floor = y.at(0).toFixed(1);
  const area = `M${places[0][0].toFixed(1)},${floor}L${path}L${places.at(-1)[0].toFixed(1)},${floor}Z`;
  const dots = points
    ? places.map(([cx, cy], i) =>
        svg(
          "circle",
          { class: `dot ${kind}`, cx, cy, r: 3 },
          svg("title", {}, `${name}: ${shown(xs[i])}, ${shown(ys[i])}`),
        ),
      )
    : [];
  return [
    fill ? svg("path", { class: `area ${kind}`, d: area }) : null,
    svg("path", { class: `line ${kind}`, d: `M${path}` }),
    ...dots,
  ];
}

function legend(lines) {
  if (lines.length < 2) return [];
  return lines.flatMap(({ name, kind }, i) => {
    const top = TOP + 14 + 17 * i;
    return [
      svg("line", { class: `line ${kind}`, x1: LEFT + 10, x2: LEFT + 30, y1: top - 4, y2: top - 4 }),
      label(LEFT + 36, top, "start", name),
    ];
  });
}

function label(x, y, anchor, text, kind = "tick") {
  return svg("text", { x, y, "text-anchor": anchor, class: kind }, text);
}

/** Where values lie on an axis, and which it names. */
function axis([low, high], [from, to], log) {
  const scale = log ? Math.log10 : (value) => value;
  const [a, b] = [scale(low), scale(high)];
  const at = (value) => from + ((scale(value) - a) / (b - a || 1)) * (to - from);
  return { at, ticks: log ? decades(low, high) : round(low, high) };
}

/** From 0, or what is below, to a little above the highest. */
function padded(values) {
  if (values.length === 0) return [0, 1];
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
  return [low * 1.1, high === low ? 1 : high * 1.1];
}

/** Some five round numbers between two. */
function round(low, high) {
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => one >= rough);
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high; i += 1) ticks.push(Number((i * step).toPrecision(12)));
  return ticks;
}

/** 1, 2 and 5 of each decade, or, where those are too many, 1 alone. */
function decades(low, high) {
  const all = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power += 1) {
    for (const factor of [1, 2, 5]) all.push(Number(`${factor}e${power}`));
  }
  const inside = all.filter((tick) => tick >= low && tick <= high);
  return inside.length <= 7 ? inside : inside.filter((tick) => String(tick.toExponential()).startsWith("1e"));
}
