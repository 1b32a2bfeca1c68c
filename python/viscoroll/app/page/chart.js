/** Charts as SVG: axes with round numbers, lines, points, areas. */

import { svg } from "./dom.js";
import { ABOVE, BESIDE, decadeTicks, roundTicks } from "./ticks.js";
import { numberText } from "./units.js";

const LEFT = 52;
const RIGHT = 14;
const TOP = 30;
const BOTTOM = 46;

/** Ratio of height to width, and smallest height [pixels], which applies on telephones. */
const SHAPE = 0.52;
const LOWEST = 190;

/** Radius of a point [pixels]. */
const DOT = 3;

let count = 0;

/**
 * A chart of lines.
 * @param {object} of
 * @param {number} of.width [pixels]
 * @param {{x: number[], y: number[], name: string, kind: string, fill?: boolean, points?: boolean}[]} of.lines
 *   `kind` is the CSS class that gives the line its color
 * @param {string} of.xLabel
 * @param {string} of.yLabel
 * @param {boolean} [of.logX]
 * @param {[number, number]} of.xRange
 * @param {[number, number]} [of.yRange]
 * @param {{x: number, y: number}} [of.mark] a separate point, drawn as a ring
 * @returns {SVGElement}
 */
export function chart({ width, lines, xLabel, yLabel, logX = false, xRange, yRange, mark }) {
  const height = Math.max(Math.round(SHAPE * width), LOWEST);
  const [right, bottom] = [width - RIGHT, height - BOTTOM];
  const frame = `frame-${(count += 1)}`;
  const ys = [...lines.flatMap((line) => line.y), mark?.y].filter(Number.isFinite);
  const x = axis(xRange, [LEFT, right], BESIDE, logX);
  const y = axis(yRange ?? padded(ys), [bottom, TOP], ABOVE);
  return svg(
    "svg",
    { viewBox: `0 0 ${width} ${height}`, class: "chart", role: "img", "aria-label": `${yLabel} over ${xLabel}` },
    svg("clipPath", { id: frame }, svg("rect", around([LEFT, right], [TOP, bottom]))),
    ...x.ticks.map((tick) => svg("line", { class: "grid", x1: x.at(tick), x2: x.at(tick), y1: TOP, y2: bottom })),
    ...y.ticks.map((tick) => svg("line", { class: "grid", x1: LEFT, x2: right, y1: y.at(tick), y2: y.at(tick) })),
    ...x.ticks.map((tick) => label(x.at(tick), bottom + 18, "middle", numberText(tick))),
    ...y.ticks.map((tick) => label(LEFT - 7, y.at(tick) + 4, "end", numberText(tick))),
    label((LEFT + right) / 2, height - 8, "middle", xLabel, "name"),
    label(2, 16, "start", yLabel, "name"),
    svg("g", { "clip-path": `url(#${frame})` }, ...lines.flatMap((line) => curve(line, x, y))),
    mark && Number.isFinite(mark.y)
      ? svg("circle", { class: "mark", cx: x.at(mark.x), cy: y.at(mark.y), r: 6 }, svg("title", {}, "this case"))
      : null,
    ...legend(lines, (LEFT + right) / 2),
  );
}

/** The rectangle of the chart, enlarged by the radius of points at its edges. */
function around([left, right], [top, bottom]) {
  return { x: left - DOT, y: top - DOT, width: right - left + 2 * DOT, height: bottom - top + 2 * DOT };
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
          { class: `dot ${kind}`, cx, cy, r: DOT },
          svg("title", {}, `${name}: ${numberText(xs[i])}, ${numberText(ys[i])}`),
        ),
      )
    : [];
  return [
    fill ? svg("path", { class: `area ${kind}`, d: area }) : null,
    svg("path", { class: `line ${kind}`, d: `M${path}` }),
    ...dots,
  ];
}

/** Legend with the names of the lines, at the top center. */
function legend(lines, middle) {
  if (lines.length < 2) return [];
  const left = middle - 55;
  return lines.flatMap(({ name, kind }, i) => {
    const top = TOP + 14 + 17 * i;
    return [
      svg("line", { class: `line ${kind}`, x1: left, x2: left + 20, y1: top - 4, y2: top - 4 }),
      label(left + 26, top, "start", name),
    ];
  });
}

function label(x, y, anchor, text, kind = "tick") {
  return svg("text", { x, y, "text-anchor": anchor, class: kind }, text);
}

/** Function from values to positions on an axis [pixels], and the values of its ticks. */
function axis([low, high], [from, to], room, log = false) {
  const scale = log ? Math.log10 : (value) => value;
  const [a, b] = [scale(low), scale(high)];
  const at = (value) => from + ((scale(value) - a) / (b - a || 1)) * (to - from);
  return { at, ticks: log ? decadeTicks(low, high) : roundTicks(low, high, Math.abs(to - from) / room) };
}

/** Range that contains 0 and all values, extended by 10 %. */
function padded(values) {
  if (values.length === 0) return [0, 1];
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
  return [low * 1.1, high === low ? 1 : high * 1.1];
}
